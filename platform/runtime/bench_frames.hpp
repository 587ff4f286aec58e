/// Draws and times frames of one view, by several displays in turn.
///
///   open(picture) a display, share(...) it with a further side · draw(side) or take_times(rounds) · close() all of them
///
/// Memory   the displays' own, and 0.5 MB inside: one object a program, not on the stack.
/// Thread   one; no other display of the thread may be current.
/// Failure  open() returns why a display cannot be started. A lost surface and a stopped program are faults that stay: all later
///          draws fail.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "platform/runtime/bench_displays.hpp"
#include "render_core/effects/paired_cost.hpp"

namespace tedavis::platform {

class BenchFrames {
public:
    static constexpr std::size_t kMaxDisplays = 5, kMaxSides = effects::kMaxQualityCandidates;
    static constexpr std::uint32_t kMinRounds = 3, kMaxRounds = 1000;

    BenchFrames(BenchDisplays& displays, const BenchPlace& place) : displays_(displays), place_(place) {}

    /// Opens a display whose terrain has arrived for the place; it is the next side, whose frames are drawn at `level` (empty:
    /// the design's own picture). A design that leaves the choice of the renderer to the display is drawn by triangles. At most
    /// kMaxDisplays.
    [[nodiscard]] base::Error open(const BenchPicture& picture, const std::optional<effects::QualityLevel>& level = {});
    /// Adds a side that draws with the display of the last one. At most kMaxSides.
    void share(const effects::EffectSet& given_up, const std::optional<effects::QualityLevel>& level = {});
    void close();

    /// Draws the n-th frame of a side; `ms` is its time. `pixels`, where given, receives the picture, bottom row first.
    [[nodiscard]] bool draw(std::size_t side, std::uint32_t n, double& ms, base::Span<std::uint8_t> pixels = {});
    /// Draws `rounds` frames of every side. All sides draw in turn, forwards and backwards, so that none of them always comes
    /// after the same other one.
    [[nodiscard]] bool take_times(std::uint32_t rounds);
    /// The times of a side, ms, as the last take_times() found them.
    [[nodiscard]] base::Span<const double> ms(std::size_t side) const { return {times_[side].data(), rounds_}; }
    [[nodiscard]] effects::PairedCost cost_between(std::size_t with, std::size_t without);
    [[nodiscard]] double median_ms(std::size_t side);

    [[nodiscard]] std::size_t sides() const { return side_count_; }
    [[nodiscard]] display::Display& display(std::size_t side) { return sides_[side].host->display(); }
    [[nodiscard]] const base::Surface& surface(std::size_t side) const { return sides_[side].host->surface(); }
    [[nodiscard]] std::optional<effects::QualityLevel>& level(std::size_t side) { return sides_[side].level; }
    [[nodiscard]] const base::Error& fault() const { return fault_; }

private:
    struct Side {
        DisplayHost* host = nullptr;
        effects::EffectSet given_up;
        std::optional<effects::QualityLevel> level;
    };
    [[nodiscard]] bool take_turn(Side& side);
    [[nodiscard]] flight::AircraftState aircraft(display::Display& display, base::Time time) const;
    [[nodiscard]] bool fail(const char* message);

    BenchDisplays& displays_;
    BenchPlace place_;
    BenchPicture opened_;                  ///< the last one, as it is drawn
    earth::GeoidUndulation undulation_{};  ///< at the place, by the first terrain
    std::array<std::unique_ptr<DisplayHost>, kMaxDisplays> hosts_;
    std::array<Side, kMaxSides> sides_;
    std::array<std::array<double, kMaxRounds>, kMaxSides> times_;
    std::array<double, kMaxRounds> room_;
    std::size_t host_count_ = 0, side_count_ = 0;
    std::uint32_t rounds_ = 0;
    base::Error fault_;
};

}  // namespace tedavis::platform
