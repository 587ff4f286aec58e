#include "render_core/design/named_phases.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tedavis::design::test_named_phases {
namespace {

std::string refusal(const std::string& text, NamedPhases& phases) {
    base::ConfigReader reader(text, "x.toml");
    base::ConfigSection root = reader.root();
    read_named_phases(root.section("phases"), phases);
    return reader.finish() ? "" : std::string(reader.error().message.view());
}

TEST(NamedPhases, ScenariosAndPhasesNameDesigns) {
    NamedPhases phases;
    EXPECT_EQ(refusal("[phases]\ncruise = \"high\"\n\"go_around.replanning\" = \"sub/x.toml\"\n", phases), "");
    ASSERT_EQ(phases.size(), 2u);
    EXPECT_EQ(phases[0].phase, (flight::FlightPhase{flight::Scenario::cruise, 0}));
    EXPECT_EQ(phases[0].design.view(), "high");
    EXPECT_EQ(phases[1].phase, flight::kGoAroundReplanning);
    EXPECT_EQ(phases[1].design.view(), "sub/x.toml");
}

TEST(NamedPhases, WithoutATableThereAreNone) {
    NamedPhases phases;
    EXPECT_EQ(refusal("", phases), "");
    EXPECT_TRUE(phases.empty());
}

TEST(NamedPhases, WhatIsNoPhaseOrNoNameIsRefusedWithItsLine) {
    NamedPhases phases;
    EXPECT_NE(refusal("[phases]\ncruise = \"a\"\nlunch = \"b\"\n", phases).find("x.toml:3: 'lunch'"), std::string::npos);
    EXPECT_NE(refusal("[phases]\ncruise = \"\"\n", phases).find("1 to 127 letters"), std::string::npos);
    EXPECT_NE(refusal("[phases]\ncruise = 3\n", phases), "");
}

}  // namespace
}  // namespace tedavis::design::test_named_phases
