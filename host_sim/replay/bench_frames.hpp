/// Frames of one view that are drawn to be timed, by displays that take turns.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "host_sim/replay/display_session.hpp"
#include "host_sim/scenario/posed_aircraft.hpp"
#include "render_core/effects/quality_level.hpp"

namespace tedavis::host_sim {

struct BenchPlace {
    PictureOptions picture;
    AircraftPose pose;  ///< with the time that data are shown at
};

/// A display that frames are drawn with, and what it gives up meanwhile. Sides may share a display.
struct BenchSide {
    std::shared_ptr<DisplaySession> session;
    effects::EffectSet given_up;
    std::optional<effects::QualityLevel> level;  ///< at which all frames are drawn; nothing: the design's own picture
};

/// Opens a display whose terrain has arrived for the place, at `level`. Throws UserError where it cannot be opened.
[[nodiscard]] BenchSide open_bench_side(const BenchPlace& place, const PictureOptions& options,
                                        const std::optional<effects::QualityLevel>& level = {});

/// Draws the n-th frame at the place; returns its time, ms.
[[nodiscard]] double bench_frame_ms(const BenchPlace& place, BenchSide& side, std::uint32_t n);

/// Returns the times of `rounds` frames of every side, ms. All sides draw in turn, forwards and backwards, so that none of them
/// always comes after the same other one.
[[nodiscard]] std::vector<std::vector<double>> bench_frames_ms(const BenchPlace& place, std::vector<BenchSide>& sides,
                                                               std::uint32_t rounds);

}  // namespace tedavis::host_sim
