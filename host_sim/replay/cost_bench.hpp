/// Measures what a display's effects cost: frames of one view with and without each, in turn, by the machine's clock.
///
/// An effect that the governor may give up is switched within one running display, as the governor does it; the others are
/// compared with a display whose design does not ask for them. Terrain is the slope over its triangles at several tolerances,
/// what is left of a picture without terrain is the frame. The quality levels are measured at the end (quality_bench.hpp).
#pragma once

#include <functional>

#include "host_sim/replay/bench_frames.hpp"
#include "host_sim/reports/calibration_file.hpp"

namespace tedavis::host_sim {

/// A shipped design that calls for an effect, by itself or with effects::with_effect; empty for what costs nothing or is measured
/// otherwise.
[[nodiscard]] std::string design_calling_for(effects::Effect effect);

class CostBench {
public:
    /// Throws UserError where the display cannot be opened.
    CostBench(const BenchPlace& place, std::uint32_t rounds) : place_(place), rounds_(rounds) {}

    /// Of every effect, overhead and quality level; date, design and terrain are the caller's. `progress(done, total)` may throw.
    [[nodiscard]] MeasuredCosts measure(const std::function<void(std::size_t, std::size_t)>& progress);

private:
    void measure_terrain(MeasuredCosts& measured);
    [[nodiscard]] MeasuredCost measure_effect(effects::Effect effect) const;
    [[nodiscard]] MeasuredCost measure_overhead(effects::Overhead overhead, const std::string& design) const;
    [[nodiscard]] PictureOptions options_for(effects::Effect effect) const;
    [[nodiscard]] double megapixels() const { return static_cast<double>(width_px_) * height_px_ / 1e6; }

    BenchPlace place_;
    std::uint32_t rounds_;
    std::uint32_t width_px_ = 0, height_px_ = 0;
    effects::CostTable costs_;  ///< as far as they are known
};

}  // namespace tedavis::host_sim
