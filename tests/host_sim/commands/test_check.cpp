#include "host_sim/commands/check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "host_sim/commands/scene.hpp"
#include "host_sim/commands/terrain.hpp"
#include "host_sim/input_file.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/raster_file.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_check {
namespace {

using test_support::CommandRun;
using test_support::run_command;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kConfigs = test_support::source_dir() + "/configs/";

CommandRun check(const std::vector<std::string>& files, bool json = false, bool strict = false) {
    CheckOptions options;
    options.files = files;
    options.strict = strict;
    return run_command([&](Console& console) { return run_check(options, console); }, json);
}

TEST(CheckCommand, EveryShippedFileIsSound) {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kConfigs))
        if (entry.path().extension() == ".toml" && entry.path().parent_path().filename() != "boards")
            files.push_back(entry.path().string());
    ASSERT_GT(files.size(), 10u);
    const CommandRun run = check(files, true);
    EXPECT_EQ(run.code, 0) << run.notes;
    EXPECT_EQ(run.json().size(), files.size());
    EXPECT_EQ(run.notes, "");
}

TEST(CheckCommand, AConfigAnywhereIsKnownByWhatItHolds) {
    const test_support::TemporaryFolder place;
    for (const auto& [shipped, kind] : {std::pair{"designs/cruise.toml", "a design"},
                                        std::pair{"flight_tests/switch_phases.toml", "a flight test of 6 expectations"},
                                        {"palettes/slope.toml", "a palette of 6 colours"},
                                        {"palettes/symbology/standard.toml", "a palette of the symbology"},
                                        {"devices/es3-mid.toml", "a device"},
                                        {"aircraft/jet.toml", "an aircraft"},
                                        {"buses/canaerospace.toml", "a bus"},
                                        {"switches/one_hot.toml", "a switch panel"},
                                        {"scenarios/default.toml", "a scenario of 16 legs"},
                                        {"sheets/terrain-styles.toml", "a contact sheet of "},
                                        {"orderings/thesis.toml", "9 orderings of pictures"},
                                        {"contracts/default.toml", "a contract of 13 conditions"}}) {
        const std::string path = place.write("x.toml", read_file(kConfigs + shipped));
        EXPECT_THAT(check({path}).results, HasSubstr(kind)) << shipped;
    }
    const std::string by_phase = place.write("x.toml", "name = 'x'\n[phases]\nlunch = 'cruise'\n");
    EXPECT_THAT(check({by_phase}).notes, HasSubstr(by_phase + ":3: 'lunch' is no phase"));
}

TEST(CheckCommand, APaletteOfTheSymbologyWithTwoRolesAlikeIsRefused) {
    const test_support::TemporaryFolder place;
    std::string text = read_file(kConfigs + "palettes/symbology/standard.toml");
    const std::string selected = "selected = \"#00e0ff\"";
    text.replace(text.find(selected), selected.size(), "selected = \"#40f060\"");
    const std::string path = place.write("x.toml", text);
    const CommandRun run = check({path});
    EXPECT_EQ(run.code, kFaultyInputExitCode);
    EXPECT_THAT(run.notes, HasSubstr(path + ": engaged and selected in normal vision by day differ by 0.00 (CIEDE2000)"));
}

TEST(CheckCommand, APaletteOfTheSymbologyWithoutNightIsKnownInAnyFolder) {
    const test_support::TemporaryFolder place;
    const std::string text = read_file(kConfigs + "palettes/symbology/standard.toml");
    const std::size_t night = text.find("[night]");
    const std::string day = text.substr(0, night), rest = text.substr(text.find("\n[", night) + 1);
    std::filesystem::create_directories(place.file("palettes"));
    for (const char* name : {"x.toml", "palettes/x.toml"}) {
        const std::string path = place.write(name, day + rest);
        EXPECT_THAT(check({path}).notes, HasSubstr("'night' is missing")) << name;
        EXPECT_EQ(check({place.write(name, text)}).code, 0) << name;
    }
    const std::string terrain = place.write("palettes/grey.toml", read_file(kConfigs + "palettes/grey.toml"));
    EXPECT_THAT(check({terrain}).results, HasSubstr("a palette of ")) << "the control";
    EXPECT_THAT(check({place.write("x.toml", "a = 1\n")}).notes, HasSubstr("palettes, palettes/symbology, devices"));
}

