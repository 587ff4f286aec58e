#include "host_sim/scenario/scenario.hpp"

#include <gtest/gtest.h>

#include "host_sim/input_file.hpp"
#include "render_core/base/units.hpp"
#include "tests/support/expect_user_error.hpp"

namespace tedavis::host_sim {
namespace {

std::string shipped() { return read_file(TEDAVIS_SOURCE_DIR "/configs/scenarios/default.toml"); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

TEST(Scenario, ReadsTheShippedOne) {
    const Scenario scenario = parse_scenario(shipped(), "default.toml");
    EXPECT_EQ(scenario.name, "default");
    EXPECT_EQ(scenario.seed, 1u);
    EXPECT_EQ(scenario.start.ns, 1780322400 * std::int64_t{1'000'000'000});
    EXPECT_NEAR(base::degrees(scenario.strip.heading_rad), 240, 1e-12);
    EXPECT_NEAR(scenario.environment.qnh_pa, 101900, 1e-9);
    EXPECT_EQ(scenario.legs.front().kind, LegKind::stand);
    EXPECT_EQ(scenario.legs[1].kind, LegKind::roll);
    EXPECT_EQ(scenario.legs[1].stated_by, PhaseStatedBy::can);
    EXPECT_EQ(scenario.legs[1].phase, flight::kTakeoffStart);
}

TEST(Scenario, NamesFileAndLineOfAFault) {
    const auto refused = [](const std::string& text, const std::string& words) {
        test_support::expect_user_error([&] { (void)parse_scenario(text, "s.toml"); }, words);
    };
    refused("name = ", "s.toml:1");
    refused(replaced(shipped(), "heading_deg = 240", "heading_deg = 540"), "heading_deg");
    refused(replaced(shipped(), "heading_deg = 240", "heading_deg = nan"), "heading_deg");
    refused(replaced(shipped(), "kind = \"roll\"", "kind = \"rolling\""), "'kind' must be one of");
    refused(replaced(shipped(), "phase = \"cruise\"", "phase = \"lunch\""), "no such flight phase");
    refused(replaced(shipped(), "turbulence = 0.5", "turbulences = 0.5"), "turbulence");
    refused(replaced(shipped(), "2026-06-01T14:00:00Z", "yesterday"), "no time such as");
    refused(replaced(shipped(), "duration_s = 3", "duration_s = 3\nspeed_mps = 20"), "speed_mps");
    refused(shipped().substr(0, shipped().find("[[leg]]")), "[[leg]]");
}

}  // namespace
}  // namespace tedavis::host_sim
