#include "host_sim/window/live_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <iterator>
#include <sstream>

#include "host_sim/commands/replay.hpp"
#include "host_sim/options/replay_config.hpp"
#include "host_sim/png_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "render_core/gl/readback.hpp"
#include "tests/host_sim/window/scripted_window.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/flights/frame_lines.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_live_run {
namespace {

using base::Duration;
using platform::Key;
using test_support::hashes_by_time;
using test_support::ScriptedWindow;
using ::testing::HasSubstr;

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

SurfaceMaker scripted(ScriptedWindow*& window) {
    return [&window](const platform::SurfaceSettings& settings) -> base::Result<std::unique_ptr<base::Surface>, base::Error> {
        auto surface = platform::make_surface("egl", settings);
        if (!surface.ok()) return base::fail(surface.error());
        auto made = std::make_unique<ScriptedWindow>(std::move(surface.value()));
        window = made.get();
        return std::unique_ptr<base::Surface>(std::move(made));
    };
}

/// A session at a window without a screen.
struct Desk {
    std::ostringstream results, notes;
    Console console{results, notes, false, false};
    ReplayOptions options;
    ScriptedWindow* window = nullptr;
    std::unique_ptr<DisplaySession> session;
    std::unique_ptr<FlightPlayer> player;
    std::unique_ptr<LiveRun> run;