TEST(CheckCommand, ADesignIsPrintedWithWhatItInherits) {
    const auto resolved = [](const std::vector<std::string>& files, bool json = false) {
        CheckOptions options;
        options.files = files;
        options.resolved = true;
        return run_command([&](Console& console) { return run_check(options, console); }, json);
    };
    const test_support::TemporaryFolder place;
    const std::string design = place.write("x.toml", "name = 'own'\nbased_on = 'approach'\n[sky]\nhaze_distance_m = 1000\n");
    const CommandRun run = resolved({design});
    EXPECT_EQ(run.code, 0) << run.notes;
    EXPECT_THAT(run.results, HasSubstr("name = \"own\"\n"));
    EXPECT_THAT(run.results, HasSubstr("\n[sky]\n"));
    EXPECT_THAT(run.results, HasSubstr("haze_distance_m = 1000\n"));
    EXPECT_THAT(run.results, HasSubstr("horizontal_accuracy_m = 30\n"));
    const std::string again = place.write("again.toml", run.results);
    EXPECT_EQ(resolved({again}).results, run.results);
    EXPECT_EQ(resolved({design}, true).json()[0]["resolved"]["sky"]["haze_distance_m"], 1000);
    EXPECT_EQ(resolved({"approach"}, true).json()[0]["resolved"]["name"], "approach") << "a shipped name";
    EXPECT_THAT(check({design}).results, HasSubstr("sound, a design")) << "known by what it holds";
    test_support::expect_user_error([&] { static_cast<void>(resolved({design, again})); }, "name one file");
    test_support::expect_user_error([&] { static_cast<void>(resolved({kConfigs + "palettes/grey.toml"})); }, "is no design");
    place.write("x.toml", "name = 'own'\nbased_on = 'x.toml'\n");
    test_support::expect_user_error([&] { static_cast<void>(resolved({design})); }, "x.toml:2: 'based_on' names a design");
}

TEST(CheckCommand, PalettesAreJudgedAloneAndInTheirDesign) {
    const test_support::TemporaryFolder place;
    std::string text = read_file(kConfigs + "palettes/alpine.toml");
    text.replace(text.find("#54645a"), 7, "#4f6a44");
    const std::string palette = place.write("green.toml", text);
    const CommandRun alone = check({palette});
    EXPECT_EQ(alone.code, 2);
    EXPECT_THAT(alone.notes, HasSubstr(palette + ": its colour #"));
    EXPECT_THAT(alone.notes, HasSubstr("the warning band from -1000.0 ft"));
    const std::string head = "name = 'own'\n[view]\n[terrain]\npalette = 'green.toml'\n";
    const std::string design = place.write("own.toml", head);
    const CommandRun run = check({design});
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.notes, HasSubstr(design + ": palette alpine: its colour #"));
    place.write("own.toml", head + "[warning]\nenabled = false\n");
    EXPECT_EQ(check({design}).code, 0) << "no band is displayed with it";
    place.write("own.toml", "name = 'own'\n[view]\n[terrain.shade]\nambient = 0.02\n");
    EXPECT_THAT(check({design}).notes, HasSubstr("in 2.0 % of the light stop "));
}

TEST(CheckCommand, ScenesAreMadeAndTheirDatabasesRead) {
    const test_support::TemporaryFolder place;
    place.write("masts.csv", "lon,lat,height\n9.8,46.8,40\n");
    const std::string text =
        "name = 's'\n[[layer]]\nname = 'masts'\nsource = 'masts.csv'\nrole = 'obstacle'\n[[layer.attribute]]\nname = 'height'\n";
    const std::string scene = place.write("s.toml", text), database = place.file("s.sdb");
    EXPECT_THAT(check({scene}).results, HasSubstr("s.toml: sound, a scene of 1 layers"));
    EXPECT_EQ(place.entries(), 2u) << "nothing is written";
    (void)run_command([&](Console& console) { return run_scene_build({scene, database}, console); });
    EXPECT_THAT(check({database}).results, HasSubstr("sound, a scene database of 1 layers, revision 1, every checksum right"));
    const CommandRun misspelt = check({place.write("t.toml", text + "variable = 'hight'\n")});
    EXPECT_EQ(misspelt.code, 2);
    EXPECT_THAT(misspelt.notes, HasSubstr("masts: 'hight' is not in masts.csv"));
    place.write("s.sdb", place.read("s.sdb").substr(0, 700));
    EXPECT_THAT(check({database}).notes, HasSubstr("s.sdb: is not as long as its header says"));
}

