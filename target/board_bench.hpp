/// The board's displays for the bench that measures costs (platform/runtime/cost_bench.hpp): over the terrain that the board
/// flies over, with its device, surface and size.
///
/// An effect is measured in a design of the board that asks for it: its own, else that of a phase, else its own with the effect
/// added, where that is possible. Quality levels are measured over all designs of the board. Frames are drawn as in flight.
///
/// Thread  one. Memory  that of up to five displays at a time. Failure  sentences.
#pragma once

#include "platform/runtime/bench_displays.hpp"
#include "target/board_clocks.hpp"
#include "target/board_config.hpp"
#include "target/event_log.hpp"
#include "target/stop_signal.hpp"

namespace tedavis::target {

class BoardBench final : public platform::BenchDisplays {
public:
    /// The arguments must outlive it. A scene that cannot be opened is logged, and measured without.
    BoardBench(const BoardSettings& settings, const BoardClocks& clocks, const StopSignal& stop, const EventLog& log);

    /// Finds where to measure: over the middle of the board's terrain, or over another part of it where the middle has no
    /// heights, kHeightAboveGround_m above the ground.
    [[nodiscard]] base::Error find_place(platform::BenchPlace& place);

    void own_picture(platform::BenchPicture& picture) const override;
    [[nodiscard]] platform::BenchNote picture_with(effects::Effect effect, platform::BenchPicture& picture) const override;
    [[nodiscard]] platform::BenchNote picture_with(effects::Overhead overhead, platform::BenchPicture& picture) const override;
    [[nodiscard]] std::size_t quality_pictures() const override { return 1 + settings_.phases.size(); }
    void quality_picture(std::size_t n, platform::BenchPicture& picture) const override;
    [[nodiscard]] base::Error open(const platform::BenchPicture& picture, std::unique_ptr<platform::DisplayHost>& host) override;
    [[nodiscard]] bool draw(platform::DisplayHost& host) override;
    [[nodiscard]] base::Time now() const override { return clocks_.live.monotonic(); }
    [[nodiscard]] bool is_stopped() const override { return stop_.requested(); }
    void progress(std::size_t done, std::size_t total) override;

    static constexpr double kHeightAboveGround_m = 1200;

private:
    const BoardSettings& settings_;
    const BoardClocks& clocks_;
    const StopSignal& stop_;
    const EventLog& log_;
    bool has_scene_ = false;
    base::Time begun_, last_line_;
};

}  // namespace tedavis::target
