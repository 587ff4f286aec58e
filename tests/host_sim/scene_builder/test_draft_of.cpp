#include "host_sim/scene_builder/draft_of.hpp"

#include <gtest/gtest.h>

#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::host_sim::test_draft_of {
namespace {

/// The bytes say everything that a scene has, so that equal bytes prove that nothing is lost.
void expect_the_same_bytes(const SceneDraft& draft) {
    const test_support::LoadedScene loaded(draft);
    EXPECT_EQ(sdb_bytes(draft_of(loaded.scene())), sdb_bytes(draft));
}

TEST(DraftOf, GivesTheBytesThatItWasReadFrom) {
    SceneDraft draft = test_support::small_scene();
    expect_the_same_bytes(draft);
    draft.revision = 7;
    draft.layers[0] = test_support::small_ensemble(4);
    draft.layers[1].attributes[0].derived_from = draft.layers[2].name;
    draft.layers[1].attributes[0].derived_time_ns = 26'000'000 * std::int64_t{60'000'000'000};
    draft.layers[2].valid_from_ns = 5;
    draft.layers[2].valid_until_ns = 6;
    draft.layers[2].data_time_ns = 4;
    draft.layers[3].importance = 9;
    expect_the_same_bytes(draft);
    expect_the_same_bytes({"none", "a test", 1, {}});
}

/// The control: the bytes differ where one value does.
TEST(DraftOf, AnotherValueGivesOtherBytes) {
    const test_support::LoadedScene loaded(test_support::small_scene());
    SceneDraft other = draft_of(loaded.scene());
    other.layers[0].attributes[0].values[3] += 1;
    EXPECT_NE(sdb_bytes(other), sdb_bytes(test_support::small_scene()));
}

}  // namespace
}  // namespace tedavis::host_sim::test_draft_of
