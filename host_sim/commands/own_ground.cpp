#include "host_sim/commands/own_ground.hpp"

#include <filesystem>

#include "host_sim/commands/scenario.hpp"
#include "host_sim/commands/scene.hpp"
#include "host_sim/commands/terrain.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/terrain_builder/generated_image.hpp"

namespace tedavis::host_sim {

std::string build_own_terrain(const OwnTerrain& terrain, const std::string& folder, Console& console) {
    TerrainBuildOptions build;
    build.rasters = {terrain.raster};
    build.accuracy_m = terrain.accuracy_m;
    build.output = folder + "/" + std::filesystem::path(terrain.raster).stem().string() + ".tdb";
    if (terrain.generated_image) {
        build.drape = folder + "/generated_image.tif";
        write_generated_image(build.rasters.front(), build.drape);
    }
    Console only_notes = console.without_result();
    (void)run_terrain_build(build, only_notes);
    return build.output;
}

std::string build_own_scenario(const std::string& scenario, const std::string& folder, Console& console) {
    ScenarioBuildOptions build;
    build.scenario = scenario;
    build.output = folder + "/scenario";
    Console only_notes = console.without_result();
    (void)run_scenario_build(build, only_notes);
    return build.output + "/scene.sdb";
}

void use_own_ground(PictureOptions& picture, const std::string& folder, Console& console) {
    if (!picture.terrain.empty()) return;
    picture.terrain = build_own_terrain({shipped_root() + kOwnRaster, true}, folder, console);
    if (picture.scene.empty()) picture.scene = build_own_scenario("default", folder, console);
}

std::string build_own_scene(const std::string& scene, const std::string& folder, Console& console) {
    SceneBuildOptions build;
    build.scene = scene;
    build.output = folder + "/scene.sdb";
    Console only_notes = console.without_result();
    (void)run_scene_build(build, only_notes);
    return build.output;
}

}  // namespace tedavis::host_sim
