#include "host_sim/scene_builder/role_needs.hpp"

#include <gtest/gtest.h>

#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_role_needs {
namespace {

using scene::LayerRole;

LayerRecipe layer_of(LayerRole role, const std::vector<std::string>& attributes = {}) {
    LayerRecipe recipe;
    recipe.name = "l";
    recipe.source = "x.dat";
    recipe.role = role;
    for (const std::string& name : attributes) {
        recipe.attributes.emplace_back();
        recipe.attributes.back().name = name;
    }
    return recipe;
}

void expect_refused(const LayerRecipe& recipe, SourceKind kind, const std::string& words) {
    test_support::expect_user_error([&] { require_what_role_needs(recipe, kind); }, words);
}

TEST(RoleNeeds, RastersAreForFields) {
    for (const LayerRole role : {LayerRole::field, LayerRole::land_cover, LayerRole::sample})
        EXPECT_NO_THROW(require_what_role_needs(layer_of(role), SourceKind::grid)) << name_of(role);
    for (const LayerRole role : {LayerRole::obstacle, LayerRole::trajectory, LayerRole::no_go, LayerRole::runway,
                                 LayerRole::place, LayerRole::storm_cell, LayerRole::building}) {
        const std::string words =
            "l: role \"" + std::string(name_of(role)) + "\" shows points, lines or areas, and x.dat is a raster";
        expect_refused(layer_of(role), SourceKind::grid, words);
        EXPECT_NO_THROW(require_what_role_needs(layer_of(role), SourceKind::vector)) << name_of(role);
    }
}

TEST(RoleNeeds, FieldsAreRasters) {
    for (const SourceKind kind : {SourceKind::vector, SourceKind::dof, SourceKind::openair})
        expect_refused(layer_of(LayerRole::field), kind, "l: role \"field\" shows rasters, and x.dat is none");
    LayerRecipe covered = layer_of(LayerRole::field);
    covered.raster_m = 50;
    EXPECT_NO_THROW(require_what_role_needs(covered, SourceKind::vector)) << "its areas become one";
}

TEST(RoleNeeds, WindHasTwoParts) {
    for (const SourceKind kind : {SourceKind::grid, SourceKind::vector}) {
        EXPECT_NO_THROW(require_what_role_needs(layer_of(LayerRole::wind, {"north", "speed", "east"}), kind));
        for (const std::vector<std::string>& names :
             {std::vector<std::string>{}, {"height"}, {"east"}, {"north", "up"}, {"speed", "direction"}})
            expect_refused(layer_of(LayerRole::wind, names), kind, "needs the attributes 'east' and 'north' (m/s)");
    }
}

TEST(RoleNeeds, AModelHasAFile) {
    LayerRecipe huts = layer_of(LayerRole::model);
    expect_refused(huts, SourceKind::vector, "l: role \"model\" needs 'model'");
    huts.model = "hut.glb";
    EXPECT_NO_THROW(require_what_role_needs(huts, SourceKind::vector));
}

}  // namespace
}  // namespace tedavis::host_sim::test_role_needs
