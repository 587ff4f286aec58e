#include "render_core/display/planner/spatial_data.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "tests/support/display/grey_palettes.hpp"
#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::display::test_spatial_data {
namespace {

constexpr std::int64_t kHour_ns = 3'600'000'000'000;
constexpr std::int64_t kDate_ns = 1'700'000'000'000'000'000 / 60'000'000'000 * 60'000'000'000;

/// The small grid, at two times from a date on.
host_sim::SceneDraft dated_scene() {
    host_sim::SceneDraft scene = test_support::small_scene();
    scene.layers[0].times_ns = {kDate_ns, kDate_ns + kHour_ns};
    scene.layers[0].attributes[0].uncertainty_growth_per_hour = 0.1;
    scene.layers[0].valid_until_ns = kDate_ns + 3 * kHour_ns;
    return scene;
}

class SpatialDataOf : public ::testing::Test {
protected:
    void start(const host_sim::SceneDraft& scene, std::uint32_t most_side = 64) {
        source_.content = host_sim::sdb_bytes(scene);
        EXPECT_EQ(data_.start(&source_, {scene_memory_, slice_memory_}, most_side).message.view(), "");
        style_.ground.is_shown = true;
        style_.ground.layer = "air";
        style_.ground.attribute = "temperature";
        style_.ground.height_m = 1000;
    }
    [[nodiscard]] const scene::GridSlice& shown() const {
        static const scene::GridSlice kNone;
        const scene::GridSlice* const slice = data_.ground();
        EXPECT_NE(slice, nullptr);
        return slice == nullptr ? kNone : *slice;
    }
    SpatialDataPlan plan(std::int64_t time_ns) { return data_.plan(style_, flight::time_of_source({time_ns})); }

