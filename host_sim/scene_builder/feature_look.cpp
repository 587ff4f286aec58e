#include "host_sim/scene_builder/feature_look.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "host_sim/scene_builder/stated_number.hpp"

namespace tedavis::host_sim {
namespace {

/// A date has separators; a plain number is a number.
bool is_date(const std::string& text) { return !stated_number(text) && stated_instant_ns(text).has_value(); }

void extend(std::optional<ValueRange>& range, double value) {
    if (std::isnan(value)) return;
    if (!range) range = ValueRange{value, value};
    range->least = std::min(range->least, value);
    range->greatest = std::max(range->greatest, value);
}

ColumnLook look_at_column(const std::string& name, const std::vector<const std::string*>& cells) {
    ColumnLook look;
    look.name = name;
    look.stated = cells.size();
    const auto all = [&cells](const auto& is_one) {
        return !cells.empty() && std::all_of(cells.begin(), cells.end(), [&](const std::string* cell) { return is_one(*cell); });
    };
    if (all([](const std::string& cell) { return stated_number(cell).has_value(); })) look.kind = ColumnKind::number;
    if (all(is_date)) look.kind = ColumnKind::time;
    std::set<std::string> different;
    for (const std::string* const cell : cells) {
        if (look.kind == ColumnKind::number) extend(look.range, *stated_number(*cell));
        if (look.kind == ColumnKind::text) different.insert(*cell);
        if (look.kind != ColumnKind::time) continue;
        const auto time = stated_instant_ns(*cell);
        if (look.first.empty() || time < stated_instant_ns(look.first)) look.first = *cell;
        if (look.last.empty() || time > stated_instant_ns(look.last)) look.last = *cell;
    }
    look.different_texts = different.size();
    for (const std::string& text : different)
        if (look.texts.size() < kMaxTextsLooked) look.texts.push_back(text);
    return look;
}

void add_columns(const SourceFeatures& source, FeatureLook& look) {
    std::map<std::string, std::vector<const std::string*>> cells;
    for (const std::string& name : source.columns) cells[name];
    std::map<std::string, ColumnLook> of_points;
    for (const SourceFeature& feature : source.features) {
        for (const auto& [name, text] : feature.fields) cells[name].push_back(&text);
        for (const auto& [name, values] : feature.point_values) {
            ColumnLook& column = of_points[name];
            column.name = name;
            column.kind = ColumnKind::number;
            column.is_of_points = true;
            for (const double value : values) {
                column.stated += std::isnan(value) ? 0 : 1;
                extend(column.range, value);
            }
        }
    }
    for (const auto& [name, column] : of_points) look.columns.push_back(column);
    for (const auto& [name, texts] : cells) look.columns.push_back(look_at_column(name, texts));
}

/// Longitudes are counted on from the first one, so that an extent may cross the antimeridian.
void add_places(const SourceFeatures& source, FeatureLook& look) {
    std::optional<ValueRange> latitude, longitude;
    double first_deg = 0;
    for (const SourceFeature& feature : source.features)
        for (const SourcePoint& point : feature.points) {
            if (look.places++ == 0) first_deg = point.longitude_deg;
            extend(latitude, point.latitude_deg);
            extend(longitude, first_deg + std::remainder(point.longitude_deg - first_deg, 360));
            if (point.height_m) extend(look.height_m, *point.height_m);
            if (!point.time_ns) continue;
            look.first_ns = std::min(look.first_ns.value_or(*point.time_ns), *point.time_ns);
            look.last_ns = std::max(look.last_ns.value_or(*point.time_ns), *point.time_ns);
        }
    if (!latitude) return;
    look.west_deg = longitude->least;
    look.east_deg = longitude->greatest;
    look.south_deg = latitude->least;
    look.north_deg = latitude->greatest;
}

void add_aircraft(const SourceFeatures& source, FeatureLook& look) {
    for (const SourceFeature& feature : source.features)
        for (const char* const field : {"callsign", "aircraft"}) {
            const auto name = feature.fields.find(field);
            if (name == feature.fields.end()) continue;
            if (std::find(look.aircraft.begin(), look.aircraft.end(), name->second) == look.aircraft.end())
                look.aircraft.push_back(name->second);
            break;
        }
}

}  // namespace

FeatureLook look_at_features(const FeatureSource& source) {
    FeatureLook look;
    look.format = source.features.format;
    look.system = source.features.system;
    look.notes = source.features.notes;
    look.height_datum = source.features.height_datum;
    look.usual_attributes = source.usual_attributes;
    look.first_ns = look.last_ns = source.features.data_time_ns;
    for (const SourceFeature& feature : source.features.features) {
        look.points += feature.shape == scene::LayerShape::points ? 1 : 0;
        look.lines += feature.shape == scene::LayerShape::lines ? 1 : 0;
        look.areas += feature.shape == scene::LayerShape::areas ? 1 : 0;
    }
    add_places(source.features, look);
    add_columns(source.features, look);
    add_aircraft(source.features, look);
    return look;
}

}  // namespace tedavis::host_sim
