/// The pictures that an evaluation writes for one picture.
#pragma once

#include <string>
#include <vector>

#include "host_sim/evaluation/evaluated_flight.hpp"
#include "host_sim/evaluation/picture_meter.hpp"

namespace tedavis::host_sim {

/// Names in the evaluation's folder: NAME.saliency.png ...
struct ViewFiles {
    std::string saliency, heat, edges, regions, congestion, second_opinion, sheet;
};
[[nodiscard]] ViewFiles view_files(const std::string& name);
[[nodiscard]] std::vector<std::string> all_view_files(const std::string& name);

/// All views in the picture's size.
struct PictureViews {
    RgbaPicture saliency, heat, edges, regions, congestion, second_opinion;
};
/// Draws the views of the picture that the meter measured last. `congestion` is its map of Feature Congestion
/// (clutter_opinions.hpp).
[[nodiscard]] PictureViews picture_views(const RgbaPicture& picture, PictureMeter& meter, const PictureMeasures& measures,
                                         const FloatMap& congestion, const EvaluationSettings& settings);
/// Picture and views side by side, with labels and numbers.
[[nodiscard]] RgbaPicture views_sheet(const std::string& title, const RgbaPicture& picture, const PictureViews& views,
                                      const PictureMeasures& measures);

/// Writes them, and the sheet, each whole or not at all; throws UserError.
void write_views(const std::string& folder, const std::string& name, const std::string& title, const RgbaPicture& picture,
                 const PictureViews& views, const PictureMeasures& measures);
/// Returns the bytes of small PNG files for a page.
[[nodiscard]] MomentViews small_views(const RgbaPicture& picture, const PictureViews& views);

}  // namespace tedavis::host_sim
