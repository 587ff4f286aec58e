#include "host_sim/accuracy/knobs/knob_registry.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/host_sim/accuracy/knob_errors.hpp"
#include "tests/host_sim/accuracy/made_knob.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_knob_registry {
namespace {

/// Every level of every knob does its work, and finds errors at places that can be named.
TEST(KnobRegistry, EveryKnobStatesWhatAFigureNeedsAndRuns) {
    const test_support::MadeKnobGround made;
    std::set<std::string> names;
    for (const RegisteredKnob& registered : knob_registry()) {
        const auto knob = registered.make(made.quick());
        EXPECT_EQ(knob->facts().name.text(), registered.name);
        EXPECT_TRUE(names.insert(registered.name).second) << registered.name;
        EXPECT_EQ(fault_of(knob->facts()), "") << registered.name;
        ASSERT_GT(knob->samples(), 0u) << registered.name;
        for (std::size_t level = 0; level < knob->facts().levels.size(); ++level) {
            std::vector<double> errors;
            knob->run(level, 0);
            knob->find_errors(level, 0, errors);
            ASSERT_FALSE(errors.empty()) << registered.name;
            for (const double error : errors) EXPECT_GE(error, 0) << registered.name;
            EXPECT_FALSE(knob->place_of(0, errors.size() - 1).empty());
            EXPECT_FALSE(knob->command(level, 0).empty());
            const bool has_picture = knob->picture(level, 0).has_value();
            EXPECT_EQ(knob->pixel_of(0, errors.size() - 1).has_value(), has_picture) << registered.name;
            EXPECT_EQ(knob->uploaded_bytes(level).has_value(), has_picture) << registered.name;
        }
    }
}

TEST(KnobRegistry, RefusesWhatIsNotCredible) {
    const auto facts = [](auto change) {
        KnobFacts made = test_support::made_facts({{"a", 1}, {"b", 2}});
        change(made);
        return fault_of(made);
    };
    EXPECT_EQ(facts([](KnobFacts&) {}), "") << "control";
    EXPECT_EQ(facts([](KnobFacts& f) { f.metric = ""; }), "its metric is empty");
    EXPECT_EQ(facts([](KnobFacts& f) { f.never_trades = ""; }), "its never trades is empty");
    EXPECT_EQ(facts([](KnobFacts& f) { f.work->thing = ""; }), "its work is empty");
    EXPECT_EQ(facts([](KnobFacts& f) { f.levels.pop_back(); }), "it has fewer than two levels");
    EXPECT_EQ(facts([](KnobFacts& f) { f.levels[1].name = "a"; }), "it has two levels 'a'");
    EXPECT_EQ(facts([](KnobFacts& f) { f.reference = {"the truth", -1, "unknown"}; }), "its reference has no bound");
}

TEST(KnobRegistry, OneLevelIsEnoughWhereTheKnobSaysWhy) {
    const auto fault = [](auto change) {
        KnobFacts made = test_support::made_facts_of_one_level({{"ours", 0}});
        change(made);
        return fault_of(made);
    };
    EXPECT_EQ(fault([](KnobFacts&) {}), "");
    EXPECT_EQ(fault([](KnobFacts& f) { f.only_level = std::nullopt; }), "it has fewer than two levels");
    EXPECT_EQ(fault([](KnobFacts& f) { f.only_level = ""; }), "its reason for one level is empty");
    EXPECT_EQ(fault([](KnobFacts& f) { f.levels.clear(); }), "it has no level");
    EXPECT_EQ(fault([](KnobFacts& f) { f.law = ExpectedLaw{-1, 0.1, "made up"}; }), "it has one level and expects a law");
}

TEST(KnobRegistry, ChoosesByNameInItsOwnOrder) {
    EXPECT_EQ(chosen_knobs({}).size(), knob_registry().size());
    const auto chosen = chosen_knobs({"smooth_surface", "ray_steps"});
    ASSERT_EQ(chosen.size(), 2u);
    EXPECT_STREQ(chosen[0].name, "ray_steps");
    test_support::expect_user_error([] { static_cast<void>(chosen_knobs({"rays"})); },
                                    "--knob rays: is unknown; choose of ray_steps");
}

/// What a knob cannot leave out: its facts have no default.
static_assert(!std::is_default_constructible_v<KnobFacts>);
static_assert(!std::is_default_constructible_v<KnobReference>);
static_assert(!std::is_default_constructible_v<KnobLevel>);

}  // namespace
}  // namespace tedavis::host_sim::test_knob_registry
