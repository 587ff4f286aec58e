/// Settings of the displays with which knobs draw a flight: the size of the largest picture, the device and the design.
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
/// Returns a grid of `across` places over the width, and as many down as the picture's aspect ratio gives. Throws UserError where
/// the design cannot be read, or it or a design of its phases shows no perspective view or one of another field of view.
[[nodiscard]] SeenGrid seen_grid(const FlownDisplay& display, std::uint32_t across = SeenGrid().across);

/// Ratio of the pixels per angle in the middle of the picture to those of a picture of kFlownSize that is 60 degrees wide; at
/// least 1. Throws UserError as seen_grid() does.
[[nodiscard]] double pixel_scale(const FlownDisplay& display);

/// Identity of the size and of the texts of all files of the device and the design. Throws UserError where one cannot be read.
[[nodiscard]] std::uint64_t identity_of(const FlownDisplay& display);

/// OSMesa, or EGL where OSMesa is missing.
[[nodiscard]] GlChoice offered_gl();

}  // namespace tedavis::host_sim