TEST(CheckCommand, LogsAreCountedAndTheirBrokenLinesNamed) {
    const test_support::TemporaryFolder place;
    const std::string log = place.write("x.log", "(1.000000) can0 123#11\n(1.500000) can0 12\nprose\n(2.000000) can0 124#22\n");
    const CommandRun run = check({log});
    EXPECT_EQ(run.code, 0);
    EXPECT_THAT(run.results,
                HasSubstr("x.log: sound, a candump log of 2 frames, of which the bus canaerospace decodes 0, 1 line that "
                          "does not begin with '(', but: 1 broken line (the first: line 2, "));
    EXPECT_THAT(run.results, HasSubstr("; none of 2 frames can be decoded by the bus canaerospace"));
    const std::string panel = place.write("x.switches", "words\n");
    EXPECT_THAT(check({panel}).notes, HasSubstr("x.switches:1: not a switch log"));
}

TEST(CheckCommand, FindingsStandBesideTheFileAndFailWhereItIsStrict) {
    const test_support::TemporaryFolder place;
    const std::string car = place.write("car.log", "(1.000000) can0 1F5#01000020000100FE\n");
    const std::string sound = kConfigs + "devices/es2-small.toml";
    EXPECT_EQ(check({car}).code, 0);
    EXPECT_EQ(check({car}, false, true).code, 1);
    EXPECT_EQ(check({sound}, false, true).code, 0) << "the control";
    EXPECT_EQ(check({car, place.file("none.toml")}, false, true).code, 2) << "what is unsound weighs more";
    const auto json = check({sound, car}, true).json();
    EXPECT_TRUE(json[0]["warnings"].empty());
    ASSERT_EQ(json[1]["warnings"].size(), 1u);
    EXPECT_EQ(json[1]["warnings"][0]["name"], "bus.nothing_decoded");
    EXPECT_EQ(json[1]["sound"], true);
}

TEST(CheckCommand, CompressedFilesThatAreNoLogsAreRefused) {
    const test_support::TemporaryFolder place;
    for (const char* text : {"", "It was a dark and stormy night.\n", "\x1f\x8b\x08"}) {
        const CommandRun run = check({place.write("x.log.gz", text)}, false, true);
        EXPECT_EQ(run.code, 2);
        EXPECT_THAT(run.notes, HasSubstr("x.log.gz: "));
        EXPECT_EQ(std::count(run.notes.begin(), run.notes.end(), '\n'), 1);
    }
    const CommandRun folder = check({place.path()});
    EXPECT_EQ(folder.code, 2);
    EXPECT_THAT(folder.notes, HasSubstr("is a folder; name a file"));
}

TEST(CheckCommand, DatabasesAreReadToTheirLastByte) {
    const test_support::TemporaryFolder place;
    TerrainBuildOptions options;
    options.rasters = {test_support::RasterFile().write(place.file("r.tif"))};
    options.output = place.file("t.tdb");
    (void)run_command([&](Console& console) { return run_terrain_build(options, console); });
    EXPECT_EQ(check({options.output}).code, 0);
    std::string bytes = place.read("t.tdb");
    bytes.back() = static_cast<char>(bytes.back() ^ 1);
    place.write("t.tdb", bytes);
    const CommandRun run = check({options.output});
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.notes, HasSubstr("t.tdb: has a damaged chunk (offset "));
}

TEST(CheckCommand, RastersAreReadAndForeignFilesAreKnown) {
    const test_support::TemporaryFolder place;
    const CommandRun shipped = check({kConfigs + "data/jacksboro_srtm3.tif"});
    EXPECT_EQ(shipped.code, 0) << shipped.notes;
    EXPECT_THAT(shipped.results, HasSubstr("sound, a height raster of "));
    const std::string raster = test_support::RasterFile().write(place.file("r.TIF"));
    EXPECT_EQ(check({raster}).code, 0);
    const std::string bytes = place.read("r.TIF");
    EXPECT_THAT(check({place.write("short.tif", bytes.substr(0, bytes.size() / 2))}).notes, HasSubstr("short.tif: "));
    EXPECT_THAT(check({kConfigs + "buses/canaerospace.dbc"}).notes, HasSubstr("a CAN database for other tools"));
}

