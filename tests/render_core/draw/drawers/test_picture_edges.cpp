#include "render_core/draw/drawers/picture_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/png_file.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/readback.hpp"
#include "render_core/gl/render_target.hpp"
#include "render_core/perception/edge_density.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/perception/held_edges.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/programs/headless_backends.hpp"

namespace tedavis::draw::test_picture_edges {
namespace {

using test_support::GlSession;
using test_support::Rgb;
using test_support::SyntheticPicture;
using Edges = std::vector<std::uint8_t>;  ///< kEdge or 0 a pixel, rows from the top
using Densities = std::vector<float>;

constexpr const char* kDevices[] = {"es3-mid", "es2-small"};

/// All of tests/golden/pictures, 256 x 192 pixels each.
std::vector<SyntheticPicture> shipped_pictures() {
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(test_support::source_dir() + "/tests/golden/pictures"))
        if (entry.path().extension() == ".png") files.insert(entry.path());
    std::vector<SyntheticPicture> pictures;
    for (const auto& file : files) {
        const auto png = host_sim::read_png(file.string());
        pictures.emplace_back(static_cast<int>(png.width), static_cast<int>(png.height), [&](int x, int y) {
            const std::uint8_t* const pixel =
                &png.pixels[4 * (static_cast<std::size_t>(y) * png.width + static_cast<std::size_t>(x))];
            return Rgb{pixel[0], pixel[1], pixel[2]};
        });
    }
    return pictures;
}

/// The first row is the lowest one.
std::vector<std::uint8_t> texels_of(const SyntheticPicture& picture) {
    std::vector<std::uint8_t> texels;
    for (int y = picture.height; y-- > 0;)
        for (int x = 0; x < picture.width; ++x) {
            for (const std::uint8_t level : picture.at(x, y)) texels.push_back(level);
            texels.push_back(255);
        }
    return texels;
}

/// What perception finds in a picture that lies in memory.
Densities expected_of(const SyntheticPicture& picture, const perception::CannySettings& settings = {}) {
    const Edges edges = test_support::edges_of(picture, settings);
    std::vector<double> densities(48);
    EXPECT_TRUE(perception::region_densities({edges, picture.width, picture.height}, {8, 6}, densities));
    return {densities.begin(), densities.end()};
}

/// Pictures of one size on a device's surface, and their edges.
class Measured {
public:
    Measured(const std::string& device, int width, int height, bool shows = true, const std::string& backend = "egl")
        : session_(backend, device, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)),
          triangle_(session_.gl),
          width_(static_cast<std::uint32_t>(width)),
          height_(static_cast<std::uint32_t>(height)),
          memory_(PictureEdges::bytes(width_, height_)),
          arena_(memory_.data(), memory_.size()) {
        budget_.bytes = std::uint64_t{4} * width_ * height_;
        auto texture =
            gl::make_texture(session_.gl, budget_, {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, width_, height_});
        texture_ = std::move(texture.value());
        EXPECT_EQ(edges_.start(session_.gl, session_.device.budget, arena_, width_, height_, shows).message.view(), "");
        session_.gl.seal();
    }
    ~Measured() {
        EXPECT_EQ(session_.gl.denied().total, 0u);
        EXPECT_EQ(session_.gl.take_error(), GLenum{GL_NO_ERROR});
        session_.gl.retire();
        edges_.destroy(session_.gl);
        EXPECT_EQ(taken(), 0u);
        EXPECT_FALSE(edges_.is_started());
        texture_.destroy(session_.gl);
        triangle_.destroy(session_.gl);
    }
    Measured(const Measured&) = delete;
    Measured& operator=(const Measured&) = delete;

