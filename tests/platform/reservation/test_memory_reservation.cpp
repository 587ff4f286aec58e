#include "platform/reservation/memory_reservation.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <utility>

namespace tedavis::platform::test_memory_reservation {
namespace {

TEST(MemoryReservation, IsOneZeroFilledArena) {
    for (Residency residency : {Residency::lazy, Residency::touched}) {
        auto reservation = reserve_memory(1 << 20, residency);
        ASSERT_TRUE(reservation.ok());
        base::Arena arena = reservation.value().arena();
        const auto bytes = arena.allocate_array<unsigned char>(1 << 20);
        ASSERT_EQ(bytes.size(), std::size_t{1} << 20);
        for (std::size_t i = 0; i < bytes.size(); i += 512) ASSERT_EQ(bytes[i], 0);
        std::memset(bytes.data(), 0xA5, bytes.size());
        EXPECT_EQ(arena.allocate(1, 1), nullptr) << "nothing beyond";
    }
}

TEST(MemoryReservation, MovesWithItsBlock) {
    auto made = reserve_memory(4096, Residency::lazy);
    ASSERT_TRUE(made.ok());
    MemoryReservation reservation(std::move(made.value()));
    EXPECT_EQ(reservation.bytes(), 4096u);
    EXPECT_EQ(made.value().bytes(), 0u);
    EXPECT_NE(reservation.arena().allocate(1, 1), nullptr);
}

TEST(MemoryReservation, RefusesWhatTheMachineHasNot) {
    EXPECT_FALSE(reserve_memory(0, Residency::lazy).ok());
    const auto huge = reserve_memory(std::numeric_limits<std::uint64_t>::max() / 2, Residency::lazy);
    ASSERT_FALSE(huge.ok());
    EXPECT_NE(huge.error().message.view().find("9223372036854775807 bytes"), std::string_view::npos)
        << huge.error().message.c_str();
}

}  // namespace
}  // namespace tedavis::platform::test_memory_reservation
