#include "render_core/scene/grid_slice.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::scene::test_grid_slice {
namespace {

constexpr std::int64_t kMinute_ns = 60'000'000'000;

class SliceOfAGrid : public ::testing::Test {
protected:
    SliceOfAGrid() {
        host_sim::SceneDraft draft;
        draft.layers = {test_support::small_grid(), test_support::small_points()};
        test_support::FlakyBytes source(host_sim::sdb_bytes(draft));
        base::Arena arena(memory_.data(), memory_.size());
        scene_ = Scene::load(source, arena).value();
        EXPECT_TRUE(slice_.start(100, arena));
        EXPECT_TRUE(slice_.set_field(layer(), attribute()));
    }
    [[nodiscard]] const Layer& layer() const { return scene_.layers()[0]; }
    [[nodiscard]] const Attribute& attribute() const { return layer().attributes[0]; }

    std::vector<std::uint8_t> memory_ = std::vector<std::uint8_t>(1 << 16);
    Scene scene_;
    GridSlice slice_;
};

TEST_F(SliceOfAGrid, TexelsAreTheFieldAtThePosts) {
    ASSERT_TRUE(slice_.show({2000, kMinute_ns * 30}));
    const GridField field(layer(), attribute());
    ASSERT_EQ(slice_.texels().size(), 12u);
    const double step = (slice_.range().highest - slice_.range().lowest) / 65535;
    int missing = 0;
    for (std::uint32_t j = 0; j < 3; ++j)
        for (std::uint32_t i = 0; i < 4; ++i) {
            const GridShape& g = layer().entry->grid;
            const FieldValue expected =
                field.at(g.north_rad - j * g.step_lat_rad, g.west_rad + i * g.step_lon_rad, 2000, kMinute_ns * 30);
            const SliceTexel& texel = slice_.texels()[j * 4 + i];
            missing += texel.state == 0 ? 1 : 0;
            ASSERT_EQ(texel.state == 0, expected.state == ValueState::missing);
            if (texel.state == 0) continue;
            EXPECT_NEAR(value_of(texel, slice_.range()), expected.value, 0.51 * step + 1e-9);
            EXPECT_EQ(texel.uncertainty, expected.uncertainty.code());
        }
    EXPECT_EQ(missing, 1);
    EXPECT_EQ(slice_.texels()[7].state, 128) << "interpolated";
}

std::vector<int> values_of(const GridSlice& slice) {
    std::vector<int> values;
    for (const SliceTexel& texel : slice.texels()) values.push_back(texel.value_high * 256 + texel.value_low);
    return values;
}

TEST_F(SliceOfAGrid, WhatIsMadeAheadIsWhatAJumpMakes) {
    EXPECT_FALSE(slice_.has_texels());
    ASSERT_TRUE(slice_.show({1500, 0}));
    const std::vector<int> first = values_of(slice_);
    slice_.prepare({1500, kMinute_ns}, 1);
    slice_.prepare({1500, kMinute_ns}, 1);
    EXPECT_EQ(values_of(slice_), first) << "nothing half done is seen";
    ASSERT_TRUE(slice_.show({1500, kMinute_ns})) << "what is left is made at once";
    const std::vector<int> ahead = values_of(slice_);
    slice_.forget();
    EXPECT_FALSE(slice_.has_texels());
    ASSERT_TRUE(slice_.set_field(layer(), attribute()));
    ASSERT_TRUE(slice_.show({1500, kMinute_ns}));
    EXPECT_EQ(values_of(slice_), ahead);
    EXPECT_NE(ahead, first);
}

TEST_F(SliceOfAGrid, TheSameMomentIsNotMadeAgain) {
    ASSERT_TRUE(slice_.show({1500, 0}));
    EXPECT_FALSE(slice_.show({1500, 0}));
    EXPECT_TRUE(slice_.show({1600, 0}));
    slice_.prepare({1600, kMinute_ns}, 100);
    slice_.prepare({1600, 2 * kMinute_ns}, 100);
    EXPECT_TRUE(slice_.show({1600, kMinute_ns})) << "another one was made ahead";
    EXPECT_TRUE(slice_.show({1600, 0})) << "a time that runs back";
}

TEST(SliceOfKinds, KnowsWhichAreInUse) {
    host_sim::LayerDraft layer = test_support::small_grid();
    host_sim::AttributeDraft& kind = layer.attributes[0];
    kind.scale = AttributeScale::nominal;
    kind.classes = {"a", "b", "c", "d"};
    for (std::size_t n = 0; n < kind.values.size(); ++n) kind.values[n] = n < 24 ? (n % 2 == 0 ? 3 : 1) : 2;
    kind.values[4] = std::nanf("");
    host_sim::SceneDraft draft;
    draft.layers = {layer};
    std::vector<std::uint8_t> memory(1 << 16);
    test_support::FlakyBytes source(host_sim::sdb_bytes(draft));
    base::Arena arena(memory.data(), memory.size());
    const Scene scene = Scene::load(source, arena).value();
    GridSlice slice;
    ASSERT_TRUE(slice.start(100, arena));
    ASSERT_TRUE(slice.set_field(scene.layers()[0], scene.layers()[0].attributes[0]));
    ASSERT_TRUE(slice.show({1000, 0}));
    EXPECT_EQ(slice.classes_in_use(), 0b1010u);
    slice.prepare({1000, layer.times_ns[1]}, 1);
    EXPECT_EQ(slice.classes_in_use(), 0b1010u) << "of what is shown, not of what is made ahead";
    ASSERT_TRUE(slice.show({1000, layer.times_ns[1]}));
    EXPECT_EQ(slice.classes_in_use(), 0b100u);
}

TEST_F(SliceOfAGrid, QuantitiesHaveNoKinds) {
    ASSERT_TRUE(slice_.show({2000, 0}));
    EXPECT_EQ(slice_.classes_in_use(), 0u);
}

TEST_F(SliceOfAGrid, WhatHasNoRoomIsRefused) {
    GridSlice small;
    std::vector<std::uint8_t> memory(GridSlice::bytes_needed(11) + 64);
    base::Arena arena(memory.data(), memory.size());
    ASSERT_TRUE(small.start(11, arena));
    EXPECT_FALSE(small.set_field(layer(), attribute()));
    EXPECT_FALSE(small.show({0, 0}));
    small.prepare({0, 0}, 10);
    EXPECT_EQ(small.columns(), 0u);
    EXPECT_FALSE(small.start(1000, arena));
    EXPECT_FALSE(slice_.set_field(scene_.layers()[1], scene_.layers()[1].attributes[0])) << "no grid";
}

TEST(SliceTexel, GoesThereAndBack) {
    const SliceRange range{-40, 60};
    for (double value = -40; value <= 60; value += 0.37)
        EXPECT_NEAR(value_of(texel_of({value, Uncertainty::from_level(0), ValueState::valid}, range), range), value,
                    100 / 65535.0);
    EXPECT_EQ(value_of(texel_of({1e9, {}, ValueState::valid}, range), range), 60);
    EXPECT_EQ(value_of(texel_of({5, {}, ValueState::valid}, {7, 7}), {7, 7}), 7) << "a constant field";
    EXPECT_EQ(texel_of({5, {}, ValueState::missing}, range).state, 0);
    EXPECT_EQ(texel_of({std::nan(""), {}, ValueState::valid}, range).state, 0) << "what is no number is missing";
}

TEST(SliceOfAnEnsemble, AMembersTexelsAreItsOwnWithTheEnsemblesStates) {
    host_sim::SceneDraft draft;
    draft.layers = {test_support::small_ensemble()};
    std::vector<std::uint8_t> memory(1 << 16);
    test_support::FlakyBytes source(host_sim::sdb_bytes(draft));
    base::Arena arena(memory.data(), memory.size());
    const Scene scene = Scene::load(source, arena).value();
    GridSlice slice;
    ASSERT_TRUE(slice.start(100, arena));
    const Layer& layer = scene.layers()[0];
    ASSERT_TRUE(slice.set_field(layer, layer.attributes[0]));
    ASSERT_TRUE(slice.show({1000, 0}));
    const std::vector<SliceTexel> mean(slice.texels().begin(), slice.texels().end());
    for (std::uint32_t member = 0; member < 3; ++member) {
        slice.prepare({1000, 0, member}, 1);
        ASSERT_TRUE(slice.show({1000, 0, member}));
        EXPECT_FALSE(slice.show({1000, 0, member}));
        for (std::size_t n = 0; n < 12; ++n) {
            const SliceTexel& texel = slice.texels()[n];
            EXPECT_EQ(texel.state, mean[n].state);
            EXPECT_EQ(texel.uncertainty, mean[n].uncertainty);
            if (texel.state == 0) continue;
            EXPECT_NEAR(value_of(texel, slice.range()), value_of(mean[n], slice.range()) + 10.0 * member - 10, 0.01);
        }
    }
    EXPECT_TRUE(slice.show({1000, 0})) << "the mean is another";
}

}  // namespace
}  // namespace tedavis::scene::test_grid_slice
