#include "host_sim/contract/contract_meter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/input_file.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "host_sim/shipped_files.hpp"
#include "tests/support/flights/frame_lines.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/sheets/contract_runs.hpp"

namespace tedavis::host_sim::test_contract_meter {
namespace {

using test_support::PaintedFrame;
using ::testing::HasSubstr;

class ContractMeterOfARun : public ::testing::Test {
protected:
    std::vector<ContractReading> readings(const std::string& conditions, const PaintedFrame& painted = {}) {
        test_support::write_painted_run(place_, "run", 1, [&](std::uint64_t) { return painted; });
        contract_ = read_contract(place_.write("c.toml", conditions));
        const FlightRun run = read_flight_run(place_.file("run"));
        PictureMeter meter({});
        return ContractMeter(contract_, run).readings(meter, run.frames[0]);
    }
    test_support::TemporaryFolder place_;
    Contract contract_;
};

const char* const kAll =
    "[[condition]]\nmeasure = \"clutter\"\nmost = 0.5\n"
    "[[condition]]\nmeasure = \"saliency_share\"\nleast = 0.1\n"
    "[[condition]]\nmeasure = \"saliency_over_area\"\nleast = 0.1\n"
    "[[condition]]\nmeasure = \"obstacle_rank\"\nmost = 5\n"
    "[[condition]]\nmeasure = \"luminance_contrast\"\nlayer = \"labels\"\nleast = 3\n"
    "[[condition]]\nmeasure = \"color_difference\"\nbetween = [\"ground\", \"sea\"]\nleast = 3\n";

TEST_F(ContractMeterOfARun, EveryMeasureHasAReading) {
    const auto all = readings(kAll);
    ASSERT_EQ(all.size(), 6u);
    for (const ContractReading& one : all) {
        EXPECT_EQ(one.state, ReadingState::measured);
        EXPECT_GT(one.value, 0);
    }
    EXPECT_EQ(all[1].words, "of data");
    EXPECT_EQ(all[5].region, "design default");
}

TEST_F(ContractMeterOfARun, OtherPhasesAreNotMeasured) {
    const auto readings_of = [&](const std::string& phase) {
        return readings("[[condition]]\nmeasure = \"clutter\"\nmost = 0.5\nphases = [\"" + phase + "\"]\n")[0].state;
    };
    EXPECT_EQ(readings_of("cruise"), ReadingState::measured);
    EXPECT_EQ(readings_of("approach"), ReadingState::absent);
}

TEST_F(ContractMeterOfARun, WithoutMasksItSaysHowTheyAreMade) {
    PaintedFrame painted;
    painted.has_layers = false;
    const auto all = readings(kAll, painted);
    EXPECT_EQ(all[0].state, ReadingState::measured) << "clutter needs none";
    for (const std::size_t n : {1, 2, 3, 4}) {
        EXPECT_EQ(all[n].state, ReadingState::missing) << n;
        EXPECT_THAT(all[n].words, HasSubstr("replay the run again with --layers"));
    }
    EXPECT_EQ(all[5].state, ReadingState::measured) << "neither do colours of the design";
}

/// The palette file is that of the run's summary, and so is the light of a record without one.
class ContractMeterOfAPalette : public ::testing::Test {
protected:
    /// Of the first frame; `light` is that of its record, if it has one.
    ContractReading reading(const std::string& measure, const std::string& summary, const std::string& light = "") {
        test_support::write_painted_run(place_, "run", 1, [](std::uint64_t) { return PaintedFrame(); });
        place_.write("run/" + std::string(kSummaryName), summary);
        auto record = test_support::frame_lines(place_.file("run")).at(0);
        record.erase("symbology_light");
        if (!light.empty()) record["symbology_light"] = light;
        place_.write("run/" + std::string(kFrameRecordsName), record.dump() + "\n");
        contract_ = read_contract(place_.write("c.toml", "[[condition]]\nmeasure = \"" + measure + "\"\nleast = 4\n"));
        const FlightRun run = read_flight_run(place_.file("run"));
        PictureMeter meter({});
        return ContractMeter(contract_, run).readings(meter, run.frames[0])[0];
    }
    test_support::TemporaryFolder place_;
    Contract contract_;
};

TEST_F(ContractMeterOfAPalette, RolesAreComparedInTheRunsLight) {
    const ContractReading day = reading("symbology_difference", R"({"design": "default", "light": "day"})"),
                          night = reading("symbology_difference", R"({"design": "default", "light": "night"})");
    EXPECT_EQ(day.state, ReadingState::measured);
    EXPECT_EQ(day.region, "palette standard");
    EXPECT_GT(day.value, 6);
    EXPECT_GT(night.value, 6);
    EXPECT_NE(day.value, night.value);
}

/// A key of the window changes the light within a run.
TEST_F(ContractMeterOfAPalette, TheLightOfAFrameComesBeforeTheRuns) {
    const auto gap = [&](const char* run, const std::string& frame) {
        return reading("symbology_difference", R"({"design": "default", "light": ")" + std::string(run) + "\"}", frame).value;
    };
    const double day = gap("day", ""), night = gap("night", "");
    ASSERT_NE(day, night);
    EXPECT_EQ(gap("day", "night"), night);
    EXPECT_EQ(gap("night", "day"), day);
    EXPECT_EQ(reading("symbology_difference", R"({"design": "default"})", "night").value, night);
}

TEST_F(ContractMeterOfAPalette, TwoRolesAlikeAreNamed) {
    std::string text = read_file(shipped_root() + "/configs/palettes/symbology/standard.toml");
    const std::string caution = "caution = \"#ffb000\"";
    text.replace(text.find(caution), caution.size(), "caution = \"#ff3838\"");
    const ContractReading alike = reading(
        "symbology_difference", R"({"design": "default", "light": "day", "palette": ")" + place_.write("p.toml", text) + "\"}");
    EXPECT_LT(alike.value, 2);
    EXPECT_THAT(alike.words, HasSubstr("warning and caution in"));
}

