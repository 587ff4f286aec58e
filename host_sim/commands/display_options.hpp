/// Options that several drawing commands have. The referenced objects must outlive the parsing of the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>

#include "host_sim/options/accuracy_shown.hpp"
#include "host_sim/options/picture_options.hpp"
#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

/// Of --layers.
inline constexpr const char* kLayersText =
    "beside each picture X.layers.png: 0 terrain, 1 data, 2 uncertainty, 3 labels, 4 symbology, by which pixel is whose";

/// Options of every drawing command: terrain, scene, device, aircraft, size and --gl.
void add_surface_options(CLI::App* command, PictureOptions& picture);
/// The same and all options of a picture's appearance.
void add_picture_options(CLI::App* command, PictureOptions& picture);
/// --legend.
void add_legend(CLI::App* command, PictureOptions& picture);
/// --show-accuracy and --error-map.
void add_accuracy_shown(CLI::App* command, AccuracyShown& shown);
/// --time, for a command without a flight.
void add_time(CLI::App* command, std::optional<base::Time>& time);

}  // namespace tedavis::host_sim
