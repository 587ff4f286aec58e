/// Converts a FrameRecord to a line of `frames.jsonl`, a stable format for scripts.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "host_sim/clearance/clearance.hpp"
#include "host_sim/reports/run_findings.hpp"
#include "render_core/base/time.hpp"
#include "render_core/display/planner/frame_record.hpp"
#include "render_core/display/planner/obstacle_places.hpp"

namespace tedavis::host_sim {

/// Measured times, the only entries that differ between two runs of the same flight.
struct FrameTiming {
    double plan_ms = 0, draw_ms = 0, total_ms = 0;
};

/// Distances on the screen between the drawn and the true places of ground (host_sim/accuracy/ground_errors.hpp).
struct MeasuredError {
    double mean_px = 0, max_px = 0;
    std::uint64_t places = 0;  ///< at which it was measured
};

struct FrameResult {
    display::FrameRecord record;
    std::uint64_t hash = 0;  ///< of the pixels, base::frame_hash
    FrameTiming timing;
    bool has_layers = false;  ///< a layer mask is beside its picture; only then `obstacles` are known
    display::ObstaclePlaces obstacles;
    bool has_accuracy_overlay = false;  ///< its picture file has the accuracy overlay; `hash` is of the picture without it
    std::optional<MeasuredError> measured_error;  ///< the error that the picture file shows in colors; nothing: it shows none
    std::optional<Findings> warnings;             ///< findings of a single picture
    std::optional<Clearance> clearance;           ///< from the terrain; nothing where it is not known
    double latency_ms = 0;  ///< from the newest message in the picture to the frame's time, both on the source's clock
};

/// One line without its newline. Keys in a fixed order, numbers in the fewest digits that read back to the same bits, values that
/// are not finite, and the position of an own ship that is lost, are null. `time_s` counts from `origin`.
[[nodiscard]] std::string frame_record_json(const FrameResult& result, base::Time origin);
/// 16 lower-case hex digits.
[[nodiscard]] std::string hash_text(std::uint64_t hash);

}  // namespace tedavis::host_sim
