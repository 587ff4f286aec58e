#include "host_sim/scene_builder/sdb_writer.hpp"

#include <gtest/gtest.h>

#include "host_sim/user_error.hpp"
#include "tests/support/scene_drafts.hpp"

namespace tedavis::host_sim::test_sdb_writer {
namespace {

std::string sentence_of(const SceneDraft& draft) {
    try {
        (void)sdb_bytes(draft);
    } catch (const UserError& error) {
        return error.what();
    }
    return {};
}

TEST(SdbWriter, EqualDraftsGiveEqualBytes) {
    EXPECT_EQ(sdb_bytes(test_support::small_scene()), sdb_bytes(test_support::small_scene()));
    SceneDraft later = test_support::small_scene();
    later.revision = 2;
    EXPECT_NE(sdb_bytes(later), sdb_bytes(test_support::small_scene()));
}

TEST(SdbWriter, WhatDoesNotFitIsSaidWithItsLayer) {
    SceneDraft draft = test_support::small_scene();
    draft.layers[1].name = std::string(40, 'm');
    EXPECT_NE(sentence_of(draft).find("its name"), std::string::npos);
    draft = test_support::small_scene();
    draft.layers[0].attributes[0].unit = "furlongs per fortnight";
    EXPECT_EQ(sentence_of(draft).rfind("air: the attribute's unit 'furlongs per fortnight' is longer than 11 bytes", 0), 0u);
    draft = test_support::small_scene();
    draft.layers[1].attributes[0].classes.assign(scene::kMaxClasses + 1, "c");
    EXPECT_NE(sentence_of(draft).find("17 classes"), std::string::npos);
    draft = test_support::small_scene();
    draft.layers.resize(scene::kMaxLayers + 1);
    EXPECT_NE(sentence_of(draft).find("at most 32 layers"), std::string::npos);
    draft = test_support::small_scene();
    draft.layers[0].attributes.resize(scene::kMaxAttributes + 1, draft.layers[0].attributes[0]);
    EXPECT_NE(sentence_of(draft).find("at most 96 attributes"), std::string::npos);
}

}  // namespace
}  // namespace tedavis::host_sim::test_sdb_writer
