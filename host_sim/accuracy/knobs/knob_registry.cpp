#include "host_sim/accuracy/knobs/knob_registry.hpp"

#include <algorithm>
#include <set>

#include "host_sim/accuracy/knobs/air_knob.hpp"
#include "host_sim/accuracy/knobs/attitude_knob.hpp"
#include "host_sim/accuracy/knobs/cap_overlap_knob.hpp"
#include "host_sim/accuracy/knobs/cell_cut_knob.hpp"
#include "host_sim/accuracy/knobs/color_classes_knob.hpp"
#include "host_sim/accuracy/knobs/crack_knob.hpp"
#include "host_sim/accuracy/knobs/depth_knob.hpp"
#include "host_sim/accuracy/knobs/distance_knob.hpp"
#include "host_sim/accuracy/knobs/effect_knobs.hpp"
#include "host_sim/accuracy/knobs/frame_settings_knob.hpp"
#include "host_sim/accuracy/knobs/isosurface_knob.hpp"
#include "host_sim/accuracy/knobs/label_places_knob.hpp"
#include "host_sim/accuracy/knobs/output_knobs.hpp"
#include "host_sim/accuracy/knobs/own_ship_knob.hpp"
#include "host_sim/accuracy/knobs/perception_knobs.hpp"
#include "host_sim/accuracy/knobs/picture_knobs.hpp"
#include "host_sim/accuracy/knobs/quality_level_knob.hpp"
#include "host_sim/accuracy/knobs/ray_search_knobs.hpp"
#include "host_sim/accuracy/knobs/sky_knobs.hpp"
#include "host_sim/accuracy/knobs/surface_knob.hpp"
#include "host_sim/accuracy/knobs/terrain_tau_knob.hpp"
#include "host_sim/accuracy/knobs/tube_knobs.hpp"
#include "host_sim/accuracy/knobs/vertex_knob.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

/// The first statement of a knob without a word.
const char* empty_statement(const KnobFacts& facts) {
    const std::pair<const char*, const std::string&> all[] = {{"name", facts.name.text()},
                                                              {"title", facts.title.text()},
                                                              {"setting", facts.setting.text()},
                                                              {"metric", facts.metric.text()},
                                                              {"unit", facts.unit.text()},
                                                              {"amount", facts.amount.text()},
                                                              {"reference", facts.reference.what()},
                                                              {"reason of its bound", facts.reference.reason()},
                                                              {"second oracle", facts.second_oracle.text()},
                                                              {"never trades", facts.never_trades.text()}};
    for (const auto& [what, text] : all)
        if (text.empty()) return what;
    return facts.only_level && facts.only_level->text().empty() ? "reason for one level" : nullptr;
}

}  // namespace

const std::vector<RegisteredKnob>& knob_registry() {
    static const std::vector<RegisteredKnob> kKnobs = {
        {"ray_steps", make_ray_steps_knob},
        {"ray_halvings", make_ray_halvings_knob},
        {"smooth_surface", make_surface_knob},
        {"antialias_rays", make_antialias_rays_knob},
        {"light_paths", make_light_paths_knob},
        {"sky_azimuths", make_sky_azimuths_knob},
        {"sky_radius", make_sky_radius_knob},
        {"cap_overlap", make_cap_overlap_knob},
        {"isosurface_step", make_isosurface_step_knob},
        {"tube_sides", make_tube_sides_knob},
        {"tube_points", make_tube_points_knob},
        {"color_classes", make_color_classes_knob},
        {"saliency_start", make_saliency_start_knob},
        {"edge_size", make_edge_size_knob},
        {"own_ship_filter", make_own_ship_filter_knob},
        {"frame_settings", make_frame_settings_knob},
        {"terrain_tau", make_terrain_tau_knob},
        {"quality_level", make_quality_level_knob},
        {"shadow_map", make_shadow_map_knob},
        {"picture_size", make_picture_size_knob},
        {"output_rate", make_output_rate_knob},
        {"map_pages", make_map_pages_knob},
        {"label_places", make_label_places_knob},
        {"focus_levels", make_focus_levels_knob},
        {"shaft_steps", make_shaft_steps_knob},
        {"blur_taps", make_blur_taps_knob},
        {"blur_squares", make_blur_squares_knob},
        {"air_steps", make_air_steps_knob},
        {"surface_distance", make_surface_distance_knob},
        {"attitude_between", make_attitude_between_knob},
        {"vertex_precision", make_vertex_precision_knob},
        {"cell_cut", make_cell_cut_knob},
        {"depth_format", make_depth_format_knob},
        {"terrain_cracks", make_crack_knob},
    };
    return kKnobs;
}

std::vector<RegisteredKnob> chosen_knobs(const std::vector<std::string>& names) {
    if (names.empty()) return knob_registry();
    std::string known;
    for (const RegisteredKnob& knob : knob_registry()) known += (known.empty() ? "" : ", ") + std::string(knob.name);
    for (const std::string& name : names)
        if (std::none_of(knob_registry().begin(), knob_registry().end(), [&](const auto& knob) { return knob.name == name; }))
            throw UserError("--knob " + name + ": is unknown; choose of " + known);
    std::vector<RegisteredKnob> chosen;
    for (const RegisteredKnob& knob : knob_registry())
        if (std::find(names.begin(), names.end(), knob.name) != names.end()) chosen.push_back(knob);
    return chosen;
}

std::string fault_of(const KnobFacts& facts) {
    if (const char* const what = empty_statement(facts)) return std::string("its ") + what + " is empty";
    if (facts.work && facts.work->thing.text().empty()) return "its work is empty";
    if (facts.levels.size() < 2 && !facts.only_level) return "it has fewer than two levels";
    if (facts.levels.empty()) return "it has no level";
    if (facts.only_level && facts.law) return "it has one level and expects a law";
    if (!(facts.reference.error_bound() >= 0)) return "its reference has no bound";
    std::set<std::string> names;
    for (const KnobLevel& level : facts.levels)
        if (!names.insert(level.name.text()).second) return "it has two levels '" + level.name.text() + "'";
    return "";
}

}  // namespace tedavis::host_sim
