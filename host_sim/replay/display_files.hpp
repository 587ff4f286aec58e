/// Identifies the files that a display reads at its start: designs with all files that they name, device, aircraft, palette and
/// scene. Terrain, log, bus and switches are identified by the player (index_key.hpp).
#pragma once

#include <optional>
#include <string>

#include "host_sim/options/picture_options.hpp"

namespace tedavis::host_sim {

struct DisplayFiles {
    std::string content;  ///< all bytes of the texts and the identity of the scene (index_key.hpp): equal for equal files
    std::string stamps;   ///< sizes and times of the files: they change when a file is written, even with the same content
};

/// Identifies the files as they are now; nothing where one cannot be read, an error that the start of the display reports.
///
/// The display reads its files at another time than this function. If the results before and after its start are equal(), it has
/// read these files.
[[nodiscard]] std::optional<DisplayFiles> display_files(const PictureOptions& picture);

[[nodiscard]] bool equal(const std::optional<DisplayFiles>& before, const std::optional<DisplayFiles>& after);

}  // namespace tedavis::host_sim
