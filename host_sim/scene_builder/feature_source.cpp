#include "host_sim/scene_builder/feature_source.hpp"

#include "host_sim/input_file.hpp"
#include "host_sim/scene_builder/dof_source.hpp"
#include "host_sim/scene_builder/flight_source.hpp"
#include "host_sim/scene_builder/openair_source.hpp"
#include "host_sim/scene_builder/runway_source.hpp"
#include "host_sim/scene_builder/vector_source.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

FeatureSource runways_of(const std::string& path) {
    FeatureSource source{read_runway_file(path), {}};
    source.usual_attributes = usual_attributes_of_runways(source.features);
    return source;
}

FeatureSource source_of(SourceKind kind, const LayerRecipe& recipe, const std::string& path) {
    switch (kind) {
        case SourceKind::flight: return {read_flight_file(path, recipe.aircraft), usual_attributes_of_flights()};
        case SourceKind::runways: return runways_of(path);
        case SourceKind::openair: return {read_openair(read_file(path), path), usual_attributes_of_airspaces()};
        case SourceKind::dof: return {read_dof(read_file(path), path), usual_attributes_of_dof()};
        default: return {read_vector_file(path, recipe.crs, recipe.raster_m > 0 ? Holes::joined : Holes::left_out), {}};
    }
}

}  // namespace

FeatureSource read_feature_source(SourceKind kind, const LayerRecipe& recipe, const std::string& path) {
    if (kind != SourceKind::flight && !recipe.aircraft.empty())
        throw UserError(recipe.name + ": 'aircraft' chooses one of a file of flights, and " + recipe.source + " is none");
    FeatureSource source = source_of(kind, recipe, path);
    source.features.file = path;
    return source;
}

}  // namespace tedavis::host_sim
