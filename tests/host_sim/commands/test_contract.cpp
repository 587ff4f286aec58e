#include "host_sim/commands/contract.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/sheets/contract_runs.hpp"

namespace tedavis::host_sim::test_contract_command {
namespace {

using test_support::CommandRun;
using test_support::PaintedFrame;
using ::testing::HasSubstr;

/// Each is kept by a run that is painted as it should be.
const char* const kConditions =
    "title = \"painted\"\n"
    "[[condition]]\nname = \"calm\"\nmeasure = \"clutter\"\nmost = 0.05\n"
    "[[condition]]\nname = \"data first\"\nmeasure = \"saliency_over_area\"\nleast = 1.5\n"
    "[[condition]]\nname = \"noticed\"\nmeasure = \"obstacle_rank\"\nmost = 4\n"
    "[[condition]]\nname = \"legible\"\nmeasure = \"luminance_contrast\"\nlayer = \"labels\"\nleast = 3\n"
    "[[condition]]\nname = \"told apart\"\nmeasure = \"color_difference\"\nbetween = [\"ground\", \"unknown\"]\nleast = 8\n";

class ContractCommand : public ::testing::Test {
protected:
    void paint(const std::function<PaintedFrame(std::uint64_t)>& painted, std::uint64_t frames = 6) {
        test_support::write_painted_run(place_, "run", frames, painted);
    }
    /// A run of which the third and the fourth frame are painted worse.
    template <class Worsen>
    void paint_worse(Worsen worsen) {
        paint([&](std::uint64_t n) {
            PaintedFrame painted;
            if (n == 2 || n == 3) worsen(painted);
            return painted;
        });
    }
    CommandRun contract(bool json = false, const std::string& conditions = kConditions, const std::string& output = "",
                        std::uint32_t threads = 2) {
        const ContractOptions options{place_.file("run"), place_.write("c.toml", conditions),
                                      output.empty() ? "" : place_.file(output), threads};
        return test_support::run_command([&](Console& console) { return run_contract(options, console); }, json);
    }
    /// Names of the failures.
    std::vector<std::string> failures() {
        const CommandRun run = contract(true);
        std::vector<std::string> names;
        const auto json = run.json();
        for (const auto& failure : json["failures"]) names.push_back(failure["condition"]);
        EXPECT_EQ(run.code, names.empty() ? 0 : 1);
        EXPECT_EQ(json["holds"], names.empty());
        return names;
    }
    test_support::TemporaryFolder place_;
};
using Names = std::vector<std::string>;

TEST_F(ContractCommand, HoldsOverARunThatKeepsIt) {
    paint([](std::uint64_t) { return PaintedFrame(); });
    EXPECT_EQ(failures(), Names());
    EXPECT_THAT(contract().results, HasSubstr("holds"));
    EXPECT_FALSE(std::filesystem::exists(place_.file("out"))) << "nothing is written unasked";
}

TEST_F(ContractCommand, ABadDesignBreaksTheConditionThatItShould) {
    paint_worse([](PaintedFrame& painted) { painted.label = 140; });
    EXPECT_EQ(failures(), Names{"legible"}) << "grey on grey";
    paint_worse([](PaintedFrame& painted) { painted.obstacle_state = display::ObstacleState::left_out; });
    EXPECT_EQ(failures(), Names{"noticed"});
    paint_worse([](PaintedFrame& painted) { painted.data = 122; });
    EXPECT_EQ(failures(), Names{"data first"}) << "what comes first looks like the ground";
    paint_worse([](PaintedFrame& painted) { painted.stripe_px = 4; });
    EXPECT_THAT(failures(), ::testing::Contains("calm"));
}

TEST_F(ContractCommand, AFailureIsToldWithItsTimesAndItsPlace) {
    paint([](std::uint64_t n) {
        PaintedFrame painted;
        if (n == 2) painted.label = 150;
        if (n == 3) painted.label = 130;
        return painted;
    });
    const auto failure = contract(true).json()["failures"][0];
    EXPECT_EQ(failure["condition"], "legible");
    EXPECT_EQ(failure["time_s"], 2.0);
    EXPECT_LT(failure["worst"]["value"].get<double>(), failure["value"].get<double>());
    EXPECT_EQ(failure["worst"]["time_s"], 3.0);
    EXPECT_EQ(failure["region"]["name"], "lower right");
    EXPECT_EQ(failure["region"]["box"], (std::vector<int>{180, 130, 200, 136}));
    EXPECT_EQ(failure["broken_s"], 2.0);
}

TEST_F(ContractCommand, AFolderGetsTheResultAndThePicturesOfTheWorstMoment) {
    paint_worse([](PaintedFrame& painted) { painted.label = 140; });
    EXPECT_EQ(contract(true, kConditions, "out").code, 1);
    const auto json = nlohmann::json::parse(place_.read("out/contract.json"));
    EXPECT_EQ(json["holds"], false);
    EXPECT_EQ(json["failures"][0]["sheet"], "4-legible.sheet.png");
    EXPECT_TRUE(std::filesystem::exists(place_.file("out/4-legible.sheet.png")));
    EXPECT_TRUE(std::filesystem::exists(place_.file("out/4-legible.heat.png")));
    EXPECT_FALSE(std::filesystem::exists(place_.file("out/1-calm.sheet.png"))) << "it holds";
}

TEST_F(ContractCommand, TheResultDoesNotDependOnThreads) {
    paint_worse([](PaintedFrame& painted) { painted.label = 140; });
    EXPECT_EQ(contract(true, kConditions, "", 1).results, contract(true, kConditions, "", 3).results);
}

TEST_F(ContractCommand, WhatCouldNotBeMeasuredIsNotShownToHold) {
    paint([](std::uint64_t) {
        PaintedFrame painted;
        painted.has_layers = false;
        return painted;
    });
    EXPECT_EQ(failures(), (Names{"data first", "noticed", "legible"}));
    EXPECT_THAT(contract().results, HasSubstr("6 frames could not be measured: no layer mask lies beside the picture"));
    const std::string of_approach = "[[condition]]\nname = \"a\"\nmeasure = \"clutter\"\nmost = 1\nphases = [\"approach\"]\n";
    EXPECT_EQ(contract(false, of_approach).code, 1);
    EXPECT_THAT(contract(false, of_approach).results, HasSubstr("no frame in approach has what it measures"));
    EXPECT_EQ(contract(false, of_approach + "optional = true\n").code, 0);
}

TEST_F(ContractCommand, EdgesAreThoseOfTheContract) {
    paint_worse([](PaintedFrame& painted) { painted.stripe_px = 4; });
    const std::string calm = "[[condition]]\nname = \"calm\"\nmeasure = \"clutter\"\nmost = 0.05\n";
    EXPECT_EQ(contract(false, calm).code, 1);
    EXPECT_EQ(contract(false, "[canny]\nsigma = 1\nlow = 20000\nhigh = 30000\n" + calm).code, 0);
}

TEST_F(ContractCommand, SaysWhatIsWrong) {
    paint([](std::uint64_t) { return PaintedFrame(); }, 1);
    const auto refused = [&](const ContractOptions& options, const std::string& words) {
        test_support::expect_user_error(
            [&] { (void)test_support::run_command([&](Console& console) { return run_contract(options, console); }); }, words);
    };
    const std::string run = place_.file("run"), sound = place_.write("c.toml", kConditions);
    refused({run, place_.file("none.toml"), "", 1}, "none.toml");
    refused({run, "no_such_contract", "", 1}, "default");
    refused({place_.file("no_run"), sound, "", 1}, "no_run");
    refused({run, sound, run, 1}, "holds a run");
    refused({run, place_.write("bad.toml", "[[condition]]\nmeasure = \"clutter\"\n"), place_.file("out"), 1}, "bad.toml:");
    EXPECT_FALSE(std::filesystem::exists(place_.file("out"))) << "nothing is left";
}

}  // namespace
}  // namespace tedavis::host_sim::test_contract_command
