#include "host_sim/evaluation/order_agreement.hpp"

#include <gtest/gtest.h>

namespace tedavis::host_sim::test_order_agreement {
namespace {

TEST(OrderAgreement, CountsPairs) {
    const OrderAgreement same = order_agreement({1, 2, 3, 4}, {10, 20, 21, 50});
    EXPECT_EQ(same.pairs, 6u);
    EXPECT_EQ(same.alike, 6u);
    EXPECT_EQ(order_agreement({1, 2, 3, 4}, {4, 3, 2, 1}).alike, 0u);
    EXPECT_EQ(order_agreement({1, 2, 3}, {1, 3, 2}).alike, 2u);
}

TEST(OrderAgreement, PairsWithoutAnOrderDoNotCount) {
    const OrderAgreement ties = order_agreement({1, 1, 2}, {5, 6, 6});
    EXPECT_EQ(ties.pairs, 2u);
    EXPECT_EQ(ties.alike, 1u) << "one is equal in the second measure";
    EXPECT_EQ(order_agreement({}, {}).pairs, 0u);
    EXPECT_EQ(order_agreement({3}, {1}).pairs, 0u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_order_agreement
