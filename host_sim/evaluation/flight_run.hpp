/// Reads the data of a run of `replay` that its evaluation needs: time and phase of each picture, and the aspect with the
/// greatest weight.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/reports/run_frames.hpp"

namespace tedavis::host_sim {

/// An obstacle near the predicted track, from the record.
struct FrameObstacle {
    std::string name;             ///< as the scene has it, or its layer and number
    std::string state;            ///< "drawn", "hidden" by terrain, "left_out", "out_of_view"
    double ahead_s = 0;           ///< time of flight until it is reached
    std::array<double, 4> box{};  ///< left, top, right, bottom in pixels; only of state "drawn"
};

/// The weight of an aspect, 0 to 1: in the frame, where hazards ahead may raise it, and as the design states it.
struct AspectWeight {
    double weight = 0, stated = 0;
};
inline constexpr std::array<const char*, 3> kMainAspectNames = {"terrain", "data", "uncertainty"};
using MainWeights = std::array<AspectWeight, kMainAspectNames.size()>;

/// Returns the aspects with the greatest weight, and among equal ones those with the greatest stated weight. Empty where every
/// weight is 0.
[[nodiscard]] std::vector<std::string> first_aspects(const MainWeights& weights);

/// A frame whose picture file exists.
struct FlightFrame : RunFrame {
    std::string phase_source;  ///< as in the record
    /// The aspect with the greatest weight, where one is greater than the others: "terrain", "data", "uncertainty".
    std::string prioritized;
    MainWeights weights;
    std::vector<std::string> layers;    ///< names by the values of the layer mask beside the picture; empty: there is none
    std::string design;                 ///< name of the design with which it was drawn
    std::string light;                  ///< of its symbology: "day", "night"; of the summary where the record has none; or empty
    bool has_scene = false;             ///< the run has spatial data
    bool has_accuracy_overlay = false;  ///< its picture has the accuracy overlay
    /// Obstacles near the predicted track; nothing where the run did not record them.
    std::optional<std::vector<FrameObstacle>> obstacles;
};

struct FlightRun {
    std::string folder;
    std::string log, design, device, size;  ///< of its summary; empty where it has none
    std::string palette, light;             ///< of the symbology, likewise
    std::vector<FlightFrame> frames;        ///< in the order of time
};

/// Converts a record to a frame, without number, time and picture.
[[nodiscard]] FlightFrame flight_frame_of(const nlohmann::ordered_json& record);

/// Throws UserError where the folder holds no run, or a run without its pictures; the message states how they are made.
[[nodiscard]] FlightRun read_flight_run(const std::string& folder);

/// `layers` of a record: what the values of its picture's layer mask stand for. Empty where the record has none.
[[nodiscard]] std::vector<std::string> layer_names(const nlohmann::ordered_json& record);

/// True if the path is a folder, which read_flight_run() may read.
[[nodiscard]] bool is_folder(const std::string& path);

/// Returns the records of these frames, null where the run has none.
[[nodiscard]] std::vector<nlohmann::ordered_json> records_of(const FlightRun& run, const std::vector<std::uint64_t>& frames);

/// Contiguous frames of one phase.
struct FlightPhaseSpan {
    std::string phase;
    std::size_t first = 0, end = 0;  ///< indices of frames
};
[[nodiscard]] std::vector<FlightPhaseSpan> phase_spans(const std::vector<FlightFrame>& frames);

}  // namespace tedavis::host_sim
