// The real program against files that are missing, cut, of another kind or full of nonsense: one sentence on stderr that
// names the file (a scenario's faults are a sentence each), exit code 2, nothing left behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <optional>
#include <random>
#include <regex>
#include <sstream>

#include "tests/support/programs/program_samples.hpp"
#include "tests/support/programs/running_program.hpp"
#include "tests/support/programs/virtual_screen.hpp"

namespace tedavis::tests::test_bad_input {
namespace {

using test_support::ProgramResult;
using test_support::ProgramSamples;
using test_support::ProgramSetting;
using ::testing::HasSubstr;
using ::testing::Not;

enum class Fault { missing, folder, empty, truncated, wrong_kind, noise };
constexpr Fault kFaults[] = {Fault::missing, Fault::folder, Fault::empty, Fault::truncated, Fault::wrong_kind, Fault::noise};
constexpr int kInterrupted = 130;
constexpr const char* kFaultNames[] = {"missing", "folder", "empty", "truncated", "wrong_kind", "noise"};

/// A place of a command line that takes a file. In `words`, @IN stands for that file, @OUT for an empty folder, and
/// @NAME for the sample of that name.
struct Slot {
    const char* name;
    std::vector<std::string> words;
    const char* sample;  ///< a sound file for the place
    const char* other;   ///< a sound file of another kind
    bool cut_is_found;   ///< a record by itself is whole in some formats, so that half a file is a shorter one
    bool empty_is_sound = false;
    bool in_window = false;  ///< on a screen in memory; it runs until it is interrupted
    std::size_t most_sentences = 1;
};

const std::vector<Slot>& slots() {
    static const std::vector<std::string> kShot = {"shot", "--pose",    "46.98,10.02,3500,0,0,0", "--size", "64x48",
                                                   "-o",   "@OUT/x.png"};
    static const std::vector<std::string> kReplay = {"replay", "--frames", "none", "--size",  "64x48",
                                                     "--to",   "1",        "-o",   "@OUT/run"};
    const auto with = [](std::vector<std::string> words, const std::vector<std::string>& more) {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    static const std::vector<Slot> table = {
        {"convert_igc", {"convert", "@IN", "-o", "@OUT/x.log"}, "flight.igc", "terrain.tdb", false},
        {"convert_gpx", {"convert", "@IN", "-o", "@OUT/x.log"}, "flight.gpx", "terrain.tdb", true},
        {"convert_json", {"convert", "@IN", "-o", "@OUT/x.log"}, "flight.json", "design.toml", true},
        {"convert_csv", {"convert", "@IN", "-o", "@OUT/x.log"}, "flight.csv", "raster.tif", false},
        {"convert_packed", {"convert", "@IN", "-o", "@OUT/x.log"}, "flight.csv.gz", "run.log", true},
        {"scenario", {"scenario", "build", "@IN", "-o", "@OUT/run"}, "scenario.toml", "device.toml", true, false, false, 10},
        {"scene_build", {"scene", "build", "@IN", "-o", "@OUT/x.sdb"}, "scene.toml", "device.toml", true},
        {"scene_info", {"scene", "info", "@IN"}, "scene.sdb", "terrain.tdb", true},
        {"terrain_build", {"terrain", "build", "@IN", "-o", "@OUT/x.tdb"}, "raster.tif", "flight.igc", true},
        {"terrain_build_drape",
         {"terrain", "build", "@raster.tif", "--drape", "@IN", "--drape-extent", "9.99,46.9,10.1,47.1", "-o", "@OUT/x.tdb"},
         "image.ppm",
         "flight.igc",
         true},
        {"terrain_check_database", {"terrain", "check", "@IN", "@raster.tif"}, "terrain.tdb", "raster.tif", true},
        {"terrain_check_raster", {"terrain", "check", "@terrain.tdb", "@IN"}, "raster.tif", "terrain.tdb", true},
        {"terrain_info", {"terrain", "info", "@IN"}, "terrain.tdb", "raster.tif", true},
        {"shot_terrain", with(kShot, {"--terrain", "@IN"}), "terrain.tdb", "raster.tif", true},
        {"shot_design", with(kShot, {"--design", "@IN"}), "design.toml", "device.toml", true},
        {"shot_device", with(kShot, {"--device", "@IN"}), "device.toml", "design.toml", true},
        {"replay_log", with(kReplay, {"@IN"}), "run.log", "raster.tif", false},
        {"replay_switches", with(kReplay, {"@run.log", "--switches", "@IN"}), "run.switches", "raster.tif", false},
        {"replay_panel", with(kReplay, {"@run.log", "--switches", "@run.switches", "--switch-config", "@IN"}), "panel.toml",
         "device.toml", true},
        {"replay_terrain", with(kReplay, {"@run.log", "--terrain", "@IN"}), "terrain.tdb", "run.log", true},
        {"replay_design", with(kReplay, {"@run.log", "--design", "@IN"}), "design.toml", "device.toml", true},
        {"replay_device", with(kReplay, {"@run.log", "--device", "@IN"}), "device.toml", "panel.toml", true},
        {"replay_aircraft", with(kReplay, {"@run.log", "--aircraft", "@IN"}), "aircraft.toml", "device.toml", true},
        {"replay_bus", with(kReplay, {"@run.log", "--bus", "@IN"}), "bus.toml", "device.toml", true, true},
        {"replay_tour",
         {"replay", "@run.log", "--size", "64x48", "--window", "--tour", "@IN", "-o", "@OUT/run"},
         "tour.csv",
         "flight.csv",
         true,
         false,
         true},
        {"replay_config", {"replay", "--config", "@IN", "-o", "@OUT/run"}, "replay.toml", "design.toml", true},
        {"sheet",
         {"sheet", "@IN", "--size", "64x48", "--terrain", "@terrain.tdb", "-o", "@OUT/run"},
         "sheet.toml",
         "device.toml",
         true},
        {"check_design", {"check", "@IN"}, "design.toml", "terrain.tdb", true},
        {"check_device", {"check", "@IN"}, "device.toml", "terrain.tdb", true},
        {"check_aircraft", {"check", "@IN"}, "aircraft.toml", "terrain.tdb", true},
        {"check_palette", {"check", "@IN"}, "palette.toml", "terrain.tdb", true},
        {"check_bus", {"check", "@IN"}, "bus.toml", "terrain.tdb", true},
        {"check_panel", {"check", "@IN"}, "panel.toml", "terrain.tdb", true},
        {"check_scenario", {"check", "@IN"}, "scenario.toml", "terrain.tdb", true},
        {"check_scene", {"check", "@IN"}, "scene.toml", "terrain.tdb", true},
        {"check_scene_database", {"check", "@IN"}, "scene.sdb", "terrain.tdb", true},
        {"check_terrain", {"check", "@IN"}, "terrain.tdb", "run.log", true},
        {"check_log", {"check", "@IN"}, "run.log", "raster.tif", false},
        {"check_switches", {"check", "@IN"}, "run.switches", "run.log", false},
        {"evaluate_picture", {"evaluate", "@IN", "-o", "@OUT/e"}, "picture.png", "flight.igc", true},
        {"evaluate_gaze", {"evaluate", "@picture.png", "--fixations", "@IN", "-o", "@OUT/e"}, "gaze.csv", "raster.tif", false},
        {"diff_records", {"diff", "@FOLDER", "@run"}, "frames.jsonl", "flight.igc", true},
    };
    return table;
}

std::string noise() {
    std::mt19937 random(11);
    std::string bytes(5000, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    return bytes;
}

/// Settings end within a value: between two lines a cut file would be another sound one.
std::size_t length_of_cut(const std::string& name, const std::string& sound) {
    const std::size_t length = sound.size() * 6 / 10;
    return name.find(".toml") == std::string::npos ? length : sound.rfind('=', length) + 1;
}

/// A folder of its own with the faulty file in it, under the sample's own name.
class FaultyFile {
public:
    FaultyFile(const Slot& slot, Fault fault) : path_(folder_.file(slot.sample)) {
        const std::string sound = ProgramSamples::read(slot.sample);
        switch (fault) {
            case Fault::missing: break;
            case Fault::folder: std::filesystem::create_directory(path_); break;
            case Fault::empty: folder_.write(slot.sample, ""); break;
            case Fault::truncated: folder_.write(slot.sample, sound.substr(0, length_of_cut(slot.sample, sound))); break;
            case Fault::wrong_kind: folder_.write(slot.sample, ProgramSamples::read(slot.other)); break;
            case Fault::noise: folder_.write(slot.sample, noise()); break;
        }
    }
    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] const std::string& folder() const { return folder_.path(); }

private:
    test_support::TemporaryFolder folder_;
    std::string path_;
};

std::string replaced(std::string word, const std::string& mark, const std::string& value) {
    const std::size_t at = word.find(mark);
    return at == std::string::npos ? word : word.replace(at, mark.size(), value);
}

std::vector<std::string> command_line(const std::vector<std::string>& words, const std::string& input,
                                      const std::string& input_folder, const std::string& output) {
    std::vector<std::string> line = {ProgramSamples::program()};
    for (std::string word : words) {
        word = replaced(replaced(replaced(word, "@IN", input), "@OUT", output), "@FOLDER", input_folder);
        if (word.front() == '@') word = ProgramSamples::path(word.substr(1));
        line.push_back(word);
    }
    return line;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += word + " ";
    return text;
}

/// Where a sentence tells its reader what to do: a verb after the semicolon, or the limits of an option.
bool says_what_to_do(const std::string& message) {
    static const std::regex remedy(
        "; (add|build|check|choose|correct|export|fetch|get|give|leave|make|mend|name|put|record|replay|see|use|write) "
        "|: must be |, such as ");
    return std::regex_search(message, remedy);
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream input(text);
    for (std::string line; std::getline(input, line);) lines.push_back(line);
    return lines;
}

/// One sentence that says where and what to do, up to `most` where a file's faults are said at once, and the code of wrong input.
void expect_refusal(const ProgramResult& result, const std::string& where, std::size_t most = 1) {
    EXPECT_EQ(result.signal, 0) << "it crashed";
    EXPECT_FALSE(result.hung);
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "");
    const auto sentences = lines_of(result.err);
    EXPECT_THAT(sentences.size(), ::testing::AllOf(::testing::Ge(1u), ::testing::Le(most))) << result.err;
    for (const std::string& sentence : sentences) {
        EXPECT_THAT(sentence, HasSubstr(where));
        EXPECT_THAT(sentence, Not(HasSubstr("please report")));
        EXPECT_TRUE(says_what_to_do(sentence)) << sentence;
        EXPECT_LT(sentence.size(), 1100u);
    }
}

class BadInput : public ::testing::TestWithParam<std::size_t> {
protected:
    BadInput() {
        if (slots()[GetParam()].in_window) screen_.emplace();
    }

