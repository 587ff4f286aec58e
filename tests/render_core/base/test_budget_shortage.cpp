#include "render_core/base/budget_shortage.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tedavis::base::test_budget_shortage {
namespace {

TEST(BudgetShortage, SaysTheLineWhatIsNeededAndWhatIsThere) {
    EXPECT_EQ(shortage_error({"staging", 10, 20, 30}).message.view(),
              "the budget line 'staging' has 10 of 20 bytes left and 30 are needed; raise the line in the device file");
    EXPECT_EQ(shortage_error({"staging", 10, 20, 30}, "drape_pages").message.view(),
              "the budget line 'staging' has 10 of 20 bytes left and 30 are needed for drape_pages; raise the line in the device "
              "file");
}

TEST(BudgetShortage, IsReadBackFromAnyMessageThatHoldsIt) {
    for (const char* const purpose : {"", "max_chunk_slots"}) {
        const Error error = shortage_error({"lod_scratch", 0, 8ull << 30, 1ull << 45}, purpose);
        BudgetShortage read;
        ASSERT_TRUE(find_shortage("a.toml: does not start: " + std::string(error.message.view()), read));
        EXPECT_EQ(read.line.view(), "lod_scratch");
        EXPECT_EQ(read.left, 0u);
        EXPECT_EQ(read.capacity, 8ull << 30);
        EXPECT_EQ(read.needed, 1ull << 45);
        EXPECT_EQ(read.enough(), (8ull << 30) + (1ull << 45));
    }
}

TEST(BudgetShortage, OtherSentencesHaveNone) {
    BudgetShortage read;
    for (const char* const message :
         {"", "the budget line", "the budget line 'x", "the budget line 'x' has", "the budget line 'x' has 1 of 2 bytes left",
          "the budget line 'x' has -1 of 2 bytes left and 3 are needed",
          "the budget line 'x' has 3 of 2 bytes left and 3 are needed",
          "the budget line 'x' has 1 of 2 bytes left and many are needed",
          "the budget line 'x' has 99999999999999999999 of 2 bytes left and 3 are needed"})
        EXPECT_FALSE(find_shortage(message, read)) << message;
}

/// A line raised as the sentence says holds what did not fit, at whatever place it lies.
TEST(BudgetShortage, ALineRaisedByItHoldsWhatWasRefused) {
    for (std::size_t bytes = 0; bytes < 200; ++bytes)
        for (std::size_t shift = 0; shift < 3; ++shift) {
            std::vector<unsigned char> block(4096);
            const auto take = [](Arena& arena) {
                const bool first = arena.allocate(13, 1) != nullptr, second = !arena.allocate_array<double>(11).empty(),
                           third = arena.allocate(40, 16) != nullptr;
                return first && second && third;
            };
            Arena small(block.data() + shift, bytes);
            if (take(small)) continue;
            BudgetShortage shortage;
            ASSERT_TRUE(find_shortage(shortage_error("x", small).message.view(), shortage));
            Arena enough(block.data() + shift, shortage.enough());
            EXPECT_TRUE(take(enough)) << bytes << " bytes at " << shift;
        }
}

TEST(BudgetShortage, HugeRequestsDoNotWrapAround) {
    Arena arena(nullptr, 0);
    for (int n = 0; n < 3; ++n) EXPECT_TRUE(arena.allocate_array<double>(~std::size_t{0} / 4).empty());
    EXPECT_GE(arena.refused_bytes(), std::uint64_t{1} << 48);
    EXPECT_LT(arena.refused_bytes(), std::uint64_t{1} << 50);
}

}  // namespace
}  // namespace tedavis::base::test_budget_shortage
