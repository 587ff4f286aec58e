#include "target/self_test/known_picture.hpp"

#include <array>
#include <cmath>
#include <cstdio>

#include "render_core/base/check.hpp"

namespace tedavis::target {
namespace {

struct Rgb {
    int r = 0, g = 0, b = 0;
};

/// Rows counted from the top, as one looks at it.
class Picture {
public:
    explicit Picture(base::Span<const std::uint8_t> pixels) : pixels_(pixels) {
        TEDAVIS_CHECK(pixels.size() == std::size_t{kKnownPictureWidth} * kKnownPictureHeight * 4);
    }
    [[nodiscard]] Rgb at(std::uint32_t x, std::uint32_t y) const {
        const std::size_t n = (std::size_t{kKnownPictureHeight - 1 - y} * kKnownPictureWidth + x) * 4;
        return {pixels_[n], pixels_[n + 1], pixels_[n + 2]};
    }

private:
    base::Span<const std::uint8_t> pixels_;
};

/// The mean colour of the 7 x 7 pixels about a place that no symbology covers.
struct KnownColor {
    const char* name;
    std::uint32_t x, y;
    Rgb expected;
};
constexpr int kColorTolerance = 14;
constexpr KnownColor kColors[] = {
    {"sky_high_left", 235, 108, {104, 151, 207}},    {"sky_high_right", 370, 70, {89, 137, 199}},
    {"sky_middle", 183, 135, {117, 162, 213}},       {"sky_low", 420, 200, {133, 176, 221}},
    {"haze_at_horizon", 190, 275, {98, 98, 102}},    {"terrain_far_left", 190, 340, {86, 98, 61}},
    {"terrain_far_right", 378, 322, {101, 112, 70}}, {"terrain_middle", 200, 320, {85, 96, 60}},
    {"terrain_near_left", 190, 385, {78, 91, 55}},   {"terrain_near_right", 380, 390, {73, 87, 51}},
};

/// Rows in which the terrain begins, cast from the elevation raster (tests/target/self_test/test_known_picture.cpp).
struct KnownSkyline {
    std::uint32_t x, y;
};
constexpr int kSkylineTolerance_px = 2;
constexpr KnownSkyline kSkyline[] = {{180, 285}, {210, 284}, {240, 283}, {280, 282}, {380, 281}, {420, 279}, {440, 280}};

using Belongs = bool (*)(Rgb);
bool is_white(Rgb c) { return c.r > 200 && c.g > 200 && c.b > 200; }
bool is_green(Rgb c) { return c.g > 180 && c.r < 120 && c.b < 170; }
bool is_yellow(Rgb c) { return c.r > 200 && c.g > 170 && c.b < 60; }
bool is_terrain(Rgb c) { return c.g > c.r + 4 && c.g > c.b + 2 && c.g < 140; }  // the sky and its haze are blue

/// How many pixels of a text's or symbol's colour its box holds.
struct KnownSymbol {
    const char* name;
    std::uint32_t left, top, right, bottom;
    Belongs belongs;
    std::size_t expected;
};
constexpr KnownSymbol kSymbols[] = {
    {"text_phase", 8, 8, 222, 27, &is_green, 536},         {"text_airspeed", 6, 221, 90, 249, &is_white, 400},
    {"text_altitude", 466, 221, 564, 249, &is_white, 478}, {"text_heading", 294, 341, 346, 366, &is_white, 328},
    {"text_advisory", 240, 456, 400, 474, &is_white, 430}, {"attitude_reference", 240, 230, 400, 255, &is_yellow, 198},
};

void check_color(const Picture& picture, const KnownColor& known, SelfTestReport& report) {
    constexpr std::uint32_t kReach = 3;
    Rgb sum;
    for (std::uint32_t y = known.y - kReach; y <= known.y + kReach; ++y)
        for (std::uint32_t x = known.x - kReach; x <= known.x + kReach; ++x) {
            const Rgb c = picture.at(x, y);
            sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b};
        }
    constexpr int kPixels = (2 * kReach + 1) * (2 * kReach + 1);
    const Rgb mean{sum.r / kPixels, sum.g / kPixels, sum.b / kPixels};
    const auto near = [](int a, int b) { return std::abs(a - b) <= kColorTolerance; };
    const Rgb& e = known.expected;
    const bool holds = near(mean.r, e.r) && near(mean.g, e.g) && near(mean.b, e.b);
    char text[120];
    std::snprintf(text, sizeof text, "(%u, %u) is %d %d %d, expected %d %d %d +- %d", known.x, known.y, mean.r, mean.g, mean.b,
                  e.r, e.g, e.b, kColorTolerance);
    report.add(known.name, holds, text);
}

/// The first row below the horizon line in which this column shows terrain; the height of the picture for none.
std::uint32_t first_terrain_row(const Picture& picture, std::uint32_t x) {
    constexpr std::uint32_t kBelowHorizonLine = 260;
    for (std::uint32_t y = kBelowHorizonLine; y < kKnownPictureHeight; ++y)
        if (is_terrain(picture.at(x, y))) return y;
    return kKnownPictureHeight;
}

void check_skyline(const Picture& picture, SelfTestReport& report) {
    int worst = 0;
    std::uint32_t worst_x = 0;
    for (const KnownSkyline& known : kSkyline) {
        const int off = std::abs(static_cast<int>(first_terrain_row(picture, known.x)) - static_cast<int>(known.y));
        if (off < worst) continue;
        worst = off;
        worst_x = known.x;
    }
    char text[120];
    std::snprintf(text, sizeof text, "off by %d px at most, in column %u, expected %d at most", worst, worst_x,
                  kSkylineTolerance_px);
    report.add("skyline", worst <= kSkylineTolerance_px, text);
}

void check_symbol(const Picture& picture, const KnownSymbol& known, SelfTestReport& report) {
    std::size_t found = 0;
    for (std::uint32_t y = known.top; y < known.bottom; ++y)
        for (std::uint32_t x = known.left; x < known.right; ++x) found += known.belongs(picture.at(x, y)) ? 1u : 0u;
    // Antialiasing of another driver moves pixels across the limit of the colour.
    report.add_count(known.name, found, known.expected * 2 / 3, known.expected * 3 / 2);
}

/// Colours at four bits a channel.
std::size_t distinct_colors(const Picture& picture) {
    std::array<bool, 4096> seen{};
    std::size_t count = 0;
    for (std::uint32_t y = 0; y < kKnownPictureHeight; ++y)
        for (std::uint32_t x = 0; x < kKnownPictureWidth; ++x) {
            const Rgb c = picture.at(x, y);
            const int index = c.r / 16 * 256 + c.g / 16 * 16 + c.b / 16;
            bool& mark = seen[static_cast<std::size_t>(index)];
            count += mark ? 0u : 1u;
            mark = true;
        }
    return count;
}

}  // namespace

void check_known_picture(base::Span<const std::uint8_t> pixels, SelfTestReport& report) {
    const Picture picture(pixels);
    report.add_count("picture_colors", distinct_colors(picture), 100, 400);
    for (const KnownColor& known : kColors) check_color(picture, known, report);
    check_skyline(picture, report);
    for (const KnownSymbol& known : kSymbols) check_symbol(picture, known, report);
}

}  // namespace tedavis::target
