/// The overlay that a command draws over a finished picture to show its accuracy: the measured error of the ground in colours
/// (error map, ground_errors.hpp), and a panel at the left edge, an eighth of the height below the top. The panel has figures of
/// the frame's record and, with the error map, the measured maximum and the scale of colours, whose end is the frame's tau.
///
/// It is drawn after the record was made, so the hash of the pixels and the FrameRecord are those of the picture without it.
/// The frame's line in frames.jsonl gets the keys `accuracy_overlay` and, with the error map, `measured_error`.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host_sim/accuracy/ground_errors.hpp"
#include "host_sim/options/accuracy_shown.hpp"
#include "host_sim/replay/display_session.hpp"

namespace tedavis::host_sim {

/// The lines of the figures: the requested tau, the proven greatest error of the drawn terrain (one line says instead of both
/// that no triangles of terrain were drawn), the quality level, and, with `has_time`, the frame's time. Errors are rounded up.
[[nodiscard]] std::vector<std::string> accuracy_lines(const FrameResult& result, bool has_time);

struct OverlayStyle {
    AccuracyShown shown;
    bool has_time = false;      ///< differs from run to run
    std::uint32_t cell_px = 8;  ///< side of the error map's cells; each is measured once
    ErrorMapStyle map = ErrorMapStyle::half;
};

class AccuracyOverlay {
public:
    /// `terrain`: the database that the display shows; empty: none. Reads all heights of the database as soon as the error map is
    /// to be shown. Throws UserError if there is then no database, or if it is damaged, too large for memory, or extends round
    /// the Earth or to a pole.
    AccuracyOverlay(const OverlayStyle& style, std::string terrain);
    AccuracyOverlay(const AccuracyOverlay&) = delete;
    AccuracyOverlay& operator=(const AccuracyOverlay&) = delete;

    /// Changes the parts that are shown. Throws as the constructor does, and then changes nothing.
    void show(const AccuracyShown& shown);
    [[nodiscard]] const AccuracyShown& shown() const { return style_.shown; }
    /// Returns the session's picture with the overlay, top row first. Also sets `has_accuracy_overlay` of `result` and, with the
    /// error map, `measured_error`; `result` must be of the frame that the session drew last. The error map redraws the session.
    [[nodiscard]] RgbaPicture over(DisplaySession& session, FrameResult& result) const;

private:
    OverlayStyle style_;
    std::string terrain_;
    std::unique_ptr<TracedGround> ground_;
};

}  // namespace tedavis::host_sim
