/// The measured error of the ground that a display shows, over the whole of a frame.
///
/// Rays through a coarse grid of the picture are intersected with the true surface (knobs/seen_ground.hpp). The error at a hit is
/// the distance on the screen between its drawn and its true place (knobs/terrain_tau_knob.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host_sim/accuracy/knobs/seen_ground.hpp"
#include "host_sim/options/picture_options.hpp"
#include "host_sim/png_file.hpp"
#include "host_sim/reports/frame_record_json.hpp"
#include "render_core/display/display.hpp"

namespace tedavis::host_sim {

/// A grid of square cells round the middle of a picture, which covers all of it; its outer cells may reach beyond the picture.
struct GroundErrors {
    PictureSize picture;        ///< pixels
    std::uint32_t cell_px = 1;  ///< side of a cell
    std::uint32_t across = 0, down = 0;
    std::vector<double> px;  ///< row by row, the top row first; NaN where no ground was measured

    /// The pixel of the picture that is the first of a column of cells, or of a row; negative for cells that reach beyond it.
    [[nodiscard]] std::int64_t left(std::uint32_t column) const;
    [[nodiscard]] std::int64_t top(std::uint32_t row) const;
    [[nodiscard]] MeasuredError summary() const;
};

/// Measures the frame that the display planned last, over the ground of its own database, which must be in memory. No ground is
/// measured over a flat reference or where a focus is magnified, because what is drawn there is not the ground; nor nearer
/// than kNearestSeenPlace_m, nor from where the tracer cannot see the ground.
[[nodiscard]] GroundErrors ground_errors(const TracedGround& ground, display::Display& display, std::uint32_t cell_px);

enum class ErrorMapStyle : std::uint8_t {
    half,  ///< each pixel of a measured cell is mixed half and half with the color of the error
    dots,  ///< the middle quarter of a measured cell has the color of the error
};
/// Draws the errors over a picture of the same size, dark blue at 0 to yellow at `full_px` and above (error_map of
/// knob_pictures.hpp).
void draw_ground_errors(RgbaPicture& picture, const GroundErrors& errors, double full_px, ErrorMapStyle style);

/// The color of an error: dark blue at 0, yellow at `full_px` and above.
[[nodiscard]] std::array<std::uint8_t, 3> error_color(double px, double full_px);

}  // namespace tedavis::host_sim
