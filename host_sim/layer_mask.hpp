/// Layer masks: the part of the display to which each pixel of a picture belongs.
///
/// The mask of a picture `P.png` is `P.layers.png` beside it: eight bits of grey per pixel, which are indices in the names that
/// the picture's record has under `layers` (the frame's line of `frames.jsonl`, `P.json` of a `shot`, `sheet.json` of a sheet).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/png_file.hpp"

namespace tedavis::host_sim {

struct LayerMask {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> layers;  ///< of each pixel, rows from the top
    std::vector<std::string> names;    ///< names by value; larger values are no layer
};

/// Writes a mask, complete or not at all; throws UserError.
void write_layer_mask(const std::string& picture, const GreyView& layers);
/// Returns "run/frames/000123.layers.png" for "run/frames/000123.png".
[[nodiscard]] std::string layer_mask_path(const std::string& picture);
[[nodiscard]] bool is_layer_mask(const std::string& file);
/// Reads the mask of a picture; nothing where there is no mask or `names` is empty. Throws UserError where it is damaged or has
/// another size than the picture.
[[nodiscard]] std::optional<LayerMask> read_layer_mask(const std::string& picture, const std::vector<std::string>& names,
                                                       std::uint32_t width, std::uint32_t height);

}  // namespace tedavis::host_sim