TEST(CheckCommand, AConfigurationIsReadWithAllThatItNames) {
    const test_support::TemporaryFolder place;
    const std::string desk = test_support::source_dir() + "/target/boards/desk_vcan.toml";
    const CommandRun elsewhere = check({place.write("vcan.toml", read_file(desk))});
    EXPECT_EQ(elsewhere.code, 2) << "its neighbours are not there";
    EXPECT_THAT(elsewhere.notes, HasSubstr(place.path()));
    const std::string board = test_support::source_dir() + "/target/boards/arm_board.toml";
    EXPECT_THAT(check({board}).notes, HasSubstr("es2-small.toml"));
    EXPECT_THAT(check({board}).notes, HasSubstr("is tested there: tedavis-display --self-test --config " + board));
}

TEST(CheckCommand, ASceneOfAConfigurationMayComeLater) {
    const test_support::TemporaryFolder place;
    const auto checked = [&](const std::string& tables) {
        return check(
            {place.write("board.toml", "device = '" + kConfigs + "devices/es2-small.toml'\ndesign = '" + kConfigs +
                                           "designs/default.toml'\npalettes = '" + kConfigs + "palettes'\nbus = '" + kConfigs +
                                           "buses/canaerospace.toml'\n[can]\ninterface = 'can9'\n" + tables)});
    };
    EXPECT_THAT(checked("").results, HasSubstr("a configuration of desk and board, which names "));
    const CommandRun later = checked("[scene]\ndatabase = 'area.sdb'\n");
    EXPECT_EQ(later.code, 0) << later.notes;
    EXPECT_THAT(later.results, HasSubstr("and a scene that is not there yet"));
    EXPECT_EQ(checked("[terrain]\ndatabase = 'area.tdb'\n").code, 2) << "control";
    place.write("area.sdb", "no scene");
    EXPECT_EQ(checked("[scene]\ndatabase = 'area.sdb'\n").code, 2) << "control";
}

/// What a start refuses, a check refuses with the same words.
TEST(CheckCommand, ADeviceMustStartWithItsDesign) {
    const test_support::TemporaryFolder place;
    const std::string shipped = read_file(kConfigs + "devices/es2-small.toml");
    const auto with_line = [&](const std::string& name, const std::string& bytes) {
        std::string text = shipped;
        const std::size_t line = text.find("bytes = ", text.find("name = \"" + name + "\""));
        text.replace(line, text.find('\n', line) - line, "bytes = " + bytes);
        return place.write("small.toml", text);
    };
    const std::string small = with_line("lod_scratch", "4096");
    const CommandRun alone = check({small});
    EXPECT_EQ(alone.code, 2);
    EXPECT_THAT(alone.notes,
                StartsWith(small + ": does not start with the design default: the budget line 'lod_scratch' has 1120 of 4096 "
                                   "bytes left and "));
    EXPECT_THAT(alone.notes, EndsWith(" are needed for max_chunk_slots; raise the line in the device file\n"));
    EXPECT_THAT(check({with_line("render_targets", "4096")}).notes, HasSubstr("the budget line 'render_targets'"));
    const std::string plain = place.write("plain.toml", "name = 'plain'\n[view]\n");
    const std::string enough = with_line("scene_glyphs", "4096");
    EXPECT_EQ(check({enough}).code, 2) << "the default design shows data";
    EXPECT_EQ(check({enough, plain}).code, 0) << "with the design that it is meant for it starts";
    EXPECT_EQ(check({plain, enough}).code, 0) << "in whatever order";
    EXPECT_EQ(check({enough, plain, kConfigs + "designs/default.toml"}).code, 2) << "every design that is named";
}

TEST(CheckCommand, LooksAtEveryFileAndIsTwoWhenOneIsUnsound) {
    const test_support::TemporaryFolder place;
    const std::string sound = kConfigs + "devices/es2-small.toml", none = place.file("none.toml"), odd = place.write("x.xyz", "");
    const CommandRun text = check({none, sound, odd});
    EXPECT_EQ(text.code, 2);
    EXPECT_THAT(text.results, HasSubstr("es2-small.toml: sound, a device"));
    EXPECT_EQ(std::count(text.notes.begin(), text.notes.end(), '\n'), 2);
    EXPECT_THAT(text.notes, HasSubstr("none.toml: no such file"));
    EXPECT_THAT(text.notes, HasSubstr("'.xyz' is no kind of file that is checked here"));
    const auto json = check({none, sound}, true).json();
    EXPECT_EQ(json[0]["sound"], false);
    EXPECT_THAT(json[0]["fault"].get<std::string>(), HasSubstr("no such file"));
    EXPECT_EQ(json[1]["sound"], true);
    EXPECT_EQ(json[1]["is"], "a device");
}

}  // namespace
}  // namespace tedavis::host_sim::test_check
