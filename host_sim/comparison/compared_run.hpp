/// Reads the data of a run for a comparison: time, position, phase, alerts, effects and numbers of each frame, and the names in
/// its summary.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/reports/run_frames.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {

/// A number of a frame that is compared.
struct Quantity {
    const char* name;        ///< key of compare.json: "height_above_terrain"
    const char* title;       ///< "Height above terrain"
    const char* unit;        ///< "m"; empty for counts
    const char* shown_unit;  ///< unit on the page, which has heights in feet like the display
    double per_unit;         ///< shown units per unit
    int digits;              ///< number of decimals on the page
    /// True: a continuous quantity of the flight, which is interpolated between frames; false: a number of one picture.
    bool is_flown;
};
inline constexpr std::size_t kQuantityCount = 9;
enum QuantityIndex : std::size_t {
    kAltitude,
    kHeightAboveTerrain,
    kClearance,
    kLabelsPlaced,
    kLabelsLeftOut,
    kDataDrawn,
    kEffectsDrawn,
    kCrowdedRegions,
    kFrameTime
};
/// In the order of QuantityIndex.
inline constexpr std::array<Quantity, kQuantityCount> kQuantities = {{
    {"altitude", "Altitude", "m", "ft", 1 / base::kMetresPerFoot, 0, true},
    {"height_above_terrain", "Height above terrain", "m", "ft", 1 / base::kMetresPerFoot, 0, true},
    {"clearance", "Distance to the nearest ground", "m", "ft", 1 / base::kMetresPerFoot, 0, true},
    {"labels_placed", "Labels placed", "", "", 1, 0, false},
    {"labels_left_out", "Labels left out", "", "", 1, 0, false},
    {"data_drawn", "Data features drawn", "", "", 1, 0, false},
    {"effects_drawn", "Effects drawn", "", "", 1, 0, false},
    {"crowded_regions", "Regions above the clutter budget", "", "", 1, 0, false},
    {"frame_time", "Time per frame", "ms", "ms", 1, 1, false},
}};

/// The path of its picture is empty where there is none.
struct ComparedFrame : RunFrame {
    std::optional<double> utc_s;
    std::string hash;  ///< of the picture; see knows_picture()
    bool has_place = false;
    bool has_pressure_height = false;             ///< its height is a pressure height alone
    double latitude_deg = 0, longitude_deg = 0;   ///< where it has a place
    int terrain_alert = 0, obstacle_alert = 0;    ///< 0 none, 1 caution, 2 warning
    std::array<double, kQuantityCount> values{};  ///< NaN where the record has none
    std::vector<std::string> effects;             ///< that were drawn
};

struct ComparedRun {
    std::string folder;
    std::string log, design, device, aircraft, palette, light, terrain, scene, size, version;  ///< of its summary, or empty
    /// Size and hash of the log's content, of its first and last 64 KiB; nothing where the file is gone.
    std::optional<std::pair<std::uint64_t, std::uint64_t>> log_content;
    std::optional<std::uint64_t> can_frames;  ///< of its summary
    nlohmann::ordered_json closest;           ///< `closest` of its summary, or null
    bool assumes_heights = false;  ///< by its summary: pressure altitudes are taken for heights (`convert --assume-geometric`)
    std::vector<ComparedFrame> frames;  ///< in the order of time; at least one
};

/// Throws UserError where the folder holds no run.
[[nodiscard]] ComparedRun read_compared_run(const std::string& folder);

/// False where the record has no hash of the picture, as with --frames none, which writes 0.
[[nodiscard]] bool knows_picture(const ComparedFrame& frame);
/// False where the record states none, as with --phase none.
[[nodiscard]] bool knows_phase(const ComparedFrame& frame);

/// UTC minus the time of the log, s, at the first frame that knows it; nothing where none does.
[[nodiscard]] std::optional<double> utc_offset_s(const ComparedRun& run);
/// "12:46:05 UTC", or "312.5 s" where no date is known.
[[nodiscard]] std::string frame_time_words(const ComparedRun& run, double time_s);
/// The median of the steps between frames, s; 0 of a single frame.
[[nodiscard]] double median_step_s(const ComparedRun& run);
/// Distance along the ground, m, for places that are less than some hundred kilometres apart.
[[nodiscard]] double ground_distance_m(double latitude_a_deg, double longitude_a_deg, double latitude_b_deg,
                                       double longitude_b_deg);

}  // namespace tedavis::host_sim
