#include "host_sim/accuracy/knob_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "host_sim/measure/lab_picture.hpp"
#include "host_sim/measure/perceptual_difference.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kFullColorDifference = 20;  ///< CIEDE2000 that is drawn in yellow
constexpr std::uint32_t kCropSide = 48, kCropFactor = 5;

/// Rises evenly in lightness, in colours that all kinds of colour vision tell apart.
constexpr std::array<std::array<double, 3>, 5> kRamp = {
    {{0, 32, 76}, {65, 77, 107}, {124, 123, 120}, {188, 175, 111}, {255, 233, 69}}};

std::array<std::uint8_t, 3> ramp_color(double share) {
    const double place = std::clamp(share, 0.0, 1.0) * (kRamp.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), kRamp.size() - 2);
    std::array<std::uint8_t, 3> color{};
    for (std::size_t n = 0; n < 3; ++n) {
        const double part = place - static_cast<double>(below);
        color[n] = static_cast<std::uint8_t>(std::lround((1 - part) * kRamp[below][n] + part * kRamp[below + 1][n]));
    }
    return color;
}

std::vector<double> color_differences(const RgbaView& first, const RgbaView& second) {
    const LabPicture a(first), b(second);
    std::vector<double> differences;
    differences.reserve(std::size_t{first.width} * first.height);
    for (std::uint32_t y = 0; y < first.height; ++y)
        for (std::uint32_t x = 0; x < first.width; ++x) differences.push_back(color_difference(a.at(x, y), b.at(x, y)));
    return differences;
}

ReportPicture report_picture(const std::string& knob, const char* what, const RgbaView& view) {
    return {knob + "-" + what + ".png", encode_small_png(view)};
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

KnobPictures compare_pictures(const std::string& knob, const RgbaView& cheap, const RgbaView& exact, const PicturePlace& place) {
    if (cheap.width != exact.width || cheap.height != exact.height || cheap.width == 0 || cheap.height == 0)
        throw UserError("pictures of different sizes, or of none, cannot be compared");
    const std::vector<double> colors = color_differences(cheap, exact);
    const PerceptualDifference perceived = perceptual_difference(cheap, exact);
    KnobPictures pictures;
    pictures.knob = knob;
    pictures.place = place;
    pictures.errors = {mean_of(colors), *std::max_element(colors.begin(), colors.end()), perceived.mean,
                       *std::max_element(perceived.map.begin(), perceived.map.end())};
    pictures.cheap = report_picture(knob, "cheap", cheap);
    pictures.exact = report_picture(knob, "exact", exact);
    pictures.color_map = report_picture(knob, "color", view_of(error_map(colors, cheap.width, kFullColorDifference)));
    pictures.perceived_map = report_picture(knob, "perceived", view_of(error_map(perceived.map, cheap.width, 1)));
    const auto crop = [&](const RgbaView& view) { return enlarged_crop(view, place.x, place.y, kCropSide, kCropFactor); };
    pictures.cheap_crop = report_picture(knob, "cheap-crop", view_of(crop(cheap)));
    pictures.exact_crop = report_picture(knob, "exact-crop", view_of(crop(exact)));
    return pictures;
}

RgbaPicture error_map(const std::vector<double>& values, std::uint32_t width, double full) {
    RgbaPicture map;
    map.width = width;
    map.height = static_cast<std::uint32_t>(values.size() / width);
    map.pixels.reserve(values.size() * 4);
    for (const double value : values) {
        const std::array<std::uint8_t, 3> color = ramp_color(value / full);
        map.pixels.insert(map.pixels.end(), color.begin(), color.end());
        map.pixels.push_back(255);
    }
    return map;
}

RgbaPicture metric_map(const std::vector<double>& errors, const std::vector<KnobPixel>& pixels, const PictureSize& size) {
    constexpr std::uint8_t kUnknown = 128;
    RgbaPicture map{size.width, size.height, std::vector<std::uint8_t>(std::size_t{size.width} * size.height * 4, kUnknown)};
    for (std::size_t n = 3; n < map.pixels.size(); n += 4) map.pixels[n] = 255;
    if (errors.empty()) return map;
    const double full = std::max(*std::max_element(errors.begin(), errors.end()), 1e-300);
    const double area = static_cast<double>(size.width) * size.height / static_cast<double>(errors.size());
    const auto side = static_cast<std::uint32_t>(std::max(1.0, std::floor(std::sqrt(area))));
    for (std::size_t n = 0; n < errors.size(); ++n) {
        const std::array<std::uint8_t, 3> color = ramp_color(errors[n] / full);
        const std::uint32_t left = pixels[n].x - std::min(pixels[n].x, side / 2),
                            top = pixels[n].y - std::min(pixels[n].y, side / 2);
        for (std::uint32_t y = top; y < std::min(top + side, size.height); ++y)
            for (std::uint32_t x = left; x < std::min(left + side, size.width); ++x)
                std::copy(color.begin(), color.end(),
                          map.pixels.begin() + static_cast<std::ptrdiff_t>((std::size_t{y} * size.width + x) * 4));
    }
    return map;
}

RgbaPicture enlarged_crop(const RgbaView& view, std::uint32_t x, std::uint32_t y, std::uint32_t side, std::uint32_t factor) {
    const auto begin = [side](std::uint32_t middle, std::uint32_t size) {
        const std::uint32_t half = side / 2, last = size - std::min(side, size);
        return std::min(middle > half ? middle - half : 0, last);
    };
    const std::uint32_t left = begin(x, view.width), top = begin(y, view.height);
    RgbaPicture crop;
    crop.width = std::min(side, view.width) * factor;
    crop.height = std::min(side, view.height) * factor;
    for (std::uint32_t row = 0; row < crop.height; ++row)
        for (std::uint32_t column = 0; column < crop.width; ++column) {
            const std::uint8_t* const p = view.row(top + row / factor) + std::size_t{left + column / factor} * 4;
            crop.pixels.insert(crop.pixels.end(), p, p + 4);
        }
    return crop;
}

}  // namespace tedavis::host_sim
