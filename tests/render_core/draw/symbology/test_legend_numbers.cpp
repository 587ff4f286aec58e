#include "render_core/draw/symbology/legend_numbers.hpp"

#include <gtest/gtest.h>

#include "tests/support/draw/data_legend_samples.hpp"

namespace tedavis::draw::test_legend_numbers {
namespace {

TEST(LegendNumbers, StepsAreRound) {
    for (const auto& [least, step] : {std::pair{1.0, 1.0}, {1.1, 2.0}, {2.1, 5.0}, {5.1, 10.0}, {0.03, 0.05}, {180.0, 200.0}})
        EXPECT_NEAR(nice_step(least), step, 1e-9 * step) << least;
}

TEST(LegendNumbers, HaveTheDecimalsOfTheirStep) {
    EXPECT_EQ(number_text(38.877, 5).view(), "39");
    EXPECT_EQ(number_text(38.877, 0.5).view(), "38.9");
    EXPECT_EQ(number_text(38.877, 38.877).view(), "38.88") << "a limit to a share of itself";
    EXPECT_EQ(number_text(-0.0001, 1).view(), "0") << "no minus before a zero";
}

TEST(LegendNumbers, SignsAreWritten) {
    EXPECT_EQ(signed_number(1000).view(), "+1000");
    EXPECT_EQ(signed_number(-500.2).view(), "-500");
    EXPECT_EQ(signed_number(0.3).view(), "0");
}

TEST(LegendNumbers, AreThoseOfTheScaleInTheUnitOfTheLegend) {
    DataLegend wind = test_support::wind();
    wind.factor = 2;
    wind.offset = 1;
    EXPECT_EQ(written(wind, lowest(wind.scale)), 1);
    EXPECT_EQ(written(wind, highest(wind.scale)), 41);
}

}  // namespace
}  // namespace tedavis::draw::test_legend_numbers
