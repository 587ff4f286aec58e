/// The pictures of a knob's cheapest and of its most accurate level, with maps of their differences.
///
/// Colour is compared by CIEDE2000 (render_core/design/color_difference.hpp), perceived differences are FLIP
/// (measure/perceptual_difference.hpp). The maps are dark blue where the pictures agree and yellow at the greatest difference.
/// Lightness increases along this scale, so it can be read without colour vision.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "host_sim/accuracy/knobs/knob.hpp"
#include "host_sim/options/picture_options.hpp"
#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

/// A picture that belongs to a report: its bytes as PNG, and the name of its file in the report's folder.
struct ReportPicture {
    std::string file, png;
};

struct PictureErrors {
    double color_mean = 0, color_max = 0;          ///< CIEDE2000
    double perceived_mean = 0, perceived_max = 0;  ///< FLIP, 0..1
};

/// Where the cheap level's error is greatest.
struct PicturePlace {
    std::string pose;            ///< description of the pose
    std::string command;         ///< command that draws the cheap picture again
    std::uint32_t x = 0, y = 0;  ///< pixel, from the left and from the top
};

struct KnobPictures {
    std::string knob, cheap_level, exact_level;
    PicturePlace place;
    PictureErrors errors;
    std::string metric;     ///< with its unit
    double metric_max = 0;  ///< error that is yellow in metric_map
    ReportPicture cheap, exact, color_map, perceived_map, metric_map;
    ReportPicture cheap_crop, exact_crop;  ///< around the place, enlarged
};

/// The pictures with their names, for a constant or a mutable KnobPictures.
template <class Pictures>
[[nodiscard]] auto named_pictures(Pictures& pictures) {
    using Picture = std::remove_reference_t<decltype((pictures.cheap))>;
    return std::array<std::pair<const char*, Picture*>, 7>{{{"cheap", &pictures.cheap},
                                                            {"exact", &pictures.exact},
                                                            {"color_map", &pictures.color_map},
                                                            {"perceived_map", &pictures.perceived_map},
                                                            {"metric_map", &pictures.metric_map},
                                                            {"cheap_crop", &pictures.cheap_crop},
                                                            {"exact_crop", &pictures.exact_crop}}};
}

/// Compares both pictures, which have the same size. Throws UserError if the sizes differ.
[[nodiscard]] KnobPictures compare_pictures(const std::string& knob, const RgbaView& cheap, const RgbaView& exact,
                                            const PicturePlace& place);

/// Returns a picture of `values`, top row first, from dark blue at 0 to yellow at `full` and above.
[[nodiscard]] RgbaPicture error_map(const std::vector<double>& values, std::uint32_t width, double full);

/// Returns a map of errors that are known at some pixels only: each error fills a square of width x height / number of errors
/// pixels, yellow at the greatest. Where none is known the map is grey. `pixels` are the places of `errors`.
[[nodiscard]] RgbaPicture metric_map(const std::vector<double>& errors, const std::vector<KnobPixel>& pixels,
                                     const PictureSize& size);

/// Returns the square of `side` pixels round a place, each pixel drawn `factor` times as large; it lies within the picture.
[[nodiscard]] RgbaPicture enlarged_crop(const RgbaView& view, std::uint32_t x, std::uint32_t y, std::uint32_t side,
                                        std::uint32_t factor);

}  // namespace tedavis::host_sim
