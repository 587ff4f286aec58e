#include "host_sim/scene_builder/role_needs.hpp"

#include <algorithm>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using scene::LayerRole;

bool may_be_grid(LayerRole role) {
    return role == LayerRole::field || role == LayerRole::wind || role == LayerRole::sample || role == LayerRole::land_cover;
}

bool has_attribute(const LayerRecipe& recipe, const char* name) {
    return std::any_of(recipe.attributes.begin(), recipe.attributes.end(),
                       [name](const AttributeRecipe& attribute) { return attribute.name == name; });
}

[[noreturn]] void refuse(const LayerRecipe& recipe, const std::string& what) {
    throw UserError(recipe.name + ": role \"" + std::string(name_of(recipe.role)) + "\" " + what);
}

}  // namespace

void require_what_role_needs(const LayerRecipe& recipe, SourceKind kind) {
    const bool is_grid = kind == SourceKind::grid;
    if (is_grid && !may_be_grid(recipe.role))
        refuse(recipe, "shows points, lines or areas, and " + recipe.source +
                           " is a raster; give a table or a map, or role = \"field\" (or \"wind\", \"land_cover\")");
    if (!is_grid && recipe.role == LayerRole::field && !(recipe.raster_m > 0))
        refuse(recipe, "shows rasters, and " + recipe.source +
                           " is none; give GeoTIFF, netCDF, GRIB or HDF5, or role = \"sample\" for values at places");
    if (recipe.role == LayerRole::wind && !(has_attribute(recipe, "east") && has_attribute(recipe, "north")))
        refuse(recipe, "needs the attributes 'east' and 'north' (m/s); bind both, or give role = \"" +
                           std::string(is_grid ? "field" : "sample") + "\"");
    if (recipe.role == LayerRole::model && recipe.model.empty())
        refuse(recipe, "needs 'model', the file of what stands at the points; name a .gltf or .glb");
}

}  // namespace tedavis::host_sim
