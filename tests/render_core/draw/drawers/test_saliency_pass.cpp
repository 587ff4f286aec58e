#include "render_core/draw/drawers/saliency_pass.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

#include "host_sim/png_file.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/readback.hpp"
#include "render_core/perception/saliency_model.hpp"
#include "tests/support/draw/screen_triangle.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/perception/rank_correlation.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_saliency_pass {
namespace {

using design::SaliencyScale;
using design::SaliencyView;
using test_support::GlSession;

/// RGBA, top row first.
struct Picture {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};
struct Map {
    std::uint32_t width = 0, height = 0;
    std::vector<double> values;  ///< top row first
    [[nodiscard]] double at(std::uint32_t x, std::uint32_t y) const { return values[std::size_t{y} * width + x]; }
    [[nodiscard]] double most() const { return *std::max_element(values.begin(), values.end()); }
};

Picture painted(std::uint32_t width, std::uint32_t height, const std::function<std::array<int, 3>(int, int)>& color) {
    Picture picture{width, height, {}};
    for (std::uint32_t y = 0; y < height; ++y)
        for (std::uint32_t x = 0; x < width; ++x) {
            for (const int channel : color(static_cast<int>(x), static_cast<int>(y)))
                picture.rgba.push_back(static_cast<std::uint8_t>(channel));
            picture.rgba.push_back(255);
        }
    return picture;
}

Picture shipped(const std::string& name) {
    const auto png = host_sim::read_png(test_support::source_dir() + "/tests/golden/pictures/" + name + ".png");
    return {png.width, png.height, png.pixels};
}

std::vector<std::uint8_t> flipped(const Picture& picture) {
    std::vector<std::uint8_t> rows;
    for (std::uint32_t y = picture.height; y-- > 0;) {
        const auto first = picture.rgba.begin() + std::ptrdiff_t{4} * picture.width * y;
        rows.insert(rows.end(), first, first + std::ptrdiff_t{4} * picture.width);
    }
    return rows;
}

/// Pictures of one size on a device's surface, and their maps.
class Measured {
public:
    Measured(const std::string& device, std::uint32_t width, std::uint32_t height)
        : session_("egl", device, width, height), triangle_(session_.gl) {
        budget_.bytes = std::uint64_t{4} * width * height;
        auto texture =
            gl::make_texture(session_.gl, budget_, {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, width, height});
        texture_ = static_cast<gl::Texture&&>(texture.value());
        EXPECT_EQ(pass_.start(session_.gl, session_.device.budget, width, height, true, true).message.view(), "");
        session_.gl.seal();
    }
    ~Measured() {
        EXPECT_EQ(session_.gl.denied().total, 0u);
        EXPECT_EQ(session_.gl.take_error(), GLenum{GL_NO_ERROR});
        session_.gl.retire();
        pass_.destroy(session_.gl);
        EXPECT_EQ(taken(), 0u);
        texture_.destroy(session_.gl);
        triangle_.destroy(session_.gl);
    }
    Measured(const Measured&) = delete;
    Measured& operator=(const Measured&) = delete;