    void put(const SyntheticPicture& picture) {
        EXPECT_TRUE(texture_.upload(session_.gl, {0, 0, width_, height_}, texels_of(picture).data()));
        gl::bind_surface(session_.gl, *session_.surface);
        session_.gl->Disable(GL_BLEND);
        triangle_.copy(session_.gl, texture_);
    }
    Densities densities() {
        const effects::ClutterMap map = edges_.measure(session_.gl, *session_.surface);
        EXPECT_TRUE(map.is_known);
        return {map.measure.begin(), map.measure.end()};
    }
    Densities densities_of(const SyntheticPicture& picture) {
        put(picture);
        return densities();
    }
    void show(EdgeView view) { edges_.show(session_.gl, view); }
    [[nodiscard]] bool can_show() const { return edges_.can_show(); }
    /// As the view shows the last measured ones; anything else than white and black is told.
    [[nodiscard]] Edges shown_edges() {
        show(EdgeView::edges);
        const std::vector<std::uint8_t> shown = pixels();
        Edges edges;
        for (std::uint32_t y = height_; y-- > 0;)
            for (std::uint32_t x = 0; x < width_; ++x) {
                const std::size_t at = 4 * (std::size_t{y} * width_ + x);
                EXPECT_TRUE(shown[at] == shown[at + 1] && shown[at] == shown[at + 2]);
                edges.push_back(shown[at]);
            }
        return edges;
    }
    [[nodiscard]] std::vector<std::uint8_t> pixels() { return session_.pixels(); }
    [[nodiscard]] std::uint64_t taken() { return session_.device.budget.find(effects::kRenderTargets)->use.in_use; }
    [[nodiscard]] const base::Arena& arena() const { return arena_; }

private:
    GlSession session_;
    test_support::ScreenTriangle triangle_;
    std::uint32_t width_, height_;
    std::vector<unsigned char> memory_;
    base::Arena arena_;
    base::BudgetLine budget_;
    gl::Texture texture_;
    PictureEdges edges_;
};

TEST(PictureEdges, AreThoseOfPerceptionInTheShippedPictures) {
    const std::vector<SyntheticPicture> pictures = shipped_pictures();
    ASSERT_GE(pictures.size(), 30u);
    for (const char* device : kDevices) {
        Measured measured(device, 256, 192);
        for (const SyntheticPicture& picture : pictures) {
            const Densities found = measured.densities_of(picture);
            EXPECT_EQ(found, expected_of(picture)) << device;
            EXPECT_NE(found, expected_of(picture, {1, 170, 170})) << "control: without weak edges";
            EXPECT_EQ(measured.shown_edges(), test_support::edges_of(picture)) << device;
        }
    }
}

/// Heights that are whole strips, one row more and one less; widths that no strip fills.
TEST(PictureEdges, OfEverySizeAreThoseOfPerception) {
    struct Case {
        const char* device;
        SyntheticPicture picture;
    };
    const Case cases[] = {
        {"es3-mid", test_support::landscape(133, 101, 16)},          {"es2-small", test_support::checkerboard(133, 101, 16)},
        {"es3-mid", test_support::noise_picture(97, 131, 5)},        {"es2-small", test_support::noise_picture(97, 131, 5)},
        {"es3-mid", test_support::noise_picture(64, 64, 8, 90, 60)}, {"es2-small", test_support::noise_picture(18, 70, 9)},
        {"es3-mid", test_support::noise_picture(16, 17, 1)},         {"es2-small", test_support::noise_picture(19, 16, 1)},
        {"es2-small", test_support::noise_picture(63, 33, 2)},       {"es3-mid", test_support::noise_picture(2101, 18, 3)},
        {"es2-small", test_support::noise_picture(16, 31, 2)},       {"es3-mid", test_support::noise_picture(17, 32, 3)}};
    for (const Case& at : cases) {
        const SyntheticPicture& picture = at.picture;
        Measured measured(at.device, picture.width, picture.height);
        EXPECT_EQ(measured.densities_of(picture), expected_of(picture)) << at.device << " " << picture.width;
        EXPECT_EQ(measured.shown_edges(), test_support::edges_of(picture)) << at.device << " " << picture.width;
        const SyntheticPicture mirrored = picture.mirrored();
        EXPECT_EQ(measured.densities_of(mirrored), expected_of(mirrored)) << at.device << " mirrored";
    }
}

/// A line that is weak but for its left end is an edge to its right end.
TEST(PictureEdges, AreFollowedToTheirEnd) {
    constexpr int kWidth = 1000;
    const SyntheticPicture line(kWidth, 32, [](int x, int y) {
        const auto level = static_cast<std::uint8_t>(y < 16 ? 100 : x < 6 ? 200 : 140);
        return Rgb{level, level, level};
    });
    // Far from its strong end, so that no edge of that end counts.
    const auto columns_with_edge = [](const Edges& edges) {
        int columns = 0;
        for (std::size_t x = 20; x < kWidth; ++x) columns += edges[15 * kWidth + x] != 0 || edges[16 * kWidth + x] != 0 ? 1 : 0;
        return columns;
    };
    for (const char* device : kDevices) {
        Measured measured(device, kWidth, 32);
        static_cast<void>(measured.densities_of(line));
        EXPECT_EQ(columns_with_edge(measured.shown_edges()), kWidth - 20) << device;
    }
    EXPECT_EQ(columns_with_edge(test_support::edges_of(line, {1, 170, 170})), 0) << "control: without weak edges";
}

