#include "host_sim/commands/check.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

#include "bus/canaerospace/bus_settings.hpp"
#include "bus/canaerospace/identifier_table.hpp"
#include "bus/switches/switch_config.hpp"
#include "host_sim/commands/check_log.hpp"
#include "host_sim/commands/check_raster.hpp"
#include "host_sim/commands/check_switch_log.hpp"
#include "host_sim/commands/sheet_plan.hpp"
#include "host_sim/commands/start_trial.hpp"
#include "host_sim/contract/contract.hpp"
#include "host_sim/evaluation/picture_orderings.hpp"
#include "host_sim/flight_test/read_flight_test.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/measure/palette_check.hpp"
#include "host_sim/measure/symbology_palette_check.hpp"
#include "host_sim/options/replay_config.hpp"
#include "host_sim/pack/pack_contents.hpp"
#include "host_sim/replay/load_design.hpp"
#include "host_sim/replay/resolved_design.hpp"
#include "host_sim/reports/height_findings.hpp"
#include "host_sim/scenario/scenario.hpp"
#include "host_sim/scene_builder/open_scene.hpp"
#include "host_sim/scene_builder/scene_build.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/terrain_builder/verify_database.hpp"
#include "host_sim/toml_text.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/design/aircraft_settings.hpp"
#include "render_core/design/design_settings.hpp"
#include "render_core/design/symbology_palette.hpp"
#include "render_core/effects/calibration.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr const char* kDevice = "a device";

/// What a sound file is, in a few words; throws UserError otherwise.
using FileChecker = std::string (*)(const std::string& path);

template <class Loaded>
void require(const Loaded& loaded) {
    if (!loaded.ok()) throw UserError(std::string(loaded.error().message.view()));
}

/// One sentence a line.
void require_no_faults(const std::vector<std::string>& faults) {
    std::string all;
    for (const std::string& fault : faults) all += (all.empty() ? "" : "\n") + fault;
    if (!all.empty()) throw UserError(all);
}

void require_legible(const design::Palette& palette, const design::DesignSettings& design, const std::string& path) {
    const std::string name = path + ": palette " + std::string(palette.name.view());
    require_no_faults(palette_faults(palette, name));
    require_no_faults(palette_faults_in_design(palette, design, name));
}

void require_legible(const design::DesignSettings& design, const std::string& path) {
    require_legible(design.terrain.palette, design, path);
    if (design.data.ground.is_shown) require_legible(design.data.ground.scale.palette, design, path);
}

std::string check_design(const std::string& path) {
    PictureOptions options;
    options.design = path;
    const std::unique_ptr<LoadedDesigns> designs = load_designs(options);
    require_legible(designs->design, path);
    for (std::size_t place = 1; place <= designs->phases.size(); ++place) require_legible(designs->phases.at(place), path);
    return "a design";
}

/// A palette is judged with the colours of a display that was given no design; one that fits terrain, without bands: natural
/// ground has none.
std::string check_palette(const std::string& path) {
    const design::Palette palette = palette_from_text(read_file(path), path);
    std::vector<std::string> faults = palette_faults(palette, path);
    design::DesignSettings design = design::default_design_settings();
    design.warning_colors = !palette.fits_terrain;
    for (std::string& fault : palette_faults_in_design(palette, design, path)) faults.push_back(std::move(fault));
    require_no_faults(faults);
    return "a palette of " + std::to_string(palette.stops.size()) + " colours, fit for every colour vision";
}

std::string check_device(const std::string& path) {
    require(effects::read_device_settings(read_file(path), path));
    return kDevice;
}

std::string check_aircraft(const std::string& path) {
    require(design::load_aircraft(read_file(path), path));
    return "an aircraft";
}

std::string check_symbology_palette(const std::string& path) {
    const auto palettes = design::load_symbology_palettes(read_file(path), path);
    require(palettes);
    require_no_faults(symbology_palette_faults(palettes.value(), path));
    return "a palette of the symbology, by day and by night, fit for every color vision";
}

std::string check_costs(const std::string& path) {
    const auto read = effects::read_calibration(read_file(path), path);
    require(read);
    return "costs of the device " + std::string(read.value().subject.device.view());
}

