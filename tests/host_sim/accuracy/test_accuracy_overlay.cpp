#include "host_sim/accuracy/accuracy_overlay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "host_sim/replay/posed_frame.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_accuracy_overlay {
namespace {

constexpr AircraftPose kPose{47.03, 9.68, 2500, 40, -6, 12};

FrameResult made_result() {
    FrameResult result;
    result.record.terrain.chunks = 3;
    result.record.terrain.tau_px = 2;
    result.record.terrain.worst_error_px = 1.2301;
    result.record.governor.quality_level = 4;
    result.timing.total_ms = 12.34;
    return result;
}

/// The number behind the words of a line; -1 where there is no such line.
double number_after(const std::vector<std::string>& lines, const std::string& words) {
    for (const std::string& line : lines)
        if (line.rfind(words, 0) == 0) return std::strtod(line.c_str() + words.size(), nullptr);
    return -1;
}

TEST(AccuracyLines, AreTheFiguresOfTheRecord) {
    const std::vector<std::string> lines = accuracy_lines(made_result(), true);
    EXPECT_EQ(number_after(lines, "TAU "), 2);
    EXPECT_EQ(number_after(lines, "PROVEN MAX "), 1.24) << "a bound is never rounded down";
    EXPECT_EQ(number_after(lines, "QUALITY LEVEL "), 4);
    EXPECT_EQ(number_after(lines, "FRAME "), 12.3);
    EXPECT_EQ(number_after(accuracy_lines(made_result(), false), "FRAME "), -1);
    FrameResult other = made_result();
    other.record.terrain.worst_error_px = 7.5;
    EXPECT_EQ(number_after(accuracy_lines(other, true), "PROVEN MAX "), 7.5) << "control: another record";
    other.record.terrain.chunks = 0;
    EXPECT_EQ(number_after(accuracy_lines(other, true), "PROVEN MAX "), -1) << "nothing is proven of no terrain";
}

TEST(AccuracyOverlay, MarksTheRecordAndChangesOnlyItsPanel) {
    const test_support::FlownFiles files;
    const PictureOptions options = files.options("unused").picture;
    DisplaySession session(options, false);
    FrameResult result = posed_frame(session, kPose, {});
    const std::uint64_t hash = result.hash;
    const RgbaPicture before = upright(session.pixels());
    EXPECT_EQ(AccuracyOverlay({}, options.terrain).over(session, result).pixels, before.pixels);
    EXPECT_FALSE(result.has_accuracy_overlay) << "control: nothing is shown";

    const RgbaPicture after = AccuracyOverlay({{true, false}}, options.terrain).over(session, result);
    EXPECT_TRUE(result.has_accuracy_overlay);
    EXPECT_FALSE(result.measured_error);
    EXPECT_EQ(session.frame_hash(), hash) << "the display's own picture stays";
    std::size_t changed = 0;
    for (std::uint32_t y = 0; y < after.height; ++y)
        for (std::uint32_t x = 0; x < after.width; ++x) {
            const std::size_t n = (std::size_t{y} * after.width + x) * 4;
            if (std::equal(&after.pixels[n], &after.pixels[n] + 4, &before.pixels[n])) continue;
            ++changed;
            EXPECT_GE(y, after.height / 8);
            EXPECT_LT(x, after.width * 2 / 3);
        }
    EXPECT_GT(changed, 1000u);
}

TEST(AccuracyOverlay, TheMapStatesWhatItMeasured) {
    const test_support::FlownFiles files;
    const PictureOptions options = files.options("unused").picture;
    DisplaySession session(options, false);
    FrameResult result = posed_frame(session, kPose, {});
    const RgbaPicture before = upright(session.pixels());
    const RgbaPicture after = AccuracyOverlay({{false, true}}, options.terrain).over(session, result);
    ASSERT_TRUE(result.measured_error);
    EXPECT_EQ(session.frame_hash(), result.hash) << "the session shows its frame again";
    EXPECT_GT(result.measured_error->places, 100u);
    EXPECT_LE(result.measured_error->max_px, result.record.terrain.worst_error_px);
    EXPECT_NE(after.pixels, before.pixels);
    EXPECT_TRUE(std::equal(after.pixels.begin(), after.pixels.begin() + 320 * 4 * 8, before.pixels.begin())) << "the sky";
    const nlohmann::json json = nlohmann::json::parse(frame_record_json(result, result.record.time));
    EXPECT_EQ(json.at("accuracy_overlay"), true);
    EXPECT_EQ(json.at("measured_error").at("max_px"), result.measured_error->max_px);
}

TEST(AccuracyOverlay, AMapNeedsTerrain) {
    test_support::expect_user_error([] { AccuracyOverlay({{false, true}}, ""); }, "--error-map: needs terrain");
    AccuracyOverlay overlay({{true, false}}, "");
    test_support::expect_user_error([&] { overlay.show({true, true}); }, "name one with --terrain");
    EXPECT_FALSE(overlay.shown().error_map) << "it goes on as before";
}

}  // namespace
}  // namespace tedavis::host_sim::test_accuracy_overlay
