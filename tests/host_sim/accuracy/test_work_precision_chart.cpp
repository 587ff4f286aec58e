#include "host_sim/accuracy/work_precision_chart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host_sim/accuracy/made_knob.hpp"

namespace tedavis::host_sim::test_work_precision_chart {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(DecadeScale, EnclosesWhatIsAboveZero) {
    const DecadeScale scale = DecadeScale::of({0, 0.03, 40, -2});
    EXPECT_EQ(scale.first, -2);
    EXPECT_EQ(scale.last, 2);
    EXPECT_DOUBLE_EQ(scale.place(0.01), 0);
    EXPECT_DOUBLE_EQ(scale.place(1), 0.5);
    EXPECT_DOUBLE_EQ(scale.place(100), 1);
    EXPECT_DOUBLE_EQ(scale.place(0), 0) << "no error has no logarithm";
    EXPECT_EQ(DecadeScale::of({0, 0}).last, 1);
    EXPECT_EQ(DecadeScale::of({1, 1}).last, 1) << "one decade at least";
}

TEST(WorkPrecisionChart, HasAMarkOfItsKindForEachLevel) {
    test_support::MadeKnob made(4);
    MeasuredKnob knob = measure_knob(made, made.plan(7));
    EXPECT_EQ(count_of(work_precision_svg(knob), "<circle "), 4u);
    knob.levels[1].is_dominated = true;
    knob.levels[3].error = {};
    const std::string svg = work_precision_svg(knob);
    EXPECT_EQ(count_of(svg, "<circle "), 2u);
    EXPECT_EQ(count_of(svg, "<path d='M"), 1u) << "the dominated one";
    EXPECT_EQ(count_of(svg, "<rect "), 1u) << "the one without an error";
    EXPECT_THAT(svg, ::testing::HasSubstr(">4 steps</text>"));
}

TEST(WorkPrecisionChart, AlternativesAreRingsOffTheLine) {
    const std::string svg = work_precision_svg(test_support::made_knob_of_one_level());
    EXPECT_EQ(count_of(svg, "<circle "), 3u);
    EXPECT_EQ(count_of(svg, "fill='none' stroke-width='2'/>"), 2u);
    const std::size_t line = svg.find("points='");
    ASSERT_NE(line, std::string::npos);
    EXPECT_EQ(count_of(svg.substr(line, svg.find("'/>", line) - line), ","), 1u) << "the only level";
}

TEST(WorkPrecisionChart, TextsAreSafe) {
    test_support::MadeKnob made(2);
    MeasuredKnob knob = measure_knob(made, made.plan(7));
    knob.levels[0].name = "<b>";
    EXPECT_THAT(work_precision_svg(knob), ::testing::Not(::testing::HasSubstr("<b>")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_work_precision_chart
