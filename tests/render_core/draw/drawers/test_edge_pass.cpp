#include "render_core/draw/drawers/edge_pass.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "host_sim/png_file.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/readback.hpp"
#include "render_core/perception/edge_density.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/perception/held_edges.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/programs/headless_backends.hpp"

namespace tedavis::draw::test_edge_pass {
namespace {

using perception::CannySettings;
using test_support::GlSession;
using test_support::Rgb;
using test_support::SyntheticPicture;
using Edges = std::vector<bool>;  ///< a pixel each, rows from the top
using Densities = std::array<double, 48>;

constexpr const char* kDevices[] = {"es3-mid", "es2-small"};
constexpr CannySettings kDefault{}, kStrongAlone{1, 170, 170};

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

/// Pictures of one size on a device's surface, and their edges.
class Measured {
public:
    Measured(const std::string& device, int width, int height, bool shows = true, const std::string& backend = "egl")
        : session_(backend, device, static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)),
          triangle_(session_.gl),
          width_(static_cast<std::uint32_t>(width)),
          height_(static_cast<std::uint32_t>(height)) {
        budget_.bytes = std::uint64_t{4} * width_ * height_;
        session_.device.budget.find(effects::kRenderTargets)->bytes = std::uint64_t{1} << 25;
        auto texture =
            gl::make_texture(session_.gl, budget_, {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, width_, height_});
        texture_ = static_cast<gl::Texture&&>(texture.value());
        EXPECT_EQ(pass_.start(session_.gl, session_.device.budget, width_, height_, shows).message.view(), "");
        session_.gl.seal();
    }
    ~Measured() {
        EXPECT_EQ(session_.gl.denied().total, 0u);
        EXPECT_EQ(session_.gl.take_error(), GLenum{GL_NO_ERROR});
        session_.gl.retire();
        pass_.destroy(session_.gl);
        EXPECT_EQ(taken(), 0u);
        EXPECT_FALSE(pass_.is_started());
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
    void measure() { pass_.measure(session_.gl, *session_.surface); }
    void show(EdgeView view) { pass_.show(session_.gl, view); }
    [[nodiscard]] bool can_show() const { return pass_.can_show(); }
    /// As the view shows them, which is read from the surface.
    [[nodiscard]] Edges edges(const SyntheticPicture& picture) {
        put(picture);
        measure();
        show(EdgeView::edges);
        const std::vector<std::uint8_t> shown = pixels();
        Edges edges;
        for (std::uint32_t y = height_; y-- > 0;)
            for (std::uint32_t x = 0; x < width_; ++x) edges.push_back(shown[4 * (std::size_t{y} * width_ + x)] == 255);
        return edges;
    }
    [[nodiscard]] effects::ClutterMap densities() { return pass_.densities(session_.gl, *session_.surface); }
    [[nodiscard]] std::vector<std::uint8_t> pixels() { return session_.pixels(); }
    [[nodiscard]] std::uint64_t taken() { return session_.device.budget.find(effects::kRenderTargets)->use.in_use; }

private:
    GlSession session_;
    test_support::ScreenTriangle triangle_;
    std::uint32_t width_, height_;
    base::BudgetLine budget_;
    gl::Texture texture_;
    EdgePass pass_;
};

Edges as_edges(const std::vector<std::uint8_t>& bytes) { return {bytes.begin(), bytes.end()}; }
Edges processors(const SyntheticPicture& picture, const CannySettings& settings = kDefault) {
    return as_edges(test_support::edges_of(picture, settings));
}

Densities densities_of(const Edges& edges, int width, int height) {
    const std::vector<std::uint8_t> bytes(edges.begin(), edges.end());
    Densities densities{};
    EXPECT_TRUE(perception::region_densities({bytes, width, height}, {8, 6}, densities));
    return densities;
}

/// Harmonic mean of precision and recall.
double f1(const Edges& found, const Edges& expected) {
    std::size_t both = 0, all = 0;
    for (std::size_t n = 0; n < found.size(); ++n) {
        both += found[n] && expected[n] ? 1 : 0;
        all += (found[n] ? 1 : 0) + (expected[n] ? 1 : 0);
    }
    return all == 0 ? 1 : 2.0 * static_cast<double>(both) / static_cast<double>(all);
}

bool is_within(const Edges& some, const Edges& all) {
    for (std::size_t n = 0; n < some.size(); ++n)
        if (some[n] && !all[n]) return false;
    return true;
}

/// How far edges are from the processor's, over pictures.
struct Agreement {
    double least_f1 = 1, sum_f1 = 0, most_off = 0, sum_off = 0;
    int pictures = 0, regions = 0, near_regions = 0;  ///< near: within 0.01

