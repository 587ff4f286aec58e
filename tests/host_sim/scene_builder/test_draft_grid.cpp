#include "host_sim/scene_builder/draft_grid.hpp"

#include <gtest/gtest.h>

#include "render_core/scene/grid_field.hpp"
#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::host_sim::test_draft_grid {
namespace {

TEST(DraftGrid, AnswersAsTheLayerInADatabaseDoes) {
    LayerDraft draft = test_support::small_grid();
    draft.attributes[0].uncertainty_growth_per_hour = 0.1;
    const DraftGrid grid(draft);
    const test_support::LoadedScene loaded(draft);
    ASSERT_NE(grid.find("temperature"), nullptr);
    EXPECT_EQ(grid.find("pressure"), nullptr);
    const scene::GridField ours(grid.layer(), *grid.find("temperature")), theirs(loaded.layer(), loaded.attribute());
    std::size_t missing = 0;
    for (double latitude_deg = 45.9; latitude_deg < 47.2; latitude_deg += 0.07)
        for (double height_m = 900; height_m < 3200; height_m += 190)
            for (const std::int64_t time_ns : {-5'000'000'000'000, 1'000'000'000'000, 9'000'000'000'000}) {
                const double latitude = base::radians(latitude_deg), longitude = base::radians(9.3);
                const scene::FieldValue a = ours.at(latitude, longitude, height_m, time_ns),
                                        b = theirs.at(latitude, longitude, height_m, time_ns);
                EXPECT_EQ(a.state, b.state);
                EXPECT_EQ(a.value, b.value);
                EXPECT_EQ(a.uncertainty, b.uncertainty);
                missing += a.state == scene::ValueState::missing ? 1 : 0;
            }
    EXPECT_GT(missing, 20u) << "some places are outside";
}

}  // namespace
}  // namespace tedavis::host_sim::test_draft_grid
