#include "host_sim/options/replay_config.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <sstream>
#include <string_view>

#include "host_sim/atomic_file.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/toml_text.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/config_reader.hpp"
#include "render_core/flight/flight_phase.hpp"
#include "render_core/scene/focus_region.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::array<std::string_view, 3> kFrameNames = {"png", "hash", "none"};
constexpr std::array<std::string_view, 2> kGlNames = {"egl", "osmesa"};
constexpr double kLargestNumber = 1e9;

/// A path stays right when the config is used from elsewhere.
std::string absolute(const std::string& path) {
    return path.empty() ? path : std::filesystem::absolute(path).lexically_normal().string();
}

/// The name of a shipped file stays short.
std::string absolute_unless_shipped(const std::string& name, const std::string& folder) {
    return resolve_config(name, folder) == name ? absolute(name) : name;
}

class TomlWriter {
public:
    TomlWriter() { text_.precision(std::numeric_limits<double>::max_digits10); }

    void path(const char* key, const std::string& value) { word(key, absolute(value)); }
    void config(const char* key, const std::string& name, const char* folder) {
        word(key, absolute_unless_shipped(name, folder));
    }
    void word(const char* key, std::string_view value) {
        if (!value.empty()) text_ << key << " = " << toml_string(std::string(value)) << '\n';
    }
    void number(const char* key, const std::optional<double>& value) {
        if (value) text_ << key << " = " << std::showpoint << *value << '\n';
    }
    void paths(const char* key, std::vector<std::string> values) {
        for (std::string& value : values) value = absolute(value);
        words(key, values);
    }
    void words(const char* key, const std::vector<std::string>& values) {
        if (values.empty()) return;
        text_ << key << " = [";
        for (std::size_t n = 0; n < values.size(); ++n) text_ << (n > 0 ? ", " : "") << toml_string(values[n]);
        text_ << "]\n";
    }
    void truth(const char* key) { text_ << key << " = true\n"; }
    void integer(const char* key, std::uint32_t value) { text_ << key << " = " << value << '\n'; }
    void section(const char* name) { text_ << "\n[" << name << "]\n"; }
    [[nodiscard]] std::string text() const { return text_.str(); }

private:
    std::ostringstream text_;
};

std::optional<double> optional_number(base::ConfigSection& section, std::string_view key) {
    return section.has(key) ? std::optional<double>(section.number(key, -kLargestNumber, kLargestNumber)) : std::nullopt;
}

std::string text_of(base::ConfigSection& section, std::string_view key, const std::string& fallback) {
    return std::string(section.text(key, fallback));
}

void read_picture(base::ConfigSection section, PictureOptions& picture) {
    picture.terrain = text_of(section, "terrain", "");
    picture.scene = text_of(section, "scene", "");
    picture.design = text_of(section, "design", picture.design);
    picture.device = text_of(section, "device", picture.device);
    picture.bus = text_of(section, "bus", picture.bus);
    picture.aircraft = text_of(section, "aircraft", "");
    picture.palette = text_of(section, "palette", "");
    section.choose("light", design::kSymbologyLightNames, picture.light);
    section.choose("gl", kGlNames, picture.gl);
    section.choose("legend", flight::kLegendShowNames, picture.legend, flight::LegendShow::none);
    picture.tau_px = optional_number(section, "tau_px");
    if (section.has("weights")) picture.weights = weights_from(text_of(section, "weights", ""));
    std::array<std::string_view, scene::kMaxFoci> foci;
    const std::size_t count = section.texts("foci", foci);
    picture.foci.assign(foci.begin(), foci.begin() + static_cast<std::ptrdiff_t>(std::min(count, foci.size())));
    picture.deadline_ms = optional_number(section, "deadline_ms");
    picture.costs = text_of(section, "costs", "");
    picture.force_effects = section.boolean("force_effects", false);
    if (section.has("saliency"))
        section.choose("saliency", design::kSaliencyViewNames, picture.saliency.emplace(), design::SaliencyView::heat);
    if (section.has("clutter"))
        section.choose("clutter", design::kClutterViewNames, picture.clutter.emplace(), design::ClutterView::edges);
    if (section.has("width") || section.has("height")) {
        picture.size = PictureSize{static_cast<std::uint32_t>(section.integer("width", 16, 16384)),
                                   static_cast<std::uint32_t>(section.integer("height", 16, 16384))};
    }
}