TEST_F(ContractMeterOfAPalette, ARunThatDoesNotSayItsLightIsToBeReplayedAgain) {
    const ContractReading old = reading("symbology_contrast", R"({"design": "default"})");
    EXPECT_EQ(old.state, ReadingState::missing);
    EXPECT_THAT(old.words, HasSubstr("replay the run again"));
    EXPECT_EQ(reading("symbology_contrast", R"({"design": "default", "light": "day"})").state, ReadingState::absent)
        << "its pictures have no symbology";
}

TEST_F(ContractMeterOfARun, ColorsAreThoseOfTheFramesDesign) {
    const std::string keys = "[[condition]]\nmeasure = \"color_difference\"\nbetween = [\"warnings\"]\nleast = 3\n";
    PaintedFrame painted;
    const double by_default = readings(keys, painted)[0].value;
    painted.design = "map_north_up";
    EXPECT_NE(readings(keys, painted)[0].value, by_default) << "it has bands";
    painted.design = "another";
    const ContractReading unknown = readings(keys, painted)[0];
    EXPECT_EQ(unknown.state, ReadingState::missing);
    EXPECT_THAT(unknown.words, HasSubstr("'another'"));
}

TEST_F(ContractMeterOfARun, ARunWithoutItsDesignIsRefused) {
    test_support::write_painted_run(place_, "run", 1, [](std::uint64_t) { return PaintedFrame(); });
    contract_ = read_contract(place_.write("c.toml", kAll));
    FlightRun run = read_flight_run(place_.file("run"));
    run.design.clear();
    test_support::expect_user_error([&] { const ContractMeter meter(contract_, run); }, "names no design");
    run.design = "no_such_design";
    test_support::expect_user_error([&] { const ContractMeter meter(contract_, run); }, "no_such_design");
}

}  // namespace
}  // namespace tedavis::host_sim::test_contract_meter
