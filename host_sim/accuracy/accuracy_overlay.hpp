/// What a command draws over a finished picture to show how accurate it is: figures of the frame's record in a corner, and the
/// measured error of the ground in colours over it (ground_errors.hpp).
///
/// It is drawn after the record was made: hash and record are those of the picture without it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host_sim/accuracy/ground_errors.hpp"
#include "host_sim/options/accuracy_shown.hpp"
#include "host_sim/replay/display_session.hpp"

namespace tedavis::host_sim {

/// The lines of the overlay: the requested tau, the proven greatest error of the drawn terrain, the quality level, and, with
/// `has_time`, the frame's time. Errors are rounded up.
[[nodiscard]] std::vector<std::string> accuracy_lines(const FrameResult& result, bool has_time);

struct OverlayStyle {
    AccuracyShown shown;
    bool has_time = false;  ///< differs from run to run
    std::uint32_t cell_px = 8;
    ErrorMapStyle map = ErrorMapStyle::half;
};

class AccuracyOverlay {
public:
    /// `terrain`: the database that the display shows; empty: none. Reads its heights where the error map is shown. Throws
    /// UserError where the map has no terrain, or the terrain does not fit into memory.
    AccuracyOverlay(const OverlayStyle& style, std::string terrain);
    AccuracyOverlay(const AccuracyOverlay&) = delete;
    AccuracyOverlay& operator=(const AccuracyOverlay&) = delete;

    /// Chooses other parts. Throws as the constructor does, and then changes nothing.
    void show(const AccuracyShown& shown);
    [[nodiscard]] const AccuracyShown& shown() const { return style_.shown; }
    /// Returns the session's picture with the overlay, top row first; sets `has_accuracy_overlay` of `result`, the same frame's.
    [[nodiscard]] RgbaPicture over(DisplaySession& session, FrameResult& result) const;

private:
    OverlayStyle style_;
    std::string terrain_;
    std::unique_ptr<TracedGround> ground_;
};

}  // namespace tedavis::host_sim
