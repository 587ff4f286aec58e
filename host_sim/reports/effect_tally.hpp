/// Counts the frames of a flight that requested each effect, and whether they drew it, replaced it, or left it out, with the
/// reasons.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "render_core/display/planner/frame_record.hpp"

namespace tedavis::host_sim {

struct EffectReason {
    std::string text;  ///< as the frame's record gives it
    std::uint64_t frames = 0;
};

struct EffectCount {
    std::string name;
    std::uint64_t asked = 0, run = 0, replaced = 0, skipped = 0;  ///< frames
    std::vector<EffectReason> reasons;                            ///< of the frames without it
    std::uint64_t skipped_work = 0;  ///< draws, passes and uploaded bytes for it in frames that skipped it; 0 is expected
    /// Greatest upper bound of its contribution in frames that skipped it: a share of full scale, or pixels for geometry.
    double bound = 0;

    /// Adds a frame that requested the effect.
    void add(const display::EffectRecord& record);
};

class EffectTally {
public:
    void add(const display::FrameRecord& record);
    /// Counts of the requested effects, in the order of their first request.
    [[nodiscard]] const std::vector<EffectCount>& counts() const { return counts_; }

private:
    std::vector<EffectCount> counts_;
};

/// {`name`, `asked`, `run`, `replaced`, `skipped`, `reasons` [{`why`, `frames`}], `skipped_work`, `bound`}.
[[nodiscard]] nlohmann::ordered_json effect_count_json(const EffectCount& count);
/// Throws as nlohmann does where a key is missing.
[[nodiscard]] EffectCount effect_count_from(const nlohmann::ordered_json& json);

}  // namespace tedavis::host_sim