    void put(const Picture& picture) {
        EXPECT_TRUE(texture_.upload(session_.gl, {0, 0, picture.width, picture.height}, flipped(picture).data()));
        gl::bind_surface(session_.gl, *session_.surface);
        session_.gl->Disable(GL_BLEND);
        triangle_.copy(session_.gl, texture_);
    }
    [[nodiscard]] Map map(const Picture& picture, SaliencyScale scale = SaliencyScale::picture) {
        put(picture);
        pass_.measure(session_.gl, *session_.surface, scale);
        const gl::TextureSettings& size = pass_.map().color().settings();
        std::vector<std::uint8_t> bytes(std::size_t{4} * size.width_px * size.height_px);
        pass_.map().bind(session_.gl);
        EXPECT_TRUE(gl::read_pixels(session_.gl, size.width_px, size.height_px, {bytes.data(), bytes.size()}));
        gl::bind_surface(session_.gl, *session_.surface);
        Map map{size.width_px, size.height_px, {}};
        for (std::size_t n = 0; n < bytes.size(); n += 4) map.values.push_back((256.0 * bytes[n] + bytes[n + 1]) / 65535);
        return map;
    }
    [[nodiscard]] std::vector<std::uint8_t> pixels() { return session_.pixels(); }
    void show(SaliencyView view) { pass_.show(session_.gl, view); }
    [[nodiscard]] std::uint64_t taken() { return session_.device.budget.find(effects::kRenderTargets)->use.in_use; }

private:
    GlSession session_;
    test_support::ScreenTriangle triangle_;
    base::BudgetLine budget_;
    gl::Texture texture_;
    SaliencyPass pass_;
};

/// The processor's, of full resolution.
Map reference(const Picture& picture, SaliencyScale scale, int start_level = 0) {
    const int width = static_cast<int>(picture.width), height = static_cast<int>(picture.height);
    std::vector<unsigned char> room(perception::SaliencyModel::bytes(width, height, 0) + 4096);
    base::Arena arena(room.data(), room.size());
    perception::SaliencyModel model;
    EXPECT_TRUE(model.start(arena, width, height, 0));
    EXPECT_TRUE(model.look(perception::packed_picture(picture.rgba.data(), width, height, 4), start_level));
    const perception::SaliencyMap made =
        model.map(scale == SaliencyScale::fixed ? perception::SaliencyScale::fixed : perception::SaliencyScale::per_picture);
    Map map{static_cast<std::uint32_t>(made.width), static_cast<std::uint32_t>(made.height), {}};
    map.values.assign(made.values.begin(), made.values.end());
    return map;
}

/// Means of 2 x 2.
Map halved(const Map& map) {
    Map half{map.width / 2, map.height / 2, {}};
    for (std::uint32_t y = 0; y < half.height; ++y)
        for (std::uint32_t x = 0; x < half.width; ++x)
            half.values.push_back(0.25 * (map.at(2 * x, 2 * y) + map.at(2 * x + 1, 2 * y) + map.at(2 * x, 2 * y + 1) +
                                          map.at(2 * x + 1, 2 * y + 1)));
    return half;
}

constexpr const char* kShipped[] = {"lambert",          "hypsometric_tints", "aerial_image", "hatching",
                                    "map_hill_shading", "contour_lines",     "silhouettes",  "tints_with_shade"};

/// Against the model on the same means of 4 x 4 levels, and against that of full resolution, from which those means differ.
TEST(SaliencyPass, RanksPlacesAsTheProcessorDoes) {
    Measured measured("es3-mid", 256, 192);
    for (const SaliencyScale scale : {SaliencyScale::picture, SaliencyScale::fixed}) {
        double sum = 0;
        for (const char* name : kShipped) {
            const Picture picture = shipped(name);
            const Map map = measured.map(picture, scale), whole = reference(picture, scale), means = reference(picture, scale, 2);
            const double to_whole = test_support::rank_correlation(map.values, whole.values);
            const double to_means = test_support::rank_correlation(map.values, means.values);
            // 0.998; in one picture a feature map is just at what may be noticed, where its weight jumps.
            EXPECT_GT(to_means, 0.94) << name;
            EXPECT_GT(to_whole, 0.85) << name;
            EXPECT_NEAR(map.most(), means.most(), 0.01) << name << ": the same scale";
            sum += to_whole;
        }
        EXPECT_GT(sum / std::size(kShipped), 0.97);
        const Map other = reference(shipped("map_contours"), scale), map = measured.map(shipped("lambert"), scale);
        EXPECT_LT(test_support::rank_correlation(map.values, other.values), 0.5) << "control";
    }
}

TEST(SaliencyPass, OnTheSmallLaneHalfAsFine) {
    Measured measured("es2-small", 256, 192);
    double sum = 0;
    for (const char* name : kShipped) {
        const Picture picture = shipped(name);
        const Map map = measured.map(picture), whole = halved(reference(picture, SaliencyScale::picture));
        const double to_whole = test_support::rank_correlation(map.values, whole.values);
        // 0.7 and more, but for thin lines on plain ground, which half as fine nearly vanish (contour_lines: 0.56).
        EXPECT_GT(to_whole, std::string(name) == "contour_lines" ? 0.5 : 0.7) << name;
        sum += to_whole;
    }
    EXPECT_GT(sum / std::size(kShipped), 0.8);
}

TEST(SaliencyPass, AFlatPictureHasNoSalientPlace) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        Measured measured(device, 133, 101);
        for (const std::array<int, 3> color : {std::array<int, 3>{0, 0, 0}, {255, 255, 255}, {127, 127, 127}, {30, 90, 201}}) {
            const Picture flat = painted(133, 101, [&](int, int) { return color; });
            EXPECT_EQ(measured.map(flat).most(), 0) << device;
            EXPECT_EQ(measured.map(flat, SaliencyScale::fixed).most(), 0) << device;
        }
    }
}

