#include "render_core/scene/glyph_sums.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

namespace tedavis::scene::test_glyph_sums {
namespace {

GlyphSummary one(const glm::vec3& place, float value, float north = 0, std::uint8_t code = 10) {
    GlyphSummary summary;
    summary.place = place;
    summary.value = value;
    summary.north_mps = north;
    summary.speed_mps = std::hypot(value, north);
    summary.members = 1;
    summary.uncertainty = Uncertainty::from_code(code);
    summary.state = ValueState::valid;
    return summary;
}

GlyphSummary missing(const glm::vec3& place) {
    GlyphSummary summary;
    summary.place = place;
    summary.members = summary.missing = 1;
    return summary;
}

GlyphSummary of(GlyphValues values, const std::vector<GlyphSummary>& parts) {
    GlyphSums sums(values);
    for (const GlyphSummary& part : parts) sums.add(part);
    return sums.summary();
}

TEST(GlyphSums, OfNoneIsNothing) {
    const GlyphSummary none = GlyphSums(GlyphValues::number).summary();
    EXPECT_EQ(none.members, 0u);
    EXPECT_EQ(none.state, ValueState::missing);
    EXPECT_FALSE(none.uncertainty.is_known());
}

TEST(GlyphSums, MeansAreThoseOfTheMembersInWhateverGroupsTheyCome) {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(-1000, 1000);
    GlyphSums all(GlyphValues::wind), halves[2] = {GlyphSums(GlyphValues::wind), GlyphSums(GlyphValues::wind)};
    long double value = 0, north = 0, speed = 0, code = 0;
    glm::highp_dvec3 place(0);
    constexpr int kCount = 5000;
    std::vector<glm::vec3> places;
    for (int n = 0; n < kCount; ++n) {
        const auto unsure = static_cast<std::uint8_t>(random() % 255);
        const GlyphSummary part = one({number(random), number(random), number(random)}, number(random), number(random), unsure);
        all.add(part);
        halves[n % 3 == 0].add(part);
        places.push_back(part.place);
        place += glm::dvec3(part.place);
        value += part.value;
        north += part.north_mps;
        speed += std::hypot(static_cast<long double>(part.value), static_cast<long double>(part.north_mps));
        code += unsure;
    }
    halves[0].add(halves[1]);
    for (const GlyphSums* sums : {&all, &halves[0]}) {
        const GlyphSummary mean = sums->summary();
        EXPECT_EQ(mean.members, kCount);
        EXPECT_NEAR(mean.value, static_cast<double>(value / kCount), 1e-5);
        EXPECT_NEAR(mean.north_mps, static_cast<double>(north / kCount), 1e-5);
        EXPECT_NEAR(mean.speed_mps, static_cast<double>(speed / kCount), 1e-4);
        EXPECT_LT(glm::length(glm::dvec3(mean.place) - place / double{kCount}), 1e-5);
        EXPECT_EQ(mean.uncertainty.code(), std::ceil(static_cast<double>(code / kCount)));
        glm::vec3 farthest(0);
        for (const glm::vec3& at : places) farthest = glm::max(farthest, glm::abs(at - mean.place));
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GE(mean.reach_m[axis], farthest[axis]);
            EXPECT_LT(mean.reach_m[axis], 1.01f * farthest[axis]);
        }
    }
}

TEST(GlyphSums, MissingMembersAreCountedAndNotAveragedIn) {
    const GlyphSummary mean = of(GlyphValues::number, {one({0, 0, 0}, 4), missing({3, 0, 0}), one({6, 0, 0}, 8)});
    EXPECT_EQ(mean.members, 3u);
    EXPECT_EQ(mean.missing, 1u);
    EXPECT_FLOAT_EQ(mean.value, 6);
    EXPECT_FLOAT_EQ(mean.place.x, 3);
    EXPECT_EQ(mean.uncertainty.code(), 10) << "who has no value does not make the others unsure";
    EXPECT_EQ(mean.state, ValueState::valid);
    const GlyphSummary none = of(GlyphValues::number, {missing({1, 0, 0}), missing({3, 0, 0})});
    EXPECT_EQ(none.state, ValueState::missing);
    EXPECT_FALSE(none.uncertainty.is_known());
    EXPECT_FLOAT_EQ(none.place.x, 2);
}

TEST(GlyphSums, BoxesAreCutWhereTheMeanIsInside) {
    GlyphSums sums(GlyphValues::number);
    GlyphSummary wide = one({5, 5, 5}, 1);
    wide.reach_m = {4, 4, 4};
    sums.add(wide);
    sums.keep_within({4, 0, 8}, {6, 20, 9});
    const GlyphSummary kept = sums.summary();
    EXPECT_NEAR(kept.reach_m.x, 1, 1e-5);
    EXPECT_NEAR(kept.reach_m.y, 4, 1e-5);
    EXPECT_NEAR(kept.reach_m.z, 4, 1e-5) << "elsewhere: left as it is";
    EXPECT_NEAR(radius_m(kept), std::sqrt(33.0), 1e-4);
}

TEST(GlyphSums, OneUnknownMakesTheWholeUnknown) {
    const GlyphSummary mean = of(GlyphValues::number, {one({}, 4, 0, 0), one({}, 8, 0, Uncertainty::kUnknown)});
    EXPECT_FALSE(mean.uncertainty.is_known());
    EXPECT_FLOAT_EQ(mean.value, 6);
}

TEST(GlyphSums, OneInterpolatedMakesTheWholeInterpolated) {
    GlyphSummary filled = one({}, 4);
    filled.state = ValueState::interpolated;
    EXPECT_EQ(of(GlyphValues::number, {one({}, 4), filled}).state, ValueState::interpolated);
}

TEST(GlyphSums, ClassesHaveNoMean) {
    EXPECT_FLOAT_EQ(of(GlyphValues::category, {one({}, 3), missing({}), one({}, 3)}).value, 3);
    EXPECT_FALSE(of(GlyphValues::category, {missing({}), one({}, 3)}).is_mixed);
    const GlyphSummary mixed = of(GlyphValues::category, {one({}, 1), one({}, 3)});
    EXPECT_TRUE(mixed.is_mixed);
    EXPECT_FLOAT_EQ(mixed.value, 0);
    GlyphSums sums(GlyphValues::category);
    sums.add(mixed);
    sums.add(one({}, 1));
    EXPECT_TRUE(sums.summary().is_mixed) << "what was mixed stays so";
}

TEST(GlyphSums, WindsThatCancelAreVariableAndNotCalm) {
    const GlyphSummary variable = of(GlyphValues::wind, {one({}, 10), one({}, -10)});
    EXPECT_EQ(wind_of(variable).state, WindState::variable);
    EXPECT_NEAR(wind_of(variable).speed_mps, 10, 1e-6);
    EXPECT_EQ(wind_of(of(GlyphValues::wind, {one({}, 0.1f), one({}, -0.1f)})).state, WindState::calm);
    EXPECT_EQ(wind_of(of(GlyphValues::wind, {one({}, 10), one({}, 9)})).state, WindState::steady);
    EXPECT_EQ(wind_of(of(GlyphValues::wind, {missing({})})).state, WindState::unknown);
}

TEST(GlyphSums, TheMeanHeightOverTheGroundIsOneOfAllOrNotKnown) {
    const auto over = [](float metres, float value) {
        GlyphSummary part = std::isnan(value) ? missing({0, 0, 0}) : one({0, 0, 0}, value);
        part.over_ground_m = metres;
        return part;
    };
    EXPECT_FLOAT_EQ(of(GlyphValues::number, {over(100, 1), over(200, 1), over(900, NAN)}).over_ground_m, 400)
        << "a missing value floats as well";
    EXPECT_TRUE(std::isnan(of(GlyphValues::number, {over(100, 1), over(NAN, 1)}).over_ground_m));
    EXPECT_TRUE(std::isnan(of(GlyphValues::number, {one({}, 1)}).over_ground_m)) << "not asked for";
}

}  // namespace
}  // namespace tedavis::scene::test_glyph_sums
