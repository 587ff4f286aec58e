/// The files that a display is started from, beside terrain, log, bus and switches, which the player identifies: designs with all
/// that they name, device, aircraft, palette and scene.
#pragma once

#include <optional>
#include <string>

#include "host_sim/options/picture_options.hpp"

namespace tedavis::host_sim {

struct DisplayFiles {
    std::string content;  ///< of texts every byte, of the scene its identity (index_key.hpp): equal for equal files
    std::string stamps;   ///< sizes and times: other ones once a file was written, even where it holds the same again
};

/// As they are now. Nothing where one of them cannot be read, which whoever starts the display says.
///
/// A display reads its files some time after, or before, somebody asks for them here: where two answers, one from before it was
/// started and one from after, are equal(), it has read these very files.
[[nodiscard]] std::optional<DisplayFiles> display_files(const PictureOptions& picture);

[[nodiscard]] bool equal(const std::optional<DisplayFiles>& before, const std::optional<DisplayFiles>& after);

}  // namespace tedavis::host_sim
