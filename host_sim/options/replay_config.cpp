#include "host_sim/options/replay_config.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "host_sim/atomic_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/options/asked_parameters.hpp"
#include "host_sim/options/display_config_text.hpp"
#include "host_sim/options/toml_writer.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/config_reader.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::array<std::string_view, 3> kFrameNames = {"png", "hash", "none"};
constexpr std::array<std::string_view, 2> kGlNames = {"egl", "osmesa"};
constexpr double kLargestNumber = 1e9;

/// A path stays right when the config is used from elsewhere.
std::string absolute(const std::string& path) {
    return path.empty() ? path : std::filesystem::absolute(path).lexically_normal().string();
}

/// A board knows no short names.
std::string absolute_config(const std::string& name, const char* folder) {
    return name.empty() ? name : absolute(resolve_config(name, folder));
}

template <std::size_t N>
void put(base::FixedString<N>& text, const std::string& value, const char* what) {
    text = base::FixedString<N>(value);
    if (text.cut()) throw UserError(std::string(what) + " \"" + value + "\": is too long for a configuration; use a shorter one");
}

/// An empty folder of palettes is the working folder.
void put_folders(const DesignFolders& folders, platform::DisplayConfig& config) {
    const std::string shipped = absolute(shipped_root()) + "/configs/";
    const std::string palettes = folders.palettes.empty() ? "./" : folders.palettes;
    put(config.palettes, absolute(folders.shipped ? shipped + "palettes/" : palettes), "palettes");
    put(config.designs, absolute(folders.shipped ? shipped + "designs/" : folders.designs), "designs");
}

/// What the board alone has stays as it was read, with its paths as absolute ones.
platform::DisplayConfig display_config_of(const ReplayOptions& options) {
    const PictureOptions& picture = options.picture;
    platform::DisplayConfig config;
    if (options.config) config = *options.config;
    if (config.title.empty()) config.title.append("replay");
    if (config.surface.empty()) config.surface.append("egl");
    put(config.device, absolute_config(picture.device, "devices"), "device");
    put(config.design, absolute_config(picture.design, "designs"), "design");
    put_folders(picture.design_folders, config);
    put(config.bus, absolute_config(picture.bus, "buses"), "bus");
    put(config.aircraft, absolute_config(picture.aircraft, "aircraft"), "aircraft");
    put(config.symbology, absolute_config(picture.palette, "palettes/symbology"), "palette");
    const bool has_panel = !config.switches.empty() || !options.switches.empty();
    put(config.switches, has_panel ? absolute_config(options.switch_config, "switches") : "", "switch config");
    put(config.terrain, absolute(picture.terrain), "terrain");
    put(config.scene, absolute(picture.scene), "scene");
    put(config.costs, absolute(picture.costs), "costs");
    put(config.programs, absolute(std::string(config.programs.view())), "programs");
    put(config.records, absolute(std::string(config.records.view())), "records");
    config.parameters = asked_parameters(picture);
    config.deadline_ms = picture.deadline_ms;
    config.light = picture.light;
    config.legend = picture.legend;
    config.width_px = picture.size ? picture.size->width : 0;
    config.height_px = picture.size ? picture.size->height : 0;
    return config;
}

std::optional<double> optional_number(base::ConfigSection& section, std::string_view key) {
    return section.has(key) ? std::optional<double>(section.number(key, -kLargestNumber, kLargestNumber)) : std::nullopt;
}

/// Reads [replay] of a file.
class ReplaySection {
public:
    ReplaySection(base::ConfigSection section, const std::string& file) : section_(section), file_(file) {}

    void read(ReplayOptions& options) {
        options.log = path_at("log");
        options.switches = path_at("switches");
        read_phase(options);
        if (section_.has("class")) section_.choose("class", flight::kAircraftClassNames, options.aircraft_class.emplace());
        options.from_s = optional_number(section_, "from_s");
        options.to_s = optional_number(section_, "to_s");
        options.step_s = optional_number(section_, "step_s");
        options.over_terrain = section_.boolean("over_terrain", false);
        if (section_.has("spread")) options.spread = static_cast<std::uint64_t>(section_.integer("spread", 2, kMaxSpread));
        if (section_.has("frames")) section_.choose("frames", kFrameNames, options.frames.emplace());
        read_ghosts(options);
        options.accuracy = {section_.boolean("show_accuracy", false), section_.boolean("error_map", false)};
        read_picture(options.picture);
    }

private:
    std::string path_at(std::string_view key) {
        const std::string name(section_.text(key, ""));
        return name.empty() ? name : path_from(file_, name);
    }

    void read_phase(ReplayOptions& options) {
        options.phase = std::string(section_.text("phase", ""));
        if (!options.phase.empty() && options.phase != kNoPhase && !flight::phase_from_name(options.phase).ok)
            section_.fault("phase", "no such phase; say for example takeoff.first_climb, cruise or none");
    }

