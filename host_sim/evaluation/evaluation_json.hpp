/// Writes `evaluation.json`, which is also the output of `evaluate --json`.
///
/// Of pictures: `pictures` [{`file`, `size`, `clutter`, `clutter_grid` (rows of regions from the upper left), `saliency_map` (a
/// PNG in the folder), `views`, `saliency_level`, `canny` {`sigma`, `low`, `high`}, `feature_congestion`, `subband_entropy`,
/// `layer_shares`, `gaze`}], `order_agreement` {`feature_congestion`, `subband_entropy`: each `pairs` of pictures that differ in
/// `clutter`, and how many of them are `alike` by that measure}, and, if orderings were given, their results
/// (picture_orderings.hpp). Of a flight: `run` and its description, `clutter` {`mean`, `highest`, `highest_s`}, `phases`, `peaks`
/// (with both other measures of clutter), `order_agreement` over them, and `pictures` of all frames, which also have `frame`,
/// `time_s` and `phase`; `saliency_map` is null except for peaks. Of two flights: `runs`, two such, and `differences`.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host_sim/evaluation/evaluate_pictures.hpp"
#include "host_sim/evaluation/flight_report.hpp"

namespace tedavis::host_sim {

[[nodiscard]] nlohmann::ordered_json pictures_json(const std::vector<EvaluatedPicture>& pictures,
                                                   const EvaluationSettings& settings, bool interrupted);
[[nodiscard]] nlohmann::ordered_json flights_json(const FlightReport& report);

/// Means over the pictures with gaze; null where there are none.
[[nodiscard]] nlohmann::ordered_json gaze_summary_json(const std::vector<const PictureMeasures*>& pictures);

}  // namespace tedavis::host_sim