void read_ghosts(base::ConfigSection& root, ReplayOptions& options) {
    std::array<std::string_view, kMaxGhosts> logs;
    const std::size_t count = root.texts("ghosts", logs);
    options.ghosts.assign(logs.begin(), logs.begin() + static_cast<std::ptrdiff_t>(std::min(count, logs.size())));
    if (root.has("ghost_align")) root.choose("ghost_align", kGhostAlignNames, options.ghost_align);
}

}  // namespace

std::string replay_config_text(const ReplayOptions& options) {
    TomlWriter toml;
    toml.path("log", options.log);
    toml.path("switches", options.switches);
    toml.config("switch_config", options.switch_config, "switches");
    if (!options.phase.empty()) toml.word("phase", options.phase);
    if (options.aircraft_class)
        toml.word("class", std::string(flight::kAircraftClassNames[static_cast<std::size_t>(*options.aircraft_class)]));
    toml.number("from_s", options.from_s);
    toml.number("to_s", options.to_s);
    toml.number("step_s", options.step_s);
    if (options.over_terrain) toml.truth("over_terrain");
    if (options.spread) toml.integer("spread", static_cast<std::uint32_t>(*options.spread));
    if (options.frames) toml.word("frames", kFrameNames[static_cast<std::size_t>(*options.frames)]);
    toml.paths("ghosts", options.ghosts);
    if (!options.ghosts.empty()) toml.word("ghost_align", name_of(options.ghost_align));
    if (options.accuracy.figures) toml.truth("show_accuracy");
    if (options.accuracy.error_map) toml.truth("error_map");
    const PictureOptions& picture = options.picture;
    toml.section("picture");
    toml.path("terrain", picture.terrain);
    toml.path("scene", picture.scene);
    toml.config("design", picture.design, "designs");
    toml.config("device", picture.device, "devices");
    toml.config("bus", picture.bus, "buses");
    if (!picture.aircraft.empty()) toml.config("aircraft", picture.aircraft, "aircraft");
    if (!picture.palette.empty()) toml.config("palette", picture.palette, "palettes/symbology");
    toml.word("light", design::kSymbologyLightNames[static_cast<std::size_t>(picture.light)]);
    if (picture.size) {
        toml.integer("width", picture.size->width);
        toml.integer("height", picture.size->height);
    }
    toml.word("gl", kGlNames[static_cast<std::size_t>(picture.gl)]);
    toml.word("legend", std::string(name_of(picture.legend)));
    toml.number("tau_px", picture.tau_px);
    toml.word("weights", text_of(picture.weights));
    toml.words("foci", picture.foci);
    toml.number("deadline_ms", picture.deadline_ms);
    toml.path("costs", picture.costs);
    if (picture.force_effects) toml.truth("force_effects");
    if (picture.saliency) toml.word("saliency", design::kSaliencyViewNames[static_cast<std::size_t>(*picture.saliency) - 1]);
    if (picture.clutter) toml.word("clutter", design::kClutterViewNames[static_cast<std::size_t>(*picture.clutter) - 1]);
    return toml.text();
}

void save_replay_config(const ReplayOptions& options, const std::string& path) {
    write_file_atomically(path, replay_config_text(options));
}

ReplayOptions load_replay_config(const std::string& path) {
    const std::string text = read_file(path);
    base::ConfigReader reader(text, path);
    base::ConfigSection root = reader.root();
    ReplayOptions options;
    options.log = text_of(root, "log", "");
    options.switches = text_of(root, "switches", "");
    options.switch_config = text_of(root, "switch_config", options.switch_config);
    options.phase = text_of(root, "phase", "");
    if (!options.phase.empty() && options.phase != kNoPhase && !flight::phase_from_name(options.phase).ok)
        throw UserError(path + ": phase \"" + options.phase +
                        "\": no such phase; say for example takeoff.first_climb, cruise or none");
    if (root.has("class")) root.choose("class", flight::kAircraftClassNames, options.aircraft_class.emplace());
    options.from_s = optional_number(root, "from_s");
    options.to_s = optional_number(root, "to_s");
    options.step_s = optional_number(root, "step_s");
    options.over_terrain = root.boolean("over_terrain", false);
    if (root.has("spread")) options.spread = static_cast<std::uint64_t>(root.integer("spread", 2, kMaxSpread));
    if (root.has("frames")) root.choose("frames", kFrameNames, options.frames.emplace());
    read_ghosts(root, options);
    options.accuracy = {root.boolean("show_accuracy", false), root.boolean("error_map", false)};
    read_picture(root.section("picture"), options.picture);
    if (!reader.finish()) throw UserError(std::string(reader.error().message.view()));
    return options;
}

}  // namespace tedavis::host_sim
