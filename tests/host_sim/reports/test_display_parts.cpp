#include "host_sim/reports/display_parts.hpp"

#include <gtest/gtest.h>

#include <set>

#include "render_core/draw/symbology/symbology.hpp"
#include "tests/support/draw/symbology_scene.hpp"
#include "tests/support/files/generated_page.hpp"

namespace tedavis::host_sim::test_display_parts {
namespace {

std::string table_of_parts() {
    std::string table = test_support::page_head({"part", "shows"});
    for (const DisplayPart& part : display_parts()) table += test_support::page_row({part.name, part.shows});
    return table;
}

TEST(DisplayParts, AreThePageOfTheModule) {
    test_support::expect_page_part("render_core/draw/symbology/README.md", "parts", table_of_parts());
}

TEST(DisplayParts, HaveNamesOfTheirOwnAndPlacesOnTheScreen) {
    std::set<std::string_view> names;
    for (const auto& [width, height] : {std::pair{960u, 540u}, {640u, 480u}, {480u, 800u}}) {
        const draw::SymbologyInput input = test_support::scene_input(test_support::scene_state(20, 2, 12), width, height);
        const draw::Layout layout = draw::make_layout(width, height, 96);
        for (const DisplayPart& part : display_parts()) {
            names.insert(part.name);
            EXPECT_FALSE(part.shows.empty());
            if (part.name == "minimum on the scale" || part.name == "altitude bug") continue;  // far off in this scene
            if (part.name == "airspeed bug") continue;
            const draw::Point place = part.place({input, layout});
            EXPECT_TRUE(layout.screen.contains(place)) << part.name << " " << place.x << " " << place.y;
        }
    }
    EXPECT_EQ(names.size(), display_parts().size());
}

}  // namespace
}  // namespace tedavis::host_sim::test_display_parts
