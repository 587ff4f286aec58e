#include "host_sim/flight_test/board_record.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/host_sim/flight_test/fake_board_port.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_board_record {
namespace {

std::string sample() {
    test_support::FakeBoardPort board(bus::BusSettings(), nullptr, 10);
    return *board.next_record(board.now());
}

TEST(BoardRecord, IsReadAsAnObservedFrame) {
    auto json = nlohmann::json::parse(sample());
    json["frame"] = 7;
    json["phase"] = "approach";
    json["sub_phase"] = "final";
    json["phase_source"] = "switch";
    json["flags"] = {"terrain.ahead"};
    json["values"] = {{"pitch", -0.25}};
    json["signals"]["pitch"] = "stale";
    json["alerts"]["terrain"]["level"] = "warning";
    const BoardRecord record = read_board_record(json.dump(), "/s");
    EXPECT_EQ(record.frame, 7u);
    EXPECT_NEAR(record.monotonic_s, 1000, 1e-6);
    EXPECT_FALSE(record.can_to_screen_s);
    EXPECT_TRUE(record.is_on_screen);
    EXPECT_EQ(record.seen.record.phase.phase, flight::phase_from_name("approach.final").phase);
    EXPECT_EQ(record.seen.record.phase.source, flight::PhaseSource::switches);
    EXPECT_EQ(record.seen.record.flags[0].view(), "terrain.ahead");
    EXPECT_EQ(record.seen.values[flight::Signal::pitch], -0.25);
    EXPECT_TRUE(std::isnan(record.seen.values[flight::Signal::roll]));
    EXPECT_EQ(record.seen.record.signals[static_cast<std::size_t>(flight::Signal::pitch)], base::SignalState::stale);
    EXPECT_EQ(record.seen.record.alerts.terrain, policy::TerrainAhead::warning);
    EXPECT_EQ(record.seen.record.design.view(), "default");
}

TEST(BoardRecord, FaultsAreNamed) {
    const auto expect_fault = [](const std::string& packet, const std::string& words) {
        test_support::expect_user_error([&] { static_cast<void>(read_board_record(packet, "/s")); }, words);
    };
    expect_fault("", "/s: what comes is no record of a frame");
    expect_fault("[1]", "no record of a frame");
    auto json = nlohmann::json::parse(sample());
    json["phase"] = "hovering";
    expect_fault(json.dump(), "a name that is not known here: 'hovering' is not known");
    json = nlohmann::json::parse(sample());
    json["signals"].erase("pitch");
    expect_fault(json.dump(), "its record lacks 'pitch'");
    json = nlohmann::json::parse(sample());
    json["on_screen"] = false;
    EXPECT_FALSE(read_board_record(json.dump(), "/s").is_on_screen);
    json.erase("on_screen");
    expect_fault(json.dump(), "its record lacks 'on_screen'");
    json = nlohmann::json::parse(sample());
    json["frame"] = "one";
    expect_fault(json.dump(), "a value of another kind");
}

TEST(BoardRecord, TextsElementsAndObstaclesAreNotInIt) {
    EXPECT_FALSE(is_in_board_record({"text", "", {}}));
    EXPECT_FALSE(is_in_board_record({"contract", "", {}}));
    EXPECT_FALSE(is_in_board_record({"obstacle_alert", "", {}}));
    EXPECT_FALSE(is_in_board_record({"elements", "", {}}));
    for (const char* key : {"phase", "phase_source", "design", "flags", "no_flags", "signals", "values", "effects", "alert",
                            "latency_frames_at_most"})
        EXPECT_TRUE(is_in_board_record({key, "", {}})) << key;
}

}  // namespace
}  // namespace tedavis::host_sim::test_board_record
