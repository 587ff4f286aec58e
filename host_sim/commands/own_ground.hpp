/// Builds default terrain and spatial data for commands without such options, as by `terrain build`, `scenario build` and `scene
/// build`, into a folder that must exist while they are used.
#pragma once

#include <optional>
#include <string>

#include "host_sim/console.hpp"
#include "host_sim/options/picture_options.hpp"

namespace tedavis::host_sim {

/// Path of the shipped raster below shipped_root().
inline constexpr const char* kOwnRaster = "/configs/data/jacksboro_srtm3.tif";

struct OwnTerrain {
    std::string raster;
    bool generated_image = false;        ///< drapes a generated image
    std::optional<double> accuracy_m{};  ///< LE90 of the raster; nothing: unknown
};

/// Each returns the database's path; throws UserError and Interrupted.
[[nodiscard]] std::string build_own_terrain(const OwnTerrain& terrain, const std::string& folder, Console& console);
[[nodiscard]] std::string build_own_scenario(const std::string& scenario, const std::string& folder, Console& console);
/// Builds the shipped terrain and the data of the shipped scenario where the options name no terrain, and sets their paths in
/// `picture`.
void use_own_ground(PictureOptions& picture, const std::string& folder, Console& console);
[[nodiscard]] std::string build_own_scene(const std::string& scene, const std::string& folder, Console& console);

}  // namespace tedavis::host_sim
