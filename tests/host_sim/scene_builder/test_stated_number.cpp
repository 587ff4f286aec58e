#include "host_sim/scene_builder/stated_number.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_stated_number {
namespace {

constexpr std::int64_t kInstant_ns = 1'586'684'820'000'000'000;  // date -u -d '2020-04-12 09:47:00' +%s

TEST(StatedNumber, IsTheWholeText) {
    EXPECT_EQ(stated_number("42.5"), 42.5);
    EXPECT_EQ(stated_number(" -3e2\t"), -300);
    EXPECT_EQ(stated_number("+7"), 7);
    for (const char* const none : {"", " ", "12 m", "1,5", "nan", "inf", "+-3", "1e999", "tall"})
        EXPECT_FALSE(stated_number(none)) << none;
}

TEST(StatedNumber, InstantsOfTablesAndOfGdal) {
    for (const char* const text : {"2020-04-12T09:47:00Z", "2020-04-12 09:47:00", "2020/04/12 09:47:00+00",
                                   "2020/04/12 11:47:00+02", "2020-04-12T11:47:00+02:00", "1586684820", " 1586684820.0 "})
        EXPECT_EQ(stated_instant_ns(text), kInstant_ns) << text;
    EXPECT_EQ(stated_instant_ns("2020/04/12 09:47:00.25"), kInstant_ns + 250'000'000);
    for (const char* const none : {"", "noon", "2020-04-12", "2020-13-12T09:47:00Z", "12.04.2020"})
        EXPECT_FALSE(stated_instant_ns(none)) << none;
}

}  // namespace
}  // namespace tedavis::host_sim::test_stated_number