    void read_ghosts(ReplayOptions& options) {
        std::array<std::string_view, kMaxGhosts> logs;
        const std::size_t count = section_.texts("ghosts", logs);
        for (std::size_t n = 0; n < std::min(count, logs.size()); ++n)
            options.ghosts.push_back(path_from(file_, std::string(logs[n])));
        if (section_.has("ghost_align")) section_.choose("ghost_align", kGhostAlignNames, options.ghost_align);
    }

    void read_picture(PictureOptions& picture) {
        section_.choose("gl", kGlNames, picture.gl);
        picture.force_effects = section_.boolean("force_effects", false);
        if (section_.has("saliency"))
            section_.choose("saliency", design::kSaliencyViewNames, picture.saliency.emplace(), design::SaliencyView::heat);
        if (section_.has("clutter"))
            section_.choose("clutter", design::kClutterViewNames, picture.clutter.emplace(), design::ClutterView::edges);
    }

    base::ConfigSection section_;
    const std::string& file_;
};

void take_picture(const platform::DisplayConfig& config, PictureOptions& picture) {
    picture.terrain = config.terrain.view();
    picture.scene = config.scene.view();
    picture.design = config.design.view();
    picture.design_folders = {false, std::string(config.designs.view()), std::string(config.palettes.view())};
    picture.device = config.device.view();
    picture.bus = config.bus.view();
    picture.aircraft = config.aircraft.view();
    picture.palette = config.symbology.view();
    picture.light = config.light;
    picture.legend = config.legend;
    picture.costs = config.costs.view();
    picture.tau_px = config.parameters.tau_px;
    picture.deadline_ms = config.deadline_ms;
    for (const platform::AspectWeight& weight : config.parameters.weights)
        picture.weights[std::string(weight.aspect.view())] = weight.weight;
    for (const auto& line : config.parameters.foci) picture.foci.emplace_back(line.view());
    if (config.width_px > 0) picture.size = PictureSize{config.width_px, config.height_px};
}

}  // namespace

std::string replay_section_text(const ReplayOptions& options) {
    TomlWriter toml;
    toml.word("log", absolute(options.log));
    toml.word("switches", absolute(options.switches));
    toml.word("phase", options.phase);
    if (options.aircraft_class)
        toml.word("class", flight::kAircraftClassNames[static_cast<std::size_t>(*options.aircraft_class)]);
    toml.number("from_s", options.from_s);
    toml.number("to_s", options.to_s);
    toml.number("step_s", options.step_s);
    if (options.over_terrain) toml.truth("over_terrain", true);
    if (options.spread) toml.integer("spread", *options.spread);
    if (options.frames) toml.word("frames", kFrameNames[static_cast<std::size_t>(*options.frames)]);
    std::vector<std::string> ghosts = options.ghosts;
    for (std::string& log : ghosts) log = absolute(log);
    toml.words("ghosts", ghosts);
    if (!options.ghosts.empty()) toml.word("ghost_align", name_of(options.ghost_align));
    if (options.accuracy.figures) toml.truth("show_accuracy", true);
    if (options.accuracy.error_map) toml.truth("error_map", true);
    const PictureOptions& picture = options.picture;
    if (picture.gl != GlChoice::egl) toml.word("gl", kGlNames[static_cast<std::size_t>(picture.gl)]);
    if (picture.force_effects) toml.truth("force_effects", true);
    if (picture.saliency) toml.word("saliency", design::kSaliencyViewNames[static_cast<std::size_t>(*picture.saliency) - 1]);
    if (picture.clutter) toml.word("clutter", design::kClutterViewNames[static_cast<std::size_t>(*picture.clutter) - 1]);
    return toml.text().empty() ? "" : "\n[replay]\n" + toml.text();
}

std::string replay_config_text(const ReplayOptions& options) {
    return display_config_text(display_config_of(options)) + replay_section_text(options);
}

void save_replay_config(const ReplayOptions& options, const std::string& path) {
    write_file_atomically(path, replay_config_text(options));
}

ReplayOptions load_replay_config(const std::string& path, const std::string& pack_key) {
    const auto found = platform::find_config(path.c_str(), pack_key.c_str());
    if (!found.ok()) throw UserError(std::string(found.error().message.view()));
    const std::string file(found.value().file.view()), text = read_file(file);
    base::ConfigReader reader(text, file);
    auto config = std::make_shared<platform::DisplayConfig>();
    platform::read_display_config(reader, platform::ConfigUse::desk, *config);
    ReplayOptions options;
    options.pack = found.value().pack;
    take_picture(*config, options.picture);
    options.picture.valid_period = platform::valid_period(options.pack);
    if (!config->switches.empty()) options.switch_config = config->switches.view();
    ReplaySection(reader.root().section("replay"), file).read(options);
    options.config = std::move(config);
    if (!reader.finish()) throw UserError(std::string(reader.error().message.view()));
    return options;
}

}  // namespace tedavis::host_sim
