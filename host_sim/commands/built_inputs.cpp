#include "host_sim/commands/built_inputs.hpp"

#include <filesystem>

#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/own_ground.hpp"
#include "host_sim/flight_test/input_logs.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

bool is_input_name(const std::string& text) { return !text.empty() && text.find_first_of("./") == std::string::npos; }

}  // namespace

void BuiltInputs::resolve(FlightTest& test) {
    test.picture.terrain = terrain(test.picture.terrain);
    if (!test.scenario.empty()) take_scenario(test);
    test.picture.scene = scene(test.picture.scene);
}

void BuiltInputs::resolve_to_fly(FlightTest& test) {
    try {
        resolve(test);
    } catch (const Interrupted&) {
        throw Interrupted(kTestInterrupted);
    }
}

template <class Build>
std::string BuiltInputs::built(const std::string& name, Build build) {
    const auto [place, is_new] = built_.try_emplace(name);
    if (!is_new) return place->second;
    const std::string folder = folder_ + "/" + std::to_string(built_.size());
    make_folder(folder);
    place->second = build(folder);
    return place->second;
}

std::string BuiltInputs::terrain(const std::string& name) {
    if (!is_input_name(name)) return name;
    if (name != "jacksboro") throw UserError("terrain = \"" + name + "\": the shipped one is jacksboro; name it, or a .tdb");
    return built("terrain",
                 [&](const std::string& folder) { return build_own_terrain({shipped_root() + kOwnRaster}, folder, console_); });
}

std::string BuiltInputs::scene(const std::string& name) {
    if (!is_input_name(name)) return name;
    return built("scene " + name, [&](const std::string& folder) { return build_own_scene(name, folder, console_); });
}

void BuiltInputs::take_scenario(FlightTest& test) {
    const std::string database = built("scenario " + test.scenario, [&](const std::string& folder) {
        return build_own_scenario(test.scenario, folder, console_);
    });
    const std::string folder = std::filesystem::path(database).parent_path().string();
    test.log = folder + "/flight.log";
    test.switch_log = folder + "/flight.switches";
    if (test.picture.scene.empty()) test.picture.scene = database;
}

}  // namespace tedavis::host_sim
