#include "render_core/draw/data/model_solids.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/placement.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::draw::test_model_solids {
namespace {

using test_support::ElementOfTest;
using test_support::SolidRoomOfTest;

void bind(host_sim::LayerDraft& layer, const char* name, float value) {
    host_sim::AttributeDraft attribute;
    attribute.name = name;
    attribute.of = scene::AttributeOf::feature;
    attribute.values = {value, value};
    layer.attributes.push_back(attribute);
}

/// Of the first model's vertex, metres east, north and up of its point.
glm::dvec3 local(const SolidBatch& batch, const ElementInput& input, std::uint32_t n) {
    const scene::ScenePoint& point = input.layer.points[0];
    const LocalAxes axes = local_axes(point.latitude_rad, point.longitude_rad);
    const glm::dvec3 at = batch.pieces()[0].anchor + glm::dvec3(batch.vertices()[n].place_m) - placed(input, point).place;
    return {glm::dot(at, axes.east), glm::dot(at, axes.north), glm::dot(at, axes.up)};
}

TEST(ModelSolids, StandAtTheirPointsRightAheadAndUp) {
    ElementOfTest test(test_support::small_meshes());
    SolidRoomOfTest room;
    const ElementInput input = test.input();
    EXPECT_EQ(add_models(room.batch, room.mesh, input).drawn, 2u);
    EXPECT_LT(glm::distance(local(room.batch, input, 1), {5, 0, 0}), 1e-5);
    EXPECT_LT(glm::distance(local(room.batch, input, 2), {0, 5, 0}), 1e-5);
    EXPECT_LT(glm::distance(local(room.batch, input, 3), {0, 0, 5}), 1e-5);
    EXPECT_NEAR(test_support::volume_m3(room.batch, room.batch.pieces()[0]), 2 * 125.0 / 6, 3e-3) << "two tetrahedra";
    EXPECT_EQ(room.batch.vertices()[0].rgba[0], 200) << "its own colour";
}

TEST(ModelSolids, AreTurnedAndScaled) {
    host_sim::LayerDraft layer = test_support::small_meshes();
    bind(layer, "heading", static_cast<float>(base::radians(90)));
    bind(layer, "scale", 2);
    ElementOfTest test(layer);
    SolidRoomOfTest room;
    const ElementInput input = test.input();
    EXPECT_EQ(add_models(room.batch, room.mesh, input).drawn, 2u);
    EXPECT_LT(glm::distance(local(room.batch, input, 2), {10, 0, 0}), 1e-4) << "ahead is east";
    EXPECT_LT(glm::distance(local(room.batch, input, 1), {0, -10, 0}), 1e-4) << "right is south";
}

TEST(ModelSolids, OfLittleDetailAreBoxesThatContainThem) {
    ElementOfTest test(test_support::small_meshes());
    test.element.detail = 0.49;
    SolidRoomOfTest room;
    EXPECT_EQ(add_models(room.batch, room.mesh, test.input()).drawn, 2u);
    EXPECT_NEAR(test_support::volume_m3(room.batch, room.batch.pieces()[0]), 2 * 125.0, 3e-2) << "turned outwards, and closed";
    glm::dvec3 low(1e9), high(-1e9);
    for (std::uint32_t n = 0; n < 24; ++n) {
        low = glm::min(low, local(room.batch, test.input(), n));
        high = glm::max(high, local(room.batch, test.input(), n));
    }
    EXPECT_LT(glm::distance(low, {0, 0, 0}), 1e-4);
    EXPECT_LT(glm::distance(high, {5, 5, 5}), 1e-4);
    EXPECT_EQ(room.batch.vertices()[0].rgba[0], 200) << "its own colour";
}

TEST(ModelSolids, TooLargeOnesAndThoseWithoutGroundAreHidden) {
    host_sim::LayerDraft layer = test_support::small_meshes();
    layer.model.vertices.resize(SolidMesh::kVertices + 1, layer.model.vertices[0]);
    ElementOfTest large(layer);
    SolidRoomOfTest room;
    EXPECT_EQ(add_models(room.batch, room.mesh, large.input()).hidden, 2u);
    layer = test_support::small_meshes();
    layer.height_datum = scene::HeightDatum::ground;
    ElementOfTest lost(layer);
    lost.ground.is_known = false;
    EXPECT_EQ(add_models(room.batch, room.mesh, lost.input()).hidden, 2u);
    EXPECT_TRUE(room.batch.pieces().empty());
}

}  // namespace
}  // namespace tedavis::draw::test_model_solids
