/// How the displays draw that knobs fly on: the size of the largest picture, the device and the design.
#pragma once

#include <cstdint>
#include <string>

#include "host_sim/options/picture_options.hpp"

namespace tedavis::host_sim {

/// Small, so that a quick run has time for several poses.
inline constexpr PictureSize kFlownSize = {640, 360};

/// Names of shipped files may be short.
struct FlownDisplay {
    PictureSize size = kFlownSize;  ///< of the largest picture; smaller levels are shares of it
    std::string device = PictureOptions().device, design = PictureOptions().design;

    /// The size times 0 .. 1, rounded.
    [[nodiscard]] PictureSize share(double of_side) const;
};

/// "640x360", as --size takes it.
[[nodiscard]] std::string size_word(const PictureSize& size);
/// "640 x 360".
[[nodiscard]] std::string size_text(const PictureSize& size);

/// The view of a picture, and a grid of places in it.
struct SeenGrid {
    std::uint32_t across = 32, down = 18;
    double field_of_view_deg = 60;  ///< over the width
};
/// So many places over the width, and as many below each other as the picture's shape has room for. Throws UserError where the
/// design is none, or it or a design of its phases shows no perspective view or one of another width.
[[nodiscard]] SeenGrid seen_grid(const FlownDisplay& display, std::uint32_t across = SeenGrid().across);

/// How many times as many pixels an angle in the middle of the picture covers as on one of kFlownSize that is 60 degrees wide; at
/// least 1. Throws UserError as seen_grid() does.
[[nodiscard]] double pixel_scale(const FlownDisplay& display);

/// Of the size and of the texts of all files that the device and the design are made of. Throws UserError where there are none.
[[nodiscard]] std::uint64_t identity_of(const FlownDisplay& display);

/// OSMesa, or EGL where OSMesa is missing.
[[nodiscard]] GlChoice offered_gl();

}  // namespace tedavis::host_sim
