#include "host_sim/command_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "tests/support/temporary_folder.hpp"

namespace tedavis::host_sim {
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
    for (const char* command : {"convert", "scenario", "terrain", "shot", "diff", "check"})
        EXPECT_THAT(help.results, HasSubstr(command));
    EXPECT_EQ(run({"convert", "--help"}).code, 0);
    EXPECT_THAT(run({"terrain", "build", "--help"}).results, HasSubstr("--vertical-datum"));
}

TEST(CommandLine, WrongUsageIsOneSentenceAndTwo) {
    for (const auto& words :
         std::vector<std::vector<const char*>>{{},
                                               {"nonsense"},
                                               {"convert"},
                                               {"convert", "a.igc"},
                                               {"scenario"},
                                               {"terrain"},
                                               {"terrain", "nonsense"},
                                               {"diff", "a"},
                                               {"check"},
                                               {"convert", "a", "-o", "b", "--nonsense"},
                                               {"convert", "a", "-o", "b", "--qnh", "high"},
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

TEST(CommandLine, PassesOptionsOn) {
    const test_support::TemporaryFolder folder;
    const std::string output = folder.file("run");
    const Outcome outcome = run({"scenario", "build", "default", "-o", output.c_str(), "--seed", "7", "--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.notes;
    EXPECT_THAT(outcome.results, HasSubstr("\"seed\":7"));
    EXPECT_TRUE(std::filesystem::exists(output + "/flight.log"));
}

}  // namespace
}  // namespace tedavis::host_sim
