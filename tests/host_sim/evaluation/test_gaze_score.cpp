#include "host_sim/evaluation/gaze_score.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace tedavis::host_sim::test_gaze_score {
namespace {

constexpr std::uint32_t kSide = 64;

std::vector<float> noise(unsigned seed) {
    std::mt19937 random(seed);
    std::vector<float> map;
    for (std::uint32_t n = 0; n < kSide * kSide; ++n) map.push_back(static_cast<float>(random()) / 4294967296.0f);
    return map;
}

std::vector<GazePixel> scattered(std::uint32_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<GazePixel> gaze;
    for (std::uint32_t n = 0; n < count; ++n)
        gaze.push_back({static_cast<std::uint32_t>(random() % kSide), static_cast<std::uint32_t>(random() % kSide)});
    return gaze;
}

TEST(GazeScore, APerfectMapIsOneAndItsNegativeZero) {
    const std::vector<GazePixel> gaze = scattered(30, 3);
    std::vector<float> map(kSide * kSide, 0.1f), negative(kSide * kSide, 0.9f);
    for (const GazePixel& pixel : gaze) {
        map[pixel.y * kSide + pixel.x] = 1;
        negative[pixel.y * kSide + pixel.x] = 0;
    }
    EXPECT_EQ(gaze_score(map, kSide, gaze)->auc, 1.0);
    EXPECT_EQ(gaze_score(negative, kSide, gaze)->auc, 0.0);
    EXPECT_LT(*gaze_score(negative, kSide, gaze)->nss, 0);
}

TEST(GazeScore, ChanceIsAHalf) {
    EXPECT_NEAR(gaze_score(noise(1), kSide, scattered(1000, 2))->auc, 0.5, 0.03);
    EXPECT_NEAR(*gaze_score(noise(1), kSide, scattered(1000, 2))->nss, 0, 0.1);
    const auto flat = gaze_score(std::vector<float>(kSide * kSide, 0.3f), kSide, scattered(20, 5));
    EXPECT_EQ(flat->auc, 0.5) << "ties count half";
    EXPECT_FALSE(flat->nss.has_value());
}

TEST(GazeScore, NssOfAKnownMap) {
    // Mean 2, variance (4 * 1 + 0 + ...) / 4: values 1, 1, 3, 3 have deviation 1.
    const std::vector<float> map{1, 1, 3, 3};
    EXPECT_DOUBLE_EQ(*gaze_score(map, 2, {{0, 1}})->nss, 1);
    EXPECT_DOUBLE_EQ(*gaze_score(map, 2, {{0, 0}})->nss, -1);
    EXPECT_DOUBLE_EQ(*gaze_score(map, 2, {{0, 0}, {1, 1}})->nss, 0);
    EXPECT_DOUBLE_EQ(gaze_score(map, 2, {{0, 1}})->auc, (0.5 + 1 + 1) / 3);
}

TEST(GazeScore, ScaleDoesNotMatterAndPixelsCountOnce) {
    const std::vector<GazePixel> gaze = scattered(40, 9);
    std::vector<float> map = noise(4), scaled = map;
    for (float& value : scaled) value = 8 * value;
    std::vector<GazePixel> twice = gaze;
    twice.insert(twice.end(), gaze.begin(), gaze.end());
    const auto score = gaze_score(map, kSide, gaze), other = gaze_score(scaled, kSide, twice);
    EXPECT_EQ(score->auc, other->auc);
    EXPECT_NEAR(*score->nss, *other->nss, 1e-9);
    EXPECT_EQ(score->pixels, other->pixels);
}

// The definition as the benchmark has it: hits against false alarms over every threshold, by trapezoids.
TEST(GazeScore, AgreesWithTheCurveOfHitsAndFalseAlarms) {
    std::vector<float> map = noise(6);
    for (float& value : map) value = std::floor(value * 20);  // many ties
    const std::vector<GazePixel> gaze = scattered(50, 8);
    std::vector<bool> looked_at(map.size(), false);
    for (const GazePixel& pixel : gaze) looked_at[pixel.y * kSide + pixel.x] = true;
    const double all = static_cast<double>(std::count(looked_at.begin(), looked_at.end(), true));
    const double rest = static_cast<double>(map.size()) - all;
    double area = 0, hits_before = 0, alarms_before = 0;
    for (int threshold = 20; threshold >= 0; --threshold) {
        double hits = 0, alarms = 0;
        for (std::size_t n = 0; n < map.size(); ++n)
            if (map[n] >= static_cast<float>(threshold)) (looked_at[n] ? hits : alarms) += 1;
        area += (alarms / rest - alarms_before) * (hits / all + hits_before) / 2;
        hits_before = hits / all, alarms_before = alarms / rest;
    }
    EXPECT_NEAR(gaze_score(map, kSide, gaze)->auc, area, 1e-12);
}

TEST(GazeScore, NothingToScore) {
    EXPECT_FALSE(gaze_score({1, 2}, 2, {}).has_value());
    EXPECT_FALSE(gaze_score({1, 2}, 2, {{0, 0}, {1, 0}}).has_value());
}

}  // namespace
}  // namespace tedavis::host_sim::test_gaze_score