/// " in place of GPS latitude", where the identifier has a meaning in the standard.
std::string in_place_of(std::uint16_t identifier) {
    const std::uint16_t index = bus::identifier_index(identifier);
    return index == bus::kNotInTable ? "" : " in place of " + std::string(bus::identifier_table()[index].name);
}

std::string check_bus(const std::string& path) {
    const auto settings = bus::load_bus_settings(read_file(path), path);
    require(settings);
    std::string words = "a bus";
    for (const bus::StatedMessage& message : settings.value().messages)
        words += (words == "a bus" ? ", on which " : ", ") + std::to_string(message.identifier) + " states " +
                 flight::to_string(message.signal) + in_place_of(message.identifier);
    return words;
}

std::string check_switches(const std::string& path) {
    require(bus::load_switch_config(read_file(path), path));
    return "a switch panel";
}

/// Made as a build does, from all of its sources, and not written.
std::string check_scene(const std::string& path) {
    const std::string folder = fs::path(path).parent_path().string();
    const MadeScene made = make_scene(parse_scene(read_file(path), path), folder, [](auto, auto, auto) {});
    return "a scene of " + std::to_string(made.draft.layers.size()) + " layers";
}

std::string check_scenario(const std::string& path) {
    const Scenario scenario = parse_scenario(read_file(path), path);
    std::string found = "a scenario of " + std::to_string(scenario.legs.size()) + " legs";
    if (scenario.weather) found += ", with weather";
    if (!scenario.scene.empty()) found += ", round it " + check_scene(scenario.scene);
    return found;
}

/// Files of a board lie there. The sentence says how they are tested.
std::size_t sound_files(const ReplayOptions& options, const std::string& path) {
    try {
        return pack_contents(options, path).files.size();
    } catch (const UserError& error) {
        if (!options.config->has_can || options.pack.is_pack()) throw;
        throw UserError(error.what() + ("; a file of the board is tested there: tedavis-display --self-test --config " + path));
    }
}

/// A display starts without its scene, and takes it over when it comes; that of a pack is there.
bool leave_absent_scene(ReplayOptions& options) {
    if (options.pack.is_pack() || options.config->scene.empty() || fs::exists(fs::symlink_status(options.config->scene.c_str())))
        return false;
    platform::DisplayConfig config = *options.config;
    config.scene.clear();
    options.config = std::make_shared<platform::DisplayConfig>(config);
    return true;
}

/// Each file that it names is read as at a start.
std::string check_configuration(const std::string& path) {
    ReplayOptions options = load_replay_config(path);
    const bool lacks_scene = leave_absent_scene(options);
    const std::size_t files = sound_files(options, path);
    if (options.pack.is_pack()) return "a pack of " + std::to_string(options.pack.files) + " files, each as packed";
    return "a configuration of desk and board, which names " + std::to_string(files) + " sound files" +
           (lacks_scene ? " and a scene that is not there yet" : "");
}

std::string check_sheet(const std::string& path) {
    const SheetPlan plan = read_sheet_plan(path);
    require_designs(plan, path);
    return "a contact sheet of " + std::to_string(plan.picture_count()) + " pictures";
}

CheckedFile check_terrain(const std::string& path) {
    const OpenDatabase open(path);
    verify_database(open, [](std::uint64_t, std::uint64_t) {});
    return {"a terrain database, every checksum right", height_findings(path, height_counts(open.database().header()))};
}

std::string check_scene_database(const std::string& path) {
    const OpenScene open(path);
    return "a scene database of " + std::to_string(open.scene().layers().size()) + " layers, revision " +
           std::to_string(open.scene().header().revision) + ", every checksum right";
}

constexpr std::array<std::string_view, 17> kRasterExtensions = {".tif", ".tiff", ".hgt", ".zip", ".hf2", ".hfz",
                                                                ".ter", ".bt",   ".asc", ".img", ".vrt", ".dem",
                                                                ".dt0", ".dt1",  ".dt2", ".nc",  ".mmf"};

