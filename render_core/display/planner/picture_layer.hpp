/// The layers of a picture, from back to front. A picture can be drawn up to each of them, so that the layer of every pixel can
/// be determined.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace tedavis::display {

enum class PictureLayer : std::uint8_t {
    terrain,      ///< with the sky and what foci change of it
    data,         ///< on the ground and over it
    uncertainty,  ///< of the ground's data, and glyphs that show only uncertainty; what changes the look of an element is data
    labels,       ///< icons, names, diagrams, barbs and cues
    symbology,    ///< instruments, legends and maps beside the picture
};
inline constexpr std::size_t kPictureLayers = 5;
inline constexpr std::array<std::string_view, kPictureLayers> kPictureLayerNames{"terrain", "data", "uncertainty", "labels",
                                                                                 "symbology"};

}  // namespace tedavis::display
