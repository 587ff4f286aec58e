/// Measures what the effects that a run left out or replaced would have cost and changed in the picture: `replay --ledger`.
///
/// Some frames of the run are drawn again on the reference device: once with all effects of the design, and once with one effect
/// forbidden. Planner and replacements are the same as on any device. Times are those of frames that are drawn alternately on
/// this machine.
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

/// The reference device, which can draw every effect.
inline constexpr const char* kLedgerReference = "desktop";
inline constexpr std::uint64_t kLedgerSamples = 6;

/// A frame that is drawn again, with its input.
struct LedgerSample {
    std::uint64_t frame = 0;
    base::Time time;
    flight::AircraftState aircraft;
    flight::PhaseStatus phase;
    std::optional<flight::LegendShow> legend;  ///< FrameInput::legend
    flight::FlightTrail way;
    RgbaPicture shown;
};

/// A state of an effect other than run, and the number of the run's frames with it.
struct LedgerFate {
    display::EffectState state = display::EffectState::run;
    std::string replaced_by, reason;
    std::uint64_t frames = 0;
};

struct LedgerPrice {
    std::string effect;  ///< empty: all effects together, as the run's device drew them
    std::vector<LedgerFate> fates;
    effects::PairedCost saved;     ///< per frame; 0 where the noise is greater
    PictureDifference difference;  ///< means and edges: averages over the samples; the largest: of all samples
    std::uint64_t worst_frame = 0;
    RgbaPicture intended, shown;  ///< of that frame
};

class EffectLedger {
public:
    /// For a run of `frames` frames with these options, in this size.
    EffectLedger(const PictureOptions& options, PictureSize size, bool generated_flight, std::uint64_t frames)
        : options_(options), generated_flight_(generated_flight), frames_(frames) {
        options_.size = size;
    }

    /// Whether the n-th frame, from 0, is drawn again: kLedgerSamples frames, evenly spread, with the first and the last.
    [[nodiscard]] bool wants(std::uint64_t n) const;
    void take(LedgerSample sample) { samples_.push_back(std::move(sample)); }
    /// Counts the effects of a frame; to be called for every frame of the run. Effects that the failure policy removed are not
    /// counted.
    void note(const display::FrameRecord& record);

    /// Measures: one entry per effect, then one for all together; empty where no frame was drawn. rest() must have been called on
    /// the run's own session. `progress(done, total)` may throw.
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