TEST(PictureEdges, AreTheSameOnEveryBackend) {
    const SyntheticPicture picture = test_support::landscape(260, 150, 7);
    for (const std::string& backend : test_support::headless_backends())
        for (const char* device : kDevices)
            EXPECT_EQ(Measured(device, 260, 150, true, backend).densities_of(picture), expected_of(picture))
                << backend << " " << device;
}

/// Without a compiler there is nothing but what is cleared: rectangles of colours.
TEST(PictureEdges, AreFoundOnTheCallsOfOpenGlSc) {
    constexpr int kWidth = 160, kHeight = 120, kFirst = 24;
    GlSession session("egl", "sc2", kWidth, kHeight);
    std::vector<unsigned char> memory(PictureEdges::bytes(kWidth, kHeight));
    base::Arena arena(memory.data(), memory.size());
    PictureEdges edges;
    ASSERT_EQ(edges.start(session.gl, session.device.budget, arena, kWidth, kHeight, false).message.view(), "");
    session.gl.seal();
    gl::bind_surface(session.gl, *session.surface);
    session.gl->Enable(GL_SCISSOR_TEST);
    for (int x = 0; x < kWidth; x += kFirst) {
        session.gl->Scissor(x, 0, kFirst, x + kFirst);
        session.gl->ClearColor(x % (2 * kFirst) == 0 ? 1 : 0, 0.4f, 0.6f, 1);
        session.gl->Clear(GL_COLOR_BUFFER_BIT);
    }
    session.gl->Disable(GL_SCISSOR_TEST);
    const std::vector<std::uint8_t> pixels = session.pixels();
    const SyntheticPicture picture(kWidth, kHeight, [&](int x, int y) {
        const auto row = static_cast<std::size_t>(kHeight - 1 - y), column = static_cast<std::size_t>(x);
        const std::uint8_t* const pixel = &pixels[4 * (row * kWidth + column)];
        return Rgb{pixel[0], pixel[1], pixel[2]};
    });
    const effects::ClutterMap map = edges.measure(session.gl, *session.surface);
    ASSERT_TRUE(map.is_known);
    EXPECT_EQ(Densities(map.measure.begin(), map.measure.end()), expected_of(picture));
    EXPECT_GT(*std::max_element(map.measure.begin(), map.measure.end()), 0.01f) << "control";
    EXPECT_EQ(session.gl.denied().total, 0u);
}

TEST(PictureEdges, LeaveThePictureAsItIs) {
    const SyntheticPicture picture = test_support::landscape(150, 110, 3), other = test_support::noise_picture(150, 110, 4);
    for (const char* device : kDevices) {
        Measured measured(device, 150, 110);
        measured.put(picture);
        const auto before = measured.pixels();
        const Densities densities = measured.densities();
        EXPECT_EQ(measured.pixels(), before) << device << ": unchanged, and the surface is bound";
        EXPECT_NE(measured.densities_of(other), densities) << device;
        EXPECT_EQ(measured.densities_of(picture), densities) << "whatever was measured before";
    }
}

TEST(PictureEdges, NothingIsShownBeforeAPictureWasMeasured) {
    const SyntheticPicture picture = test_support::landscape(150, 110, 3);
    Measured measured("es3-mid", 150, 110);
    measured.put(picture);
    const auto before = measured.pixels();
    for (const EdgeView view : {EdgeView::edges, EdgeView::regions}) measured.show(view);
    EXPECT_EQ(measured.pixels(), before);
    static_cast<void>(measured.densities());
    measured.show(EdgeView::regions);
    EXPECT_NE(measured.pixels(), before) << "control";
}

