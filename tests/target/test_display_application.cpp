#include "target/display_application.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "bus/canaerospace/message_encoder.hpp"
#include "host_sim/heap_trap/heap_trap.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/options/replay_config.hpp"
#include "host_sim/pack/write_pack.hpp"
#include "render_core/display/calibration_subject.hpp"
#include "render_core/gl/readback.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/scene/scene_drafts.hpp"
#include "tests/target/board_costs.hpp"
#include "tests/target/fake_board.hpp"
#include "tests/target/record_reader.hpp"
#include "tests/target/ticking_clock.hpp"

namespace tedavis::target::test_display_application {
namespace {

using ::testing::HasSubstr;

bool has_flag(const display::FrameRecord& record, std::string_view name) {
    return std::any_of(record.flags.begin(), record.flags.end(), [name](const auto& flag) { return flag.view() == name; });
}

/// What the sleep between frames does; plain functions cannot carry it.
PairPort* the_port = nullptr;
EmbeddedFlight* the_flight = nullptr;
int sleeps = 0;

struct DisplayApplicationTest : testing::Test {
    void SetUp() override {
        FakeClock::reset();
        the_port = &port;
        the_flight = nullptr;
        sleeps = 0;
    }
    DisplayApplication& make() {
        BoardPorts ports;
        ports.can = &port;
        ports.clocks = FakeClock::clocks();
        ports.log = lines.log();
        ports.process_age = [] { return base::Duration{FakeClock::monotonic().ns - 90'000'000'000}; };  // 10 s at the start
        application = std::make_unique<DisplayApplication>(settings, std::move(ports));
        return *application;
    }
    DisplayApplication& start() {
        const base::Error error = make().start();
        EXPECT_EQ(error.message.view(), "");
        return *application;
    }
    std::string refusal() { return std::string(make().start().message.view()); }
    std::vector<std::uint8_t> pixels() {
        std::vector<std::uint8_t> rgba(std::size_t{4} * settings.width_px * settings.height_px);
        EXPECT_TRUE(gl::read_pixels(application->display().gl(), settings.width_px, settings.height_px, rgba));
        return rgba;
    }
    std::size_t red_pixels() {
        const std::vector<std::uint8_t> rgba = pixels();
        std::size_t count = 0;
        for (std::size_t n = 0; n < rgba.size(); n += 4) count += rgba[n] > 200 && rgba[n + 1] < 80 && rgba[n + 2] < 80 ? 1 : 0;
        return count;
    }
    BoardSettings settings = board_settings();
    PairPort port;
    LogLines lines;
    StopSignal stop;
    std::unique_ptr<DisplayApplication> application;
};

TEST_F(DisplayApplicationTest, AMissingInterfaceShowsFlagsAndDoesNotEndTheProgram) {
    port.missing = true;
    const RunReport report = start().run(60, stop);
    EXPECT_EQ(report.end, RunEnd::stopped);
    EXPECT_EQ(report.frames, 60u);
    EXPECT_EQ(report.gl_calls_outside_device, 0u);
    EXPECT_FALSE(report.is_warm) << "there is nothing to draw the designs behind";
    EXPECT_FALSE(report.has_first_picture) << "a picture without a position is not the one that is waited for";
    const display::FrameRecord& record = application->display().record();
    EXPECT_EQ(record.terrain.triangles, 0u) << "no position, no terrain";
    EXPECT_GE(record.flags.size(), 5u);
    EXPECT_GT(red_pixels(), 500u) << "crosses where the information would be";
    EXPECT_EQ(lines.str(), "tedavis-display: CAN interface 'can9': there is no such interface\n");
}

TEST_F(DisplayApplicationTest, AFlightOnTheBusShowsTerrain) {
    EmbeddedFlight recorded;
    the_flight = &recorded;
    FakeClock::on_sleep = [] { the_flight->send_due(*the_port); };
    const RunReport report = start().run(90, stop);
    ASSERT_TRUE(report.has_first_picture);
    EXPECT_GT(report.first_picture, base::Duration::seconds(10)) << "not before anything came from the bus";
    EXPECT_LT(report.first_picture, base::Duration::seconds(12));
    const display::FrameRecord& record = application->display().record();
    EXPECT_GT(report.bus.decoded, recorded.size() * 9 / 10);
    EXPECT_EQ(record.own_ship.state, base::SignalState::valid);
    EXPECT_EQ(record.phase.source, flight::PhaseSource::can);
    EXPECT_GT(record.terrain.triangles, 1000u);
    EXPECT_LT(red_pixels(), 50u);
    EXPECT_EQ(report.gl_calls_outside_device, 0u);
}

TEST_F(DisplayApplicationTest, TheTimeFromTheBusToThePictureIsKnown) {
    EmbeddedFlight recorded;
    the_flight = &recorded;
    FakeClock::on_sleep = [] { the_flight->send_due(*the_port); };
    const LatencyReport all = start().run(90, stop).latency;
    EXPECT_GT(all.pictures, 60u);
    EXPECT_EQ(all.longest.ns, 0) << "frames come at the instant at which they are read";
}

TEST_F(DisplayApplicationTest, TheTimeFromTheBusToThePictureHoldsWhatDrawingTakes) {
    TickingClock::reset();
    BoardPorts ports;
    ports.can = &port;
    ports.clocks = TickingClock::clocks();
    ports.clocks.sleep_until = [](base::Time) {};
    ports.log = lines.log();
    application = std::make_unique<DisplayApplication>(settings, std::move(ports));
    ASSERT_EQ(application->start().message.view(), "");
    (void)application->run(1, stop);  // opens the bus
    bus::CanFrame frame;
    frame.id = 0x7F0;
    frame.length = 8;
    for (int n = 0; n < 4; ++n) {
        ASSERT_TRUE(port.deliver(frame));
        (void)application->run(1, stop);
    }
    const LatencyReport latency = application->run(1, stop).latency;
    EXPECT_EQ(latency.pictures, 4u) << "one of the five had no new frame";
    EXPECT_GE(latency.longest.ns, TickingClock::kTick_ns);
    EXPECT_GT(latency.p99_pictures, 0);
    EXPECT_LT(latency.most_pictures, 2) << "each frame is in the first picture after it";
}

TEST_F(DisplayApplicationTest, ASceneIsTakenOverWhenItIsThere) {
    const test_support::TemporaryFolder folder;
    host_sim::SceneDraft draft = test_support::small_scene();
    draft.revision = 3;
    const auto bytes = host_sim::sdb_bytes(draft);
    settings.scene = Path(folder.write("area.sdb", std::string(bytes.begin(), bytes.end())));
    start();
    for (int n = 0; n < 500 && application->display().record().scene_revision == 0; ++n) {
        (void)application->run(1, stop);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_EQ(application->display().record().scene_revision, 3u);
    EXPECT_THAT(lines.str(), HasSubstr("area.sdb: has revision 3\n"));
}

/// The next start takes the new one: tests/target/test_board_program.cpp.
TEST_F(DisplayApplicationTest, APackReplacedWhileItRunsIsTakenAtTheNextStartOnly) {
    const test_support::TemporaryFolder folder;
    const auto write_scene = [&](std::uint64_t revision) {
        host_sim::SceneDraft draft = test_support::small_scene();
        draft.revision = revision;
        const auto bytes = host_sim::sdb_bytes(draft);
        folder.write("area.sdb", std::string(bytes.begin(), bytes.end()));
    };
    const auto pack = [&] {
        const std::string config =
            folder.write("board.toml", host_sim::read_file(test_support::source_dir() + "/tests/target/boards/fake_board.toml"));
        std::string text = folder.read("board.toml");
        for (std::size_t at = 0; (at = text.find("../../../", at)) != std::string::npos;)
            text.replace(at, 9, test_support::source_dir() + "/");
        folder.write("board.toml", text + "[scene]\ndatabase = 'area.sdb'\n");
        host_sim::write_pack(host_sim::pack_contents(host_sim::load_replay_config(config), config),
                             {folder.file("pack"), true, "", "", ""}, [](std::uint64_t, std::uint64_t) {});
    };
    write_scene(3);
    pack();
    settings = load_board_settings(folder.file("pack").c_str()).value();
    EmbeddedFlight recorded;
    the_flight = &recorded;
    FakeClock::on_sleep = [] { the_flight->send_due(*the_port); };
    (void)start().run(20, stop);
    EXPECT_EQ(application->display().record().scene_revision, 3u) << "of the first frame on";
    EXPECT_FALSE(platform::confirm_pack(settings.pack));
    write_scene(4);
    pack();
    EXPECT_TRUE(platform::confirm_pack(settings.pack)) << "control: it was replaced";
    for (int n = 0; n < 30; ++n) {
        (void)application->run(3, stop);
        std::this_thread::sleep_for(std::chrono::milliseconds(50));  // longer than a watch of the file needs
    }
    EXPECT_EQ(application->display().record().scene_revision, 3u);
    settings = load_board_settings(folder.file("pack").c_str()).value();
    (void)start().run(1, stop);
    EXPECT_EQ(application->display().record().scene_revision, 4u);
}

/// The board's clock says 2023-11-14 at the start; nothing on the bus says otherwise.
TEST_F(DisplayApplicationTest, APackOutOfDateIsSaidInTheRecordsOnTheBoardsClockUntilTheBusStatesUtc) {
    const auto is_said = [&] {
        (void)application->run(1, stop);
        return has_flag(application->display().record(), "database.out_of_date");
    };
    settings.pack.valid_until = platform::DayText("2023-11-14");
    start();
    EXPECT_FALSE(is_said()) << "control: its last day";
    settings.pack.valid_until = platform::DayText("2023-11-13");
    start();
    EXPECT_TRUE(is_said());
    EXPECT_FALSE(application->display().record().flight_time.is_date);
    bus::MessageEncoder encoder(settings.bus, 1);
    std::array<bus::CanFrame, 2> sent{};
    ASSERT_EQ(encoder.encode_utc(12, 0, 0, {0}, {&sent[0], 1}) + encoder.encode_date(13, 11, 2023, {0}, {&sent[1], 1}), 2u);
    for (const bus::CanFrame& frame : sent) ASSERT_TRUE(port.deliver(frame));
    EXPECT_FALSE(is_said()) << "the bus states the day before";
    EXPECT_TRUE(application->display().record().flight_time.is_date);
    (void)application->run(350, stop);  // more than ten seconds
    EXPECT_TRUE(has_flag(application->display().record(), "utc.lost"));
    EXPECT_FALSE(is_said()) << "what the bus said goes before the board's clock";
}

TEST_F(DisplayApplicationTest, TheDevicesDeadlineIsHeldWithCostsOfThisBoard) {
    const test_support::TemporaryFolder folder;
    settings.device.deadline_ms = 5;
    (void)start().run(3, stop);
    EXPECT_EQ(application->display().record().governor.why.view(), "the cost is not known: calibrate this device");
    const std::string renderer(display::calibration_subject(application->display()).renderer.view());
    application.reset();
    settings.costs = Path(folder.write("costs.toml", costs_of(settings, renderer)));
    (void)start().run(3, stop);
    EXPECT_GT(application->display().record().governor.predicted_ms, 0);
    EXPECT_EQ(application->display().record().governor.deadline_ms, 5);
    application.reset();
    settings.costs = Path(folder.write("costs.toml", costs_of(settings, "another")));
    EXPECT_THAT(refusal(), HasSubstr("'another', not for"));
    settings.costs = Path(folder.file("none.toml"));
    EXPECT_THAT(refusal(), HasSubstr("none.toml"));
}

TEST_F(DisplayApplicationTest, EveryFrameHandsOutItsRecord) {
    const test_support::TemporaryFolder folder;
    settings.records = Path(folder.file("records"));
    EmbeddedFlight recorded;
    the_flight = &recorded;
    FakeClock::on_sleep = [] { the_flight->send_due(*the_port); };
    start();
    const RecordReader reader(folder.file("records"));
    ASSERT_TRUE(reader.is_connected());
    (void)application->run(10, stop);
    const std::vector<std::string> records = reader.take_all();
    ASSERT_EQ(records.size(), 10u);
    const nlohmann::json first = nlohmann::json::parse(records.front()), last = nlohmann::json::parse(records.back());
    EXPECT_EQ(first["time_s"], 0.0);
    EXPECT_TRUE(first["can_to_screen_ms"].is_null()) << "nothing had come from the bus";
    EXPECT_EQ(last["frame"], 9);
    EXPECT_EQ(last["phase_source"], "can");
    EXPECT_EQ(last["signals"]["latitude"], "valid");
    EXPECT_EQ(last["can_to_screen_ms"], 0.0) << "frames come at the instant at which they are read";
    EXPECT_EQ(last["on_screen"], true);
}

/// Without a scene cruise and re-planning show the first design: there are three to draw, one every eighth picture, and where the
/// device can keep a picture how they fade.
TEST_F(DisplayApplicationTest, TheDesignsOfOtherPhasesAreDrawnBehindThePictures) {
    const test_support::TemporaryFolder folder;
    settings.records = Path(folder.file("records"));
    EmbeddedFlight recorded;
    the_flight = &recorded;
    FakeClock::on_sleep = [] { the_flight->send_due(*the_port); };
    start();
    std::vector<bool> warm;
    const RecordReader reader(folder.file("records"));
    RunReport report;
    for (int n = 0; n < 12; ++n) {
        report = application->run(10, stop);
        for (const std::string& record : reader.take_all()) warm.push_back(nlohmann::json::parse(record)["warm"]);
    }
    ASSERT_TRUE(report.is_warm);
    EXPECT_GT(report.warm, report.first_picture);
    ASSERT_EQ(warm.size(), 120u);
    const auto since = std::find(warm.begin(), warm.end(), true);
    EXPECT_GE(since - warm.begin(), 17) << "two times eight pictures lie between three designs";
    EXPECT_EQ(std::count(since, warm.end(), false), 0);
    EXPECT_THAT(lines.str(), HasSubstr("all designs have been drawn once; from now on no change of phase waits for"));
    EXPECT_EQ(application->display().record().phase.source, flight::PhaseSource::can) << "the record is that of a picture shown";
}

TEST_F(DisplayApplicationTest, WithoutAPlaceForRecordsItRuns) {
    settings.records = "/no/such/folder/records";
    EXPECT_EQ(start().run(3, stop).frames, 3u);
    EXPECT_THAT(lines.str(), HasSubstr("name a folder that exists and that the program may write to; this run hands out no"));
}

TEST_F(DisplayApplicationTest, NothingAllocatesAfterStart) {
    const test_support::TemporaryFolder folder;
    settings.records = Path(folder.file("records"));
    EmbeddedFlight recorded;
    the_flight = &recorded;
    FakeClock::on_sleep = [] {
        if (++sleeps == 60) the_port->hang_up();  // and the socket is opened again
        if (sleeps < 60) the_flight->send_due(*the_port);
    };
    start();
    const RecordReader reader(folder.file("records"));
    host_sim::HeapTrap trap;
    const RunReport report = application->run(130, stop);
    trap.close();
    EXPECT_EQ(report.frames, 130u);
    EXPECT_EQ(trap.counts().ours, 0u) << trap.first_of_ours();
    EXPECT_EQ(application->flight().bus_statistics().reopened, 1u);
    EXPECT_THAT(lines.str(), HasSubstr("open again"));
}

TEST_F(DisplayApplicationTest, TheTrapWouldHaveSeenAnAllocationInTheLoop) {
    static std::unique_ptr<int> seeded;
    FakeClock::on_sleep = [] { seeded = std::make_unique<int>(7); };
    start();
    host_sim::HeapTrap trap;
    (void)application->run(3, stop);
    trap.close();
    EXPECT_EQ(trap.counts().ours, 3u);
    seeded.reset();
}

TEST_F(DisplayApplicationTest, ASignalStopsTheRun) {
    FakeClock::on_sleep = [] {
        if (++sleeps == 4) raise(SIGTERM);
    };
    const RunReport report = start().run(0, stop);
    EXPECT_EQ(report.end, RunEnd::stopped);
    EXPECT_EQ(report.frames, 4u);
}

TEST_F(DisplayApplicationTest, LateFramesAreCounted) {
    FakeClock::on_sleep = [] { FakeClock::now_ns += ++sleeps == 2 ? 200'000'000 : 0; };
    const RunReport report = start().run(5, stop);
    EXPECT_EQ(report.frames, 5u);
    EXPECT_EQ(report.missed, 6u) << "200 ms hold six turns of 30 frames/s";
}

TEST_F(DisplayApplicationTest, WhatCannotStartSaysWhy) {
    settings.surface = base::FixedString<15>("glut");
    EXPECT_EQ(refusal(), "[surface]: the surface 'glut' is not known; use egl or osmesa");
    settings.surface = base::FixedString<15>("kms");
    settings.screen.path = "/dev/null";
    EXPECT_THAT(refusal(), HasSubstr("[surface]: "));
    settings = board_settings();
    settings.device.budget.find(effects::kLodScratch)->bytes = 8;
    EXPECT_THAT(refusal(), HasSubstr("device 'es2-small': the budget line 'lod_scratch' has 8 of 8 bytes left and "));
}

TEST_F(DisplayApplicationTest, WithoutTerrainThatThereShouldBeItFliesAndSaysSo) {
    const test_support::TemporaryFolder folder;
    EmbeddedFlight recorded;
    the_flight = &recorded;
    FakeClock::on_sleep = [] { the_flight->send_due(*the_port); };
    settings.terrain = Path(folder.file("absent.tdb"));
    const RunReport report = start().run(90, stop);
    EXPECT_EQ(report.frames, 90u);
    EXPECT_EQ(report.end, RunEnd::stopped);
    const display::FrameRecord& record = application->display().record();
    EXPECT_EQ(record.own_ship.state, base::SignalState::valid) << "symbology goes on";
    EXPECT_TRUE(has_flag(record, "terrain.failed"));
    EXPECT_EQ(lines.str().substr(0, lines.str().find('\n') + 1),
              "tedavis-display: " + folder.file("absent.tdb") +
                  ": cannot be read (No such file or directory); check the path; the display shows TERRAIN FAIL "
                  "until it is started again with sound terrain\n");
    EXPECT_GT(red_pixels(), 50u) << "the notice";
}

TEST_F(DisplayApplicationTest, ASceneThatCannotBeReadIsSaidAndItsDataAreMissing) {
    const test_support::TemporaryFolder folder;
    settings.scene = Path(folder.write("area.sdb", "no scene at all"));
    settings.design.data.ground.is_shown = true;
    settings.design.data.ground.layer = "radar";
    settings.design.data.ground.attribute = "reflectivity";
    start();
    for (int n = 0; n < 500 && lines.str().find("area.sdb") == std::string::npos; ++n) {
        (void)application->run(1, stop);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_THAT(lines.str(), HasSubstr("area.sdb: is not a scene database"));
    EXPECT_THAT(lines.str(), HasSubstr("; there are no data until a sound scene is in its place\n"));
    EXPECT_TRUE(has_flag(application->display().record(), "ground_data.missing"));
}

TEST_F(DisplayApplicationTest, WithoutTerrainItRuns) {
    settings.terrain = Path();
    const RunReport report = start().run(2, stop);
    EXPECT_EQ(report.frames, 2u);
    EXPECT_EQ(application->display().planner().terrain_database(), nullptr);
}

}  // namespace
}  // namespace tedavis::target::test_display_application
