#include "host_sim/contract/picture_readings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/flights/evaluated_flights.hpp"

namespace tedavis::host_sim::test_picture_readings {
namespace {

constexpr std::uint32_t kWidth = 240, kHeight = 180;
const std::vector<std::string> kLayers = {"terrain", "data", "uncertainty", "labels", "symbology"};
enum : std::uint8_t { kTerrain, kData, kUncertainty, kLabels, kSymbology };

/// A grey picture, measured when it is asked of.
class Scene {
public:
    Scene() : picture_{kWidth, kHeight, std::vector<std::uint8_t>(std::size_t{kWidth} * kHeight * 4, 120)} {
        mask_ = {kWidth, kHeight, std::vector<std::uint8_t>(std::size_t{kWidth} * kHeight, kTerrain), kLayers};
        frame_.prioritized = "terrain";
        frame_.has_scene = true;
        frame_.obstacles.emplace();
    }
    Scene& box(int left, int top, int right, int bottom, std::uint8_t level, std::uint8_t layer) {
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                const std::size_t at = static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
                std::fill_n(&picture_.pixels[4 * at], 3, level);
                mask_.layers[at] = layer;
            }
        return *this;
    }
    /// Vertical lines every fourth column.
    Scene& stripes(int left, int top, int right, int bottom, std::uint8_t layer) {
        for (int x = left; x < right; ++x) box(x, top, x + 1, bottom, x / 2 % 2 == 0 ? 30 : 220, layer);
        return *this;
    }
    FlightFrame& frame() { return frame_; }
    void obstacle(const std::string& state, double x, double y) {
        frame_.obstacles->push_back({"Mast", state, 30, {x - 5, y - 5, x + 5, y + 5}});
    }
    template <class Reading>
    ContractReading read(const ContractCondition& condition, Reading reading) {
        PictureMeter meter({});
        const PictureMeasures measures = meter.measure(picture_, "p", &mask_, {});
        return reading(condition, MeasuredFrame{frame_, picture_, &mask_, measures, meter});
    }

private:
    RgbaPicture picture_;
    LayerMask mask_;
    FlightFrame frame_;
};

TEST(PictureReadings, ClutterIsOfThePictureOfARegionOrOfTheBusiest) {
    Scene scene;
    scene.stripes(160, 120, 240, 180, kTerrain);  // lower right third
    ContractCondition condition;
    const double all = scene.read(condition, clutter_reading).value;
    condition.region = ClutterRegion::cell;
    condition.grid = {3, 3};
    condition.column = condition.row = 2;
    const ContractReading corner = scene.read(condition, clutter_reading);
    EXPECT_GT(corner.value, 8 * all) << "all edges lie in a ninth";
    EXPECT_EQ(corner.region, "lower right");
    EXPECT_EQ(corner.box.right, 239) << "the outermost pixels do not count";
    condition.column = 0;
    EXPECT_EQ(scene.read(condition, clutter_reading).value, 0);
    condition.region = ClutterRegion::every;
    const ContractReading busiest = scene.read(condition, clutter_reading);
    EXPECT_EQ(busiest.value, corner.value);
    EXPECT_EQ(busiest.region, "lower right");
    condition.grid = {8, 6};
    EXPECT_NE(scene.read(condition, clutter_reading).region.find(" of 8 x 6"), std::string::npos);
}

TEST(PictureReadings, TheShareIsThatOfTheLayerWithoutThoseThatAreLeftOut) {
    Scene scene;
    scene.box(40, 60, 60, 80, 250, kData).box(180, 60, 200, 80, 250, kSymbology);
    ContractCondition condition;
    condition.measure = ContractMeasure::saliency_share;
    condition.layer = "data";
    const double share = scene.read(condition, saliency_reading).value;
    EXPECT_GT(share, 0.05);
    EXPECT_LT(share, 0.5);
    condition.without = {"symbology"};
    EXPECT_GT(scene.read(condition, saliency_reading).value, 1.1 * share);
    condition.measure = ContractMeasure::saliency_over_area;
    EXPECT_GT(scene.read(condition, saliency_reading).value, 10) << "a small bright box draws the eye more than its size";
    condition.layer = "terrain";
    EXPECT_LT(scene.read(condition, saliency_reading).value, 1);
}

TEST(PictureReadings, WithoutALayerItIsThatOfThePrioritizedAspect) {
    Scene scene;
    scene.box(40, 60, 60, 80, 250, kData);
    ContractCondition of_data, prioritized;
    of_data.layer = "data";
    of_data.measure = prioritized.measure = ContractMeasure::saliency_share;
    scene.frame().prioritized = "data";
    EXPECT_EQ(scene.read(prioritized, saliency_reading).value, scene.read(of_data, saliency_reading).value);
    EXPECT_EQ(scene.read(prioritized, saliency_reading).words, "of data");
    scene.frame().prioritized.clear();
    EXPECT_EQ(scene.read(prioritized, saliency_reading).state, ReadingState::absent);
    EXPECT_EQ(Scene().read(of_data, saliency_reading).state, ReadingState::absent) << "nothing is salient on flat ground";
}

TEST(PictureReadings, DataThatAreNotShownHaveNoShareButWithoutASceneThereIsNothingToShow) {
    Scene scene;
    scene.box(40, 60, 60, 80, 250, kTerrain);
    ContractCondition of_data, over_area;
    of_data.layer = over_area.layer = "data";
    of_data.measure = ContractMeasure::saliency_share;
    over_area.measure = ContractMeasure::saliency_over_area;
    for (const ContractCondition& condition : {of_data, over_area}) {
        scene.frame().has_scene = true;
        EXPECT_EQ(scene.read(condition, saliency_reading).state, ReadingState::measured);
        EXPECT_EQ(scene.read(condition, saliency_reading).value, 0);
        scene.frame().has_scene = false;
        EXPECT_EQ(scene.read(condition, saliency_reading).state, ReadingState::absent);
    }
}

TEST(PictureReadings, ContrastIsOfTheFaintestSign) {
    Scene scene;
    ContractCondition condition;
    condition.measure = ContractMeasure::luminance_contrast;
    condition.layer = "labels";
    EXPECT_EQ(scene.read(condition, contrast_reading).state, ReadingState::absent);
    scene.box(20, 20, 40, 26, 255, kLabels);
    const double bright = scene.read(condition, contrast_reading).value;
    EXPECT_GT(bright, 3);
    scene.box(200, 150, 220, 156, 140, kLabels);
    const ContractReading faint = scene.read(condition, contrast_reading);
    EXPECT_LT(faint.value, 1.5);
    EXPECT_EQ(faint.region, "lower right");
    EXPECT_EQ(faint.box.left, 200);
    condition.layer = "symbology";
    EXPECT_EQ(scene.read(condition, contrast_reading).state, ReadingState::absent);
}

class ObstacleReading : public ::testing::Test {
protected:
    /// A bright box at the left, a fainter one at the right.
    ObstacleReading() {
        scene.box(50, 80, 60, 90, 255, kSymbology).box(190, 80, 200, 90, 170, kData);
        condition.measure = ContractMeasure::obstacle_rank;
        condition.limit = {true, 2, 0};
    }
    ContractReading read() { return scene.read(condition, obstacle_reading); }
    Scene scene;
    ContractCondition condition;
};

TEST_F(ObstacleReading, IsTheRankOfTheFirstPlaceThatReachesIt) {
    scene.obstacle("drawn", 55, 85);
    EXPECT_EQ(read().value, 1);
    scene.obstacle("drawn", 195, 85);
    EXPECT_EQ(read().value, 2) << "the worst of both";
    EXPECT_EQ(read().region, "middle right");
    EXPECT_EQ(read().words, "Mast");
    condition.without = {"symbology"};
    scene.frame().obstacles = {{"Mast", "drawn", 30, {190, 80, 200, 90}}};
    EXPECT_EQ(read().value, 1) << "instruments do not count";
}

TEST_F(ObstacleReading, WhatIsNotSalientHasNoRank) {
    scene.obstacle("drawn", 120, 170);
    condition.focus_share = 0.02;
    EXPECT_TRUE(std::isinf(read().value));
}

TEST_F(ObstacleReading, WhatTheDesignLeavesOutHasNone) {
    scene.obstacle("left_out", 55, 85);
    const ContractReading reading = read();
    EXPECT_TRUE(std::isinf(reading.value)) << "whatever is salient there";
    EXPECT_EQ(reading.words, "Mast, which is not shown");
}

TEST_F(ObstacleReading, WhatCannotBeSeenDoesNotCount) {
    EXPECT_EQ(read().state, ReadingState::absent);
    scene.obstacle("hidden", 55, 85);
    scene.obstacle("out_of_view", 55, 85);
    EXPECT_EQ(read().state, ReadingState::absent);
}

}  // namespace
}  // namespace tedavis::host_sim::test_picture_readings
