/// Measures what a display's effects cost: frames of one view with and without each, in turn, by the machine's clock.
///
/// An effect that the governor may give up is switched within one running display, as the governor does it; the others are
/// compared with a display whose design does not ask for them. Terrain is the slope over its triangles at several tolerances,
/// what is left of a picture without terrain is the frame.
#pragma once

#include <functional>
#include <memory>

#include "host_sim/replay/display_session.hpp"
#include "host_sim/reports/calibration_file.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"

namespace tedavis::host_sim {

struct BenchPlace {
    PictureOptions picture;
    AircraftPose pose;  ///< with the time that data are shown at
};

/// A shipped design that calls for an effect, by itself or with effects::with_effect; empty for what costs nothing or is measured
/// otherwise.
[[nodiscard]] std::string design_calling_for(effects::Effect effect);

class CostBench {
public:
    /// Throws UserError where the display cannot be opened.
    CostBench(const BenchPlace& place, std::uint32_t rounds) : place_(place), rounds_(rounds) {}

    /// Of every effect and overhead; date, design and terrain are the caller's. `progress(done, total)` may throw.
    [[nodiscard]] MeasuredCosts measure(const std::function<void(std::size_t, std::size_t)>& progress);

private:
    struct Side;
    [[nodiscard]] std::vector<std::vector<double>> frames_ms(std::vector<Side>& sides) const;
    [[nodiscard]] double frame_ms(Side& side, std::uint32_t n) const;
    [[nodiscard]] Side open(const PictureOptions& options) const;
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
