#include "render_core/design/phase_designs.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace tedavis::design::test_phase_designs {
namespace {

using flight::FlightPhase;
using flight::Scenario;

NamedPhase named(FlightPhase phase, const char* name) { return {phase, name}; }

TEST(PhaseDesigns, APhaseGoesBeforeItsScenarioAndWhatIsNotNamedHasNone) {
    const auto designs = std::make_unique<PhaseDesigns>();
    DesignSettings design = default_design_settings();
    design.name = "low";
    ASSERT_TRUE(designs->add(named({Scenario::go_around, 0}, "low"), design));
    design.name = "unsure";
    ASSERT_TRUE(designs->add(named(flight::kGoAroundReplanning, "unsure"), design));
    EXPECT_EQ(designs->place_of(flight::kGoAroundAbort), 1u);
    EXPECT_EQ(designs->place_of({Scenario::go_around, 0}), 1u);
    EXPECT_EQ(designs->place_of(flight::kGoAroundReplanning), 2u);
    EXPECT_EQ(designs->place_of({Scenario::cruise, 0}), 0u);
    EXPECT_EQ(designs->place_of({}), 0u);
    EXPECT_EQ(designs->at(2).name.view(), "unsure");
}

TEST(PhaseDesigns, OneNameIsOneDesign) {
    const auto designs = std::make_unique<PhaseDesigns>();
    const DesignSettings design = default_design_settings();
    EXPECT_EQ(designs->find("low"), nullptr);
    ASSERT_TRUE(designs->add(named({Scenario::takeoff, 0}, "low"), design));
    ASSERT_TRUE(designs->add(named({Scenario::approach, 0}, "low"), design));
    EXPECT_EQ(designs->size(), 1u);
    EXPECT_NE(designs->find("low"), nullptr);
    EXPECT_EQ(designs->place_of(flight::kApproachFinal), designs->place_of(flight::kTakeoffStart));
}

TEST(PhaseDesigns, AFullListRefuses) {
    const auto designs = std::make_unique<PhaseDesigns>();
    const DesignSettings design = default_design_settings();
    for (std::size_t n = 0; n < kMaxPhaseDesigns; ++n)
        ASSERT_TRUE(designs->add(named({Scenario::cruise, 0}, std::to_string(n).c_str()), design));
    EXPECT_FALSE(designs->add(named({Scenario::ground, 0}, "one more"), design));
    EXPECT_EQ(designs->place_of({Scenario::ground, 0}), 0u);
}

}  // namespace
}  // namespace tedavis::design::test_phase_designs
