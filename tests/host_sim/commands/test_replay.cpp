#include "host_sim/commands/replay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "host_sim/commands/convert.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "tests/support/files/read_film.hpp"
#include "tests/support/flights/flown_across.hpp"
#include "tests/support/flights/flown_circle.hpp"
#include "tests/support/flights/frame_lines.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"
#include "tests/support/programs/headless_backends.hpp"
#include "tests/support/terrain/damaged_terrain.hpp"

namespace tedavis::host_sim::test_replay {
namespace {

using test_support::frame_lines;
using test_support::hashes_by_time;
using test_support::summary_of;
using ::testing::HasSubstr;

const test_support::FlownFiles& files() {
    static const test_support::FlownFiles kFiles;
    return kFiles;
}

std::map<double, std::string> replayed(const ReplayOptions& options) {
    std::ostringstream results, notes;
    Console console(results, notes, false, false);
    EXPECT_EQ(run_replay(options, console), 0);
    return hashes_by_time(options.output);
}

/// The whole flight, drawn once for all tests.
const std::map<double, std::string>& whole() {
    static const std::map<double, std::string> kHashes = replayed(files().options("whole"));
    return kHashes;
}

TEST(Replay, LeavesAWholeRun) {
    EXPECT_EQ(whole().size(), 17u);
    const std::string folder = files().folder.file("whole");
    EXPECT_TRUE(std::filesystem::exists(folder + "/report.html"));
    const auto summary = summary_of(folder);
    EXPECT_EQ(summary.at("frames"), 17);
    EXPECT_EQ(summary.at("size"), "320x240");
    EXPECT_EQ(summary.at("heap_allocations_after_start"), 0);
    EXPECT_EQ(summary.at("interrupted"), false);
    EXPECT_EQ(summary.at("gl_calls_outside_device"), 0);
    EXPECT_GT(summary.at("can").at("decoded"), 1000);
    std::set<std::string> different;
    for (const auto& [time, hash] : whole()) different.insert(hash);
    EXPECT_EQ(different.size(), 17u) << "the aircraft flies";
    for (const auto& line : frame_lines(folder)) {
        const bool position_was_sent = line.at("time_s") > 0;
        EXPECT_EQ(line.at("own_ship").at("state") == "valid", position_was_sent) << line.at("time_s");
    }
}

TEST(Replay, TwiceIsTheSame) {
    const auto again = replayed(files().options("again"));
    EXPECT_EQ(again, whole());
    const auto first = frame_lines(files().folder.file("whole")), second = frame_lines(files().folder.file("again"));
    for (std::size_t n = 0; n < first.size(); ++n) {
        auto a = first[n], b = second[n];
        a.erase("ms");
        b.erase("ms");
        EXPECT_EQ(a, b);
    }
}

TEST(Replay, TheOverlayIsTheSameTwiceAndLeavesHashesAlone) {
    ReplayOptions options = files().options("no_overlay");
    options.frames = FrameOutput::png;
    options.to_s = 1;
    const auto plain = replayed(options);
    const std::uint64_t last = frame_lines(options.output).back().at("frame");
    const std::string without = read_file(frame_picture_path(options.output, last));
    options.accuracy = {true, true};
    std::vector<std::string> pictures;
    for (const char* const name : {"overlay_1", "overlay_2"}) {
        options.output = files().folder.file(name);
        EXPECT_EQ(replayed(options), plain);
        for (const auto& line : frame_lines(options.output)) EXPECT_EQ(line.at("accuracy_overlay"), true);
        pictures.push_back(read_file(frame_picture_path(options.output, last)));
    }
    EXPECT_EQ(pictures[0], pictures[1]) << "no time is in it";
    EXPECT_NE(pictures[0], without);
}

/// The own flight again, 5 s later: it is not there before.
TEST(Replay, GhostsChangePicturesOnlyWhereTheyAre) {
    ReplayOptions options = files().options("no_ghost");
    options.picture.legend = flight::LegendShow::none;
    const auto without = replayed(options);
    options.output = files().folder.file("ghost");
    options.ghosts = {files().folder.write("later.log", test_support::log_of(test_support::FlownLater(5)))};
    const auto with = replayed(options);
    ASSERT_EQ(with.size(), without.size());
    for (const auto& [time_s, hash] : with)
        if (time_s < 4.5) {
            EXPECT_EQ(hash, without.at(time_s)) << time_s;
        }
    EXPECT_EQ(summary_of(options.output).at("ghosts").at(0).at("name"), "later");
    EXPECT_EQ(summary_of(options.output).at("scene"), "") << "as it was named";
    EXPECT_THAT(read_file(options.output + "/report.html"), HasSubstr(">ghost later begins<"));
    // 3 s before the own ship it flies 180 m in front of it.
    options.output = files().folder.file("ghost_in_front");
    options.ghosts = {files().folder.write("earlier.log", test_support::log_of(test_support::FlownLater(-3)))};
    std::size_t changed = 0;
    for (const auto& [time_s, hash] : replayed(options)) changed += hash == without.at(time_s) ? 0 : 1;
    EXPECT_GT(changed, 5u);
}

/// Right in front of the own ship, where any traffic would be an intruder.
TEST(Replay, GhostsRaiseNoAlertAndNoFlag) {
    ReplayOptions options = files().options("alerts_without");
    replayed(options);
    const auto without = frame_lines(options.output);
    options.output = files().folder.file("alerts_with");
    options.ghosts = {files().folder.write("close.log", test_support::log_of(test_support::FlownLater(-1)))};
    replayed(options);
    const auto with = frame_lines(options.output);
    ASSERT_EQ(with.size(), without.size());
    bool is_shown = false;
    for (std::size_t n = 0; n < with.size(); ++n) {
        for (const char* key : {"alerts", "flags", "own_ship", "phase", "signals"})
            EXPECT_EQ(with[n].at(key), without[n].at(key)) << key;
        is_shown = is_shown || (with[n].at("data").contains("ghost") && with[n].at("data").at("ghost").at("drawn") > 0);
    }
    EXPECT_TRUE(is_shown);
}

/// A flight that comes over the terrain after 15.6 s and leaves it after 65.6 s.
ReplayOptions across(const std::string& output) {
    ReplayOptions options = files().options(output);
    options.log = files().folder.file("across.log");
    if (std::filesystem::exists(options.log)) return options;
    ConvertOptions convert;
    convert.flight = files().folder.write("across.igc", test_support::FlownAcross().igc());
    convert.output = options.log;
    convert.assume_geometric = true;
    EXPECT_EQ(test_support::run_command([&](Console& console) { return run_convert(convert, console); }).code, 0);
    return options;
}

TEST(Replay, OverTerrainIsWhereTheFlightIsOverIt) {
    ReplayOptions options = across("over");
    options.over_terrain = true;
    options.step_s = 1;
    replayed(options);
    const auto lines = frame_lines(options.output);
    ASSERT_GT(lines.size(), 40u);
    EXPECT_NEAR(lines.front().at("time_s").get<double>(), test_support::FlownAcross().time_at(9.6), 2);
    EXPECT_NEAR(lines.back().at("time_s").get<double>(), test_support::FlownAcross().time_at(9.76), 2);
    for (const auto& line : lines) EXPECT_EQ(line.dump().find("terrain.outside_database"), std::string::npos);
    // The control: without the option most of the flight is drawn, and some of it lies outside.
    ReplayOptions whole = across("not_cut");
    whole.step_s = 1;
    replayed(whole);
    EXPECT_NE(frame_lines(whole.output).at(5).dump().find("terrain.outside_database"), std::string::npos);
}

/// Off the terrain and back over it, twice: a fix each second, north of 46.94 N and south of it in turns of 10 s.
ReplayOptions in_and_out(const std::string& output) {
    ReplayOptions options = files().options(output);
    options.log = files().folder.file("in_and_out.log");
    if (std::filesystem::exists(options.log)) return options;
    ConvertOptions convert;
    convert.flight = files().folder.write("in_and_out.igc", test_support::FlownAcross{46.94, 50, 0.003}.igc_meandering(0.02, 20));
    convert.output = options.log;
    convert.assume_geometric = true;
    EXPECT_EQ(test_support::run_command([&](Console& console) { return run_convert(convert, console); }).code, 0);
    return options;
}

TEST(Replay, BetweenTwoSpansOverTheTerrainNothingIsDrawn) {
    for (const bool is_spread : {false, true}) {
        ReplayOptions options = in_and_out(is_spread ? "spans_spread" : "spans");
        options.over_terrain = true;
        options.step_s = is_spread ? std::nullopt : std::optional<double>(1);
        if (is_spread) options.spread = 20;
        replayed(options);
        const auto lines = frame_lines(options.output);
        EXPECT_GE(lines.size(), 15u);
        double widest_gap_s = 0;
        for (std::size_t n = 1; n < lines.size(); ++n)
            widest_gap_s = std::max(widest_gap_s, lines[n].at("time_s").get<double>() - lines[n - 1].at("time_s").get<double>());
        EXPECT_GT(widest_gap_s, 7) << "it was away";
        for (const auto& line : lines) EXPECT_EQ(line.dump().find("terrain.outside_database"), std::string::npos);
        const std::string notes = summary_of(options.output).at("notes").dump();
        EXPECT_THAT(notes, HasSubstr("frames are drawn where the flight is over " + options.picture.terrain + ": "));
        EXPECT_GE(std::count(notes.begin(), notes.end(), '-'), 2) << notes;
    }
}

TEST(Replay, SpreadFramesAreThoseOfTheWholeRun) {
    ReplayOptions options = files().options("spread");
    options.step_s.reset();
    options.spread = 5;
    const auto spread = replayed(options);
    EXPECT_GE(spread.size(), 4u) << "whole frames apart, of which the last may lie beyond the end";
    options.output = files().folder.file("all");
    options.spread.reset();
    const auto all = replayed(options);
    EXPECT_GE(all.size(), 240u);
    for (const auto& [time, hash] : spread) EXPECT_EQ(all.at(time), hash) << time;
    EXPECT_EQ(spread.count(0.0), 1u);
}

TEST(Replay, ALongerRunIsSpokenOf) {
    ReplayOptions options = files().options("longer");
    options.picture.size = PictureSize{64, 48};
    options.step_s = 1.0 / 30;
    options.to_s = 7;
    options.frames = FrameOutput::none;
    const auto said = test_support::run_command([&](Console& console) { return run_replay(options, console); });
    EXPECT_EQ(said.code, 0);
    EXPECT_THAT(said.notes, HasSubstr("note: " + options.output + ": 211 frames, about "));
}

TEST(Replay, ALongRunIsRefusedAndNothingIsWritten) {
    ReplayOptions options = across("too_long");
    options.step_s = 0.001;
    test_support::expect_user_error([&] { replayed(options); }, ": 8000");
    test_support::expect_user_error([&] { replayed(options); },
                                    "; draw fewer, such as with --step 1, --from, --to, or confirm with --yes");
    EXPECT_FALSE(std::filesystem::exists(options.output));
}

TEST(Replay, TheFrameAtTIsTheOneOfTheWholeRun) {
    for (const double from : {0.5, 3.0, 7.5, 8.0}) {
        ReplayOptions part = files().options("part");
        part.from_s = from;
        part.to_s = from + 1;
        const auto some = replayed(part);
        EXPECT_EQ(some.begin()->first, from);
        for (const auto& [time, hash] : some) EXPECT_EQ(whole().at(time), hash) << time;
    }
}

/// The flight with requests for a legend on the bus: whole at 2.2 s, and withdrawn at 5.2 s.
std::string log_with_requests() {
    std::string log = read_file(files().log);
    const std::string interface = log.substr(log.find(' ') + 1, log.find(' ', log.find(' ') + 1) - log.find(' ') - 1);
    for (const auto& [second, frame] : {std::pair<int, std::string>{2, "73C#010A000002"}, {5, "73C#01000001"}}) {
        const std::string stamp = "(" + std::to_string(test_support::FlownCircle::kBegin_s + second) + ".2";
        const std::size_t line = log.find(stamp);
        EXPECT_NE(line, std::string::npos);
        log.insert(line, stamp + "00000) " + interface + " " + frame + "\n");
    }
    std::string path = files().folder.file("requests.log");
    std::ofstream(path, std::ios::binary) << log;
    return path;
}

/// What each frame shows, by its time.
std::map<double, std::string> legends_of(const std::string& folder) {
    std::map<double, std::string> shown;
    for (const auto& line : frame_lines(folder)) shown[line.at("time_s")] = line.at("legend").at("show");
    return shown;
}

TEST(Replay, TheLegendIsThatOfTheOptionUntilTheBusAsksForAnother) {
    ReplayOptions options = files().options("requests");
    options.log = log_with_requests();
    options.picture.legend = flight::LegendShow::none;
    options.picture.design = "map_north_up";  // its ground has a legend; the natural look has none
    const auto all = replayed(options);
    const auto shown = legends_of(options.output);
    EXPECT_EQ(shown.at(2.0), "none");
    EXPECT_EQ(shown.at(2.5), "whole");
    EXPECT_EQ(shown.at(5.0), "whole") << "a request holds";
    EXPECT_EQ(shown.at(5.5), "none") << "it was withdrawn";
    for (const double from : {3.0, 6.0}) {
        ReplayOptions part = options;
        part.output = files().folder.file("requests_part");
        part.from_s = from;
        for (const auto& [time, hash] : replayed(part)) EXPECT_EQ(all.at(time), hash) << time;
    }
    // The control: without the messages the pictures between them are others.
    ReplayOptions without = files().options("no_requests");
    without.picture.legend = flight::LegendShow::none;
    without.picture.design = options.picture.design;
    const auto plain = replayed(without);
    EXPECT_NE(plain.at(3.0), all.at(3.0));
    EXPECT_EQ(plain.at(6.0), all.at(6.0));
}

TEST(Replay, OtherStepsMeetTheSameFrames) {
    ReplayOptions coarse = files().options("coarse");
    coarse.step_s = 2;
    const auto some = replayed(coarse);
    EXPECT_EQ(some.size(), 5u);
    for (const auto& [time, hash] : some) EXPECT_EQ(whole().at(time), hash) << time;
}

TEST(Replay, BackwardsIsTheSameTheOtherWay) {
    ReplayOptions back = files().options("back");
    back.step_s = -0.5;
    EXPECT_EQ(replayed(back), whole());
    const auto lines = frame_lines(back.output);
    EXPECT_EQ(lines.front().at("time_s"), 8);
    EXPECT_EQ(lines.back().at("time_s"), 0);
}

TEST(Replay, AllSurfacesDrawTheSamePictures) {
    ReplayOptions osmesa = files().options("osmesa");
    osmesa.picture.gl = test_support::headless_backends().size() > 1 ? GlChoice::osmesa : GlChoice::egl;
    EXPECT_EQ(replayed(osmesa), whole());
}

TEST(Replay, PicturesHashesOrNothing) {
    ReplayOptions options = files().options("pictures");
    options.to_s = 1;
    options.frames.reset();
    static_cast<void>(replayed(options));
    EXPECT_TRUE(std::filesystem::exists(options.output + "/frames/000002.png"));
    options.frames = FrameOutput::hash;
    EXPECT_EQ(replayed(options).at(1), whole().at(1));
    EXPECT_FALSE(std::filesystem::exists(options.output + "/frames/000002.png")) << "of the run before";
    options.frames = FrameOutput::none;
    EXPECT_EQ(replayed(options).at(1), "0000000000000000");
}

TEST(Replay, ASwitchLogStatesThePhase) {
    ReplayOptions options = files().options("switches");
    const std::string stamp = "(1700000002.250000) panel.";
    std::string log = "# tedavis switch log 1\n";
    for (const char* name : {"GROUND 0", "TAKEOFF 0", "CRUISE 1", "APPROACH 0", "GO_AROUND 0", "REPLAN 0", "AUTO 0"})
        log += stamp + name + "\n";
    options.switches = files().folder.write("cruise.switches", log + "this is no edge\n");
    static_cast<void>(replayed(options));
    for (const auto& line : frame_lines(options.output)) {
        const bool switched = line.at("time_s") > 2.25;
        EXPECT_EQ(line.at("phase_source") == "switch", switched) << line.at("time_s");
        if (switched) {
            EXPECT_EQ(line.at("phase"), "cruise");
        }
    }
    EXPECT_THAT(summary_of(options.output).at("notes").dump(), HasSubstr("cruise.switches:9"));
    EXPECT_EQ(summary_of(options.output).at("warnings")[0].at("name"), "switches.broken_lines");
}

/// Standard frames of identifiers that CANaerospace does not use for what the display shows, among the flight's own.
TEST(Replay, AlienTrafficChangesNothingButCounters) {
    std::string log = files().folder.read("flight.log");
    std::size_t at = log.find('\n', log.size() / 4) + 1;
    std::size_t aliens = 0;
    for (; aliens < 200 && at != 0; ++aliens) {
        const std::string stamp = log.substr(at, log.find(')', at) + 1 - at);
        const std::string alien = stamp + " can0 1ABCDE0" + std::to_string(aliens % 10) + "#DEADBEEF00\n";
        log.insert(at, alien);
        at = log.find('\n', at + alien.size()) + 1;
    }
    ReplayOptions options = files().options("alien");
    options.log = files().folder.write("alien.log", log);
    EXPECT_EQ(replayed(options), whole());
    const auto mixed = summary_of(options.output).at("can"), plain = summary_of(files().folder.file("whole")).at("can");
    EXPECT_EQ(mixed.at("decoded"), plain.at("decoded"));
    EXPECT_EQ(mixed.at("frames"), plain.at("frames").get<std::size_t>() + aliens);
    EXPECT_EQ(mixed.at("alien"), plain.at("alien").get<std::size_t>() + aliens);
}

TEST(Replay, ADamagedChunkIsSaidAndEndsWithTwo) {
    std::string image = files().folder.read("terrain.tdb");
    test_support::damage_payloads(image);
    ReplayOptions options = files().options("damaged");
    options.picture.terrain = files().folder.write("damaged.tdb", image);
    const test_support::CommandRun run =
        test_support::run_command([&](Console& console) { return run_replay(options, console); });
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.notes, HasSubstr("damaged.tdb: a part of it cannot be used"));
    EXPECT_THAT(run.notes, HasSubstr("'tedavis check " + options.picture.terrain));
    EXPECT_THAT(run.results, HasSubstr("17 frames"));
    EXPECT_EQ(frame_lines(options.output).size(), 17u) << "the result is whole but for the terrain";
    EXPECT_THAT(summary_of(options.output).at("notes").dump(), HasSubstr("damaged.tdb: "));
}

TEST(Replay, LinesThatAreNoFramesAreCountedAndSaid) {
    static_cast<void>(whole());
    EXPECT_EQ(summary_of(files().folder.file("whole")).at("can").at("broken_lines"), 0);
    EXPECT_EQ(summary_of(files().folder.file("whole")).at("can").at("other_lines"), 0);
    std::string log = files().folder.read("flight.log");
    const std::size_t middle = log.find('\n', log.size() / 2) + 1;
    for (int n = 0; n < 40; ++n) log.insert(middle, "(1700000004.000000) can0 12\n");
    ReplayOptions options = files().options("broken");
    options.log = files().folder.write("broken.log", "some prose\n" + log + "more prose\n");
    const test_support::CommandRun run =
        test_support::run_command([&](Console& console) { return run_replay(options, console); });
    EXPECT_EQ(run.code, 0) << "the flight is all there";
    EXPECT_THAT(run.notes, HasSubstr("note: 34 notes in summary.json, the first: " + options.log + ":"));
    const auto summary = summary_of(options.output);
    EXPECT_EQ(summary.at("can").at("broken_lines"), 40);
    EXPECT_EQ(summary.at("can").at("other_lines"), 2);
    EXPECT_THAT(summary.at("notes").dump(), HasSubstr("40 broken lines in all; only the first 32 are named"));
    EXPECT_THAT(summary.at("notes").dump(), HasSubstr("2 lines do not begin with '('"));
    EXPECT_THAT(files().folder.read("broken/report.html"), HasSubstr("40 broken, 2 other"));
    EXPECT_EQ(hashes_by_time(options.output), whole());
}

/// Names of the findings that a run's summary has.
std::vector<std::string> warnings_of(const std::string& folder) {
    std::vector<std::string> names;
    const auto summary = summary_of(folder);
    for (const auto& one : summary.at("warnings")) names.push_back(one.at("name"));
    return names;
}

test_support::CommandRun run_of(const ReplayOptions& options) {
    return test_support::run_command([&](Console& console) { return run_replay(options, console); });
}

TEST(Replay, AFlightElsewhereIsSaidAndFailsWhereItIsStrict) {
    ReplayOptions options = files().options("elsewhere");
    const test_support::FlownFiles elsewhere{test_support::FlownAway()};
    options.log = elsewhere.log;
    const test_support::CommandRun run = run_of(options);
    EXPECT_EQ(run.code, 0);
    EXPECT_THAT(warnings_of(options.output), ::testing::ElementsAre("terrain.outside"));
    EXPECT_THAT(run.notes, HasSubstr("warning: 16 of 17 frames lie outside " + options.picture.terrain + ": it covers "));
    EXPECT_THAT(files().folder.read("elsewhere/report.html"), HasSubstr("frames lie outside"));
    options.strict = true;
    EXPECT_EQ(run_of(options).code, 1);
    ReplayOptions sound = files().options("sound");
    sound.strict = true;
    const test_support::CommandRun control = run_of(sound);
    EXPECT_EQ(control.code, 0) << control.notes;
    EXPECT_TRUE(warnings_of(sound.output).empty());
    EXPECT_THAT(control.notes, ::testing::Not(HasSubstr("warning")));
}

TEST(Replay, WhatIsWrongWithALogIsSaid) {
    std::vector<std::string> lines;
    std::istringstream text(files().folder.read("flight.log"));
    for (std::string line; std::getline(text, line);) lines.push_back(line + "\n");
    ReplayOptions options = files().options("wrong");
    options.frames = FrameOutput::none;
    const auto found = [&](const std::string& log) {
        options.log = files().folder.write("wrong.log", log);
        static_cast<void>(run_of(options));
        return warnings_of(options.output);
    };
    const auto joined = [](auto begin, auto end) {
        std::string all;
        for (; begin != end; ++begin) all += *begin;
        return all;
    };
    EXPECT_THAT(found(joined(lines.rbegin(), lines.rend())), ::testing::Contains("log.reversed"));
    EXPECT_THAT(found(joined(lines.begin(), lines.end()) + lines[10]), ::testing::ElementsAre("log.time_runs_back"));
    EXPECT_THAT(found(joined(lines.begin(), lines.end()) + "(1700000008.500000) can1 123#00\n"),
                ::testing::ElementsAre("log.interfaces"));
    EXPECT_THAT(found(joined(lines.begin(), lines.end()) + "(1700000008.500000) can0 726#01100001630002FF\n"),
                ::testing::ElementsAre("bus.impossible_phase"));
    EXPECT_THAT(found("(1700000000.000000) can0 1F5#01000020000100FE\n(1700000001.000000) can0 1F5#01\n"),
                ::testing::ElementsAre("bus.nothing_decoded", "flight.no_position"));
}

/// Presses Ctrl-C when the progress line shows a number.
class ImpatientUser final : public std::stringbuf {
protected:
    std::streamsize xsputn(const char* text, std::streamsize count) override {
        seen_.append(text, static_cast<std::size_t>(count));
        press();
        return count;
    }
    int overflow(int c) override {
        seen_ += static_cast<char>(c);
        press();
        return c;
    }

private:
    void press() {
        if (pressed_ || seen_.find("replay 35 %") == std::string::npos) return;
        pressed_ = true;
        raise(SIGINT);
    }
    std::string seen_;
    bool pressed_ = false;
};

TEST(Replay, AFilmHasThePicturesOfTheRun) {
    ReplayOptions options = files().options("filmed");
    options.frames = FrameOutput::png;
    options.to_s = 4;
    options.video = options.output + "/flight.mp4";
    static_cast<void>(replayed(options));
    EXPECT_EQ(summary_of(options.output).at("video"), options.video);
    auto film = test_support::read_film(options.video);
    ASSERT_EQ(film.pictures.size(), 9u);
    EXPECT_EQ(film.rate_num, 2 * film.rate_den);
    EXPECT_EQ(film.metadata["title"], "TEDAVIS, design default, flight.log, not for navigation");
    EXPECT_THAT(film.metadata["creation_time"], HasSubstr("2023-11-14T22:13:20")) << "the flight's";
    const auto lines = frame_lines(options.output);
    const auto png = [&](std::size_t n) { return read_png(frame_picture_path(options.output, lines.at(n).at("frame"))); };
    constexpr double kSame_db = 32;
    for (const std::size_t n : {std::size_t{0}, std::size_t{4}}) {
        EXPECT_GT(test_support::luma_psnr_db(film.pictures[n], png(n)), kSame_db) << n;
        EXPECT_LT(test_support::luma_psnr_db(film.pictures[n], png(4 - n)), kSame_db - 8) << "control: the other picture";
    }
}

TEST(Replay, AFilmNeedsNoPicturesBesideItAndNoFilmIsMadeUnasked) {
    ReplayOptions options = files().options("filmed_1");
    options.to_s = 1;
    options.frames = FrameOutput::png;
    options.video = files().folder.file("with.mp4");
    static_cast<void>(replayed(options));
    options.output = files().folder.file("filmed_2");
    options.frames = FrameOutput::none;
    options.video = files().folder.file("without.mp4");
    static_cast<void>(replayed(options));
    EXPECT_FALSE(std::filesystem::exists(options.output + "/frames"));
    EXPECT_EQ(files().folder.read("with.mp4"), files().folder.read("without.mp4"));
    static_cast<void>(whole());
    EXPECT_EQ(summary_of(files().folder.file("whole")).at("video"), "");
}

TEST(Replay, AFilmThatCannotBeLeavesTheFolderAsItWas) {
    std::ostringstream results, notes;
    Console console(results, notes, false, false);
    ReplayOptions options = files().options("not_filmed");
    const auto refused = [&](const std::string& words) {
        test_support::expect_user_error([&] { static_cast<void>(run_replay(options, console)); }, words);
        EXPECT_FALSE(std::filesystem::exists(options.output));
    };
    options.video = files().folder.file("none/film.mp4");
    refused("check the folder");
    options.video = files().folder.file("film.mp4");
    options.picture.size = PictureSize{321, 240};
    refused("say --size 322x240");
}

TEST(Replay, CtrlCEndsAFilmThatPlays) {
    ImpatientUser user;
    std::ostream notes(&user);
    std::ostringstream results;
    Console console(results, notes, false, true);
    ReplayOptions options = files().options("interrupted_film");
    options.video = files().folder.file("interrupted.mp4");
    EXPECT_EQ(run_replay(options, console), kInterruptedExitCode);
    EXPECT_EQ(test_support::read_film(options.video).pictures.size(), 6u) << "35 % of 17";
    EXPECT_EQ(summary_of(options.output).at("video"), options.video);
}

TEST(Replay, CtrlCLeavesAValidPartialRun) {
    static_cast<void>(whole());
    ImpatientUser user;
    std::ostream notes(&user);
    std::ostringstream results;
    Console console(results, notes, false, true);
    const ReplayOptions options = files().options("interrupted");
    EXPECT_EQ(run_replay(options, console), kInterruptedExitCode);
    const auto some = hashes_by_time(options.output);
    EXPECT_EQ(some.size(), 6u) << "35 % of 17";
    for (const auto& [time, hash] : some) EXPECT_EQ(whole().at(time), hash) << time;
    EXPECT_EQ(summary_of(options.output).at("interrupted"), true);
    EXPECT_EQ(summary_of(options.output).at("frames"), 6);
    EXPECT_TRUE(std::filesystem::exists(options.output + "/report.html"));
    EXPECT_THAT(results.str(), HasSubstr("6 frames (interrupted)"));
}

TEST(Replay, WrongInputIsRefusedAndNothingIsWritten) {
    std::ostringstream results, notes;
    Console console(results, notes, false, false);
    const auto refused = [&](ReplayOptions options, const std::string& words) {
        options.output = files().folder.file("refused");
        test_support::expect_user_error([&] { static_cast<void>(run_replay(options, console)); }, words);
        EXPECT_FALSE(std::filesystem::exists(options.output)) << words;
    };
    ReplayOptions options = files().options("refused");
    options.log = files().folder.file("none.log");
    refused(options, "none.log");
    options.log = files().folder.write("empty.log", "");
    refused(options, "empty.log: no CAN frame");
    options.log = files().folder.write("prose.log", "It was a dark and stormy night.\n");
    refused(options, "prose.log: no CAN frame");
    options = files().options("refused");
    options.from_s = 9;
    refused(options, "--from 9");
    options = files().options("refused");
    options.switches = files().folder.write("none.switches", "(1700000000.000000) panel.GROUND 1\n");
    refused(options, "none.switches:1: not a switch log");
    options = files().options("refused");
    options.picture.bus = "smoke_signals";
    refused(options, "smoke_signals");
    options = files().options("refused");
    options.picture.terrain = files().log;
    refused(options, "flight.log: ");
}

}  // namespace
}  // namespace tedavis::host_sim::test_replay
