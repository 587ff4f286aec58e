#include "host_sim/commands/pack.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <tuple>

#include "host_sim/commands/command_line.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/png_file.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "host_sim/scene_builder/sdb_writer.hpp"
#include "tests/host_sim/pack/configured_flight.hpp"
#include "tests/support/flights/frame_lines.hpp"
#include "tests/support/scene/scene_drafts.hpp"

namespace tedavis::host_sim::test_pack {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

struct Ran {
    int code = -1;
    std::string results, notes;
};
Ran tedavis(std::vector<std::string> words) {
    words.insert(words.begin(), "tedavis");
    std::vector<const char*> pointers;
    for (const std::string& word : words) pointers.push_back(word.c_str());
    std::ostringstream results, told;
    const int code = run_command_line(static_cast<int>(pointers.size()), pointers.data(), results, told, false);
    return {code, results.str(), told.str()};
}

struct PackCommand : testing::Test {
    [[nodiscard]] std::string place(const char* name) const { return flight.files.folder.file(name); }
    void pack(std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"pack", flight.config, "-o", place("pack")});
        const Ran ran = tedavis(more);
        ASSERT_EQ(ran.code, 0) << ran.notes;
    }
    Ran fly(const std::string& config, const char* output, std::vector<std::string> more = {},
            const char* frames = "hash") const {
        more.insert(more.begin(), {"replay", flight.files.log, "--config", config, "-o", place(output), "--from", "1", "--to",
                                   "4", "--step", "0.75", "--frames", frames});
        return tedavis(more);
    }
    ConfiguredFlight flight;
};

TEST_F(PackCommand, AReplayFromItHasTheSameHashesWhereverItLies) {
    pack();
    ASSERT_EQ(fly(flight.config, "plain").code, 0);
    fs::create_directory(place("away"));
    fs::rename(place("pack"), place("away/moved"));
    fs::rename(place("terrain.tdb"), place("away/terrain.tdb"));
    const Ran from_pack = fly(place("away/moved"), "packed");
    ASSERT_EQ(from_pack.code, 0) << from_pack.notes;
    EXPECT_EQ(test_support::hashes_by_time(place("plain")).size(), 5u);
    EXPECT_EQ(test_support::hashes_by_time(place("plain")), test_support::hashes_by_time(place("packed")));
    EXPECT_NE(fly(flight.config, "without").code, 0) << "control: the plain configuration needs its terrain";
}

TEST_F(PackCommand, AChangedByteOfEachFileIsFoundAtTheStart) {
    pack();
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(place("pack"))) {
        if (!entry.is_regular_file() || entry.path().filename() == "pack.toml") continue;
        ++files;
        const std::string path = entry.path().string(), sound = read_file(path);
        std::string changed = sound;
        changed[changed.size() / 2] = static_cast<char>(changed[changed.size() / 2] ^ 1);
        std::ofstream(path, std::ios::binary) << changed;
        const Ran ran = fly(place("pack"), "run");
        EXPECT_EQ(ran.code, 2);
        EXPECT_THAT(ran.notes, HasSubstr(path + ": was changed after packing"));
        EXPECT_FALSE(fs::exists(place("run")));
        std::ofstream(path, std::ios::binary) << sound;
    }
    EXPECT_GE(files, 8u);
    EXPECT_EQ(fly(place("pack"), "run").code, 0) << "control";
}

TEST_F(PackCommand, ItSaysWhatItMadeAndCheckKnowsIt) {
    const Ran ran = tedavis({"pack", flight.config, "-o", place("pack"), "--json", "--valid-until", "2026-12-28"});
    ASSERT_EQ(ran.code, 0) << ran.notes;
    const auto json = nlohmann::json::parse(ran.results);
    EXPECT_EQ(json.at("title"), "a board");
    EXPECT_EQ(json.at("valid_until"), "2026-12-28");
    EXPECT_EQ(json.at("signed"), false);
    EXPECT_THAT(tedavis({"check", place("pack")}).results, HasSubstr("a pack of " + std::to_string(json.at("files").get<int>())));
    EXPECT_THAT(tedavis({"check", flight.config}).results, HasSubstr("a configuration of desk and board"));
    const Ran again = tedavis({"pack", place("pack"), "-o", place("again")});
    EXPECT_EQ(again.code, 0) << again.notes << "a pack of a pack";
    EXPECT_EQ(read_file(place("again/config.toml")), read_file(place("pack/config.toml")));
}

