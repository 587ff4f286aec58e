#include "target/run_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/target/captured_output.hpp"
#include "tests/target/fake_board.hpp"

namespace tedavis::target::test_run_report {
namespace {

using ::testing::HasSubstr;

struct RunReportTest : testing::Test {
    void SetUp() override {
        FakeClock::reset();
        BoardPorts ports;
        ports.can = &port;
        ports.clocks = FakeClock::clocks();
        ports.log = lines.log();
        application = std::make_unique<DisplayApplication>(settings, std::move(ports));
        ASSERT_EQ(application->start().message.view(), "");
    }
    BoardSettings settings = board_settings();
    PairPort port;
    LogLines lines;
    std::unique_ptr<DisplayApplication> application;
};

TEST_F(RunReportTest, TheStartNamesTheWholeBudget) {
    const std::string text = printed([&](std::FILE* out) { print_start(*application, false, out); });
    const auto json = nlohmann::json::parse(printed([&](std::FILE* out) { print_start(*application, true, out); }));
    EXPECT_EQ(json.at("device"), "es2-small");
    EXPECT_EQ(json.at("size"), "640x480");
    EXPECT_EQ(json.at("frame_rate_hz"), 30);
    EXPECT_EQ(json.at("can"), "can9");
    EXPECT_EQ(json.at("switches"), "");
    EXPECT_THAT(json.at("gl").get<std::string>(), HasSubstr("egl: "));
    const auto lines_of_device = settings.device.budget.lines();
    ASSERT_EQ(json.at("budget").size(), lines_of_device.size());
    std::uint64_t cpu = 0;
    for (std::size_t n = 0; n < lines_of_device.size(); ++n) {
        const auto& line = json.at("budget").at(n);
        EXPECT_EQ(line.at("name"), lines_of_device[n].name.view());
        EXPECT_EQ(line.at("bytes"), lines_of_device[n].bytes);
        EXPECT_THAT(text, HasSubstr(lines_of_device[n].reason.c_str()));
        cpu += line.at("kind") == "cpu" ? line.at("bytes").get<std::uint64_t>() : 0;
    }
    EXPECT_EQ(cpu, settings.device.budget.total(base::MemoryKind::cpu));
    EXPECT_THAT(text, HasSubstr("fake board"));
}

TEST_F(RunReportTest, TheStartNamesItsSelfTestWhereThereWasOne) {
    const auto start = [&](bool json, const StartTest& test) {
        return printed([&](std::FILE* out) { print_start(*application, json, out, test); });
    };
    const StartTest test{19, base::Duration::milliseconds(3)};
    EXPECT_THAT(start(false, test), HasSubstr("self-test of the start: passed, 19 checks in 3.0 ms\n"));
    EXPECT_EQ(nlohmann::json::parse(start(true, test)).at("self_test"),
              nlohmann::json::parse(R"({"holds": true, "checks": 19, "ms": 3})"));
    EXPECT_FALSE(nlohmann::json::parse(start(true, {})).contains("self_test"));
}

TEST(RunReport, TheEndSaysWhenTheFirstCorrectPictureCame) {
    RunReport report;
    const auto end = [&](bool json) { return printed([&](std::FILE* out) { print_end(report, json, out); }); };
    EXPECT_TRUE(nlohmann::json::parse(end(true)).at("first_picture_s").is_null()) << "none came";
    EXPECT_EQ(end(false).find("first correct picture"), std::string::npos);
    report.has_first_picture = true;
    report.first_picture = base::Duration::milliseconds(1250);
    EXPECT_EQ(nlohmann::json::parse(end(true)).at("first_picture_s"), 1.25);
    EXPECT_THAT(end(false), HasSubstr("first correct picture 1.25 s after the start of the process\n"));
}

TEST(RunReport, TheEndSaysWhenAllDesignsHadBeenDrawn) {
    RunReport report;
    const auto end = [&](bool json) { return printed([&](std::FILE* out) { print_end(report, json, out); }); };
    EXPECT_EQ(end(false).find("all designs"), std::string::npos);
    report.is_warm = true;
    report.warm = base::Duration::milliseconds(3500);
    EXPECT_EQ(nlohmann::json::parse(end(true)).at("warm_s"), 3.5);
    EXPECT_THAT(end(false), HasSubstr("all designs drawn once 3.50 s after the start of the process\n"));
}

TEST(RunReport, TheEndHoldsTheCounts) {
    RunReport report;
    report.frames = 7;
    report.missed = 2;
    report.bus.frames = 5;
    report.bus.alien = 3;
    report.end = RunEnd::surface_lost;
    const auto json = nlohmann::json::parse(printed([&](std::FILE* out) { print_end(report, true, out); }));
    EXPECT_EQ(
        json,
        (nlohmann::json{
            {"end", "surface_lost"},
            {"frames", 7},
            {"missed", 2},
            {"gl_calls_outside_device", 0},
            {"first_picture_s", nullptr},
            {"warm_s", nullptr},
            {"can", {{"frames", 5}, {"decoded", 0}, {"alien", 3}, {"errors", 0}, {"dropped", 0}}},
            {"can_to_screen",
             {{"pictures", 0}, {"median_ms", 0}, {"p99_ms", 0}, {"longest_ms", 0}, {"p99_pictures", 0}, {"most_pictures", 0}}}}));
    EXPECT_THAT(printed([&](std::FILE* out) { print_end(report, false, out); }),
                HasSubstr("surface_lost after 7 frames, 2 turns missed; CAN 5 frames, 0 decoded, 3 foreign"));
}

TEST(RunReport, TheEndSaysHowLongTheBusTookToTheScreen) {
    RunReport report;
    EXPECT_EQ(printed([&](std::FILE* out) { print_end(report, false, out); }).find("from a CAN frame"), std::string::npos);
    report.latency = {
        90, base::Duration::milliseconds(30), base::Duration::milliseconds(61), base::Duration::milliseconds(70), 1.75, 2.125};
    EXPECT_THAT(
        printed([&](std::FILE* out) { print_end(report, false, out); }),
        HasSubstr("from a CAN frame to the screen: median 30 ms, 99 of 100 pictures within 61 ms and 1.75 frame times, longest "
                  "70.0 ms and 2.12 frame times\n"));
    EXPECT_EQ(nlohmann::json::parse(printed([&](std::FILE* out) { print_end(report, true, out); })).at("can_to_screen"),
              (nlohmann::json{{"pictures", 90},
                              {"median_ms", 30},
                              {"p99_ms", 61},
                              {"longest_ms", 70},
                              {"p99_pictures", 1.75},
                              {"most_pictures", 2.125}}));
}

TEST(RunReport, TheEndOfAScreenHasItsCounts) {
    RunReport report;
    report.screen.driver = "virtio_gpu";
    report.screen.connector = "Virtual-1";
    report.screen.mode = platform::mode_text(1024, 768, 60000);
    report.screen.flips = 9;
    report.screen.missed_flips = 8;
    report.screen.late_flips = 7;
    report.screen.hidden_frames = 6;
    report.screen.unplugged = 5;
    report.screen.taken_away = 4;
    report.screen.paced_by = platform::FlipPacing::vblank;
    const auto json = nlohmann::json::parse(printed([&](std::FILE* out) { print_end(report, true, out); }));
    EXPECT_EQ(json.at("screen"), (nlohmann::json{{"driver", "virtio_gpu"},
                                                 {"connector", "Virtual-1"},
                                                 {"mode", "1024x768@60"},
                                                 {"flips", 9},
                                                 {"missed_flips", 8},
                                                 {"late_flips", 7},
                                                 {"hidden_frames", 6},
                                                 {"unplugged", 5},
                                                 {"taken_away", 4},
                                                 {"paced_by", "vblank"},
                                                 {"atomic", false}}));
    EXPECT_THAT(printed([&](std::FILE* out) { print_end(report, false, out); }),
                HasSubstr("\nscreen Virtual-1 of virtio_gpu, 1024x768@60: 9 flips, 8 missed, 7 late, paced by vblank; 6 frames "
                          "hidden, unplugged 5 times, taken away 4 times; legacy mode setting\n"));
}

TEST(RunReport, TheVersionIsTheProjects) {
    const auto json = nlohmann::json::parse(printed([](std::FILE* out) { print_version(true, out); }));
    EXPECT_EQ(printed([](std::FILE* out) { print_version(false, out); }),
              "tedavis-display " + json.at("version").get<std::string>() + "\n");
}

}  // namespace
}  // namespace tedavis::target::test_run_report
