#include "host_sim/flight_log/message_schedule.hpp"

#include <gtest/gtest.h>

#include <set>

#include "bus/canaerospace/identifier_table.hpp"

namespace tedavis::host_sim::test_message_schedule {
namespace {

TEST(MessageSchedule, AgreesWithTheIdentifierTable) {
    constexpr bus::GuidanceSettings kGuidance{1832};
    std::set<std::uint16_t> seen;
    for (const ScheduledMessage& message : message_schedule()) {
        const int first = message.is_guidance ? kGuidance.first_identifier : 0;
        const std::uint16_t place = bus::place_of(static_cast<std::uint16_t>(first + message.identifier), kGuidance);
        ASSERT_NE(place, bus::kNotInTable) << message.identifier;
        const bus::IdentifierEntry& entry = bus::entry_at(place);
        EXPECT_EQ(entry.signal, message.signal) << message.identifier;
        EXPECT_NE(entry.types & bus::type_bit(message.type), 0u) << message.identifier;
        EXPECT_TRUE(seen.insert(place).second) << message.identifier << " stands twice";
    }
}

TEST(MessageSchedule, FitsTheBus) {
    double frames_per_s = 0;
    for (const ScheduledMessage& message : message_schedule()) {
        ASSERT_GT(message.period_ms, 0);
        EXPECT_LT(message.offset_ms, message.period_ms);
        frames_per_s += 1000.0 / message.period_ms * (message.type == bus::DataType::double_high ? 2 : 1);
    }
    EXPECT_LT(frames_per_s, 0.8 * 8000) << "the standard advises at most 80 % of 1 Mbit/s";
}

TEST(MessageSchedule, NoMillisecondCarriesMoreThanItCanHold) {
    for (int ms = 0; ms < 1000; ++ms) {
        int frames = ms == 0 ? 3 : 0;  // time, date, phase
        for (const ScheduledMessage& message : message_schedule()) {
            if (ms % message.period_ms == message.offset_ms) frames += message.type == bus::DataType::double_high ? 2 : 1;
        }
        EXPECT_LE(frames, 8) << "125 us each, at millisecond " << ms;
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_message_schedule