TEST_F(PackCommand, OneThatNoBoardStartsFromSaysSo) {
    EXPECT_THAT(tedavis({"pack", flight.config, "-o", place("pack")}).notes, Not(HasSubstr("[can]"))) << "control";
    const std::string text = read_file(flight.config), can = "[can]\ninterface = 'can9'\n";
    std::string without = text;
    without.replace(text.find(can), can.size(), "");
    flight.files.folder.write("desk.toml", without);
    const Ran ran = tedavis({"pack", place("desk.toml"), "-o", place("desk")});
    EXPECT_EQ(ran.code, 0) << ran.notes;
    EXPECT_THAT(ran.notes, HasSubstr("has no [can], so no board starts from this pack"));
}

/// The instants and ghosts of a file are those of its own log.
TEST_F(PackCommand, ALogBesideAConfigurationIsShownWhole) {
    static_cast<void>(flight.write("[replay]\nlog = 'flight.log'\nfrom_s = 1\nto_s = 2\nghosts = ['flight.log']\n"));
    const auto frames_of = [&](std::vector<std::string> words, const char* output) {
        words.insert(words.end(), {"--config", flight.config, "-o", place(output), "--frames", "none", "--step", "0.5"});
        const Ran ran = tedavis(words);
        EXPECT_EQ(ran.code, 0) << ran.notes;
        return test_support::summary_of(place(output)).at("frames").get<int>();
    };
    EXPECT_EQ(frames_of({"replay"}, "own"), 3);
    EXPECT_GT(frames_of({"replay", flight.files.log}, "beside"), 3);
}

TEST_F(PackCommand, WrongUsageIsASentence) {
    for (const auto& [words, says] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"--valid-until", "2026-02-30"}, "--valid-until 2026-02-30: is no day"},
             {{"--valid-from", "2026-03-02", "--valid-until", "2026-03-01"}, "lies before --valid-from"},
             {{"--sign", "/nowhere.sec"}, "/nowhere.sec"}}) {
        std::vector<std::string> all = {"pack", flight.config, "-o", place("pack")};
        all.insert(all.end(), words.begin(), words.end());
        const Ran ran = tedavis(all);
        EXPECT_EQ(ran.code, 2);
        EXPECT_THAT(ran.notes, HasSubstr(says));
        EXPECT_FALSE(fs::exists(place("pack")));
    }
}

