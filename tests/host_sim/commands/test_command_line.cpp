#include "host_sim/commands/command_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "host_sim/input_file.hpp"
#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/flights/flown_circle.hpp"

namespace tedavis::host_sim::test_command_line {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Outcome {
    int code = 0;
    std::string results, notes;
};

Outcome run(std::vector<const char*> words) {
    words.insert(words.begin(), "tedavis");
    std::ostringstream results, notes;
    const int code = run_command_line(static_cast<int>(words.size()), words.data(), results, notes, false);
    return {code, results.str(), notes.str()};
}

std::size_t lines_of(const std::string& text) { return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')); }

TEST(CommandLine, HelpAndVersionSucceed) {
    EXPECT_THAT(run({"--version"}).results, HasSubstr("tedavis "));
    const Outcome help = run({"--help"});
    EXPECT_EQ(help.code, 0);
    for (const char* command :
         {"convert", "scenario", "scene", "terrain", "shot", "sheet", "calibrate", "diff", "compare", "check"})
        EXPECT_THAT(help.results, HasSubstr(command));
    EXPECT_EQ(run({"convert", "--help"}).code, 0);
    EXPECT_THAT(run({"terrain", "build", "--help"}).results, HasSubstr("--vertical-datum"));
    EXPECT_THAT(run({"sheet", "--help"}).results, HasSubstr("of a picture; default: the sheet's"));
    EXPECT_THAT(run({"shot", "--help"}).results, HasSubstr("default: the device's"));
}

TEST(CommandLine, WrongUsageIsOneSentenceAndTwo) {
    for (const auto& words :
         std::vector<std::vector<const char*>>{{},
                                               {"nonsense"},
                                               {"convert"},
                                               {"convert", "a.igc"},
                                               {"scenario"},
                                               {"scene"},
                                               {"scene", "build", "a.toml"},
                                               {"scene", "info"},
                                               {"terrain"},
                                               {"terrain", "nonsense"},
                                               {"diff", "a"},
                                               {"compare", "a", "b"},
                                               {"compare", "a", "b", "-o", "p.html", "--align", "altitude"},
                                               {"compare", "a", "b", "-o", "p.html", "--within", "0"},
                                               {"check"},
                                               {"convert", "a", "-o", "b", "--nonsense"},
                                               {"convert", "a", "-o", "b", "--qnh", "high"},
                                               {"sheet", "-o", "a"},
                                               {"sheet", "terrain-styles"},
                                               {"sheet", "no-such", "-o", "a"},
                                               {"sheet", "terrain-styles", "-o", "a", "--pose", "1,2,3"},
                                               {"sheet", "terrain-styles", "-o", "a", "--design", "cruise"},
                                               {"shot", "-o", "a.png"},
                                               {"shot", "-o", "a.png", "--pose", "1,2,3"},
                                               {"shot", "-o", "a.png", "--pose", "nan,2,3,4,5,6"},
                                               {"shot", "-o", "a.png", "--pose", "1,2,3,4,5,6", "--phase", "lunch"},
                                               {"shot", "-o", "a.png", "--pose", "1,2,3,4,5,6", "--size", "640"},
                                               {"shot", "-o", "a.png", "--pose", "1,2,3,4,5,6", "--gl", "vulkan"}}) {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.code, 2) << (words.empty() ? "" : words[0]);
        EXPECT_THAT(outcome.results, IsEmpty());
        EXPECT_EQ(lines_of(outcome.notes), 1u) << outcome.notes;
    }
}

TEST(CommandLine, WrongInputIsOneSentenceAndTwo) {
    const Outcome outcome = run({"convert", "/nonexistent/flight.igc", "-o", "/nonexistent/x.log"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.notes, "tedavis: /nonexistent/flight.igc: no such file; check the path\n");
}

TEST(CommandLine, SeveralFaultsOfAFileAreALineEach) {
    const test_support::TemporaryFolder folder;
    const std::string file = folder.write("s.toml", "seed = -1\n[strip]\n");
    const Outcome outcome = run({"scenario", "build", file.c_str(), "-o", folder.file("out").c_str()});
    EXPECT_EQ(outcome.code, 2);
    std::istringstream lines(outcome.notes);
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) EXPECT_EQ(line.substr(0, 9), "tedavis: ") << line;
    EXPECT_EQ(count, 6) << "seed, four keys of the strip, and no leg:\n" << outcome.notes;
    EXPECT_FALSE(std::filesystem::exists(folder.file("out")));
}

TEST(CommandLine, AWrongWordOrNumberIsToldInAShortSentence) {
    const auto told = [](const std::vector<const char*>& words) { return run(words).notes; };
    EXPECT_EQ(told({"shot", "-o", "a.png", "--pose", "1,2,3,4,5,6", "--gl", "vulkan"}),
              "tedavis: --gl vulkan: unknown; choose one of egl, osmesa\n");
    EXPECT_EQ(told({"replay", "a.log", "-o", "a", "--frames", "jpg"}),
              "tedavis: --frames jpg: unknown; choose one of hash, none, png\n");
    EXPECT_EQ(told({"terrain", "build", "a.tif", "-o", "a.tdb", "--accuracy", "-3"}),
              "tedavis: --accuracy: -3 is no number from 0 on; see tedavis --help\n");
    EXPECT_EQ(told({"scenario", "build", "default", "-o", "a", "--seed", "-1"}),
              "tedavis: --seed: -1 is no number from 0 on; see tedavis --help\n");
}

TEST(CommandLine, ReplayTakesABusByNameOrFile) {
    const test_support::FlownFiles files;
    const std::string own =
        files.folder.write("own.toml", read_file(test_support::source_dir() + "/configs/buses/canaerospace.toml"));
    const auto replayed = [&](const char* bus, const std::string& folder) {
        return run({"replay", files.log.c_str(), "-o", folder.c_str(), "--bus", bus, "--frames", "hash", "--step", "4", "--size",
                    "64x48"});
    };
    EXPECT_EQ(replayed("glider", files.folder.file("glider")).code, 0);
    const std::string folder = files.folder.file("own");
    EXPECT_EQ(replayed(own.c_str(), folder).code, 0);
    const Outcome refused = replayed("smoke", files.folder.file("smoke"));
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.notes,
                HasSubstr("smoke: no such file and no shipped one of buses; name a file, or one of these: canaerospace, glider"));
}

TEST(CommandLine, PassesOptionsOn) {
    const test_support::TemporaryFolder folder;
    const std::string output = folder.file("run");
    const Outcome outcome = run({"scenario", "build", "default", "-o", output.c_str(), "--seed", "7", "--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.notes;
    EXPECT_THAT(outcome.results, HasSubstr("\"seed\":7"));
    EXPECT_TRUE(std::filesystem::exists(output + "/flight.log"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_command_line
