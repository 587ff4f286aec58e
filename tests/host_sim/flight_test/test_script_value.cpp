#include "host_sim/flight_test/script_value.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tedavis::host_sim::test_script_value {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Kind = ScriptValue::Kind;

TEST(ScriptValue, HoldsWhatTheFileStatesWithItsLines) {
    ScriptFaults faults;
    const ScriptValue tree = parse_script_value("a = 1\nb = [\"x\", true]\n[t]\nc = 2.5\n", "f.toml", faults);
    ASSERT_TRUE(faults.empty());
    EXPECT_EQ(tree.find("a")->number, 1);
    EXPECT_EQ(tree.find("b")->items[0].text, "x");
    EXPECT_EQ(tree.find("b")->items[1].kind, Kind::boolean);
    EXPECT_EQ(tree.find("t")->find("c")->number, 2.5);
    EXPECT_EQ(tree.find("t")->find("c")->line, 4u);
    EXPECT_EQ(tree.find("d"), nullptr);
}

TEST(ScriptValue, AFileThatIsNoTomlIsOneFault) {
    ScriptFaults faults;
    static_cast<void>(parse_script_value("a = 1\nb = = 2\n", "f.toml", faults));
    EXPECT_THAT(faults.sentences(), ElementsAre(HasSubstr("f.toml:2: ")));
}

TEST(ScriptValue, ParametersStandForTextsPartsAndKeys) {
    ScriptFaults faults;
    ScriptValue tree = parse_script_value("a = \"$n\"\nb = \"${s}.lost\"\nc = { \"${s}\" = \"$s\" }\n", "f.toml", faults);
    std::set<std::string> used;
    put_parameters(tree, {{"n", stated_parameter("2.5")}, {"s", stated_parameter("pitch")}}, faults, used);
    ASSERT_TRUE(faults.empty());
    EXPECT_EQ(tree.find("a")->kind, Kind::number);
    EXPECT_EQ(tree.find("a")->number, 2.5);
    EXPECT_EQ(tree.find("b")->text, "pitch.lost");
    EXPECT_EQ(tree.find("c")->find("pitch")->text, "pitch");
}

TEST(ScriptValue, AnUnknownParameterIsAFaultAtItsLine) {
    ScriptFaults faults;
    ScriptValue tree = parse_script_value("a = 1\nb = \"$no\"\nc = \"${none}\"\n", "f.toml", faults);
    std::set<std::string> used;
    put_parameters(tree, {{"n", stated_parameter("1")}}, faults, used);
    EXPECT_THAT(faults.sentences(), ElementsAre("f.toml:2: '$no' is no parameter; [parameters] has: n",
                                                "f.toml:3: '$none' is no parameter; [parameters] has: n"));
}

TEST(ScriptValue, FaultsAreToldInTheOrderOfFilesAndLines) {
    ScriptFaults faults;
    faults.add("b", 1, "x");
    faults.add("a", 10, "y");
    faults.add("a", 9, "z");
    EXPECT_THAT(faults.sentences(), ElementsAre("a:9: z", "a:10: y", "b:1: x"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_script_value