    void add(const Edges& found, const SyntheticPicture& picture) {
        const Edges expected = processors(picture);
        const Densities densities = densities_of(found, picture.width, picture.height);
        const Densities expected_densities = densities_of(expected, picture.width, picture.height);
        for (std::size_t n = 0; n < densities.size(); ++n) {
            const double off = std::fabs(densities[n] - expected_densities[n]);
            most_off = std::max(most_off, off);
            sum_off += off;
            ++regions;
            near_regions += off <= 0.01 ? 1 : 0;
        }
        const double same = f1(found, expected);
        least_f1 = std::min(least_f1, same);
        sum_f1 += same;
        ++pictures;
    }
    [[nodiscard]] double mean_f1() const { return sum_f1 / pictures; }
    [[nodiscard]] double mean_off() const { return sum_off / regions; }
    [[nodiscard]] double share_near() const { return static_cast<double>(near_regions) / regions; }
    [[nodiscard]] bool is_good() const { return mean_f1() > 0.98 && mean_off() < 0.001 && share_near() > 0.97; }
};

/// What is an edge is the processor's to a pixel, but for edges that are followed no further.
TEST(EdgePass, FindsTheProcessorsEdgesInTheShippedPictures) {
    const std::vector<SyntheticPicture> pictures = shipped_pictures();
    ASSERT_GE(pictures.size(), 30u);
    std::vector<Edges> first;
    for (const char* device : kDevices) {
        Measured measured(device, 256, 192);
        Agreement agreement, strong_alone;
        for (const SyntheticPicture& picture : pictures) {
            const Edges found = measured.edges(picture), strong = processors(picture, kStrongAlone);
            EXPECT_TRUE(is_within(found, processors(picture)));
            EXPECT_TRUE(is_within(strong, found));
            agreement.add(found, picture);
            strong_alone.add(strong, picture);
            const Densities expected = densities_of(found, picture.width, picture.height);
            const effects::ClutterMap map = measured.densities();
            ASSERT_TRUE(map.is_known);
            for (std::size_t n = 0; n < expected.size(); ++n)
                EXPECT_EQ(map.measure[n], static_cast<float>(expected[n])) << device << " region " << n;
            if (device == kDevices[0])
                first.push_back(found);
            else
                EXPECT_EQ(found, first[static_cast<std::size_t>(agreement.pictures) - 1]) << "both lanes, in other strips";
        }
        EXPECT_TRUE(agreement.is_good()) << device << ": F1 " << agreement.mean_f1() << " and " << agreement.least_f1
                                         << " at least; regions off by " << agreement.mean_off() << ", at most "
                                         << agreement.most_off << "; within 0.01: " << agreement.share_near();
        EXPECT_GT(agreement.least_f1, 0.8) << device;
        EXPECT_LT(agreement.most_off, 0.1) << device;
        EXPECT_FALSE(strong_alone.is_good()) << "control: without what is connected";
    }
}

/// Where all that is connected lies near what is strong: noise, whose edges are short, and patches of colour.
TEST(EdgePass, ShortEdgesAreTheProcessorsToAPixel) {
    struct Case {
        const char* device;
        SyntheticPicture picture;
    };
    const Case cases[] = {
        {"es3-mid", test_support::checkerboard(133, 101, 16)},       {"es2-small", test_support::checkerboard(133, 101, 16)},
        {"es3-mid", test_support::noise_picture(97, 131, 5)},        {"es2-small", test_support::noise_picture(97, 131, 5)},
        {"es3-mid", test_support::noise_picture(64, 64, 8, 90, 60)}, {"es2-small", test_support::noise_picture(18, 70, 9)},
        {"es3-mid", test_support::noise_picture(16, 17, 1)},         {"es2-small", test_support::noise_picture(19, 16, 1)},
        {"es2-small", test_support::noise_picture(63, 33, 2)},       {"es3-mid", test_support::noise_picture(2101, 18, 3)}};
    for (const Case& at : cases) {
        const SyntheticPicture& picture = at.picture;
        Measured measured(at.device, picture.width, picture.height);
        const Edges found = measured.edges(picture), expected = processors(picture);
        EXPECT_EQ(found, expected) << at.device << " " << picture.width << " x " << picture.height << ": F1 "
                                   << f1(found, expected);
        const Densities densities = densities_of(expected, picture.width, picture.height);
        const effects::ClutterMap map = measured.densities();
        for (std::size_t n = 0; n < densities.size(); ++n) EXPECT_EQ(map.measure[n], static_cast<float>(densities[n])) << n;
        const SyntheticPicture mirrored = picture.mirrored();
        EXPECT_GT(f1(measured.edges(mirrored), processors(mirrored)), 0.999) << at.device << " mirrored";
    }
}

TEST(EdgePass, AFlatPictureHasNoEdgeAndAStepOneLine) {
    for (const char* device : kDevices) {
        Measured measured(device, 96, 100);
        for (const Rgb& color : {Rgb{0, 0, 0}, Rgb{255, 255, 255}, Rgb{30, 90, 201}}) {
            const Edges none = measured.edges(test_support::flat_picture(96, 100, color));
            EXPECT_EQ(std::count(none.begin(), none.end(), true), 0) << device;
            for (const float density : measured.densities().measure) EXPECT_EQ(density, 0) << device;
        }
        const SyntheticPicture step(96, 100, [](int, int y) { return y < 37 ? Rgb{20, 20, 20} : Rgb{20, 220, 20}; });
        const Edges line = measured.edges(step);
        EXPECT_EQ(std::count(line.begin(), line.end(), true), 96) << device;
        EXPECT_EQ(std::count(line.begin() + 36 * 96, line.begin() + 38 * 96, true), 96) << device;
    }
}

/// A line that is weak but for its left end.
TEST(EdgePass, FollowsAnEdgeSoFarAsItSays) {
    constexpr int kWidth = 256, kReach = 4 * EdgePass::kIterations;
    const SyntheticPicture line(kWidth, 16, [](int x, int y) {
        const auto level = static_cast<std::uint8_t>(y < 8 ? 100 : x < 6 ? 200 : 140);
        return Rgb{level, level, level};
    });
    const auto reach = [](const Edges& edges) {
        int x = 0;
        while (x < kWidth && (edges[std::size_t{7} * kWidth + static_cast<std::size_t>(x)] ||
                              edges[std::size_t{8} * kWidth + static_cast<std::size_t>(x)]))
            ++x;
        return x;
    };
    ASSERT_EQ(reach(processors(line)), kWidth);
    ASSERT_LT(reach(processors(line, kStrongAlone)), 12);
    for (const char* device : kDevices) {
        Measured measured(device, kWidth, 16);
        const int reached = reach(measured.edges(line));
        EXPECT_GE(reached, kReach) << device;
        EXPECT_LT(reached, kReach + 16) << device;
    }
}

TEST(EdgePass, FindsTheSameOnEveryBackend) {
    const SyntheticPicture picture = test_support::landscape(260, 150, 7);
    const Edges expected = Measured("es3-mid", 260, 150).edges(picture);
    EXPECT_GT(f1(expected, processors(picture)), 0.98);
    for (const std::string& backend : test_support::headless_backends())
        for (const char* device : kDevices)
            EXPECT_EQ(Measured(device, 260, 150, true, backend).edges(picture), expected) << backend << " " << device;
}

TEST(EdgePass, ReadsThePictureAndLeavesItAsItIs) {
    const SyntheticPicture picture = test_support::landscape(150, 110, 3), other = test_support::noise_picture(150, 110, 4);
    for (const char* device : kDevices) {
        Measured measured(device, 150, 110);
        EXPECT_FALSE(measured.densities().is_known) << "before anything was measured";
        measured.put(picture);
        const auto before = measured.pixels();
        measured.measure();
        EXPECT_EQ(measured.pixels(), before) << device;
        const auto densities = measured.densities().measure;
        EXPECT_EQ(measured.pixels(), before) << device << ": the surface is bound";
        measured.put(other);
        measured.measure();
        EXPECT_NE(measured.densities().measure, densities) << device;
        measured.put(picture);
        measured.measure();
        EXPECT_EQ(measured.densities().measure, densities) << "whatever was measured before";
    }
}

/// Left half flat, right half noise.
TEST(EdgePass, RegionsAreTintedTheLighterTheDenser) {
    const SyntheticPicture noise = test_support::noise_picture(162, 122, 2);
    const SyntheticPicture picture(162, 122, [&](int x, int y) { return x < 81 ? Rgb{90, 90, 90} : noise.at(x, y); });
    for (const char* device : kDevices) {
        Measured measured(device, 162, 122);
        measured.put(picture);
        measured.measure();
        const SyntheticPicture black = test_support::flat_picture(162, 122, {0, 0, 0});
        measured.put(black);
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

TEST(EdgePass, TakesWhatItSaysAndMakesWhatIsShownAlone) {
    {
        Measured large("es3-mid", 1024, 768);
        EXPECT_EQ(large.taken(), 1'928'720u);
        EXPECT_TRUE(large.can_show());
    }
    Measured small("es2-small", 640, 480, false);
    EXPECT_EQ(small.taken(), 620'816u);
    EXPECT_FALSE(small.can_show());
}

TEST(EdgePass, RefusesAPictureThatIsTooLargeOrABudgetThatIsTooSmall) {
    GlSession session("egl", "es2-small");
    EdgePass pass;
    EXPECT_FALSE(pass.is_started());
    EXPECT_NE(pass.start(session.gl, session.device.budget, 9000, 64, false).message.view().find("8192"), std::string_view::npos);
    session.device.budget.find(effects::kRenderTargets)->bytes = 100'000;
    EXPECT_NE(pass.start(session.gl, session.device.budget, 640, 480, false).message.view().find("render_targets"),
              std::string_view::npos);
    pass.destroy(session.gl);
    EXPECT_EQ(session.device.budget.find(effects::kRenderTargets)->use.in_use, 0u);
}

}  // namespace
}  // namespace tedavis::draw::test_edge_pass
