#include "host_sim/flight_log/message_schedule.hpp"

#include <gtest/gtest.h>

#include <set>

#include "bus/canaerospace/identifier_table.hpp"

namespace tedavis::host_sim::test_message_schedule {
namespace {

TEST(MessageSchedule, AgreesWithTheIdentifierTable) {
    std::set<std::uint16_t> seen;
    for (const ScheduledMessage& message : message_schedule()) {
        const std::uint16_t index = bus::identifier_index(message.identifier);
        ASSERT_NE(index, bus::kNotInTable) << message.identifier;
        const bus::IdentifierEntry& entry = bus::identifier_table()[index];
        EXPECT_EQ(entry.signal, message.signal) << message.identifier;
        EXPECT_NE(entry.types & bus::type_bit(message.type), 0u) << message.identifier;
        EXPECT_TRUE(seen.insert(message.identifier).second) << message.identifier << " stands twice";
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
