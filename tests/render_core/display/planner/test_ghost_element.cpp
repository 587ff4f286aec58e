#include "render_core/display/planner/ghost_element.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "render_core/display/planner/element_labels.hpp"
#include "render_core/draw/data/ghost_signs.hpp"

namespace tedavis::display::test_ghost_element {
namespace {

struct LayerOfTest {
    scene::LayerEntry entry{};
    scene::Layer layer;

    explicit LayerOfTest(scene::LayerRole role, scene::LayerShape shape = scene::LayerShape::lines) {
        std::strcpy(entry.name, "others");
        entry.role = role;
        entry.shape = shape;
        layer.entry = &entry;
    }
};

design::DataElementList with(const design::DataElement& element) {
    design::DataElementList elements;
    EXPECT_TRUE(elements.try_push_back(element));
    return elements;
}

TEST(GhostElement, IsNeededWhereNoElementMeansTheGhosts) {
    const LayerOfTest ghosts(scene::LayerRole::ghost);
    EXPECT_TRUE(needs_ghost_element({}, ghosts.layer));
    design::DataElement element;
    element.role = scene::LayerRole::traffic;
    EXPECT_TRUE(needs_ghost_element(with(element), ghosts.layer));
    element.role = scene::LayerRole::ghost;
    EXPECT_FALSE(needs_ghost_element(with(element), ghosts.layer)) << "by their role";
    element.role = scene::LayerRole::count;
    element.layer = std::string_view("others");
    EXPECT_FALSE(needs_ghost_element(with(element), ghosts.layer)) << "by their layer's name";
    element.own = design::OwnData::trail;
    EXPECT_TRUE(needs_ghost_element(with(element), ghosts.layer)) << "own data are no layer";
}

TEST(GhostElement, OtherLayersNeedNone) {
    for (const scene::LayerRole role : {scene::LayerRole::traffic, scene::LayerRole::trajectory, scene::LayerRole::runway})
        EXPECT_FALSE(needs_ghost_element({}, LayerOfTest(role).layer));
    EXPECT_FALSE(needs_ghost_element({}, LayerOfTest(scene::LayerRole::ghost, scene::LayerShape::points).layer));
}

TEST(GhostElement, MeansGhostsAndHasTheirColor) {
    const LayerOfTest ghosts(scene::LayerRole::ghost);
    EXPECT_TRUE(is_meant(ghost_element(), ghosts.layer));
    EXPECT_FALSE(needs_ghost_element(with(ghost_element()), ghosts.layer));
    EXPECT_EQ(ghost_element().color, draw::kGhostColor);
    EXPECT_EQ(ghost_element().technique, design::DataTechnique::billboard);
}

}  // namespace
}  // namespace tedavis::display::test_ghost_element
