#include "host_sim/replay/ghost_flights.hpp"

#include <algorithm>
#include <filesystem>

#include "host_sim/atomic_file.hpp"
#include "host_sim/scene_builder/draft_of.hpp"
#include "host_sim/scene_builder/open_scene.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr const char* kGhostPrefix = "GHOST ";
constexpr std::size_t kMaxGhostName = scene::kNameBytes - 1 - 6;  // beside the prefix

std::string name_of_file(const std::string& log) {
    const std::string name = std::filesystem::path(log).filename().string();
    return name.substr(0, std::max<std::size_t>(name.find('.'), 1));
}

std::string name_of_folder(const std::string& log) {
    return std::filesystem::absolute(log).lexically_normal().parent_path().filename().string();
}

/// Between characters of UTF-8.
std::string cut(const std::string& text, std::size_t most) {
    if (text.size() <= most) return text;
    while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0u) == 0x80u) --most;
    return text.substr(0, most);
}

PlayerFiles files_of_ghost(const ReplayOptions& options, const std::string& log) {
    PlayerFiles files = player_files(options);
    files.log = log;
    files.switches.clear();
    return files;
}

ShownGhost shown(const ScannedFlight& own, const std::string& log, const std::string& name, GhostAlign align,
                 const GhostTrack& track) {
    ShownGhost ghost{log, name, align, track.shift_s, {}};
    for (const ScannedPlace& place : track.places)
        ghost.places.push_back({(place.time - own.first).to_seconds(), base::degrees(place.latitude_rad),
                                base::degrees(place.longitude_rad), place.joins_next});
    return ghost;
}

SceneDraft scene_of_options(const std::string& path) {
    if (!path.empty()) return draft_of(OpenScene(path).scene());
    SceneDraft draft;
    draft.name = "ghosts";
    return draft;
}

}  // namespace

LayerDraft ghost_layer(const ScannedFlight& own, const std::vector<ShownGhost>& flights, const std::vector<GhostTrack>& tracks) {
    LayerDraft layer;
    layer.name = "ghosts";
    layer.title = "GHOSTS";
    layer.shape = scene::LayerShape::lines;
    layer.role = scene::LayerRole::ghost;
    layer.height_datum = scene::HeightDatum::ellipsoid;
    layer.starts = {0};
    for (std::size_t n = 0; n < tracks.size(); ++n) {
        const auto end_line = [&] {
            const auto count = static_cast<std::uint32_t>(layer.points.size());
            if (count - layer.starts.back() < 2) return layer.points.resize(layer.starts.back());
            layer.starts.push_back(count);
            layer.names.push_back(kGhostPrefix + flights[n].name);
        };
        for (const ScannedPlace& place : tracks[n].places) {
            layer.points.push_back(
                {place.latitude_rad, place.longitude_rad, static_cast<float>(place.height_m), 0, (place.time + own.ahead).ns});
            if (!place.joins_next) end_line();
        }
        end_line();
    }
    return layer;
}

std::vector<std::string> ghost_names(const std::string& own, const std::vector<std::string>& logs) {
    std::vector<std::string> files{name_of_file(own)}, names;
    for (const std::string& log : logs) files.push_back(name_of_file(log));
    for (std::size_t n = 0; n < logs.size(); ++n) {
        const bool is_alone = std::count(files.begin(), files.end(), files[n + 1]) == 1;
        std::string name = cut(is_alone ? files[n + 1] : name_of_folder(logs[n]), kMaxGhostName);
        if (name.empty()) name = files[n + 1];
        if (std::count(names.begin(), names.end(), name) > 0) name = cut(name, kMaxGhostName - 2) + " " + std::to_string(n + 1);
        names.push_back(name);
    }
    return names;
}

ShownGhosts make_ghosts(const ReplayOptions& options, const std::string& folder, Console& console) {
    if (options.ghosts.size() > kMaxGhosts)
        throw UserError("--ghost: at most " + std::to_string(kMaxGhosts) + " flights are shown beside the own one, not " +
                        std::to_string(options.ghosts.size()) + "; leave some out");
    SceneDraft scene = scene_of_options(options.picture.scene);
    const ScannedFlight own = scan_flight(player_files(options), console);
    const std::vector<std::string> names = ghost_names(options.log, options.ghosts);
    ShownGhosts ghosts;
    std::vector<GhostTrack> tracks;
    for (std::size_t n = 0; n < options.ghosts.size(); ++n) {
        const std::string& log = options.ghosts[n];
        tracks.push_back(ghost_track(own, scan_flight(files_of_ghost(options, log), console), options.ghost_align));
        ghosts.flights.push_back(shown(own, log, names[n], options.ghost_align, tracks.back()));
    }
    for (const LayerDraft& layer : scene.layers)
        if (layer.name == "ghosts")
            throw UserError("--ghost: " + options.picture.scene + " has a layer 'ghosts' already; give that layer another name");
    scene.layers.push_back(ghost_layer(own, ghosts.flights, tracks));
    const std::vector<std::uint8_t> bytes = sdb_bytes(scene);
    ghosts.scene = folder + "/ghosts.sdb";
    write_file_atomically(ghosts.scene, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    return ghosts;
}

}  // namespace tedavis::host_sim