/// The layers of the scene are valid from 2024-10-04 to 2024-11-13.
TEST_F(PackCommand, DatesThatLeaveNoValidDayAreRefused) {
    constexpr std::int64_t kDay_ns = 86'400'000'000'000;
    SceneDraft draft = test_support::small_scene();
    for (auto& layer : draft.layers) {
        layer.valid_from_ns = 20'000 * kDay_ns;
        layer.valid_until_ns = 20'040 * kDay_ns;
    }
    const std::vector<unsigned char> bytes = sdb_bytes(draft);
    flight.files.folder.write("area.sdb", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    static_cast<void>(flight.write("[scene]\ndatabase = 'area.sdb'\n"));
    for (const auto& [option, day, says] :
         {std::tuple{"--valid-from", "2024-11-14", "lies after the last day of the packed scene/area.sdb (2024-11-13)"},
          std::tuple{"--valid-until", "2024-10-03", "lies before the first day of the packed scene/area.sdb (2024-10-04)"}}) {
        const Ran ran = tedavis({"pack", flight.config, "-o", place("pack"), option, day});
        EXPECT_EQ(ran.code, 2);
        EXPECT_THAT(ran.notes, HasSubstr(says));
        EXPECT_FALSE(fs::exists(place("pack")));
    }
    EXPECT_EQ(tedavis({"pack", flight.config, "-o", place("pack"), "--valid-from", "2024-11-13"}).code, 0) << "control";
}

/// The flight is of 2023-11-14.
TEST_F(PackCommand, WhatIsOutOfDateIsSaidAtTheStartAndInTheSummary) {
    pack({"--valid-until", "2023-11-13"});
    const Ran late = fly(place("pack"), "late");
    EXPECT_EQ(late.code, 0);
    EXPECT_THAT(late.notes, HasSubstr("was valid until 2023-11-13, and this is 2023-11-14"));
    EXPECT_THAT(test_support::summary_of(place("late")).at("notes").dump(), HasSubstr("was valid until 2023-11-13"));
    pack({"--replace", "--valid-from", "2023-11-14", "--valid-until", "2023-11-14"});
    const Ran now = fly(place("pack"), "now");
    EXPECT_THAT(now.notes, Not(HasSubstr("valid")));
    EXPECT_THAT(test_support::summary_of(place("now")).at("notes").dump(), Not(HasSubstr("valid")));
}

/// In how many frames of a run the flag stands.
std::size_t frames_out_of_date(const std::string& run) {
    std::size_t count = 0;
    for (const nlohmann::json& line : test_support::frame_lines(run))
        for (const nlohmann::json& flag : line.at("flags")) count += flag == "database.out_of_date" ? 1 : 0;
    return count;
}

/// By rows from the top: whether two pictures differ in each.
std::vector<bool> differing_rows(const std::string& one, const std::string& other) {
    const RgbaPicture a = read_png(one), b = read_png(other);
    std::vector<bool> rows(a.height);
    if (a.pixels.size() != b.pixels.size()) return rows;
    for (std::size_t n = 0; n < a.pixels.size(); ++n)
        if (a.pixels[n] != b.pixels[n]) rows[n / (std::size_t{4} * a.width)] = true;
    return rows;
}

/// One pack, and the same flight on its last day and on the day after it.
TEST_F(PackCommand, WhatIsOutOfDateIsSaidInEachFrameAndOnThePictureAndADayEarlierItIsNot) {
    constexpr std::int64_t kDay_s = 86'400;
    const auto fly_on = [&](const std::string& config, std::int64_t days, const char* output) {
        flight.files.folder.write("flight.log", test_support::log_of(test_support::FlownLater(days * kDay_s)));
        const Ran ran = fly(config, output, {}, "png");
        EXPECT_EQ(ran.code, 0) << ran.notes;
    };
    pack({"--valid-until", "2023-11-14"});
    fly_on(place("pack"), 0, "last_day");
    fly_on(flight.config, 0, "undated_last_day");
    fly_on(place("pack"), 1, "day_after");
    fly_on(flight.config, 1, "undated");
    EXPECT_EQ(frames_out_of_date(place("last_day")), 0u);
    EXPECT_EQ(frames_out_of_date(place("day_after")), 5u);
    EXPECT_EQ(frames_out_of_date(place("undated")), 0u) << "control: no pack";
    EXPECT_EQ(test_support::hashes_by_time(place("last_day")), test_support::hashes_by_time(place("undated_last_day")));
    const auto frame = test_support::frame_lines(place("undated")).front().at("frame").get<std::uint64_t>();
    const std::vector<bool> rows =
        differing_rows(frame_picture_path(place("day_after"), frame), frame_picture_path(place("undated"), frame));
    const std::size_t strip = rows.size() / 8;
    EXPECT_TRUE(
        std::any_of(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(strip), [](bool differs) { return differs; }));
    EXPECT_TRUE(std::none_of(rows.begin() + static_cast<std::ptrdiff_t>(strip), rows.end(), [](bool differs) { return differs; }))
        << "the notice stands in the strip, and nothing else changes";
    pack({"--replace", "--valid-from", "2023-11-16"});
    fly_on(place("pack"), 1, "too_early");
    EXPECT_EQ(frames_out_of_date(place("too_early")), 5u);
}

TEST_F(PackCommand, WhereAKeyIsNamedAnUnsignedPackIsRefused) {
    const std::string make = "minisign -G -W -p " + place("k.pub") + " -s " + place("k.sec") + " >/dev/null";
    ASSERT_EQ(std::system(make.c_str()), 0);
    pack();
    const Ran refused = fly(place("pack"), "run", {"--pack-key", place("k.pub")});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.notes, HasSubstr("pack.toml: is not signed"));
    pack({"--replace", "--sign", place("k.sec")});
    EXPECT_EQ(fly(place("pack"), "run", {"--pack-key", place("k.pub")}).code, 0);
    const Ran no_pack = fly(flight.config, "plain", {"--pack-key", place("k.pub")});
    EXPECT_EQ(no_pack.code, 2);
    EXPECT_THAT(no_pack.notes, HasSubstr("is of no pack, so that no signature would be asked for"));
    EXPECT_EQ(fly(flight.config, "plain").code, 0) << "control";
    EXPECT_EQ(tedavis({"replay", flight.files.log, "-o", place("none"), "--pack-key", place("k.pub")}).code, 2)
        << "nor is there a configuration";
}

}  // namespace
}  // namespace tedavis::host_sim::test_pack
