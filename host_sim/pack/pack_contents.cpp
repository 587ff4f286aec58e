#include "host_sim/pack/pack_contents.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include "bus/canaerospace/bus_settings.hpp"
#include "bus/switches/switch_config.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/options/display_config_text.hpp"
#include "host_sim/options/replay_config.hpp"
#include "host_sim/pack/packed_designs.hpp"
#include "host_sim/scene_builder/open_scene.hpp"
#include "host_sim/terrain_builder/verify_database.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/design/aircraft_settings.hpp"
#include "render_core/effects/calibration.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::host_sim {
namespace {

namespace fs = std::filesystem;
using platform::Path;

class ContentsReader {
public:
    explicit ContentsReader(const ReplayOptions& options) : options_(options), config_(*options.config) {}

    PackContents read() {
        contents_.title = config_.title.view();
        take(config_.device, "devices/", &effects::read_device_settings);
        read_designs();
        take(config_.bus, "buses/", &bus::load_bus_settings);
        take(config_.aircraft, "aircraft/", &design::load_aircraft);
        take(config_.symbology, "symbology/", &design::load_symbology_palettes);
        take(config_.switches, "switches/", &bus::load_switch_config);
        take(config_.costs, "costs/",
             [](std::string_view text, std::string_view file) { return effects::read_calibration(text, file); });
        take_terrain();
        take_scene();
        take_programs();
        if (!config_.records.empty()) config_.records = Path(fs::absolute(config_.records.view()).lexically_normal().string());
        ReplayOptions shown = options_;
        shown.log.clear();
        shown.switches.clear();
        shown.ghosts.clear();
        shown.from_s.reset();
        shown.to_s.reset();
        contents_.config_text = display_config_text(config_) + replay_section_text(shown);
        std::sort(contents_.files.begin(), contents_.files.end(),
                  [](const PackedFile& a, const PackedFile& b) { return a.path < b.path; });
        return std::move(contents_);
    }

private:
    PackedFile place(Path& name, const char* folder) {
        PackedFile file;
        file.from = name.view();
        file.path = folder + fs::path(file.from).filename().string();
        name = Path(file.path);
        return file;
    }

    template <class Load>
    void take(Path& name, const char* folder, Load load) {
        if (name.empty()) return;
        PackedFile file = place(name, folder);
        const std::string text = read_file(file.from);
        const auto loaded = load(text, std::string_view(file.from));
        if (!loaded.ok()) throw UserError(std::string(loaded.error().message.view()));
        add_packed(std::move(file), contents_.files);
    }

    void read_designs() {
        PackedDesigns designs(options_.picture.design_folders, contents_.files);
        const std::string place = designs.add(std::string(config_.design.view()));
        config_.design = Path(place);
        config_.palettes = Path("palettes");
        if (!config_.designs.empty()) config_.designs = Path("designs");
    }

    void take_terrain() {
        if (config_.terrain.empty()) return;
        PackedFile file = place(config_.terrain, "terrain/");
        const OpenDatabase open(file.from);
        file.sources = open.database().header().source;
        add_packed(std::move(file), contents_.files);
    }

    void take_scene() {
        if (config_.scene.empty()) return;
        PackedFile file = place(config_.scene, "scene/");
        const OpenScene open(file.from);
        file.sources = open.scene().header().origin;
        std::int64_t from = INT64_MIN, until = INT64_MAX;
        for (const scene::Layer& layer : open.scene().layers()) {
            const std::string source = layer.entry->source;
            if (file.sources.find(source) == std::string::npos) file.sources += (file.sources.empty() ? "" : "; ") + source;
            from = std::max(from, layer.entry->valid_from_ns);
            until = std::min(until, layer.entry->valid_until_ns);
        }
        if (from != INT64_MIN) file.valid_from = platform::day_of(from).view();
        if (until != INT64_MAX) file.valid_until = platform::day_of(until).view();
        add_packed(std::move(file), contents_.files);
    }

    void take_programs() {
        if (config_.programs.empty()) return;
        const std::string folder(config_.programs.view());
        std::error_code error;
        for (const auto& entry : fs::directory_iterator(folder, error))
            add_packed({entry.path().string(), "programs/" + entry.path().filename().string(), {}, {}, {}}, contents_.files);
        if (error) throw UserError(folder + ": cannot be read (" + error.message() + "); name the folder of programs");
        config_.programs = Path("programs");
    }

    const ReplayOptions& options_;
    platform::DisplayConfig config_;
    PackContents contents_;
};

}  // namespace

PackContents pack_contents(const ReplayOptions& options, const std::string& named) {
    PackContents contents = ContentsReader(options).read();
    contents.config_origin = named;
    return contents;
}

}  // namespace tedavis::host_sim