    explicit Desk(const ReplayOptions& asked) : options(asked) {
        options.window = true;
        session = std::make_unique<DisplaySession>(options.picture, false, scripted(window));
        player = std::make_unique<FlightPlayer>(
            PlayerFiles{options.log, options.picture.bus, options.switches, options.switch_config}, session->display());
        run = std::make_unique<LiveRun>(options, std::nullopt, *session, *player, *window, console);
    }
    /// Half a second goes by, a frame of the options' step.
    bool turn() { return run->turn(Duration::milliseconds(500)); }
    void turns(int count) {
        for (int n = 0; n < count; ++n) turn();
    }
    /// Ends the session; another display may then be opened.
    void finish() {
        EXPECT_EQ(run->finish(false), 0);
        run.reset();
        player.reset();
        session.reset();
    }
    [[nodiscard]] std::string switches() const { return options.output + "/window.switches"; }
};

void replay_batch(const ReplayOptions& options) {
    std::ostringstream results, notes;
    Console console(results, notes, false, false);
    ASSERT_EQ(run_replay(options, console), 0);
}

/// Whether every frame of the first run has its like in the second.
void expect_within(const std::map<double, std::string>& some, const std::map<double, std::string>& all) {
    EXPECT_FALSE(some.empty());
    for (const auto& [time, hash] : some) {
        ASSERT_EQ(all.count(time), 1u) << "no frame at " << time;
        EXPECT_EQ(all.at(time), hash) << "at " << time;
    }
}

TEST(LiveRun, ShowsThePicturesOfABatchReplay) {
    Desk desk(files().options("live_plain"));
    desk.turns(5);
    desk.window->press(Key::space);
    desk.turn();
    EXPECT_FALSE(desk.turn()) << "paused: nothing new to draw";
    desk.window->press('.');
    desk.window->press(Key::right);
    EXPECT_TRUE(desk.turn());
    const int presented = desk.window->presented();
    desk.finish();
    replay_batch(files().options("batch_plain"));
    const auto shown = hashes_by_time(desk.options.output);
    EXPECT_GE(shown.size(), 5u);
    expect_within(shown, hashes_by_time(files().folder.file("batch_plain")));
    EXPECT_EQ(test_support::summary_of(desk.options.output).at("frames").get<int>() + 1, presented)
        << "one frame was shown again, as paused";
}

/// What is on the screen, read back from it when it is shown.
std::vector<std::uint8_t> on_screen(Desk& desk) {
    std::vector<std::uint8_t> pixels(std::size_t{4} * desk.session->width() * desk.session->height());
    desk.window->on_present = [&] {
        EXPECT_TRUE(gl::read_pixels(desk.session->display().gl(), desk.session->width(), desk.session->height(), pixels));
    };
    EXPECT_TRUE(desk.turn());
    desk.window->on_present = [] {};
    return pixels;
}

TEST(LiveRun, TheOverlayIsOnTheScreenAlone) {
    Desk desk(files().options("live_overlay"));
    desk.turns(3);
    desk.window->press(Key::space);
    desk.window->press('.');
    const std::vector<std::uint8_t> plain = on_screen(desk);
    desk.window->press('i');
    const std::vector<std::uint8_t> figures = on_screen(desk);
    EXPECT_NE(figures, plain) << "also while it is paused";
    EXPECT_FALSE(desk.turn()) << "nothing new to show";
    desk.window->press('m');
    const std::vector<std::uint8_t> both = on_screen(desk);
    EXPECT_NE(both, figures);
    desk.window->press('i');
    desk.window->press('m');
    EXPECT_EQ(on_screen(desk), plain) << "off again: the display's own picture";
    desk.window->press('i');
    desk.window->press('.');
    desk.turns(2);
    EXPECT_EQ(desk.session->display().gl().denied().total, 0u);
    desk.finish();
    replay_batch(files().options("batch_overlay"));
    const auto shown = hashes_by_time(desk.options.output);
    EXPECT_GE(shown.size(), 4u);
    expect_within(shown, hashes_by_time(files().folder.file("batch_overlay")));
    for (const nlohmann::json& line : test_support::frame_lines(desk.options.output))
        EXPECT_FALSE(line.contains("accuracy_overlay"));
}

/// As the display drew the frame that is on the screen; its rows from the top.
std::vector<std::uint8_t> display_frame(Desk& desk) { return upright(desk.session->pixels()).pixels; }

TEST(LiveRun, TheLineAndTheKeysAreOnTheScreenAlone) {
    Desk desk(files().options("live_line"));
    desk.turns(3);
    desk.window->press(Key::space);
    const std::vector<std::uint8_t> line = on_screen(desk);
    desk.window->press('h');
    const std::vector<std::uint8_t> help = on_screen(desk);
    EXPECT_NE(help, line);
    EXPECT_THAT(desk.notes.str(), HasSubstr("Keys of the window"));
    desk.window->press('?');
    EXPECT_EQ(on_screen(desk), line) << "off again";
    desk.window->press('o');
    const std::vector<std::uint8_t> bare = on_screen(desk);
    EXPECT_NE(bare, line);
    EXPECT_EQ(bare, std::vector<std::uint8_t>(desk.session->pixels().pixels, desk.session->pixels().pixels + bare.size()))
        << "nothing but the display's frame";
    EXPECT_EQ(desk.session->display().gl().denied().total, 0u);
    desk.finish();
    replay_batch(files().options("batch_line"));
    expect_within(hashes_by_time(desk.options.output), hashes_by_time(files().folder.file("batch_line")));
}

TEST(LiveRun, AScreenshotIsTheFrameOfTheDisplay) {
    Desk desk(files().options("live_screenshot"));
    desk.turns(2);
    desk.window->press(Key::space);
    desk.window->press('h');
    desk.turn();
    const std::vector<std::uint8_t> frame = display_frame(desk);
    desk.window->press('p');
    desk.window->press('s');
    desk.turn();
    desk.window->press('s');
    desk.turn();
    std::vector<std::string> pictures;
    for (const auto& entry : std::filesystem::directory_iterator(desk.options.output))
        if (entry.path().filename().string().rfind("screenshot_", 0) == 0) pictures.push_back(entry.path().string());
    ASSERT_EQ(pictures.size(), 2u) << "the second has a name of its own";
    for (const std::string& picture : pictures) {
        EXPECT_EQ(read_png(picture).pixels, frame);
        EXPECT_THAT(desk.notes.str(), HasSubstr("saved " + picture));
    }
    desk.window->press('.');
    desk.turn();
    EXPECT_NE(display_frame(desk), frame) << "control";
    desk.finish();
}

TEST(LiveRun, KeysFromBeforeItBeganAreNotLost) {
    Desk desk(files().options("live_early"));
    desk.run->handle({ScriptedWindow::key_event(Key::space), ScriptedWindow::key_event(Key::character, '3')});
    desk.turn();
    EXPECT_FALSE(desk.run->controller().transport().playing());
    EXPECT_THAT(read_file(desk.switches()), HasSubstr("panel."));
    desk.finish();
}

/// Four minutes in one place: more intervals than are decided before a picture.
class LongCircle final : public test_support::FlownCircle {
public:
    base::Time end() const override { return begin() + Duration::seconds(240); }
    std::optional<SignalSample> at(base::Time time) const override {
        const double s = (time - begin()).to_seconds();
        return FlownCircle::at(begin() + Duration::from_seconds(4 + 4 * std::sin(s / 40)));
    }
};

TEST(LiveRun, FarIntoAFlightAPictureComesAtOnceAndTheRecordIsThatOfTheFlight) {
    static const test_support::FlownFiles kFiles{LongCircle()};
    const auto late = [](const char* output) {
        ReplayOptions options = kFiles.options(output);
        options.from_s = 200;
        options.to_s = 202;
        options.step_s = 0.5;
        return options;
    };
    Desk desk(late("live_late"));
    EXPECT_TRUE(desk.turn());
    EXPECT_EQ(desk.window->presented(), 1);
    EXPECT_FALSE(desk.run->is_prepared());
    EXPECT_THAT(desk.window->title(), HasSubstr("preparing"));
    desk.window->press('p');
    int turns = 0;
    while (!desk.run->is_prepared() && turns++ < 100) desk.turn();
    EXPECT_GT(turns, 1);
    EXPECT_THAT(desk.notes.str(), HasSubstr("no picture of the flight yet"));
    desk.turns(3);
    desk.finish();
    replay_batch(late("batch_late"));
    const auto shown = hashes_by_time(desk.options.output), batch = hashes_by_time(kFiles.folder.file("batch_late"));
    EXPECT_GE(shown.size(), 3u);
    EXPECT_EQ(shown.begin()->first, std::next(batch.begin())->first) << "it goes on by the first turn alone, then waits";
    expect_within(shown, batch);
}

TEST(LiveRun, AKeyShowsAnotherLegendAndTheRunSaysSo) {
    Desk desk(files().options("live_legend"));
    desk.turns(2);
    desk.window->press(Key::space);
    desk.turn();
    desk.window->press('l');
    EXPECT_TRUE(desk.turn()) << "also while it is paused";
    EXPECT_FALSE(desk.turn()) << "nothing new to show";
    desk.finish();
    EXPECT_EQ(test_support::frame_lines(desk.options.output).back().at("legend").at("show"), "whole");
    const std::string summary = read_file(desk.options.output + "/summary.json");
    EXPECT_THAT(summary, HasSubstr("the legend was set to 'whole'"));
}

TEST(LiveRun, AKeyChangesTheLightFromThenOn) {
    Desk desk(files().options("live_light"));
    desk.turns(2);
    desk.window->press(Key::space);
    desk.turn();
    desk.window->press('n');
    EXPECT_TRUE(desk.turn());
    desk.finish();
    const auto lines = test_support::frame_lines(desk.options.output);
    EXPECT_EQ(lines.front().at("symbology_light"), "day");
    EXPECT_EQ(lines.back().at("symbology_light"), "night");
    EXPECT_THAT(read_file(desk.options.output + "/summary.json"), HasSubstr("the symbology was switched to night"));
}

TEST(LiveRun, AMapWithoutTerrainIsRefusedInTheWindow) {
    ReplayOptions options = files().options("live_no_map");
    options.picture.terrain.clear();
    Desk desk(options);
    desk.turn();
    desk.window->press('m');
    desk.turn();
    EXPECT_THAT(desk.notes.str(), HasSubstr("--error-map: needs terrain"));
    EXPECT_FALSE(desk.run->controller().accuracy().error_map);
    desk.finish();
}

TEST(LiveRun, RecordedSwitchesReplayToTheSamePictures) {
    Desk desk(files().options("live_switches"));
    desk.turns(3);
    desk.window->press('3');  // cruise
    desk.turns(4);
    desk.window->press('4');  // approach
    desk.turns(3);
    desk.finish();

    ReplayOptions with = files().options("batch_switches"), without = files().options("batch_no_switches");
    with.switches = desk.switches();
    replay_batch(with);
    replay_batch(without);
    const auto shown = hashes_by_time(desk.options.output);
    expect_within(shown, hashes_by_time(with.output));
    const auto unswitched = hashes_by_time(without.output);
    std::size_t different = 0;
    for (const auto& [time, hash] : shown) different += unswitched.at(time) != hash ? 1 : 0;
    EXPECT_GE(different, 6u) << "the switches must show";
    const auto lines = test_support::frame_lines(desk.options.output);
    EXPECT_EQ(lines.back().at("phase"), "approach");
    EXPECT_EQ(lines.back().at("phase_source"), "switch");
}

TEST(LiveRun, AfterGoingBackTheNewTakeCounts) {
    Desk desk(files().options("live_take"));
    desk.turns(4);
    desk.window->press('3');
    desk.turns(8);
    desk.window->press(Key::space);
    desk.window->press(Key::home);
    desk.turn();
    desk.window->press('.');
    desk.turn();
    desk.window->press('5');
    desk.window->press(Key::space);
    desk.turns(14);
    desk.finish();
    ReplayOptions with = files().options("batch_take");
    with.switches = desk.switches();
    replay_batch(with);
    expect_within(hashes_by_time(desk.options.output), hashes_by_time(with.output));
    EXPECT_EQ(test_support::frame_lines(with.output).back().at("phase"), "go_around");
    EXPECT_THAT(files().folder.read("live_take/window.switches"), ::testing::Not(HasSubstr("CRUISE 1")));
    EXPECT_THAT(test_support::summary_of(desk.options.output).at("notes").dump(), HasSubstr("later than 0.500 s"));
}

TEST(LiveRun, GoesOnFromARecordedSwitchLog) {
    ReplayOptions first = files().options("live_first");
    Desk desk(first);
    desk.turns(2);
    desk.window->press('2');
    desk.turns(2);
    desk.finish();
    ReplayOptions second = files().options("live_second");
    second.switches = desk.switches();
    Desk again(second);
    again.turns(6);
    again.window->press('6');
    again.turns(4);
    again.finish();
    const std::string log = files().folder.read("live_second/window.switches");
    EXPECT_THAT(log, HasSubstr("panel.TAKEOFF 1"));
    EXPECT_THAT(log, HasSubstr("panel.REPLAN 1"));
    ReplayOptions batch = files().options("batch_second");
    batch.switches = again.switches();
    replay_batch(batch);
    expect_within(hashes_by_time(again.options.output), hashes_by_time(batch.output));
}

TEST(LiveRun, ItsSavedConfigReplaysTheSession) {
    ReplayOptions options = files().options("live_config");
    options.save_config = files().folder.file("session.toml");
    options.from_s = 1;
    Desk desk(options);
    desk.turns(2);
    desk.window->press('4');
    desk.turns(20);
    EXPECT_FALSE(desk.run->controller().transport().playing()) << "at the end";
    desk.finish();
    ReplayOptions loaded = load_replay_config(options.save_config);
    EXPECT_FALSE(loaded.window);
    loaded.output = files().folder.file("batch_config");
    replay_batch(loaded);
    expect_within(hashes_by_time(desk.options.output), hashes_by_time(loaded.output));
}

TEST(LiveRun, TheFreeCameraShowsAnotherPictureAndIsNotRecorded) {
    Desk desk(files().options("live_camera"));
    desk.window->press(Key::space);
    desk.turn();
    const std::uint64_t cockpit = desk.session->frame_hash();
    desk.window->press('c');
    EXPECT_TRUE(desk.turn());
    desk.window->press('w');
    EXPECT_TRUE(desk.turn());
    const std::uint64_t flown = desk.session->frame_hash();
    EXPECT_NE(flown, cockpit);
    EXPECT_THAT(desk.window->title(), HasSubstr("free camera 200 m/s"));
    desk.window->press('c');
    EXPECT_TRUE(desk.turn());
    EXPECT_EQ(desk.session->frame_hash(), cockpit) << "back in the cockpit";
    desk.finish();
    for (const auto& line : test_support::frame_lines(desk.options.output)) EXPECT_EQ(line.at("time_s"), 0);
}

TEST(LiveRun, TheFreeCameraHasItsOwnSky) {
    ReplayOptions options = files().options("live_sky");
    const std::string points = "0,47.04,9.68,2500,0,80,0\n1,47.04,9.68,2500,0,-80,0\n";
    options.tour =
        files().folder.write("sky.csv", "time_s,latitude_deg,longitude_deg,altitude_m,heading_deg,pitch_deg,roll_deg\n" + points);
    Desk desk(options);
    desk.window->press(Key::space);
    const auto bluish_share = [&desk] {
        const RgbaView view = desk.session->pixels();
        std::size_t bluish = 0;
        for (std::size_t n = 0; n < std::size_t{view.width} * view.height; ++n)
            bluish += view.pixels[4 * n + 2] > view.pixels[4 * n] + 10 ? 1 : 0;
        return static_cast<double>(bluish) / (static_cast<double>(view.width) * view.height);
    };
    desk.turn();
    EXPECT_EQ(bluish_share(), 1) << "straight up there is nothing but sky";
    desk.window->press('.');
    desk.window->press('.');
    desk.turn();
    EXPECT_LT(bluish_share(), 0.02) << "straight down there is none";
}

TEST(LiveRun, ATourIsTiedToTheFlight) {
    ReplayOptions options = files().options("live_tour");
    options.tour = files().folder.write("tour.csv",
                                        "time_s,latitude_deg,longitude_deg,altitude_m,heading_deg,pitch_deg,roll_deg\n0,47.0,9.7,"
                                        "2500,0,-20,0\n6,47.04,9.7,2500,90,-20,0\n");
    Desk desk(options);
    desk.window->press(Key::space);
    desk.turn();
    const std::uint64_t first = desk.session->frame_hash();
    desk.window->press('.');
    desk.turn();
    EXPECT_NE(desk.session->frame_hash(), first);
    desk.window->press(',');
    desk.turn();
    EXPECT_EQ(desk.session->frame_hash(), first);
    EXPECT_THAT(desk.window->title(), HasSubstr("tour"));
    desk.finish();
    EXPECT_TRUE(test_support::frame_lines(desk.options.output).empty());
}

TEST(LiveRun, ABadTourIsRefusedBeforeAnythingIsWritten) {
    ReplayOptions options = files().options("live_bad_tour");
    options.tour = files().folder.write("bad.csv", "time_s\n");
    test_support::expect_user_error([&] { Desk desk(options); }, "bad.csv:1: ");
    EXPECT_FALSE(std::filesystem::exists(options.output));
    options.tour = files().folder.file("none.csv");
    test_support::expect_user_error([&] { Desk desk(options); }, "none.csv: ");
}

TEST(LiveRun, AChangedDesignIsShownAtOnceAndABrokenOneIsNot) {
    const std::string sound = read_file(resolve_config("default", "designs"));
    std::string other = sound;
    other.replace(other.find("field_of_view_deg = 60"), 22, "field_of_view_deg = 40");
    other.replace(other.find("\"#1c54a8\""), 9, "\"#541ca8\"");
    other.replace(other.find("dpi = 96"), 8, "dpi = 400");
    ReplayOptions options = files().options("live_design");
    options.picture.design = files().folder.write("live.toml", sound);
    options.picture.size = PictureSize{1000, 600};
    Desk desk(options);
    desk.window->press(Key::space);
    desk.turns(2);
    const std::uint64_t before = desk.session->frame_hash();
    files().folder.write("live.toml", "name = \n");
    desk.turns(3);
    EXPECT_EQ(desk.session->frame_hash(), before);
    EXPECT_THAT(desk.notes.str(), HasSubstr("live.toml:1"));
    files().folder.write("live.toml", other);
    desk.turns(3);
    EXPECT_NE(desk.session->frame_hash(), before);
    EXPECT_THAT(desk.notes.str(), HasSubstr("design reloaded"));
    desk.finish();
    // A display that was started with the new design is the oracle.
    ReplayOptions batch = options;
    batch.output = files().folder.file("batch_design");
    batch.to_s = 0;
    replay_batch(batch);
    EXPECT_EQ(hashes_by_time(batch.output).at(0), hashes_by_time(desk.options.output).at(0));
}

TEST(LiveRun, TellsKeysAndState) {
    Desk desk(files().options("live_title"));
    desk.turns(2);
    EXPECT_THAT(desk.window->title(), HasSubstr("x1"));
    desk.window->press(Key::up);
    desk.window->press('r');
    desk.window->press('h');
    desk.turn();
    EXPECT_THAT(desk.window->title(), HasSubstr("x2 backwards"));
    EXPECT_THAT(desk.notes.str(), HasSubstr("Keys of the window"));
    EXPECT_FALSE(desk.run->closed());
    desk.window->press(Key::escape);
    desk.turn();
    EXPECT_TRUE(desk.run->closed());
    desk.finish();
    EXPECT_THAT(desk.results.str(), HasSubstr("frames"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_live_run
