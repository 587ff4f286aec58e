/// `sweep.json`, which is also the output of `sweep --json`, and the same as text.
///
/// `place` {`lat_deg`, `lon_deg`, `alt_msl_m`, `radius_m`}, `terrain`, `scene`, `design`, `device`, `gl`, `interrupted`; `views`
/// [{`file`, `bearing_deg`, `distance_m`, `height_m`, `pose`, `hash`, `clutter`, `saliency_level`, `layer_shares`, `place`
/// {`sight`: seen, behind terrain, outside the picture; of the picture without symbology `x_px`, `y_px`, `radius_px`, `share` of
/// all saliency, `area` of all pixels, `times_mean`: the one by the other, `rank`: share of the pixels that draw the eye less
/// than its strongest one; null outside the picture}}], `skipped` [{`bearing_deg`, `distance_m`, `height_m`, `reason`}],
/// `standing_out` [{`what`, `file`, `clutter`, `feature_congestion`, `subband_entropy`, `sheet`}].
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "host_sim/sweep/swept_views.hpp"

namespace tedavis::host_sim {

[[nodiscard]] nlohmann::ordered_json sweep_json(const Sweep& sweep);
/// Returns one line per viewpoint, in columns, and the views that stand out.
[[nodiscard]] std::string sweep_text(const Sweep& sweep);

}  // namespace tedavis::host_sim
