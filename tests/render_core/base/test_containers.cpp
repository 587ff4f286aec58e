// FixedVector, FixedString, Span and Result: header-only types that everything above relies on.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/result.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::base::test_containers {
namespace {

TEST(FixedVector, refuses_and_counts_when_full) {
    FixedVector<int, 3> v;
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(v.try_push_back(i));
    EXPECT_TRUE(v.full());
    EXPECT_FALSE(v.try_push_back(99));
    EXPECT_FALSE(v.try_push_back(99));
    EXPECT_EQ(v.refused(), 2u);
    EXPECT_EQ(v.size(), 3u);
    EXPECT_EQ(v.back(), 2) << "what was there stays";
    v.truncate(1);
    EXPECT_TRUE(v.try_push_back(7));
    EXPECT_EQ(v[1], 7);
    v.clear();
    EXPECT_TRUE(v.empty());
    EXPECT_EQ(v.refused(), 2u) << "clearing forgets elements, not refusals";
}

TEST(FixedVectorDeathTest, reading_outside_stops) {
    FixedVector<int, 2> v;
    EXPECT_DEATH(v[0] = 1, "index < size_");
    EXPECT_DEATH(v.pop_back(), "size_ > 0");
    EXPECT_DEATH(v.truncate(1), "count <= size_");
}

TEST(FixedString, cuts_at_its_capacity_and_says_so) {
    FixedString<5> text("abc");
    EXPECT_FALSE(text.cut());
    text.append("de");
    EXPECT_FALSE(text.cut());
    EXPECT_EQ(text.view(), "abcde");
    text.append("f");
    EXPECT_TRUE(text.cut());
    EXPECT_EQ(text.view(), "abcde");
    EXPECT_EQ(std::string(text.c_str()).size(), 5u) << "zero-terminated at the capacity";
    text.clear();
    EXPECT_TRUE(text.empty());
    EXPECT_FALSE(text.cut());
}

TEST(FixedString, compares_by_content_and_takes_empty_views) {
    EXPECT_EQ(FixedString<8>("x"), FixedString<8>("x"));
    EXPECT_NE(FixedString<8>("x"), FixedString<8>("xy"));
    EXPECT_EQ(FixedString<8>(std::string_view()).size(), 0u);
}

TEST(Span, views_arrays_vectors_and_strings) {
    int array[] = {1, 2, 3};
    std::array<int, 2> two = {4, 5};
    EXPECT_EQ(Span<int>(array).size(), 3u);
    EXPECT_EQ(Span<int>(two)[1], 5);
    Span<const int> middle = Span<const int>(array, 3).subspan(1, 1);
    EXPECT_EQ(middle.size(), 1u);
    EXPECT_EQ(middle[0], 2);
    EXPECT_TRUE(Span<int>().empty());
    EXPECT_EQ(Span<int>(array).subspan(3, 0).size(), 0u);
}

TEST(SpanDeathTest, reading_outside_stops) {
    int array[] = {1, 2, 3};
    const Span<int> span(array);
    EXPECT_DEATH(span[3] = 0, "index < size_");
    EXPECT_DEATH((void)span.subspan(2, 2), "offset <= size_");
    EXPECT_DEATH((void)span.subspan(1, static_cast<std::size_t>(-1)), "count <= size_ - offset");
}

Result<int, std::string> half(int value) {
    if (value % 2 != 0) return fail(std::string("odd"));
    return value / 2;
}

TEST(Result, holds_the_value_or_the_error) {
    EXPECT_TRUE(half(4).ok());
    EXPECT_EQ(half(4).value(), 2);
    EXPECT_FALSE(half(3));
    EXPECT_EQ(half(3).error(), "odd");
}

TEST(ResultDeathTest, the_wrong_alternative_stops) {
    EXPECT_DEATH((void)half(3).value(), "has_value_");
    EXPECT_DEATH((void)half(4).error(), "!has_value_");
}

}  // namespace
}  // namespace tedavis::base::test_containers
