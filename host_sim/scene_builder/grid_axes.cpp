#include "host_sim/scene_builder/grid_axes.hpp"

#include <algorithm>

#include "host_sim/calendar_time.hpp"
#include "host_sim/name_choices.hpp"
#include "host_sim/printed_text.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

template <class T>
void sort_once(std::vector<T>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

template <class T>
std::size_t place_of(const std::vector<T>& values, const std::optional<T>& value) {
    if (!value || values.empty()) return 0;
    return static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), *value) - values.begin());
}

bool is_wanted(const GridPlane& plane, const PlaneChoice& choice) {
    const bool at_level = choice.levels.empty() || !plane.level ||
                          std::find(choice.levels.begin(), choice.levels.end(), *plane.level) != choice.levels.end();
    if (!plane.time_ns) return at_level;
    return at_level && (!choice.from_ns || *plane.time_ns >= *choice.from_ns) &&
           (!choice.until_ns || *plane.time_ns <= *choice.until_ns);
}

/// "levels 300, 400, 500; times 2020-01-01T00:00:00Z to 2020-01-31T23:00:00Z (744)".
std::string stated_axes(const std::vector<GridPlane>& planes) {
    std::vector<double> levels;
    std::vector<std::int64_t> times_ns;
    for (const GridPlane& plane : planes) {
        if (plane.level) levels.push_back(*plane.level);
        if (plane.time_ns) times_ns.push_back(*plane.time_ns);
    }
    sort_once(levels);
    sort_once(times_ns);
    std::vector<std::string> names;
    for (const double level : levels) names.push_back(printed("%.9g", level));
    std::string text = "it has levels " + name_choices(names);
    if (times_ns.empty()) return text + " and no times";
    return text + " and times from " + utc_text({times_ns.front()}) + " to " + utc_text({times_ns.back()}) + " (" +
           std::to_string(times_ns.size()) + ")";
}

}  // namespace

GridAxes sort_planes(const std::vector<GridPlane>& planes, const PlaneChoice& choice, const std::string& file) {
    GridAxes axes;
    for (const GridPlane& plane : planes) {
        if (!is_wanted(plane, choice)) continue;
        if (plane.time_ns) axes.times_ns.push_back(*plane.time_ns);
        if (plane.level) axes.levels.push_back(*plane.level);
    }
    sort_once(axes.times_ns);
    sort_once(axes.levels);
    axes.members.resize(axes.time_count() * axes.level_count());
    for (const GridPlane& plane : planes)
        if (is_wanted(plane, choice))
            axes.members[place_of(axes.times_ns, plane.time_ns) * axes.level_count() + place_of(axes.levels, plane.level)]
                .push_back(plane);
    for (const std::vector<GridPlane>& members : axes.members) {
        if (members.empty())
            throw UserError(
                file +
                ": has no grid at every time and level that is asked for; choose others with 'from', 'until' and 'levels': " +
                stated_axes(planes) + look_hint(file));
        if (members.size() > 1 && !choice.has_members)
            throw UserError(file + ": has " + std::to_string(members.size()) +
                            " grids of one time and level; choose one with variable = \"band N\", or say members = \"bands\"" +
                            look_hint(file));
    }
    return axes;
}

std::optional<std::int64_t> data_time_of(const GridAxes& axes) {
    if (axes.times_ns.empty()) return std::nullopt;
    std::optional<std::int64_t> computed_ns;
    for (const std::vector<GridPlane>& members : axes.members)
        for (const GridPlane& plane : members)
            if (plane.computed_ns) computed_ns = std::max(computed_ns.value_or(*plane.computed_ns), *plane.computed_ns);
    return axes.times_ns.size() > 1 && computed_ns ? computed_ns : axes.times_ns.back();
}

}  // namespace tedavis::host_sim
