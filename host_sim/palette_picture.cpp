#include "host_sim/palette_picture.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::host_sim {
namespace {

struct CountedColor {
    PaletteColor color;
    double count;
};

/// Colors `begin` to `end` of a list, as what is known of them.
struct ColorBox {
    std::size_t begin, end;
    std::array<double, 3> mean{};
    double squared_error = 0;  ///< of all pixels against the mean
    std::size_t channel = 0;   ///< that varies most
};

std::vector<CountedColor> counted_colors(const RgbaView& view) {
    std::vector<PaletteColor> all;
    all.reserve(std::size_t{view.width} * view.height);
    for (std::uint32_t y = 0; y < view.height; ++y)
        for (const std::uint8_t *at = view.row(y), *end = at + std::size_t{view.width} * 4; at != end; at += 4)
            all.push_back({at[0], at[1], at[2]});
    std::sort(all.begin(), all.end());
    std::vector<CountedColor> counted;
    for (const PaletteColor& color : all) {
        if (counted.empty() || counted.back().color != color) counted.push_back({color, 0});
        counted.back().count += 1;
    }
    return counted;
}

ColorBox measured_box(const std::vector<CountedColor>& colors, std::size_t begin, std::size_t end) {
    ColorBox box{begin, end};
    std::array<double, 3> sums{}, squares{};
    double count = 0;
    for (std::size_t n = begin; n < end; ++n) {
        count += colors[n].count;
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = colors[n].color[c];
            sums[c] += colors[n].count * value;
            squares[c] += colors[n].count * value * value;
        }
    }
    std::array<double, 3> errors{};
    for (std::size_t c = 0; c < 3; ++c) {
        box.mean[c] = sums[c] / count;
        errors[c] = squares[c] - sums[c] * box.mean[c];
        box.squared_error += errors[c];
    }
    box.channel = static_cast<std::size_t>(std::max_element(errors.begin(), errors.end()) - errors.begin());
    if (end - begin == 1) box.squared_error = 0;  // what rounding leaves is nothing to divide
    return box;
}

/// Moves colors within the box, so that those up to the mean come first; returns the second part.
ColorBox divide(std::vector<CountedColor>& colors, ColorBox& box) {
    const auto first = colors.begin() + static_cast<std::ptrdiff_t>(box.begin);
    const auto last = colors.begin() + static_cast<std::ptrdiff_t>(box.end);
    const auto middle = std::partition(
        first, last, [&](const CountedColor& counted) { return counted.color[box.channel] <= box.mean[box.channel]; });
    const std::size_t at = static_cast<std::size_t>(middle - colors.begin()), end = box.end;
    box = measured_box(colors, box.begin, at);
    return measured_box(colors, at, end);
}

std::vector<ColorBox> divided(std::vector<CountedColor>& colors, std::size_t max_colors) {
    std::vector<ColorBox> boxes{measured_box(colors, 0, colors.size())};
    while (boxes.size() < max_colors) {
        const auto worst = std::max_element(
            boxes.begin(), boxes.end(), [](const ColorBox& a, const ColorBox& b) { return a.squared_error < b.squared_error; });
        if (worst->squared_error <= 0) break;
        const ColorBox second = divide(colors, *worst);
        boxes.push_back(second);
    }
    return boxes;
}

}  // namespace

PalettePicture with_palette(const RgbaView& view, std::size_t max_colors) {
    std::vector<CountedColor> colors = counted_colors(view);
    PalettePicture picture{view.width, view.height, {}, {}};
    std::vector<std::pair<PaletteColor, std::uint8_t>> places;
    for (const ColorBox& box : divided(colors, max_colors)) {
        const auto place = static_cast<std::uint8_t>(picture.colors.size());
        PaletteColor& mean = picture.colors.emplace_back();
        for (std::size_t c = 0; c < 3; ++c) mean[c] = static_cast<std::uint8_t>(std::lround(box.mean[c]));
        for (std::size_t n = box.begin; n < box.end; ++n) places.emplace_back(colors[n].color, place);
    }
    std::sort(places.begin(), places.end());
    picture.pixels.reserve(std::size_t{view.width} * view.height);
    for (std::uint32_t y = 0; y < view.height; ++y)
        for (const std::uint8_t *at = view.row(y), *end = at + std::size_t{view.width} * 4; at != end; at += 4) {
            const std::pair<PaletteColor, std::uint8_t> first_of_color{{at[0], at[1], at[2]}, 0};
            picture.pixels.push_back(std::lower_bound(places.begin(), places.end(), first_of_color)->second);
        }
    return picture;
}

}  // namespace tedavis::host_sim
