// A recorded flight at any instant: whichever way an instant is reached (a run from the start, a leap, backwards, from a
// kept index) state and phase must be equal bit for bit.
#include "host_sim/replay/flight_player.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <zlib.h>

#include <csignal>
#include <map>
#include <random>
#include <sstream>

#include "platform/files/file_byte_source.hpp"
#include "tests/host_sim/replay/played_text.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/default_flight.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_flight_player {
namespace {

using base::Duration;
using test_support::TemporaryFolder;
using ::testing::HasSubstr;

const test_support::RecordedFlight& recorded() {
    static const test_support::RecordedFlight flight = test_support::default_flight();
    return flight;
}

/// The first lines of the default flight that lie within so many seconds.
std::string first_seconds(std::int64_t seconds) {
    const std::string& log = recorded().log;
    const std::int64_t end = std::stoll(log.substr(1, 10)) + seconds;
    return log.substr(0, log.find("\n(" + std::to_string(end)) + 1);
}

/// Checkpoints so close that a short log has many, and every log has an index, however new.
IndexPolicy dense() {
    IndexPolicy policy;
    policy.smallest_kept_log = 0;
    policy.rest = Duration{-1'000'000'000};
    policy.spacing = {64u << 10, 150, 512};
    return policy;
}

IndexPolicy without_index() {
    IndexPolicy policy;
    policy.smallest_kept_log = ~std::uint64_t{0};
    policy.spacing.log_bytes = ~std::uint64_t{0};  // and no checkpoint but the first
    policy.spacing.steps = ~std::uint64_t{0};
    return policy;
}

/// A player with a console to listen to, over a display without terrain.
struct Played {
    display::Display display;
    std::ostringstream results, notes;
    Console console{results, notes, false, false};
    FlightPlayer player;

    explicit Played(const PlayerFiles& files, const IndexPolicy& policy = dense()) : player(files, display, &console, policy) {}
    /// The state with its way: the newest points by their times and places.
    [[nodiscard]] std::string text(double seconds) {
        const base::Time time = player.first() + Duration::from_seconds(seconds);
        std::string text = text_at(player, time);
        const flight::FlightTrail& way = *player.at(time).trail;
        for (std::size_t n = 0; n < way.size(); ++n)
            text += std::to_string(way[n].at.ns) + (way[n].begins ? " begins " : " ") + std::to_string(way[n].latitude_rad);
        return text;
    }
};

PlayerFiles files_of(const std::string& log, const std::string& switches = {}) {
    return {log, "canaerospace", switches, "one_hot"};
}

/// Rewrites a byte in place until the file system shows it: its clock ticks in milliseconds.
void change_byte(const std::string& path, std::size_t offset, char value) {
    struct stat before {
    }, after{};
    ASSERT_EQ(::stat(path.c_str(), &before), 0);
    do {
        std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(static_cast<std::streamoff>(offset));
        file.put(value);
        file.close();
        ASSERT_EQ(::stat(path.c_str(), &after), 0);
    } while (after.st_ctim.tv_nsec == before.st_ctim.tv_nsec && after.st_ctim.tv_sec == before.st_ctim.tv_sec);
}

TEST(FlightPlayer, KnowsExtentAndCountsOfTheLog) {
    const TemporaryFolder folder;
    Played played(files_of(folder.write("a.log",
                                        "(1700000000.000000) can0 137#0902000000000000\n"
                                        "(1700000000.5) can0 137#09\n"
                                        "(1700000001.500000) can0 7FF#00\n"
                                        "(1700000003.250000) can0 20000008#0000000000000000\n"
                                        "(1700000003.000000) can0 137#0902000100000000\n")));
    EXPECT_EQ(played.player.first(), base::Time{1'700'000'000'000'000'000});
    EXPECT_EQ(played.player.last(), base::Time{1'700'000'003'250'000'000});
    EXPECT_EQ(text_of(played.player.facts().counters), "4 frames 2 decoded 1 alien 1 errors 0 dropped\n");
    ASSERT_EQ(played.player.notes().size(), 1u);
    EXPECT_THAT(played.player.notes()[0], HasSubstr("a.log:2: "));
}

TEST(FlightPlayer, ACompressedLogIsPlayedAsWhatItHolds) {
    const TemporaryFolder folder;
    const std::string text = first_seconds(20), plain = folder.write("a.log", text), packed = folder.file("b.log.gz");
    gzFile file = gzopen(packed.c_str(), "wb");
    ASSERT_EQ(gzwrite(file, text.data(), static_cast<unsigned>(text.size())), static_cast<int>(text.size()));
    gzclose(file);
    Played straight(files_of(plain), without_index()), unpacked(files_of(packed), without_index());
    EXPECT_EQ(unpacked.player.last(), straight.player.last());
    for (const double t : {19.5, 3.0}) EXPECT_EQ(unpacked.text(t), straight.text(t)) << t;
    test_support::expect_user_error(
        [&] { Played cut(files_of(folder.write("c.log.gz", folder.read("b.log.gz").substr(0, 900)))); },
        "c.log.gz: the compressed data break off");
}

TEST(FlightPlayer, FindsWhatIsWrongAndAKeptIndexFindsTheSame) {
    const TemporaryFolder folder;
    const std::string good = first_seconds(6);
    const auto names = [&](const PlayerFiles& files) {
        std::string all;
        for (int time = 0; time < 2; ++time) {
            Played played(files);
            for (const Finding& finding : played.player.findings()) all += finding.name + " ";
        }
        return all;
    };
    EXPECT_EQ(names(files_of(folder.write("good.log", good), folder.write("a.switches", recorded().switch_log))), "");
    std::string merged = good;
    for (std::size_t at = merged.find(" can0 ", merged.size() / 2); at != std::string::npos; at = merged.find(" can0 ", at + 1))
        merged.replace(at, 6, " can1 ");
    EXPECT_EQ(names(files_of(folder.write("merged.log", merged))), "log.interfaces log.interfaces ");
    EXPECT_EQ(names(files_of(folder.write("twice.log", good + good))), "log.time_runs_back log.time_runs_back ");
    std::string typo = recorded().switch_log;
    typo.replace(typo.find("panel.CRUISE"), 12, "panel.CRUZE_");
    EXPECT_EQ(names(files_of(folder.file("good.log"), folder.write("b.switches", typo))),
              "switches.unknown_line switches.unknown_line ");
    EXPECT_EQ(names(files_of(folder.file("good.log"),
                             folder.write("c.switches", test_support::seconds_later(recorded().switch_log, 1'000'000)))),
              "switches.another_time switches.another_time ");
}

TEST(FlightPlayer, RefusesWhatIsNoFlight) {
    const TemporaryFolder folder;
    const std::string good = folder.write("good.log", first_seconds(2));
    const auto play = [](const PlayerFiles& files) { return [files] { Played played(files); }; };
    test_support::expect_user_error(play(files_of(folder.write("empty.log", ""))), "no CAN frame in this file");
    test_support::expect_user_error(
        play(files_of(folder.write("f.igc", "AXXX001\nHFDTE200319\nB0900004600000N00900000EA0100001000\n"))),
        "a recorded flight (IGC), not a bus log; 'tedavis fly FLIGHT -o DIR' makes its report");
    test_support::expect_user_error(play(files_of(folder.write("f.json", "[{\"timestamp\": 1}]"))),
                                    "a recorded flight (ADS-B JSON)");
    test_support::expect_user_error(play(files_of(folder.write("text.log", "hello\n"))), "no CAN frame in this file");
    test_support::expect_user_error(play(files_of(folder.file("missing.log"))), "missing.log");
    test_support::expect_user_error(play({good, "no_such_bus", "", "one_hot"}), "no_such_bus");
    test_support::expect_user_error(play({good, "canaerospace", "", "no_such_panel"}), "no_such_panel");
    test_support::expect_user_error(play(files_of(good, good)), "not a switch log");
    EXPECT_EQ(folder.entries(), 5u) << "no index of what could not be played";
}

TEST(FlightPlayer, AnyOrderOfInstantsGivesTheSameStates) {
    const TemporaryFolder folder;
    const PlayerFiles files = files_of(folder.write("a.log", recorded().log), folder.write("a.switches", recorded().switch_log));
    Played straight(files, without_index());
    std::map<double, std::string> expected;
    for (double t = 0; t < 399; t += 7.77) expected[t] = straight.text(t);
    std::vector<double> order;
    for (const auto& [t, text] : expected) order.push_back(t);
    std::mt19937 random(5);
    std::shuffle(order.begin(), order.end(), random);
    Played leaping(files);
    for (const double t : order) ASSERT_EQ(leaping.text(t), expected[t]) << "at " << t;
    for (auto it = expected.rbegin(); it != expected.rend(); ++it) ASSERT_EQ(leaping.text(it->first), it->second) << it->first;
    EXPECT_NE(expected.begin()->second, expected.rbegin()->second) << "the control: states do differ";
}

TEST(FlightPlayer, PhasesComeFromTheHeightAboveTheTerrainAndAreReachedAlike) {
    const TemporaryFolder folder;
    const PlayerFiles files = files_of(folder.write("a.log", recorded().log));
    test_support::DefaultTerrain terrain;
    test_support::HeadlessDisplay over_terrain("egl", "es2-small", 64, 48, &terrain.bytes);
    FlightPlayer straight(files, over_terrain.display(), nullptr, without_index());
    FlightPlayer leaping(files, over_terrain.display(), nullptr, dense());
    Played without_terrain(files, without_index());
    bool terrain_matters = false;
    std::vector<double> times;
    for (double t = 3; t < 399; t += 13.3) times.push_back(t);
    std::map<double, std::string> expected;
    for (const double t : times) {
        expected[t] = text_at(straight, straight.first() + Duration::from_seconds(t));
        terrain_matters = terrain_matters || expected[t] != without_terrain.text(t);
    }
    std::mt19937 random(6);
    std::shuffle(times.begin(), times.end(), random);
    for (const double t : times) ASSERT_EQ(text_at(leaping, leaping.first() + Duration::from_seconds(t)), expected[t]) << t;
    EXPECT_TRUE(terrain_matters);
}

TEST(FlightPlayer, AKeptIndexGivesTheSameStates) {
    const TemporaryFolder folder;
    const PlayerFiles files = files_of(folder.write("a.log", recorded().log), folder.write("a.switches", recorded().switch_log));
    Played plain(files, without_index());
    EXPECT_EQ(folder.entries(), 2u);
    Played first(files);
    EXPECT_EQ(folder.entries(), 3u) << "a.log.tdx";
    Played second(files);
    EXPECT_EQ(first.notes.str() + second.notes.str(), "");
    EXPECT_EQ(second.player.first(), plain.player.first());
    EXPECT_EQ(second.player.last(), plain.player.last());
    EXPECT_EQ(text_of(second.player.facts().counters), text_of(plain.player.facts().counters));
    for (const double t : {390.0, 12.5, 200.01, 398.9}) EXPECT_EQ(second.text(t), plain.text(t)) << t;
}

TEST(FlightPlayer, IsInUseWhereItFits) {
    // The control: an index that lies is believed as long as its key fits, so a kept index is really what is read.
    const TemporaryFolder folder;
    const PlayerFiles files = files_of(folder.write("a.log", first_seconds(5)));
    Played first(files);
    const std::string bytes = folder.read("a.log.tdx");
    platform::FileByteSource log = std::move(platform::open_file(files.log.c_str()).value());
    IndexKey key;
    key.parts[IndexKey::program] = program_identity();
    key.parts[IndexKey::log] = file_identity(files.log, log).hash;
    key.parts[IndexKey::bus] = text_identity(test_support::source_file("configs/buses/canaerospace.toml"));
    key.parts[IndexKey::switch_config] = text_identity(test_support::source_file("configs/switches/one_hot.toml"));
    UnpackedIndex unpacked = unpack_index(bytes, key, dense().spacing);
    ASSERT_TRUE(unpacked.index) << unpacked.refusal;
    unpacked.index->facts.counters.alien = 77;
    static_cast<void>(folder.write("a.log.tdx", pack_index(*unpacked.index, key)));
    Played second(files);
    EXPECT_EQ(second.notes.str(), "");
    EXPECT_EQ(second.player.facts().counters.alien, 77u);
}

TEST(FlightPlayer, DoesNotTrustAnIndexOfOtherInputs) {
    const TemporaryFolder folder;
    const std::string log = folder.write("a.log", first_seconds(5));
    const std::string switches = folder.write("a.switches", recorded().switch_log);
    const auto note_of = [](const PlayerFiles& files) { return Played(files).notes.str(); };
    EXPECT_EQ(note_of(files_of(log)), "");
    EXPECT_THAT(note_of(files_of(log, switches)), HasSubstr("made when the switch log was another; the log is indexed anew"));
    EXPECT_THAT(note_of({log, "glider", switches, "one_hot"}), HasSubstr("the bus settings"));
    EXPECT_THAT(note_of({log, "glider", "", "coded_parity"}), HasSubstr("made when the switch"));
    EXPECT_EQ(note_of({log, "glider", "", "coded_parity"}), "") << "the new one fits";
    EXPECT_THAT(note_of({log, "glider", "", "coded_parity", "jet"}), HasSubstr("the aircraft or the phase"));
    EXPECT_THAT(note_of({log, "glider", "", "coded_parity", "jet", "cruise"}), HasSubstr("the aircraft or the phase"));
    EXPECT_THAT(note_of({log, "glider", "", "coded_parity"}), HasSubstr("the aircraft or the phase"));
    test_support::DefaultTerrain terrain;
    test_support::HeadlessDisplay over_terrain("egl", "es2-small", 64, 48, &terrain.bytes);
    std::ostringstream results, notes;
    Console console(results, notes, false, false);
    const FlightPlayer player({log, "glider", "", "coded_parity"}, over_terrain.display(), &console, dense());
    EXPECT_THAT(notes.str(), HasSubstr("the terrain database"));
}

TEST(FlightPlayer, FindsAnIndexStaleAfterOneByteOfTheLogChanged) {
    const TemporaryFolder folder;
    const std::string text = first_seconds(60);
    ASSERT_GT(text.size(), 1000000u) << "the byte must lie outside the samples of the identity";
    const PlayerFiles files = files_of(folder.write("a.log", text));
    Played first(files);
    const std::size_t value = text.find('#', text.size() / 2) + 1;  // of a frame in the middle: its node
    const struct timespec times[2] = {{0, UTIME_NOW}, {1'700'000'000, 0}};
    ASSERT_EQ(utimensat(AT_FDCWD, files.log.c_str(), times, 0), 0);
    Played touched(files);
    EXPECT_THAT(touched.notes.str(), HasSubstr("the log was another"));
    change_byte(files.log, value, 'z');
    ASSERT_EQ(utimensat(AT_FDCWD, files.log.c_str(), times, 0), 0);  // size and modification time are what they were
    Played changed(files);
    EXPECT_THAT(changed.notes.str(), HasSubstr("a.log.tdx: it was made when the log was another; the log is indexed anew"));
    EXPECT_EQ(changed.player.notes().size(), 1u) << "the broken line is there now";
    EXPECT_EQ(Played(files).notes.str(), "");
}

TEST(FlightPlayer, MakesADamagedOrCutIndexAnew) {
    const TemporaryFolder folder;
    const PlayerFiles files = files_of(folder.write("a.log", first_seconds(20)));
    Played first(files);
    const std::string whole = folder.read("a.log.tdx");
    std::string flipped = whole;
    flipped[whole.size() / 2] ^= 1;
    for (const std::string& bad : {whole.substr(0, whole.size() - 1), whole.substr(0, 10), std::string(), flipped}) {
        static_cast<void>(folder.write("a.log.tdx", bad));
        Played played(files);
        EXPECT_THAT(played.notes.str(), HasSubstr("the log is indexed anew"));
        EXPECT_EQ(played.text(15.1), first.text(15.1));
        EXPECT_EQ(Played(files).notes.str(), "") << "and kept whole again";
    }
}

TEST(FlightPlayer, KeepsNoIndexOfALogThatHasJustChangedOrIsShort) {
    const TemporaryFolder folder;
    const PlayerFiles files = files_of(folder.write("a.log", first_seconds(5)));
    IndexPolicy policy = dense();
    policy.rest = Duration::seconds(1'000'000);
    EXPECT_THAT(Played(files, policy).notes.str(), HasSubstr("has just been changed; its index is not kept"));
    policy.smallest_kept_log = 32u << 20;
    EXPECT_EQ(Played(files, policy).notes.str(), "");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(FlightPlayer, PlaysFromAFolderThatCannotBeWritten) {
    const TemporaryFolder folder;
    const PlayerFiles files = files_of(folder.write("a.log", first_seconds(5)));
    std::filesystem::create_directory(folder.file("a.log.tdx.part"));  // stands where the index is written, for root as well
    Played played(files);
    EXPECT_THAT(played.notes.str(), HasSubstr("its index is not kept"));
    EXPECT_EQ(played.player.last() - played.player.first() > Duration::seconds(4), true);
    EXPECT_EQ(std::filesystem::exists(folder.file("a.log.tdx")), false);
}

TEST(FlightPlayer, LeapsOverLongPausesOfTheRecording) {
    // A recorder without a clock of its own starts in 1970 and is then set: 56 years without a frame must cost nothing.
    const TemporaryFolder folder;
    const std::string flight = first_seconds(40);
    const std::int64_t first_second = std::stoll(flight.substr(1, 10));
    std::string early;
    for (int i = 0; i < 200; ++i) {
        char line[80];
        std::snprintf(line, sizeof line, "(%010d.%02d0000) can0 137#090200%02X00000000\n", 5 + i / 100, i % 100, i % 256);
        early += line;
    }
    const PlayerFiles files = files_of(folder.write("a.log", early + flight), folder.write("a.switches", recorded().switch_log));
    Played straight(files, without_index()), leaping(files);
    const double pause = static_cast<double>(first_second - 5);
    std::map<double, std::string> expected;
    for (const double t : {0.5, 100.0, 1e8, pause - 0.5, pause + 0.01, pause + 7.77, pause + 39}) expected[t] = straight.text(t);
    for (auto it = expected.rbegin(); it != expected.rend(); ++it) EXPECT_EQ(leaping.text(it->first), it->second) << it->first;
    EXPECT_THAT(expected[1e8], HasSubstr("unknown. by none"));
    EXPECT_THAT(expected[pause + 39], HasSubstr("takeoff."));
}

TEST(FlightPlayer, OtherSwitchesFromAnInstantOnPlayAsIfTheyHadBeenRecorded) {
    const TemporaryFolder folder;
    const std::string log = folder.write("a.log", first_seconds(60));
    const PlayerFiles files = files_of(log, folder.write("a.switches", recorded().switch_log));
    Played changed(files);
    const base::Time press = changed.player.first() + Duration::seconds(20);
    std::vector<bus::SwitchEdge> kept;
    for (const bus::SwitchEdge& edge : changed.player.switch_edges())
        if (edge.time <= press) kept.push_back(edge);
    const bus::SwitchEdge up{press + Duration::milliseconds(10), 0, false}, down{press + Duration::milliseconds(30), 3, true};
    static_cast<void>(changed.text(59));
    changed.player.replace_switches_after(press, {up, down});
    kept.insert(kept.end(), {up, down});
    std::string text(bus::kSwitchLogHeader);
    for (const bus::SwitchEdge& edge : kept) {
        char line[bus::kMaxSwitchLogLine];
        text.append(line, bus::format_switch_log_line(edge, changed.player.switch_config(), {line, sizeof line}));
    }
    Played as_recorded(files_of(log, folder.write("b.switches", text)), without_index());
    for (const double t : {19.9, 20.02, 25.0, 59.0, 21.0}) EXPECT_EQ(changed.text(t), as_recorded.text(t)) << t;
}

TEST(FlightPlayer, SaysWhenTheLogCannotBeReadToItsEnd) {
    const TemporaryFolder folder;
    const std::string text = first_seconds(120);
    ASSERT_GT(text.size(), 3u << 20) << "more than the player holds at a time";
    const PlayerFiles files = files_of(folder.write("a.log", text));
    Played played(files);
    static_cast<void>(played.text(1));
    std::filesystem::resize_file(files.log, text.size() / 2);
    test_support::expect_user_error([&] { static_cast<void>(played.text(119)); }, "cannot be read beyond byte");
}

TEST(FlightPlayer, CtrlCWhileIndexingLeavesNothing) {
    const TemporaryFolder folder;
    const PlayerFiles files = files_of(folder.write("a.log", first_seconds(20)));
    struct Interrupter : std::stringbuf {
        int sync() override {
            std::raise(SIGINT);
            return 0;
        }
    } interrupter;
    std::ostringstream results;
    std::ostream notes(&interrupter);
    Console console(results, notes, false, true);
    display::Display display;
    EXPECT_THROW(FlightPlayer(files, display, &console, dense()), Interrupted);
    EXPECT_EQ(folder.entries(), 1u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_flight_player