    std::vector<std::uint8_t> memory_ = std::vector<std::uint8_t>(1 << 17);
    base::Arena scene_memory_{memory_.data(), 1 << 16}, slice_memory_{memory_.data() + (1 << 16), 1 << 12};
    test_support::FlakyBytes source_{{}};
    /// Whether the ground's colours are others than when this was asked last.
    bool has_changed() {
        const std::uint64_t before = ground_key_;
        ground_key_ = data_.ground_key();
        return ground_key_ != before;
    }
    std::uint64_t ground_key_ = 0;
    SpatialData data_;
    design::DataStyle style_;
};

TEST_F(SpatialDataOf, TheGroundFollowsTheSourcesTime) {
    start(dated_scene());
    EXPECT_EQ(plan(kDate_ns).ground, GroundDataState::shown);
    EXPECT_TRUE(has_changed());
    EXPECT_FALSE(has_changed()) << "once";
    EXPECT_NEAR(scene::value_of(shown().texels()[0], shown().range()), 260, 0.01);
    EXPECT_EQ(plan(kDate_ns + 59'000'000'000).ground, GroundDataState::shown);
    EXPECT_FALSE(has_changed()) << "the same minute";
    static_cast<void>(plan(kDate_ns + kHour_ns / 2));
    EXPECT_TRUE(has_changed());
    EXPECT_NEAR(scene::value_of(shown().texels()[0], shown().range()), 272, 0.01) << "between 260 and 284";
}

TEST_F(SpatialDataOf, WithoutAHeightItIsTheLowestLevel) {
    start(dated_scene());
    style_.ground.height_m = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(plan(kDate_ns).ground, GroundDataState::shown);
    EXPECT_NEAR(scene::value_of(shown().texels()[0], shown().range()), 260, 0.01);
    style_.ground.height_m = 3000;
    static_cast<void>(plan(kDate_ns));
    EXPECT_NEAR(scene::value_of(shown().texels()[0], shown().range()), 272, 0.01) << "the upper one";
}

TEST_F(SpatialDataOf, APaletteOfKindsIsForKinds) {
    start(dated_scene());
    style_.ground.scale.palette = test_support::kinds_palette();
    EXPECT_EQ(plan(kDate_ns).ground, GroundDataState::no_classes);
    EXPECT_EQ(data_.ground(), nullptr);
    style_.ground.scale.palette = test_support::grey_palette();
    EXPECT_EQ(plan(kDate_ns).ground, GroundDataState::shown) << "control";
}

TEST_F(SpatialDataOf, ANewerSceneIsTakenOverWholeAndAnOlderOneNever) {
    start(dated_scene());
    static_cast<void>(plan(kDate_ns));
    const auto loaded = [this](std::uint64_t revision, const char* layer) {
        host_sim::SceneDraft draft = dated_scene();
        draft.revision = revision;
        draft.layers[0].name = layer;
        test_support::FlakyBytes file(host_sim::sdb_bytes(draft));
        auto scene = scene::Scene::load(file, data_.spare());
        EXPECT_TRUE(scene.ok());
        return scene.value();
    };
    EXPECT_FALSE(data_.take(loaded(1, "other"))) << "the same revision";
    EXPECT_NEAR(scene::value_of(shown().texels()[0], shown().range()), 260, 0.01);
    EXPECT_TRUE(data_.take(loaded(2, "other")));
    EXPECT_TRUE(has_changed()) << "what was shown is gone";
    EXPECT_EQ(data_.ground(), nullptr);
    EXPECT_EQ(plan(kDate_ns).ground, GroundDataState::no_such_layer);
    EXPECT_TRUE(data_.take(loaded(7, "air")));
    EXPECT_EQ(plan(kDate_ns).ground, GroundDataState::shown);
    EXPECT_EQ(data_.scene().header().revision, 7u);
}

TEST_F(SpatialDataOf, AFirstSceneMayComeLater) {
    EXPECT_EQ(data_.start(nullptr, {scene_memory_, slice_memory_}, 64).message.view(), "");
    EXPECT_FALSE(data_.has_scene());
    test_support::FlakyBytes file(host_sim::sdb_bytes(dated_scene()));
    auto scene = scene::Scene::load(file, data_.spare());
    ASSERT_TRUE(scene.ok());
    EXPECT_TRUE(data_.take(scene.value()));
    EXPECT_TRUE(data_.has_scene());
}

TEST_F(SpatialDataOf, TheSameMomentHasTheSameTexelsFromWhereverItIsReached) {
    start(dated_scene());
    for (std::int64_t t = 0; t < 40; ++t) static_cast<void>(plan(kDate_ns + t * 10'000'000'000));
    std::vector<int> flown;
    for (const scene::SliceTexel& texel : shown().texels()) flown.push_back(texel.value_low);
    static_cast<void>(plan(kDate_ns + 2 * kHour_ns));
    static_cast<void>(plan(kDate_ns + 39 * 10'000'000'000));
    for (std::size_t n = 0; n < flown.size(); ++n) EXPECT_EQ(shown().texels()[n].value_low, flown[n]);
}

TEST_F(SpatialDataOf, DataHaveAnAgeAndAnEnd) {
    start(dated_scene());
    const auto first_uncertainty = [this](std::int64_t time_ns) {
        EXPECT_EQ(plan(time_ns).ground, GroundDataState::shown);
        return int{shown().texels()[1].uncertainty};
    };
    const int within = first_uncertainty(kDate_ns + kHour_ns / 2);
    EXPECT_NEAR(first_uncertainty(kDate_ns + 2 * kHour_ns) - first_uncertainty(kDate_ns + kHour_ns), 254 / 10, 2);
    EXPECT_LE(within, first_uncertainty(kDate_ns + kHour_ns)) << "within its times it has no age";
    EXPECT_EQ(plan(kDate_ns + 3 * kHour_ns + 60'000'000'000).ground, GroundDataState::out_of_date);
    EXPECT_EQ(data_.ground(), nullptr) << "what is no longer valid is taken away";
    EXPECT_TRUE(has_changed());
    EXPECT_EQ(plan(kDate_ns).ground, GroundDataState::shown);
    EXPECT_TRUE(has_changed()) << "and comes back";
}

TEST_F(SpatialDataOf, ASourceWithoutADateShowsTheirFirstTime) {
    start(dated_scene());
    EXPECT_EQ(plan(12'000'000'000).ground, GroundDataState::shown);
    EXPECT_NEAR(scene::value_of(shown().texels()[0], shown().range()), 260, 0.01);
}

host_sim::SceneDraft dated_ensemble(int members) {
    host_sim::SceneDraft scene = dated_scene();
    scene.layers[0].attributes[0].members = test_support::small_ensemble(members).attributes[0].members;
    return scene;
}

TEST_F(SpatialDataOf, MembersComeOneAfterTheOtherByTheFlightsTime) {
    start(dated_ensemble(3));
    style_.ground.members = design::GroundMembers::animated;
    style_.ground.member_s = 2;
    const std::int64_t first_ns = kDate_ns / 6'000'000'000 * 6'000'000'000;  // a whole number of rounds
    std::vector<double> seen;
    for (int frame = 0; frame < 3 * 20; ++frame) {
        const SpatialDataPlan now = plan(first_ns + frame * 100'000'000LL);
        ASSERT_EQ(now.ground, GroundDataState::shown);
        EXPECT_EQ(now.member, static_cast<std::uint32_t>(frame / 20));
        EXPECT_EQ(now.members, 3u);
        EXPECT_EQ(has_changed(), frame % 20 == 0) << "no frame makes it anew but where another's turn begins";
        const double value = scene::value_of(shown().texels()[0], shown().range());
        EXPECT_NEAR(value, 260 - 10 + 10 * (frame / 20), 0.01) << "and never the mean";
        seen.push_back(value);
    }
    for (int frame = 59; frame >= 0; frame -= 7) {
        static_cast<void>(plan(first_ns + frame * 100'000'000LL));
        EXPECT_EQ(scene::value_of(shown().texels()[0], shown().range()), seen[static_cast<std::size_t>(frame)]);
    }
    EXPECT_EQ(plan(first_ns + 6'000'000'000).member, 0u) << "and round again";
}

TEST_F(SpatialDataOf, FewerMembersAreEvenlySpacedAndAFieldWithoutAnyIsNotShown) {
    start(dated_ensemble(5));
    style_.ground.members = design::GroundMembers::animated;
    style_.ground.member_s = 1;
    style_.ground.most_members = 3;
    std::vector<std::uint32_t> members;
    for (int second = 0; second < 3; ++second) members.push_back(plan(second * 1'000'000'000LL).member);
    EXPECT_EQ(members, (std::vector<std::uint32_t>{0, 2, 4})) << "without a date too";
    style_.ground.members = design::GroundMembers::mean;
    EXPECT_EQ(plan(0).member, scene::kMean);
    scene_memory_.reset();
    slice_memory_.reset();
    start(dated_scene());
    style_.ground.members = design::GroundMembers::animated;
    EXPECT_EQ(plan(kDate_ns).ground, GroundDataState::no_members);
    EXPECT_EQ(data_.ground(), nullptr) << "the mean stands for no member";
}

TEST_F(SpatialDataOf, WhatCannotBeShownIsSaid) {
    style_.ground.is_shown = true;
    EXPECT_EQ(plan(0).ground, GroundDataState::no_terrain);
    style_.ground.is_shown = false;
    EXPECT_EQ(data_.start(nullptr, {scene_memory_, slice_memory_}, 64).message.view(), "");
    EXPECT_EQ(plan(0).ground, GroundDataState::not_asked_for);
    style_.ground.is_shown = true;
    EXPECT_EQ(plan(0).ground, GroundDataState::no_scene);
    scene_memory_.reset();
    slice_memory_.reset();
    start(dated_scene());
    style_.ground.layer = "nothing";
    EXPECT_EQ(plan(kDate_ns).ground, GroundDataState::no_such_layer);
    style_.ground.layer = "masts";
    EXPECT_EQ(plan(kDate_ns).ground, GroundDataState::no_such_attribute);
    style_.ground.attribute = "kind";
    EXPECT_EQ(plan(kDate_ns).ground, GroundDataState::too_large) << "no grid";
    for (const GroundDataState state : {GroundDataState::no_scene, GroundDataState::no_such_layer, GroundDataState::too_large,
                                        GroundDataState::out_of_date, GroundDataState::shown})
        EXPECT_GT(std::string(reason_of(state)).size(), 10u);
}

TEST_F(SpatialDataOf, AGridThatIsTooLargeForTheDeviceIsRefused) {
    start(dated_scene(), 3);
    EXPECT_EQ(plan(kDate_ns).ground, GroundDataState::too_large) << "four columns";
}

TEST_F(SpatialDataOf, AFaultySceneIsNamed) {
    test_support::FlakyBytes damaged(host_sim::sdb_bytes(dated_scene()));
    damaged.content[300] = static_cast<std::uint8_t>(damaged.content[300] ^ 1u);
    const base::Error error = data_.start(&damaged, {scene_memory_, slice_memory_}, 64);
    EXPECT_EQ(std::string(scene_fault(error.message.view())).rfind("is damaged (offset ", 0), 0u) << error.message.view();
    EXPECT_EQ(scene_fault("the reservation does not hold"), "");
    base::Arena little(memory_.data(), 8);
    SpatialData other;
    EXPECT_NE(other.start(nullptr, {scene_memory_, little}, 64).message.view().find("scene_slices"), 0u);
}

}  // namespace
}  // namespace tedavis::display::test_spatial_data
