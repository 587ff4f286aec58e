#include "render_core/flight/signal.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace tedavis::flight::test_signal {
namespace {

TEST(Signal, every_signal_has_its_own_name_and_is_found_by_it) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < kSignalCount; ++i) {
        const auto signal = static_cast<Signal>(i);
        EXPECT_TRUE(names.insert(to_string(signal)).second) << to_string(signal);
        EXPECT_EQ(signal_from_name(to_string(signal)), signal);
    }
}

TEST(Signal, names_stand_at_the_right_places) {
    // The table is positional: a few fixed points, first, last and neighbours that a shifted table would swap.
    EXPECT_STREQ(to_string(Signal::latitude), "latitude");
    EXPECT_STREQ(to_string(Signal::pitch), "pitch");
    EXPECT_STREQ(to_string(Signal::roll), "roll");
    EXPECT_STREQ(to_string(Signal::vertical_speed), "vertical_speed");
    EXPECT_STREQ(to_string(Signal::radio_height), "radio_height");
    EXPECT_STREQ(to_string(Signal::height_above_terrain), "height_above_terrain");
}

TEST(Signal, strangers_are_named_unknown) {
    EXPECT_EQ(signal_from_name("altitude"), Signal::count_);
    EXPECT_EQ(signal_from_name(""), Signal::count_);
    EXPECT_EQ(signal_from_name("Pitch"), Signal::count_);
    EXPECT_STREQ(to_string(Signal::count_), "unknown");
    EXPECT_STREQ(to_string(static_cast<Signal>(255)), "unknown");
}

}  // namespace
}  // namespace tedavis::flight::test_signal