/// Left half flat, right half noise.
TEST(PictureEdges, RegionsAreTintedTheLighterTheDenser) {
    const SyntheticPicture noise = test_support::noise_picture(162, 122, 2);
    const SyntheticPicture picture(162, 122, [&](int x, int y) { return x < 81 ? Rgb{90, 90, 90} : noise.at(x, y); });
    for (const char* device : kDevices) {
        Measured measured(device, 162, 122);
        static_cast<void>(measured.densities_of(picture));
        measured.put(test_support::flat_picture(162, 122, {0, 0, 0}));
        measured.show(EdgeView::regions);
        const std::vector<std::uint8_t> shown = measured.pixels();
        const auto light = [&](int x, int y) {
            const std::size_t at = 4 * (static_cast<std::size_t>(121 - y) * 162 + static_cast<std::size_t>(x));
            return shown[at] + shown[at + 1] + shown[at + 2];
        };
        EXPECT_LT(light(10, 10), 60) << device;
        EXPECT_GT(light(150, 110), 300) << device;
        EXPECT_GT(light(21, 10), 300) << device << ": a line between the first two regions, which are 20 pixels wide";
        EXPECT_LT(light(20, 10), 60) << device;
        EXPECT_LT(light(1, 1), 60) << device << ": none round the picture";
        EXPECT_GT(light(10, 21), 300) << device;
    }
}

TEST(PictureEdges, TakeWhatTheySay) {
    {
        Measured large("es3-mid", 1024, 768);
        EXPECT_LE(large.arena().use().capacity - large.arena().use().in_use, 160u);
        EXPECT_EQ(large.taken(), 16'384u) << "a strip of sixteen rows, a byte a pixel";
        EXPECT_TRUE(large.can_show());
    }
    Measured small("es2-small", 640, 480, false);
    EXPECT_LE(small.arena().use().capacity, 460'000u);
    EXPECT_EQ(small.taken(), 0u) << "nothing of the GPU where nothing is shown";
    EXPECT_FALSE(small.can_show());
}

TEST(PictureEdges, FitIntoTheShippedDevices) {
    for (const char* const name : {"es2-small", "sc2", "es3-mid", "desktop"}) {
        const effects::DeviceSettings device = test_support::shipped_device(name);
        EXPECT_GE(device.budget.find(effects::kPictureEdges)->bytes, PictureEdges::bytes(device.width_px, device.height_px))
            << name;
    }
    const auto room = [](const char* name) {
        return test_support::shipped_device(name).budget.find(effects::kPictureEdges)->bytes;
    };
    EXPECT_GE(room("es3-mid"), PictureEdges::bytes(1920, 1080)) << "larger pictures than the device's own are asked for";
    EXPECT_GE(room("sc2"), PictureEdges::bytes(800, 600));
}

TEST(PictureEdges, RefuseAPictureThatIsTooLargeOrABudgetThatIsTooSmall) {
    GlSession session("egl", "es2-small");
    std::vector<unsigned char> memory(PictureEdges::bytes(640, 480));
    const auto refusal = [&](std::size_t bytes, std::uint32_t width, std::uint64_t target_bytes, bool shows) {
        base::Arena arena(memory.data(), bytes);
        session.device.budget.find(effects::kRenderTargets)->bytes = target_bytes;
        PictureEdges edges;
        std::string message(
            edges.start(session.gl, session.device.budget, arena, width, width == 640 ? 480u : 64u, shows).message.view());
        edges.destroy(session.gl);
        return message;
    };
    EXPECT_EQ(refusal(memory.size(), 640, 20'000, true), "") << "control";
    EXPECT_NE(refusal(memory.size(), 9000, 20'000, false).find("8192"), std::string::npos);
    EXPECT_NE(refusal(memory.size() - 400, 640, 20'000, false).find("'picture_edges'"), std::string::npos);
    const std::string bytes = std::to_string(PictureEdges::bytes(640, 480));
    EXPECT_EQ(refusal(0, 640, 20'000, false),
              "clutter is measured, for which the device file has no budget line 'picture_edges'; add one of kind \"cpu\" with " +
                  bytes + " bytes");
    EXPECT_NE(refusal(memory.size(), 640, 10'000, true).find("'render_targets'"), std::string::npos);
    EXPECT_EQ(session.device.budget.find(effects::kRenderTargets)->use.in_use, 0u);
}

}  // namespace
}  // namespace tedavis::draw::test_picture_edges
