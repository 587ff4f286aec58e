#include "host_sim/comparison/height_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/comparison/comparison_words.hpp"
#include "tests/host_sim/comparison/made_runs.hpp"

namespace tedavis::host_sim::test_height_words {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class HeightWords : public ::testing::Test {
protected:
    [[nodiscard]] std::vector<std::string> sentences() const { return height_sentences(compared_runs(a_, b_, {})); }
    ComparedRun a_ = made_run("a", 10), b_ = with_log(made_run("b", 10), "a.log");
};

TEST_F(HeightWords, GeometricHeightsOverKnownGroundNeedNone) { EXPECT_THAT(sentences(), IsEmpty()); }

TEST_F(HeightWords, AssumedHeightsAreSaid) {
    a_.assumes_heights = b_.assumes_heights = true;
    EXPECT_THAT(sentences(), ElementsAre("Heights of both are pressure altitudes, taken for heights above sea level "
                                         "(--assume-geometric)."));
    EXPECT_THAT(difference_sentences(compared_runs(a_, b_, {})), Contains(sentences().front())) << "though nothing differs";
    b_.frames[2].values[kAltitude] += 50;
    EXPECT_THAT(difference_sentences(compared_runs(a_, b_, {})), Contains(sentences().front()));
    a_.assumes_heights = false;
    EXPECT_THAT(sentences(), ElementsAre("Heights of B are pressure altitudes, taken for heights above sea level "
                                         "(--assume-geometric); those of A are not, so that a part of each difference in height "
                                         "comes from that."));
}

TEST_F(HeightWords, PressureAltitudesAreSaidWithTheirFrames) {
    for (std::size_t n = 0; n < 4; ++n) a_.frames[n].has_pressure_height = true;
    EXPECT_EQ(frames_by_pressure(a_), 4u);
    EXPECT_THAT(sentences(), ElementsAre(HasSubstr("Heights of A are pressure altitudes alone in 4 of 10 frames, which are no")));
    for (ComparedFrame& frame : a_.frames) frame.has_pressure_height = true;
    b_.assumes_heights = true;
    EXPECT_THAT(sentences(), ElementsAre("Heights of A are pressure altitudes alone, which are no heights above sea level; those "
                                         "of B are pressure altitudes, taken for heights above sea level (--assume-geometric)."));
}

TEST_F(HeightWords, PartsOverKnownGroundAreSaid) {
    for (std::size_t n = 3; n < 10; ++n) b_.frames[n].values[kHeightAboveTerrain] = kUnknown;
    EXPECT_EQ(frames_over_known_ground(b_), 3u);
    EXPECT_THAT(sentences(), ElementsAre(HasSubstr("The ground below is known in all 10 frames of A and 3 of 10 frames of B: ")));
    for (ComparedFrame& frame : b_.frames) frame.values[kHeightAboveTerrain] = kUnknown;
    EXPECT_THAT(sentences(), ElementsAre(HasSubstr("in all 10 frames of A and none of 10 frames of B: ")));
    for (ComparedFrame& frame : a_.frames) frame.values[kHeightAboveTerrain] = kUnknown;
    EXPECT_THAT(sentences(), IsEmpty()) << "no height above the terrain is compared";
}

}  // namespace
}  // namespace tedavis::host_sim::test_height_words
