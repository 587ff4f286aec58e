#include "host_sim/replay/scene_findings.hpp"

#include <algorithm>

#include "host_sim/calendar_time.hpp"
#include "host_sim/scene_builder/open_scene.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kInReach_deg = 2;  // some 200 km: farther away nothing is seen

/// What is there at a place for years has a time of survey, which says nothing of the flight.
bool is_of_the_moment(scene::LayerRole role) {
    return role == scene::LayerRole::field || role == scene::LayerRole::wind || role == scene::LayerRole::sample ||
           role == scene::LayerRole::storm_cell || role == scene::LayerRole::traffic;
}

std::string times_words(std::int64_t first_ns, std::int64_t last_ns) {
    const std::string first = utc_text(base::Time{first_ns}), last = utc_text(base::Time{last_ns});
    return first == last ? "of " + first : "from " + first + " to " + last;
}

}  // namespace

GeoExtent extent_of_scene(const std::string& path) { return path.empty() ? GeoExtent() : extent_of(OpenScene(path).scene()); }

Findings scene_findings(const std::string& scene, const GeoExtent& extent, const GeoExtent& flown) {
    if (scene.empty() || !are_apart(extent, flown, kInReach_deg)) return {};
    return {
        {"scene.elsewhere",
         "none of the data of " + scene + " lie near the flight: they cover " + extent.words() + ", the flight " + flown.words(),
         1}};
}

std::vector<LayerTimes> times_of_scene(const std::string& path) {
    std::vector<LayerTimes> found;
    if (path.empty()) return found;
    const OpenScene open(path);
    for (const scene::Layer& layer : open.scene().layers()) {
        const scene::LayerEntry& entry = *layer.entry;
        const bool has_times = !layer.times_ns.empty();
        if (!is_of_the_moment(entry.role) || (!has_times && entry.data_time_ns == scene::kNoTime)) continue;
        LayerTimes times{entry.name, has_times ? layer.times_ns[0] : entry.data_time_ns,
                         has_times ? layer.times_ns[layer.times_ns.size() - 1] : entry.data_time_ns};
        times.from_ns = times.first_ns - base::Duration::seconds(3600).ns;
        times.until_ns =
            entry.valid_until_ns != INT64_MAX ? entry.valid_until_ns : times.last_ns + base::Duration::seconds(86400).ns;
        found.push_back(times);
    }
    return found;
}

Findings time_findings(const std::string& scene, const std::vector<LayerTimes>& layers, base::Time begin, base::Time end) {
    Findings findings;
    for (const LayerTimes& layer : layers)
        if (end.ns < layer.from_ns || begin.ns > layer.until_ns)
            findings.push_back({"scene.other_time",
                                "the data of the layer " + layer.layer + " of " + scene + " are " +
                                    times_words(layer.first_ns, layer.last_ns) + ", and the flight is " +
                                    times_words(begin.ns, end.ns) + ": none of them is of its time",
                                1});
    return findings;
}

}  // namespace tedavis::host_sim
