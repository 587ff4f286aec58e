/// Measures the costs of a display's effects: it times frames of one view with and without each effect, in turn, by the program's
/// clock.
///
/// An effect that the governor may give up is switched within one running display, as the governor does it; the others are
/// compared with a display whose design does not request them. The cost of terrain is the slope over its triangles at several
/// tolerances, that of rays the difference of pictures with traced terrain and without any; the cost of the frame is what remains
/// of a picture without terrain. The quality levels are measured at the end
/// (quality_bench.hpp).
///
/// Memory   that of up to five displays at a time, and 0.5 MB inside: one object a program, not on the stack.
/// Thread   one; no other display of the thread may be current.
/// Failure  measure() returns one sentence where the program was stopped or a display of its own design cannot be used. An effect
///          whose display cannot be started has the reason as its note.
#pragma once

#include "platform/runtime/bench_frames.hpp"

namespace tedavis::platform {

/// Whether a design requests an effect, also for effects that are settings of others: ridges, warning colours.
[[nodiscard]] bool asks_for(const design::DesignSettings& design, effects::Effect effect) noexcept;

class CostBench {
public:
    /// `rounds`: kMinRounds to kMaxRounds of BenchFrames; a third as many of each quality level.
    CostBench(BenchDisplays& displays, const BenchPlace& place, std::uint32_t rounds)
        : displays_(displays), frames_(displays, place), rounds_(rounds) {}

    /// Measures every effect, overhead and quality level. The caller states program, date, design and terrain.
    [[nodiscard]] base::Error measure(effects::MeasuredCosts& measured);

private:
    [[nodiscard]] base::Error measure_terrain(effects::MeasuredCosts& measured);
    [[nodiscard]] base::Error open_terrain_sides();
    [[nodiscard]] base::Error measure_effects(effects::MeasuredCosts& measured);
    [[nodiscard]] base::Error measure_overheads(effects::MeasuredCosts& measured);
    void measure_effect(effects::Effect effect, effects::MeasuredCost& cost);
    [[nodiscard]] base::Error open_effect_sides(effects::Effect effect);
    void measure_overhead(effects::Overhead overhead, effects::MeasuredCost& cost);
    void measure_rays(effects::MeasuredCost& cost);
    void take_bare_picture();
    void step(std::size_t& done) { displays_.progress(++done, total()); }
    [[nodiscard]] std::size_t total() const {
        return effects::kEffectCount + effects::kOverheads - 1 + displays_.quality_pictures();
    }
    [[nodiscard]] double megapixels() const { return static_cast<double>(width_px_) * height_px_ / 1e6; }

    BenchDisplays& displays_;
    BenchFrames frames_;
    std::uint32_t rounds_;
    BenchPicture picture_;  ///< the picture that is measured now
    std::uint32_t width_px_ = 0, height_px_ = 0;
    std::size_t done_ = 0;
    effects::CostTable costs_;  ///< as far as they are known
};

}  // namespace tedavis::platform