bool is_raster_name(std::string extension) {
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return std::find(kRasterExtensions.begin(), kRasterExtensions.end(), extension) != kRasterExtensions.end();
}

std::string check_orderings(const std::string& path) {
    return std::to_string(read_orderings(path).orderings.size()) + " orderings of pictures";
}

std::string check_contract(const std::string& path) {
    const std::size_t count = read_contract(path).conditions.size();
    return "a contract of " + std::to_string(count) + (count == 1 ? " condition" : " conditions");
}

/// Those in a folder below are there to be included: what their parameters stand for, the including script says.
std::string check_flight_test(const std::string& path) {
    ScriptFaults faults;
    const bool is_part = fs::absolute(path).parent_path().parent_path().filename() == "flight_tests";
    std::size_t expected = 0;
    if (is_part)
        static_cast<void>(parse_script_value(read_file(path), path, faults));
    else
        expected = read_flight_test(path, {}, faults).expectations.size();
    const std::vector<std::string> sentences = faults.sentences();
    const std::string more =
        sentences.size() > 1 ? " (1 of " + std::to_string(sentences.size()) + " faults; tedavis verify says all)" : "";
    if (!sentences.empty()) throw UserError(sentences.front() + more);
    return is_part ? "a part of flight tests" : "a flight test of " + std::to_string(expected) + " expectations";
}

struct FolderKind {
    std::string_view folder, key;  ///< place under configs/; a key that only this kind has
    FileChecker check;
};
constexpr std::array<FolderKind, 21> kConfigKinds = {{{"designs", "[view]", check_design},
                                                      {"designs", "based_on =", check_design},
                                                      {"designs", "[phases]", check_design},
                                                      {"symbology", "[night]", check_symbology_palette},
                                                      {"symbology", "[day]", check_symbology_palette},
                                                      {"palettes", "[[stop]]", check_palette},
                                                      {"palettes", "[[class]]", check_palette},
                                                      {"devices", "[[budget]]", check_device},
                                                      {"aircraft", "[speeds]", check_aircraft},
                                                      {"buses", "[dialect]", check_bus},
                                                      {"switches", "[[pattern]]", check_switches},
                                                      {"scenarios", "[[leg]]", check_scenario},
                                                      {"scenes", "[[layer]]", check_scene},
                                                      {"sheets", "[[group.picture]]", check_sheet},
                                                      {"orderings", "[[ordering]]", check_orderings},
                                                      {"contracts", "[[condition]]", check_contract},
                                                      {"flight_tests", "[[expect]]", check_flight_test},
                                                      {"costs", "[cost.terrain]", check_costs},
                                                      {"boards", "[can]", check_configuration},
                                                      {"boards", "[surface]", check_configuration},
                                                      {"boards", "[replay]", check_configuration}}};

/// A palette may be of terrain and data or of the symbology, whichever folder of palettes it lies in.
bool is_of_symbology(const std::string& text) {
    return std::any_of(kConfigKinds.begin(), kConfigKinds.end(), [&](const FolderKind& kind) {
        return kind.folder == "symbology" && text.find(kind.key) != std::string::npos;
    });
}

/// By the folder it lies in; elsewhere by what only its kind holds.
FileChecker config_checker(const std::string& path) {
    const fs::path place = fs::absolute(path).parent_path();
    const std::string folder = place.filename().string(), outer_folder = place.parent_path().filename().string();
    for (const FolderKind& kind : kConfigKinds) {
        if (folder == kind.folder || (outer_folder == kind.folder && place.filename() != "configs"))
            return kind.check == check_palette && is_of_symbology(read_file(path)) ? check_symbology_palette : kind.check;
    }
    const std::string text = read_file(path);
    for (const FolderKind& kind : kConfigKinds) {
        if (text.find(kind.key) != std::string::npos) return kind.check;
    }
    throw UserError(path +
                    ": neither its folder nor its content says what it configures; put it into designs, palettes, "
                    "palettes/symbology, devices, aircraft, buses, "
                    "switches, scenarios, scenes, sheets, orderings, contracts or flight_tests");
}

