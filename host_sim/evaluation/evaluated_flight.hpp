/// A run with the measures of its pictures, and its notable moments.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/evaluation/clutter_opinions.hpp"
#include "host_sim/evaluation/clutter_peaks.hpp"
#include "host_sim/evaluation/flight_run.hpp"
#include "host_sim/evaluation/picture_measures.hpp"

namespace tedavis::host_sim {

/// Views of one moment as bytes of small PNG files, for the report.
struct MomentViews {
    std::string picture, saliency, heat, edges, congestion;
};

/// The frame's plan: terms with their descriptions.
using PlanLines = std::vector<std::pair<std::string, std::string>>;

struct FlightMoment {
    std::string label;         ///< "A"
    std::size_t index = 0;     ///< of the frame in its flight
    double prominence = 0;     ///< of clutter; 0 for a flight without peaks, whose moment is its highest value
    std::string file;          ///< begin of the names of its view files in the evaluation's folder
    PlanLines plan;            ///< of its flight
    MomentViews views;         ///< of its flight
    ClutterOpinions opinions;  ///< of its flight
    std::size_t other = 0;     ///< index of the frame of the same time in the other flight, if there is one
    PlanLines other_plan;      ///< empty without another flight
    MomentViews other_views;
    ClutterOpinions other_opinions;
};

struct EvaluatedFlight {
    FlightRun run;                          ///< with as many frames as `measures`
    std::vector<PictureMeasures> measures;  ///< one per frame
    PeakRule peak_rule;
    std::vector<FlightMoment> moments;  ///< in the order of time
    bool interrupted = false;
};

/// Means and extremes over contiguous frames of one phase, or over all frames.
struct SpanSummary {
    std::string phase;
    std::size_t first = 0, end = 0;  ///< indices of frames
    double mean = 0, highest = 0;    ///< clutter
    std::size_t highest_at = 0;      ///< index
    std::vector<LayerShare> layers;  ///< means of the frames that have them; empty where none has
    /// The aspect with the greatest mean weight, of equal ones that with the greatest stated weight; empty where it differs
    /// between phases, or several are equal.
    std::string prioritized;
    std::string comes_first;  ///< the same in words: "terrain and data alike", "none"; empty where it differs between phases
};

[[nodiscard]] SpanSummary summary_of(const EvaluatedFlight& flight, std::size_t first, std::size_t end);
[[nodiscard]] std::vector<SpanSummary> summaries_by_phase(const EvaluatedFlight& flight);
/// Returns the saliency share of the layer of a span's prioritized aspect; nothing where either is unknown.
[[nodiscard]] std::optional<double> prioritized_share(const SpanSummary& span);

/// Mean over the frames that have a prioritized aspect and a layer of its name; nothing where none has.
[[nodiscard]] std::optional<double> mean_prioritized_share(const EvaluatedFlight& flight);

[[nodiscard]] std::vector<double> times_of(const EvaluatedFlight& flight);
[[nodiscard]] std::vector<double> clutter_of(const EvaluatedFlight& flight);
/// Compares the orders of the flight's moments.
[[nodiscard]] OpinionsAgreement agreement_over_moments(const EvaluatedFlight& flight);
/// Returns the mean clutter of each region over the flight.
[[nodiscard]] std::vector<double> mean_grid(const EvaluatedFlight& flight);

/// Returns the peaks of clutter, without plans and views, labelled A, B, ..., or B1, B2, ... with the prefix "B"; where there are
/// none, the highest value.
[[nodiscard]] std::vector<FlightMoment> moments_of(const EvaluatedFlight& flight, const std::string& prefix);

/// Returns "upper left", "middle", "lower right" ..., by the third of the picture in which a region lies.
[[nodiscard]] std::string region_name(const perception::RegionGrid& grid, int column, int row);
/// Returns the index of the region with the highest density of edges.
[[nodiscard]] std::size_t busiest_region(const std::vector<double>& densities);

}  // namespace tedavis::host_sim
