#include "render_core/policy/signal_rules.hpp"

#include <gtest/gtest.h>

#include <map>

namespace tedavis::policy::test_signal_rules {
namespace {

using base::SignalState;
using flight::Signal;

TEST(SignalRules, EverySignalThatIsShownIsASourceOfItsGroupOnce) {
    std::map<Signal, int> uses;
    for (std::size_t i = 0; i < kGroupCount; ++i) {
        const SourceChain& chain = source_chain(static_cast<SignalGroup>(i));
        EXPECT_GE(chain.count, 1);
        EXPECT_GE(chain.count, chain.equals);
        for (std::size_t n = 0; n < chain.count; ++n) ++uses[chain.sources[n]];
    }
    for (const SignalRule& rule : signal_rules()) {
        // The variation turns a magnetic heading and states no information of its own.
        const bool is_shown = rule.group != SignalGroup::not_shown && rule.signal != Signal::magnetic_variation;
        const bool is_altitude_too = rule.signal == Signal::ellipsoid_height || rule.signal == Signal::true_altitude;
        EXPECT_EQ(uses[rule.signal], is_altitude_too ? 2 : is_shown ? 1 : 0) << to_string(rule.signal);
    }
}

/// A signal whose loss must not be overlooked is flagged in every bad state but the one in which it was never received.
TEST(SignalRules, NoReceivedSignalGoesBadUnseen) {
    for (const SignalRule& rule : signal_rules()) {
        EXPECT_EQ(consequences(rule, SignalState::valid), kNoConsequence);
        if (rule.group == SignalGroup::not_shown) continue;
        for (const SignalState state : {SignalState::stale, SignalState::lost, SignalState::invalid})
            EXPECT_NE(consequences(rule, state) & kFlag, 0) << to_string(rule.signal) << "." << to_string(state);
    }
}

/// What states a value of its own is never left standing when it is lost: something is removed or replaced by a cross.
TEST(SignalRules, WhatIsLostIsRemoved) {
    constexpr std::uint8_t kRemoving = kFailElement | kRemoveTerrain | kRemoveWarningColors;
    for (const SignalRule& rule : signal_rules()) {
        if (rule.group == SignalGroup::not_shown) continue;
        EXPECT_NE(rule.lost & kRemoving, 0) << to_string(rule.signal);
        EXPECT_NE(rule.invalid & kRemoving, 0) << to_string(rule.signal);
    }
}

}  // namespace
}  // namespace tedavis::policy::test_signal_rules
