#include "target/command_line.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tedavis::target::test_command_line {
namespace {

base::Result<CommandLine, base::Error> parse(const std::vector<const char*>& arguments) {
    return parse_command_line(static_cast<int>(arguments.size()), arguments.data());
}

std::string refusal(const std::vector<const char*>& arguments) {
    const auto line = parse(arguments);
    return line.ok() ? "accepted" : std::string(line.error().message.view());
}

TEST(CommandLine, ReadsARun) {
    const auto line = parse({"--json", "--config", "board.toml", "--frames", "250"});
    ASSERT_TRUE(line.ok());
    EXPECT_EQ(line.value().request, Request::run);
    EXPECT_STREQ(line.value().config, "board.toml");
    EXPECT_EQ(line.value().frames, 250u);
    EXPECT_TRUE(line.value().json);
    EXPECT_EQ(parse({"--config", "b"}).value().frames, 0u) << "no limit";
    EXPECT_STREQ(parse({"--config", "b", "--shot", "p.png"}).value().shot, "p.png");
    EXPECT_EQ(parse({"--config", "b"}).value().shot, nullptr);
    EXPECT_EQ(refusal({"--self-test", "--shot", "p.png"}), "--shot: belongs to a run; leave it out; see tedavis-display --help");
    EXPECT_EQ(refusal({"--config", "b", "--shot", ""}),
              "--shot: is empty; name the picture to write; see tedavis-display --help");
}

TEST(CommandLine, APackMayHaveAnotherKey) {
    EXPECT_STREQ(parse({"--config", "p"}).value().pack_key, "/etc/tedavis/pack.pub");
    EXPECT_STREQ(parse({"--config", "p", "--pack-key", "/proc/self/exe"}).value().pack_key, "/proc/self/exe");
    EXPECT_NE(refusal({"--config", "p", "--pack-key", "/nowhere.pub"}).find("--pack-key /nowhere.pub: cannot be read"),
              std::string::npos)
        << "without the file no signature would be asked for";
    EXPECT_NE(refusal({"--probe", "--pack-key", "/proc/self/exe"}).find("--pack-key: belongs to --config"), std::string::npos);
}

TEST(CommandLine, SelfTestNeedsNoFile) {
    EXPECT_EQ(parse({"--self-test"}).value().request, Request::self_test);
    EXPECT_EQ(parse({"--self-test"}).value().config, nullptr);
    EXPECT_STREQ(parse({"--self-test", "--config", "b"}).value().config, "b");
}

TEST(CommandLine, AProbeNeedsNoFileAndTakesOne) {
    EXPECT_EQ(parse({"--probe"}).value().request, Request::probe);
    EXPECT_EQ(parse({"--probe"}).value().config, nullptr);
    EXPECT_STREQ(parse({"--probe", "--config", "b", "--json"}).value().config, "b");
    EXPECT_EQ(refusal({"--probe", "--frames", "3"}), "--frames: belongs to a run; leave it out; see tedavis-display --help");
}

TEST(CommandLine, WritingShadersNamesBoardAndFolder) {
    const auto line = parse({"--write-shaders", "sc2.programs", "--config", "b", "--json"});
    ASSERT_TRUE(line.ok());
    EXPECT_EQ(line.value().request, Request::write_shaders);
    EXPECT_STREQ(line.value().shaders, "sc2.programs");
    const std::string help = "; see tedavis-display --help";
    EXPECT_EQ(refusal({"--write-shaders", "d"}), "--config: is missing; name the board file" + help);
    EXPECT_EQ(refusal({"--config", "b", "--write-shaders"}), "--write-shaders: needs a value behind it" + help);
    EXPECT_EQ(refusal({"--config", "b", "--write-shaders", ""}),
              "--write-shaders: is empty; name the folder of programs to write" + help);
    EXPECT_EQ(refusal({"--config", "b", "--write-shaders", "d", "--frames", "3"}),
              "--frames: belongs to a run; leave it out" + help);
}

TEST(CommandLine, ACalibrationNamesBoardAndFile) {
    const auto line = parse({"--calibrate", "-o", "c.toml", "--config", "b"});
    ASSERT_TRUE(line.ok());
    EXPECT_EQ(line.value().request, Request::calibrate);
    EXPECT_STREQ(line.value().output, "c.toml");
    EXPECT_EQ(line.value().rounds, 15u);
    EXPECT_EQ(parse({"--calibrate", "-o", "c", "--config", "b", "--rounds", "3"}).value().rounds, 3u);
    const std::string help = "; see tedavis-display --help";
    EXPECT_EQ(refusal({"--calibrate", "-o", "c"}), "--config: is missing; name the board file" + help);
    EXPECT_EQ(refusal({"--calibrate", "--config", "b"}), "-o: is missing; name the file of costs to write" + help);
    EXPECT_EQ(refusal({"--calibrate", "--config", "b", "-o", ""}), "-o: is empty; name the file of costs to write" + help);
    EXPECT_EQ(refusal({"--calibrate", "--config", "b", "-o", "b"}), "-o b: is the board file; name another file" + help);
    EXPECT_EQ(refusal({"--config", "b", "-o", "c"}), "-o: belongs to --calibrate; leave it out" + help);
    EXPECT_EQ(refusal({"--config", "b", "--rounds", "5"}), "--rounds: belongs to --calibrate; leave it out" + help);
    for (const char* count : {"2", "1001", "x"})
        EXPECT_EQ(refusal({"--calibrate", "--rounds", count}),
                  "--rounds '" + std::string(count) + "': must be a whole number from 3 to 1000" + help);
}

TEST(CommandLine, QuestionsAreAnsweredWhateverFollows) {
    EXPECT_EQ(parse({"--help", "--nonsense"}).value().request, Request::help);
    EXPECT_EQ(parse({"-h"}).value().request, Request::help);
    EXPECT_EQ(parse({"--frames", "3", "--version"}).value().request, Request::version);
}

TEST(CommandLine, WrongUsageIsOneSentence) {
    EXPECT_EQ(refusal({}), "--config: is missing; name the board file; see tedavis-display --help");
    EXPECT_EQ(refusal({"--config"}), "--config: needs a value behind it; see tedavis-display --help");
    EXPECT_EQ(refusal({"--fast"}), "'--fast': no such option; see tedavis-display --help");
    EXPECT_EQ(refusal({"board.toml"}), "'board.toml': no such option; see tedavis-display --help");
    EXPECT_EQ(refusal({"--self-test", "--frames", "2"}), "--frames: belongs to a run; leave it out; see tedavis-display --help");
    for (const char* count : {"0", "-1", "1.5", "ten", "", "1 ", "99999999999999999999"})
        EXPECT_EQ(refusal({"--config", "b", "--frames", count}),
                  "--frames '" + std::string(count) + "': must be a whole number from 1 on; see tedavis-display --help");
}

TEST(CommandLine, TheHelpNamesEveryOption) {
    const std::string help = command_line_help();
    for (const char* option :
         {"--config", "--self-test", "--frames", "--shot", "--calibrate", "-o", "--rounds", "--json", "--help", "--version"})
        EXPECT_NE(help.find(option), std::string::npos) << option;
}

}  // namespace
}  // namespace tedavis::target::test_command_line