/// Green disks, one of them red.
TEST(SaliencyPass, TheOddDiskIsTheMostSalientPlace) {
    constexpr int kOddX = 2, kOddY = 1, kCell = 64;
    const Picture disks = painted(5 * kCell, 4 * kCell, [](int x, int y) -> std::array<int, 3> {
        const int across = x % kCell - kCell / 2, down = y % kCell - kCell / 2;
        if (across * across + down * down > 100) return {60, 60, 60};
        if (x / kCell == kOddX && y / kCell == kOddY) return {200, 40, 40};
        return {40, 150, 40};
    });
    for (const char* device : {"es3-mid", "es2-small"}) {
        Measured measured(device, disks.width, disks.height);
        const Map map = measured.map(disks);
        const auto most = static_cast<std::uint32_t>(std::max_element(map.values.begin(), map.values.end()) - map.values.begin());
        const std::uint32_t pixel = disks.width / map.width;
        EXPECT_EQ(most % map.width * pixel / kCell, std::uint32_t{kOddX}) << device;
        EXPECT_EQ(most / map.width * pixel / kCell, std::uint32_t{kOddY}) << device;
        EXPECT_EQ(map.most(), 1) << device;
    }
}

TEST(SaliencyPass, OnTheFixedScaleMoreContrastIsMore) {
    const auto disk = [](int level) {
        return painted(256, 192, [level](int x, int y) -> std::array<int, 3> {
            const int across = x - 128, down = y - 96;
            return across * across + down * down > 150 ? std::array<int, 3>{50, 50, 50} : std::array<int, 3>{level, level, level};
        });
    };
    Measured measured("es3-mid", 256, 192);
    EXPECT_LT(measured.map(disk(90), SaliencyScale::fixed).most(), 0.6 * measured.map(disk(200), SaliencyScale::fixed).most());
    EXPECT_EQ(measured.map(disk(90)).most(), 1) << "on its own scale";
}

TEST(SaliencyPass, ReadsThePictureAndLeavesItAsItIs) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        Measured measured(device, 256, 192);
        const Picture picture = shipped("aerial_image");
        measured.put(picture);
        const auto before = measured.pixels();
        const Map first = measured.map(picture);
        EXPECT_EQ(measured.pixels(), before) << device;
        EXPECT_EQ(measured.map(picture).values, first.values) << "again, to a bit";
        EXPECT_EQ(measured.map(picture, SaliencyScale::fixed).most() < 1, true);
        EXPECT_EQ(measured.map(picture).values, first.values) << "whatever was measured before";
        measured.show(SaliencyView::map);
        const auto shown = measured.pixels();
        EXPECT_EQ(shown[0], shown[1]);
        EXPECT_NE(shown, before);
    }
}

TEST(SaliencyPass, PicturesOfAnySizeHaveMaps) {
    struct Case {
        const char* device;
        std::uint32_t width, height;
    };
    for (const Case& at : {Case{"es3-mid", 16, 17}, {"es3-mid", 479, 131}, {"es2-small", 67, 45}}) {
        Measured measured(at.device, at.width, at.height);
        const Picture dot = painted(at.width, at.height, [](int x, int y) -> std::array<int, 3> {
            return x < 2 && y < 2 ? std::array<int, 3>{250, 250, 250} : std::array<int, 3>{20, 20, 20};
        });
        const Map map = measured.map(dot);
        EXPECT_EQ(map.most(), 1) << at.width;
        EXPECT_EQ(map.at(0, 0), 1) << at.width << ": from the top left";
    }
}

/// Beside the picture of the terrain, which has depth.
TEST(SaliencyPass, FitsTheShippedDevices) {
    for (const char* device : {"es3-mid", "es2-small"}) {
        const effects::DeviceSettings settings = test_support::shipped_device(device);
        Measured measured(device, settings.width_px, settings.height_px);
        const std::uint64_t picture = std::uint64_t{8} * settings.width_px * settings.height_px;
        EXPECT_LE(measured.taken() + picture, settings.budget.find(effects::kRenderTargets)->bytes) << device;
        EXPECT_EQ(measured.taken(), device == std::string("es2-small") ? 399'688u : 2'675'432u) << "as the device's file says";
    }
}

}  // namespace
}  // namespace tedavis::draw::test_saliency_pass