CheckedFile check_file(const std::string& path, const CheckOptions& options) {
    const std::string extension = fs::path(path).extension().string();
    if (fs::is_regular_file(path + "/" + platform::kPackManifest)) return check_configuration(path);
    if (extension == ".toml") return config_checker(path)(path);
    if (extension == ".tdb") return check_terrain(path);
    if (extension == ".sdb") return check_scene_database(path);
    if (extension == ".switches") return check_switch_log(path, options.switch_config);
    if (extension == ".log" || extension == ".gz") return check_log(path, options.bus);
    if (is_raster_name(extension)) return check_raster(path);
    (void)read_file(path);
    if (extension == ".dbc")
        throw UserError(path +
                        ": a CAN database for other tools, which no program here reads; check the bus file (.toml) instead");
    throw UserError(
        path + ": '" + extension +
        "' is no kind of file that is checked here; known are .toml, .tdb, .sdb, .log, .log.gz, .switches and height rasters");
}

/// ", but: ..."; the line has named the file already.
std::string but_words(const std::string& path, const Findings& findings) {
    std::string words;
    for (const Finding& finding : findings) {
        const bool names_it = finding.text.compare(0, path.size() + 2, path + ": ") == 0;
        words += (words.empty() ? ", but: " : "; ") + (names_it ? finding.text.substr(path.size() + 2) : finding.text);
    }
    return words;
}

/// Of the files those that a checker finds sound.
std::vector<std::string> sound_among(const std::vector<std::string>& files, FileChecker checker) {
    std::vector<std::string> sound;
    for (const std::string& path : files) {
        if (fs::path(path).extension() != ".toml") continue;
        try {
            if (config_checker(path) != checker) continue;
            static_cast<void>(checker(path));
            sound.push_back(path);
        } catch (const UserError&) {
            continue;  // said where it is checked itself
        }
    }
    return sound;
}

/// A device that no start would take is not sound. It must start with the designs that are checked beside it; of several devices
/// each, and one that is checked without a design, with what is shown where nobody names one.
void require_starts(const std::string& device, const std::vector<std::string>& files) {
    std::vector<std::string> designs;
    if (sound_among(files, check_device).size() == 1) designs = sound_among(files, check_design);
    if (designs.empty()) designs.push_back(PictureOptions().design);
    StartTrial trial;
    for (const std::string& design : designs) trial.require(device, design);
}

Json sound_json(const std::string& path, const CheckedFile& file) {
    return {{"file", path}, {"sound", true}, {"is", file.is}, {"warnings", findings_json(file.warnings)}};
}

/// One design, with all that it inherits.
void print_resolved(const CheckOptions& options, Console& console) {
    if (options.files.size() != 1) throw UserError("--resolved: prints one design; name one file");
    const std::string path = resolve_config(options.files.front(), "designs");
    if (fs::path(path).extension() != ".toml" || config_checker(path) != check_design)
        throw UserError(path + ": is no design, and --resolved prints what a design inherits; leave it out");
    Json result = sound_json(path, {check_design(path), {}});
    result["resolved"] = resolved_design(path);
    console.result(toml_text(result["resolved"]), json_text(Json::array({result})));
}

}  // namespace

int run_check(const CheckOptions& options, Console& console) {
    if (options.resolved) {
        print_resolved(options, console);
        return 0;
    }
    Json results = Json::array();
    std::string text;
    bool all_sound = true;
    Findings warnings;
    for (const std::string& path : options.files) {
        try {
            const CheckedFile file = check_file(path, options);
            if (file.is == kDevice) require_starts(path, options.files);
            results.push_back(sound_json(path, file));
            text += path + ": sound, " + file.is + but_words(path, file.warnings) + "\n";
            append(warnings, file.warnings);
        } catch (const UserError& error) {
            all_sound = false;
            results.push_back({{"file", path}, {"sound", false}, {"fault", error.what()}, {"warnings", Json::array()}});
            console.note(error.what());
        }
    }
    if (!text.empty() || console.json()) console.result(text, json_text(results));
    return all_sound ? exit_code_of(warnings, options.strict) : kFaultyInputExitCode;
}

}  // namespace tedavis::host_sim
