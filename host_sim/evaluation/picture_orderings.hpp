/// Compares published orderings of pairs of pictures with measured values.
///
///     title = "Clutter and saliency as the thesis found them"
///     [canny]                          by which edges their clutter was measured; absent: the default
///     sigma = 1
///     low = 6
///     high = 15
///     [[ordering]]
///     title = "Terrain first is more cluttered than data first"
///     source = "figure 5.17"
///     measure = "clutter"              or "share.LAYER": of the saliency, that layer's
///     more = "priority/terrain.png"    the end of a picture's path
///     less = "priority/data.png"
///     thesis = [0.25, 0.18]            what was reported of both; absent: that there is more
///     alike_within = 0.03              they are said to be alike: neither is more by more than this
///
/// Both pictures must be among the measured ones for an ordering to be judged.
#pragma once

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "render_core/perception/edge_detector.hpp"

namespace tedavis::host_sim {

struct PictureOrdering {
    std::string title, source;
    std::string layer;  ///< whose share of the saliency is compared; empty: the clutter is
    std::string more, less;
    std::optional<std::array<double, 2>> reported;
    std::optional<double> alike_within;
};

struct PictureOrderings {
    std::string title;
    std::optional<perception::CannySettings> canny;
    std::vector<PictureOrdering> orderings;
};

/// Throws UserError with file and line.
[[nodiscard]] PictureOrderings read_orderings(const std::string& path);

/// The measures of a picture that orderings compare.
struct OrderedPicture {
    std::string file;
    double clutter = 0;
    std::vector<std::pair<std::string, double>> shares;  ///< of the saliency by layer; empty without layers
};

enum class OrderingState : std::uint8_t {
    holds,
    differs,
    missing,  ///< a picture, or its layers, were not measured
};

struct JudgedOrdering {
    PictureOrdering ordering;
    OrderingState state = OrderingState::missing;
    double more = 0, less = 0;  ///< our values; 0 where missing
};

[[nodiscard]] std::vector<JudgedOrdering> judged(const PictureOrderings& orderings, const std::vector<OrderedPicture>& pictures);

/// Text with one line per ordering, in columns.
[[nodiscard]] std::string orderings_text(const std::vector<JudgedOrdering>& judged);
/// A list of {`title`, `source`, `measure`, `more`, `less`, `reported`, `ours`, `state`}.
[[nodiscard]] nlohmann::ordered_json orderings_json(const std::vector<JudgedOrdering>& judged);

}  // namespace tedavis::host_sim
