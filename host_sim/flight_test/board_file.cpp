#include "host_sim/flight_test/board_file.hpp"

#include <algorithm>
#include <filesystem>
#include <memory>

#include "host_sim/input_file.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"
#include "platform/configuration/display_config.hpp"
#include "platform/configuration/pack_check.hpp"
#include "render_core/base/config_reader.hpp"

namespace tedavis::host_sim {
namespace {

namespace fs = std::filesystem;

bool is_same_file(const std::string& one, const std::string& other) {
    std::error_code error;
    if (fs::equivalent(one, other, error)) return true;
    return fs::is_regular_file(one, error) && fs::is_regular_file(other, error) && read_file(one) == read_file(other);
}

bool is_same_panel(const bus::SwitchConfig& one, const bus::SwitchConfig& other) {
    bool is_same = one.lines.size() == other.lines.size() && one.patterns.size() == other.patterns.size() &&
                   one.has_legend_line == other.has_legend_line;
    for (std::size_t n = 0; is_same && n < one.lines.size(); ++n) is_same = one.lines[n].name == other.lines[n].name;
    for (std::size_t n = 0; is_same && n < one.patterns.size(); ++n)
        is_same = one.patterns[n].high == other.patterns[n].high && one.patterns[n].phase == other.patterns[n].phase;
    return is_same && one.debounce == other.debounce && one.settle == other.settle;
}

std::string misfit(const std::string& what, const std::string& named, const std::string& has) {
    return "is one of the " + what + " '" + named + "', and the board has " + (has.empty() ? "none" : "'" + has + "'");
}

/// Of a terrain or a scene: a path, or the name of one that is built.
bool is_database(const std::string& named, const std::string& has) {
    if (has.empty()) return false;
    const bool is_name = named.find_first_of("./") == std::string::npos;
    return is_name ? fs::path(has).stem() == named : is_same_file(named, has);
}

/// What tedavis-display reads; a fault is the one that it would tell.
platform::DisplayConfig config_of_board(const std::string& path) {
    const std::string text = read_file(path);
    base::ConfigReader reader(text, path);
    const auto config = std::make_unique<platform::DisplayConfig>();
    platform::read_display_config(reader, platform::ConfigUse::board, *config);
    if (!reader.finish()) throw UserError(std::string(reader.error().message.view()));
    return *config;
}

void load_panel_of_board(BoardFile& board) {
    if (board.switches.empty()) return;
    const auto panel = bus::load_switch_config(read_file(board.switches), board.switches);
    if (!panel.ok()) throw UserError(std::string(panel.error().message.view()));
    board.panel = panel.value();
}

}  // namespace

bool throws_switches(const FlightTest& test) {
    if (!test.has_steps) return !test.switch_log.empty() || !test.scenario.empty();
    return std::any_of(test.steps.begin(), test.steps.end(),
                       [](const TestStep& step) { return !step.lines.empty() || step.bounce; });
}

BoardFile read_board_file(const std::string& named) {
    const auto found = platform::find_config(named.c_str(), platform::kInstalledPackKey);
    if (!found.ok()) throw UserError(std::string(found.error().message.view()));
    BoardFile board;
    board.path = found.value().file.view();
    const platform::DisplayConfig config = config_of_board(board.path);
    board.design = config.design.view();
    board.design_folders = {false, std::string(config.designs.view()), std::string(config.palettes.view())};
    board.device = config.device.view();
    board.bus = config.bus.view();
    board.aircraft = config.aircraft.view();
    board.switches = config.switches.view();
    board.terrain = config.terrain.view();
    board.scene = config.scene.view();
    board.interface = config.can.interface_name.view();
    board.can_fd = config.can.can_fd;
    PictureOptions picture;
    picture.device = board.device;
    picture.design = board.design;
    picture.design_folders = board.design_folders;
    board.designs = design_names(picture);
    board.rate_hz = load_device(picture).frame_rate_hz;
    load_panel_of_board(board);
    return board;
}

ScriptDefaults script_defaults(const BoardFile& board) {
    ScriptDefaults defaults;
    defaults.design = board.design;
    defaults.design_folders = board.design_folders;
    defaults.device = board.device;
    defaults.bus = board.bus;
    if (!board.switches.empty()) defaults.switches = board.switches;
    return defaults;
}

std::string misfit_of(const FlightTest& test, const BoardFile& board) {
    const PictureOptions& picture = test.picture;
    if (!is_same_file(picture.design, board.design)) return misfit("design", picture.design, board.design);
    if (!is_same_file(picture.device, board.device)) return misfit("device", picture.device, board.device);
    if (!is_same_file(picture.bus, board.bus)) return misfit("bus", picture.bus, board.bus);
    if (!picture.aircraft.empty() && !is_same_file(picture.aircraft, board.aircraft))
        return misfit("aircraft", picture.aircraft, board.aircraft);
    const bool has_panel = !board.switches.empty();
    if (!has_panel && throws_switches(test)) return "throws switches, and the board has no panel";
    if (has_panel ? !is_same_panel(test.panel, board.panel) : test.switch_config != ScriptDefaults().switches)
        return misfit("panel", test.switch_config, board.switches);
    if (!picture.terrain.empty() && !is_database(picture.terrain, board.terrain))
        return misfit("terrain", picture.terrain, board.terrain);
    if (!picture.scene.empty() && !is_database(picture.scene, board.scene)) return misfit("scene", picture.scene, board.scene);
    return {};
}

}  // namespace tedavis::host_sim
