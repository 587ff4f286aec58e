#include "host_sim/scene_builder/grid_look.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "host_sim/scene_builder/ensemble.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

/// Posts of all members of one time and level beyond which their spread is not computed.
constexpr std::size_t kMaxSpreadPosts = 1U << 24U;

template <class T>
void sort_distinct(std::vector<T>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Numbers that formats and programs often write where there is no value.
bool is_usual_missing(double value) {
    constexpr double kUsual[] = {-32768, -32767, -9999, -99999, -999, -9999000};
    return std::find(std::begin(kUsual), std::end(kUsual), value) != std::end(kUsual);
}

bool is_special(const VariableLook& look, double value) {
    return std::find(look.special.begin(), look.special.end(), value) != look.special.end() || look.undetected == value;
}

/// Only the least number of a grid is suspected, since values in between are none of these.
void find_special(const std::vector<float>& values, VariableLook& look) {
    double least = HUGE_VAL;
    for (const float value : values)
        if (!std::isnan(value)) least = std::min(least, double{value});
    if (is_usual_missing(least) && !is_special(look, least)) look.special.push_back(least);
}

void describe_values(const std::vector<float>& values, VariableLook& look) {
    find_special(values, look);
    std::size_t missing = 0;
    for (const float number : values) {
        const auto value = double{number};
        const bool has_value = !std::isnan(value) && !is_special(look, value);
        missing += has_value || look.undetected == value ? 0 : 1;
        if (!has_value) continue;
        if (!look.range) look.range = ValueRange{value, value};
        look.range->least = std::min(look.range->least, value);
        look.range->greatest = std::max(look.range->greatest, value);
    }
    if (!values.empty()) look.missing_share = static_cast<double>(missing) / static_cast<double>(values.size());
}

bool are_together(const GridPlane& a, const GridPlane& b) { return a.time_ns == b.time_ns && a.level == b.level; }

double largest_spread(const GridSource& source, const std::vector<GridPlane>& planes) {
    Members members;
    for (const GridPlane& plane : planes)
        if (are_together(plane, planes.front())) members.push_back(source.read(plane));
    double largest = 0;
    if (members.size() < 2 || members.size() * members.front().size() > kMaxSpreadPosts) return largest;
    for (const float spread : mean_of(members).spread)
        if (spread > largest) largest = double{spread};
    return largest;
}

void describe_axes(const std::vector<GridPlane>& planes, VariableLook& look) {
    using Key = std::pair<std::optional<double>, std::optional<std::int64_t>>;
    std::map<Key, std::size_t> members;
    std::map<std::optional<double>, std::size_t> times_of_level;
    for (const GridPlane& plane : planes) {
        if (plane.level) look.levels.push_back(*plane.level);
        if (plane.time_ns) look.times_ns.push_back(*plane.time_ns);
        if (plane.computed_ns) look.computed_ns = std::max(look.computed_ns.value_or(*plane.computed_ns), *plane.computed_ns);
        if (++members[{plane.level, plane.time_ns}] == 1) ++times_of_level[plane.level];
    }
    sort_distinct(look.levels);
    sort_distinct(look.times_ns);
    look.least_members = planes.size();
    for (const auto& [key, count] : members) {
        look.least_members = std::min(look.least_members, count);
        look.most_members = std::max(look.most_members, count);
    }
    look.is_whole =
        members.size() == std::max<std::size_t>(look.levels.size(), 1) * std::max<std::size_t>(look.times_ns.size(), 1);
    std::size_t most = 0;
    for (const auto& [level, count] : times_of_level)
        if (count > most) most = count, look.fullest_level = level.value_or(0);
}

VariableLook look_at_variable(const GridSource& source, const std::string& name, const std::vector<GridPlane>& planes) {
    VariableLook look;
    look.name = name;
    look.places = source.places();
    const PlaneTexts texts = source.texts_of(planes.front());
    look.description = texts.description;
    look.unit = texts.unit;
    look.level_unit = texts.level_unit;
    look.level_kind = texts.level_kind;
    if (texts.missing) look.special.push_back(*texts.missing);
    look.undetected = texts.undetected;
    describe_axes(planes, look);
    describe_values(source.read(planes.front()), look);
    if (look.most_members > 1) look.first_spread = largest_spread(source, planes);
    return look;
}

class GridLooker {
public:
    GridLooker(const std::string& file, const std::string& crs) : file_(file), crs_(crs) {}

    GridLook look() {
        const std::vector<std::string> names = rasters_inside(file_);
        if (names.empty()) {
            add_bands();
        } else {
            for (const std::string& name : names) add_raster(name);
        }
        if (look_.variables.empty()) throw UserError(file_ + ": " + first_fault_);
        return std::move(look_);
    }

private:
    void describe_system(const GridSource& source) {
        look_.format = source.format();
        look_.system = source.system();
        look_.is_assumed = source.is_assumed();
        look_.is_warped = source.is_warped();
    }
    void add(const GridSource& source, const std::string& name, const std::vector<GridPlane>& planes) {
        if (look_.variables.size() >= kMaxVariablesLooked) return void(++look_.more_variables);
        look_.variables.push_back(look_at_variable(source, name, planes));
    }
    /// Some rasters of a container are not fields: bounds of axes, images without a place.
    void add_raster(const std::string& name) {
        if (look_.variables.size() >= kMaxVariablesLooked) return void(++look_.more_variables);
        try {
            const GridSource source(file_, name, crs_, false);
            describe_system(source);
            add(source, name, source.planes());
        } catch (const UserError& fault) {
            const std::string text = fault.what();
            const std::size_t begin = text.rfind(file_ + ": ", 0) == 0 ? file_.size() + 2 : 0;
            if (first_fault_.empty()) first_fault_ = text.substr(begin);
        }
    }
    /// Of bands without names each is a variable.
    void add_bands() {
        const GridSource source(file_, "", crs_, false);
        describe_system(source);
        std::vector<std::string> names;
        std::map<std::string, std::vector<GridPlane>> planes;
        for (const GridPlane& plane : source.planes()) {
            const std::string name = plane.variable.empty() ? "band " + std::to_string(plane.band) : plane.variable;
            if (planes.find(name) == planes.end()) names.push_back(name);
            planes[name].push_back(plane);
        }
        for (const std::string& name : names) add(source, name, planes[name]);
    }

    const std::string file_, crs_;
    GridLook look_;
    std::string first_fault_;
};

}  // namespace

GridLook look_at_grid(const std::string& file, const std::string& crs) { return GridLooker(file, crs).look(); }

}  // namespace tedavis::host_sim
