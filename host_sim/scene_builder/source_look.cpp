#include "host_sim/scene_builder/source_look.hpp"

#include <numeric>

#include "host_sim/scene_builder/layer_block.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using scene::LayerRole;

std::string without_name(const std::string& message, const std::string& file) {
    const std::string start = file + ": ";
    return message.rfind(start, 0) == 0 ? message.substr(start.size()) : message;
}

FeatureSource read_as(SourceKind kind, const std::string& file, const std::string& crs) {
    LayerRecipe recipe;
    recipe.name = recipe.source = file;
    recipe.crs = crs;
    return read_feature_source(kind, recipe, file);
}

struct Reading {
    std::optional<FeatureSource> source;
    std::string fault;  ///< why there is none
};
Reading try_to_read(SourceKind kind, const std::string& file, const std::string& crs) {
    try {
        return {read_as(kind, file, crs), ""};
    } catch (const UserError& fault) {
        return {std::nullopt, without_name(fault.what(), file)};
    }
}

std::size_t point_count(const FeatureSource& source) {
    const auto& features = source.features.features;
    return std::accumulate(features.begin(), features.end(), std::size_t{0},
                           [](std::size_t sum, const SourceFeature& feature) { return sum + feature.points.size(); });
}

/// Of readings of a flight few fixes are left out; a table with times of which most rows could not be flown is none.
bool is_flown(const FeatureSource& flight, const Reading& table) {
    constexpr std::size_t kLeftOut = 2;  // one of so many
    return !table.source || point_count(flight) * kLeftOut >= point_count(*table.source);
}

void take(SourceLook& look, SourceKind kind, const FeatureSource& source) {
    look.kind = kind;
    look.features = look_at_features(source);
}

void look_at_features_of(SourceLook& look, const std::string& crs) {
    const SourceKind kind = source_kind(look.file, LayerRole::place);
    if (kind != SourceKind::vector) return take(look, kind, read_as(kind, look.file, crs));
    const Reading table = try_to_read(SourceKind::vector, look.file, crs);
    const bool may_be_flight = source_kind(look.file, LayerRole::trajectory) == SourceKind::flight;
    const Reading flight = may_be_flight ? try_to_read(SourceKind::flight, look.file, crs) : Reading();
    if (flight.source && is_flown(*flight.source, table)) return take(look, SourceKind::flight, *flight.source);
    if (table.source) return take(look, SourceKind::vector, *table.source);
    throw UserError(look.file + ": no scene can take it: not a raster that GDAL can read, " + table.fault +
                    (may_be_flight ? "; as a recorded flight: " + flight.fault : ""));
}

}  // namespace

SourceLook look_at_source(const std::string& file, const std::string& crs) {
    SourceLook look;
    look.file = file;
    if (source_kind(file, LayerRole::field) == SourceKind::grid) {
        look.grid = look_at_grid(file, crs);
        look.layer = grid_block(file, crs, *look.grid);
    } else {
        look_at_features_of(look, crs);
        look.layer = feature_block(file, crs, look.kind, *look.features);
    }
    return look;
}

std::string_view kind_text(SourceKind kind) {
    switch (kind) {
        case SourceKind::grid: return "grid";
        case SourceKind::openair: return "airspaces (OpenAir)";
        case SourceKind::runways: return "runways (OurAirports)";
        case SourceKind::dof: return "obstacles (Digital Obstacle File)";
        case SourceKind::flight: return "recorded flight";
        default: return "table or map";
    }
}

}  // namespace tedavis::host_sim
