/// What the effects that a run left out, or replaced, would have cost and shown: `replay --ledger`.
///
/// Some frames of the run are drawn again on the reference device, as the design intends them and as they are with the one effect
/// forbidden; planner and replacements are those of any device. Times are of frames drawn in turn on this machine.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/measure/paired_cost.hpp"
#include "host_sim/measure/picture_difference.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/flight_player.hpp"

namespace tedavis::host_sim {

/// Can do every effect.
inline constexpr const char* kLedgerReference = "desktop";
inline constexpr std::uint64_t kLedgerSamples = 6;

/// A frame that is drawn again.
struct LedgerSample {
    std::uint64_t frame = 0;
    base::Time time;
    flight::AircraftState aircraft;
    flight::PhaseStatus phase;
    std::optional<flight::LegendShow> legend;  ///< FrameInput::legend
    flight::FlightTrail way;
    RgbaPicture shown;
};

/// What happened to an effect in some frames of the run.
struct LedgerFate {
    display::EffectState state = display::EffectState::run;
    std::string replaced_by, reason;
    std::uint64_t frames = 0;
};

struct LedgerPrice {
    std::string effect;  ///< empty: all together, as the run's device showed it
    std::vector<LedgerFate> fates;
    effects::PairedCost saved;     ///< of a frame; may be 0 where noise is greater
    PictureDifference difference;  ///< mean of means and edges over the samples, largest of all
    std::uint64_t worst_frame = 0;
    RgbaPicture intended, shown;  ///< of that frame
};

class EffectLedger {
public:
    /// Of a run of `frames` frames with these options, in this size.
    EffectLedger(const PictureOptions& options, PictureSize size, bool generated_flight, std::uint64_t frames)
        : options_(options), generated_flight_(generated_flight), frames_(frames) {
        options_.size = size;
    }

    /// Whether the n-th frame is one of those that are drawn again: evenly spread, with the first and the last.
    [[nodiscard]] bool wants(std::uint64_t n) const;
    void take(LedgerSample sample) { samples_.push_back(std::move(sample)); }
    /// Of every frame. What the failure policy removed has no price.
    void note(const display::FrameRecord& record);

    /// The run's own session must have rested. `progress(done, total)` may throw. By effect, then all together; nothing where
    /// no frame was drawn.
    [[nodiscard]] std::vector<LedgerPrice> prices(const std::function<void(std::size_t, std::size_t)>& progress) const;
    [[nodiscard]] const std::vector<LedgerSample>& samples() const { return samples_; }

private:
    [[nodiscard]] PictureOptions intended() const;
    [[nodiscard]] LedgerPrice price_of(effects::Effect effect, const std::function<void()>& between) const;
    [[nodiscard]] LedgerPrice price_of_all(const std::function<void()>& between) const;

    PictureOptions options_;
    bool generated_flight_;
    std::uint64_t frames_;
    std::vector<LedgerSample> samples_;
    std::map<effects::Effect, std::vector<LedgerFate>> fates_;
};

}  // namespace tedavis::host_sim