    /// Runs the slot with a file and looks at what came of it.
    static void expect(const Slot& slot, Fault fault) {
        const FaultyFile input(slot, fault);
        const test_support::TemporaryFolder output;
        const auto words = command_line(slot.words, input.path(), input.folder(), output.path());
        SCOPED_TRACE(std::string(kFaultNames[static_cast<std::size_t>(fault)]) + ": " + joined(words));
        const ProgramResult result = test_support::run_program(words);
        if (fault == Fault::truncated && !slot.cut_is_found) {
            EXPECT_THAT(result.code, ::testing::AnyOf(0, 2)) << result.err;
            EXPECT_THAT(result.err, Not(HasSubstr("please report")));
            return;
        }
        expect_refusal(result, slot.sample, slot.most_sentences);
        EXPECT_EQ(output.entries(), 0u) << "something was left behind";
    }

private:
    std::optional<test_support::VirtualScreen> screen_;
};

TEST_P(BadInput, IsRefusedInOneSentence) {
    const Slot& slot = slots()[GetParam()];
    for (const Fault fault : kFaults)
        if (fault != Fault::empty || !slot.empty_is_sound) expect(slot, fault);
}

/// A control: the refusals prove nothing where a sound file is refused as well.
TEST_P(BadInput, WhileASoundFileIsTaken) {
    const Slot& slot = slots()[GetParam()];
    const test_support::TemporaryFolder output;
    const auto words = command_line(slot.words, ProgramSamples::path(slot.sample), ProgramSamples::path("run"), output.path());
    SCOPED_TRACE(joined(words));
    ProgramSetting setting;
    if (slot.in_window) {
        setting.signal = SIGINT;
        setting.signal_when = [&] { return output.entries() > 0; };
    }
    const ProgramResult result = test_support::run_program(words, setting);
    EXPECT_EQ(result.code, slot.in_window ? kInterrupted : 0) << result.err;
}

INSTANTIATE_TEST_SUITE_P(EveryCommand, BadInput, ::testing::Range(std::size_t{0}, slots().size()),
                         [](const auto& place) { return std::string(slots()[place.param].name); });

/// Words of commands that write, with @TARGET where the output is named.
struct Writer {
    const char* name;
    std::vector<std::string> words;
    bool writes_folder;
};

const std::vector<Writer>& writers() {
    static const std::vector<Writer> table = {
        {"convert", {"convert", "@flight.igc", "-o", "@TARGET"}, false},
        {"scenario", {"scenario", "build", "default", "-o", "@TARGET"}, true},
        {"scene_build", {"scene", "build", "@scene.toml", "-o", "@TARGET"}, false},
        {"terrain_build", {"terrain", "build", "@raster.tif", "-o", "@TARGET"}, false},
        {"terrain_fractal", {"terrain", "fractal", "--size", "65", "-o", "@TARGET"}, false},
        {"shot", {"shot", "--pose", "46.98,10.02,3500,0,0,0", "--size", "128x96", "-o", "@TARGET"}, false},
        {"replay", {"replay", "@run.log", "--frames", "hash", "--size", "64x48", "--to", "1", "-o", "@TARGET"}, true},
    };
    return table;
}

class Unwritable : public ::testing::TestWithParam<std::size_t> {
protected:
    void refuses(const std::string& target, const std::string& where, const ProgramSetting& setting = {}) {
        const Writer& writer = writers()[GetParam()];
        std::vector<std::string> words = writer.words;
        for (std::string& word : words) word = replaced(word, "@TARGET", target);
        const auto line = command_line(words, "", "", "");
        SCOPED_TRACE(joined(line));
        const std::size_t before = files_in(place_.path());
        expect_refusal(test_support::run_program(line, setting), where);
        EXPECT_EQ(files_in(place_.path()), before) << "something was left behind";
    }
    static std::size_t files_in(const std::string& folder) {
        const std::filesystem::recursive_directory_iterator everything(folder);
        return static_cast<std::size_t>(
            std::count_if(begin(everything), end(everything), [](const auto& entry) { return entry.is_regular_file(); }));
    }
    test_support::TemporaryFolder place_;
};

TEST_P(Unwritable, AFileStandsWhereAFolderShould) {
    place_.write("file", "mine");
    refuses(place_.file("file/x"), "file/x");
    EXPECT_EQ(place_.read("file"), "mine");
}

TEST_P(Unwritable, TheNameIsTakenByTheOtherKind) {
    if (writers()[GetParam()].writes_folder) {
        place_.write("taken", "mine");
        refuses(place_.file("taken"), "taken");
        EXPECT_EQ(place_.read("taken"), "mine");
    } else {
        std::filesystem::create_directory(place_.file("taken"));
        refuses(place_.file("taken"), "taken");
    }
}

TEST_P(Unwritable, TheFolderOfAFileMustBeThere) {
    if (writers()[GetParam()].writes_folder) {
        EXPECT_EQ(writers()[GetParam()].words.back(), "@TARGET") << "folders are made with their parents";
    } else {
        refuses(place_.file("none/x"), "none/x");
    }
}

TEST_P(Unwritable, TheDiskIsFull) {
    ProgramSetting setting;
    setting.largest_file = 512;
    refuses(place_.file("result"), "result", setting);
}

INSTANTIATE_TEST_SUITE_P(EveryCommand, Unwritable, ::testing::Range(std::size_t{0}, writers().size()),
                         [](const auto& place) { return std::string(writers()[place.param].name); });

TEST(BadUsage, ASentenceWithoutARemedyIsNone) {
    EXPECT_FALSE(says_what_to_do("tedavis: file 'x.tdb' cannot be read: No such file or directory\n"));
    EXPECT_FALSE(says_what_to_do("tedavis: x.tdb: the terrain database is not a terrain database at offset 0\n"));
    EXPECT_TRUE(says_what_to_do("tedavis: x.tdb: no such file; check the path\n"));
}

TEST(BadUsage, ARunThatIsNoFolder) {
    const auto program = ProgramSamples::program();
    const std::string run = ProgramSamples::path("run"), file = ProgramSamples::path("flight.igc");
    expect_refusal(test_support::run_program({program, "diff", run, file}), "flight.igc");
    expect_refusal(test_support::run_program({program, "diff", "/nowhere/at/all", run}), "/nowhere/at/all");
}

TEST(BadUsage, AnOutputNeverReplacesItsInput) {
    const test_support::TemporaryFolder folder;
    const auto program = ProgramSamples::program();
    const std::string flight = folder.write("flight.igc", ProgramSamples::read("flight.igc"));
    const std::string raster = folder.write("raster.tif", ProgramSamples::read("raster.tif"));
    expect_refusal(test_support::run_program({program, "convert", flight, "-o", flight}), "is also an input");
    expect_refusal(test_support::run_program({program, "terrain", "build", raster, "-o", raster}), "is also an input");
    EXPECT_EQ(folder.read("flight.igc"), ProgramSamples::read("flight.igc"));
    EXPECT_EQ(folder.read("raster.tif"), ProgramSamples::read("raster.tif"));
}

TEST(BadUsage, OptionsOutOfRange) {
    const std::string program = ProgramSamples::program(), raster = ProgramSamples::path("raster.tif"),
                      flight = ProgramSamples::path("flight.csv"), log = ProgramSamples::path("run.log");
    const test_support::TemporaryFolder folder;
    const std::string output = folder.file("x");
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"convert", flight, "-o", output, "--qnh", "30"},
             {"convert", flight, "-o", output, "--qnh", "nan"},
             {"convert", flight, "-o", output, "--aircraft", "nobody"},
             {"scenario", "build", "default", "-o", output, "--seed", "-1"},
             {"scenario", "build", "default", "-o", output, "--seed", "1e3"},
             {"terrain", "build", raster, "-o", output, "--bounds", "10,46,9,47"},
             {"terrain", "build", raster, "-o", output, "--bounds", "nan,46,11,47"},
             {"terrain", "build", raster, "-o", output, "--bounds", "-inf,46,inf,47"},
             {"terrain", "build", raster, "-o", output, "--bounds", "9,46,10"},
             {"terrain", "build", raster, "-o", output, "--bounds", "0,0,1,1"},
             {"terrain", "build", raster, "-o", output, "--crs", "nonsense"},
             {"terrain", "build", raster, "-o", output, "--accuracy", "-1"},
             {"terrain", "build", raster, "-o", output, "--accuracy", "nan"},
             {"terrain", "build", raster, "-o", output, "--accuracy", "inf"},
             {"terrain", "build", raster, "-o", output, "--vertical-datum", "moon"},
             {"terrain", "fractal", "-o", output, "--size", "2"},
             {"terrain", "fractal", "-o", output, "--size", "999999"},
             {"terrain", "fractal", "-o", output, "--size", "-5"},
             {"shot", "--pose", "91,0,0,0,0,0", "-o", output},
             {"shot", "--pose", "0,0,nan,0,0,0", "-o", output},
             {"shot", "--pose", "46.98,10.02,3500,0,0,0", "-o", output, "--tau", "nan"},
             {"shot", "--pose", "46.98,10.02,3500,0,0,0", "-o", output, "--tau", "-1"},
             {"shot", "--pose", "46.98,10.02,3500,0,0,0", "-o", output, "--size", "0x0"},
             {"replay", log, "-o", output, "--frames", "none", "--from", "nan"},
             {"replay", log, "-o", output, "--frames", "none", "--from", "1e9"},
             {"replay", log, "-o", output, "--frames", "none", "--to", "-1"},
             {"replay", log, "-o", output, "--frames", "none", "--step", "0"},
             {"replay", log, "-o", output, "--frames", "none", "--step", "nan"},
             {"replay", log, "-o", output, "--frames", "maybe"},
         }) {
        std::vector<std::string> line = words;
        line.insert(line.begin(), program);
        SCOPED_TRACE(joined(line));
        expect_refusal(test_support::run_program(line), "tedavis: ");
        EXPECT_EQ(folder.entries(), 0u);
    }
}

}  // namespace
}  // namespace tedavis::tests::test_bad_input
