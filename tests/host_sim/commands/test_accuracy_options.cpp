#include "tests/host_sim/commands/parsed_commands.hpp"

namespace tedavis::host_sim::test_accuracy_options {
namespace {

using AccuracyCommand = test_support::ParsedCommands<add_accuracy>;

TEST_F(AccuracyCommand, OptionsReachIt) {
    EXPECT_EQ(line.accuracy.display.device, PictureOptions().device);
    parse({"accuracy", "-o", "out", "--flight", "a.log", "--flight", "b.log", "--switches", "a.switches", "--terrain", "a.tdb",
           "--terrain", "b.tdb", "--size", "800x600", "--device", "desktop", "--design", "cruise"});
    EXPECT_EQ(line.accuracy.flights, (std::vector<std::string>{"a.log", "b.log"}));
    EXPECT_EQ(line.accuracy.switches, std::vector<std::string>{"a.switches"});
    EXPECT_EQ(line.accuracy.terrains, (std::vector<std::string>{"a.tdb", "b.tdb"}));
    EXPECT_EQ(line.accuracy.display.size.height, 600u);
    EXPECT_EQ(line.accuracy.display.device, "desktop");
    EXPECT_EQ(line.accuracy.display.design, "cruise");
    EXPECT_THROW(parse({"accuracy", "-o", "out", "--size", "800"}), UserError);
}

TEST_F(AccuracyCommand, LimitsAreNumbersInTheirRange) {
    parse({"accuracy", "-o", "out", "--budget-ms", "12", "--max-slower", "50"});
    EXPECT_EQ(line.accuracy.budget_ms, 12.0);
    EXPECT_EQ(line.accuracy.slower_percent, 50);
    EXPECT_THROW(parse({"accuracy", "-o", "out", "--budget-ms", "0"}), CLI::ParseError);
    EXPECT_THROW(parse({"accuracy", "-o", "out", "--max-slower", "-1"}), CLI::ParseError);
    EXPECT_THROW(parse({"accuracy", "--quick"}), CLI::ParseError) << "without a folder";
}

}  // namespace
}  // namespace tedavis::host_sim::test_accuracy_options
