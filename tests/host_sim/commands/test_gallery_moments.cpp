#include "host_sim/commands/gallery_moments.hpp"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_gallery_moments {
namespace {

base::Time at(double seconds) { return base::Time{0} + base::Duration::from_seconds(seconds); }

/// Two approaches of 10 s with 5 s of go-around between.
std::vector<PhaseSpan> two_approaches() {
    std::vector<PhaseSpan> spans;
    for (int s = 0; s <= 10; ++s) add_to_spans(flight::kApproachFinal, at(s), spans);
    for (int s = 11; s <= 16; ++s) add_to_spans(flight::kGoAroundAbort, at(s), spans);
    for (int s = 20; s <= 30; ++s) add_to_spans(flight::kApproachFinal, at(s), spans);
    return spans;
}

TEST(GalleryMoments, TimesOfAPhaseAreToldApart) {
    const auto spans = two_approaches();
    ASSERT_EQ(spans.size(), 3u);
    EXPECT_EQ(spans[0].end, at(10));
    EXPECT_EQ(spans[1].begin, at(11));
    EXPECT_EQ(spans[1].end, at(16));
    GalleryMoment moment{"", "", "", "", flight::kApproachFinal, 0, 0.5};
    EXPECT_EQ(instant_of(moment, spans, "log"), at(5));
    moment.turn = 1;
    EXPECT_EQ(instant_of(moment, spans, "log"), at(25));
    moment.share = 1;
    EXPECT_EQ(instant_of(moment, spans, "log"), at(30));
    moment.phase = flight::kGoAroundAbort;
    moment.turn = 0;
    EXPECT_EQ(instant_of(moment, spans, "log"), at(16));
}

/// The panel states the approach alone, the bus its phases.
TEST(GalleryMoments, WhereNoSubPhaseIsStatedTheyAreOfTheScenario) {
    std::vector<PhaseSpan> spans = two_approaches();
    for (int s = 31; s <= 40; ++s) add_to_spans(flight::kApproachLanding, at(s), spans);
    GalleryMoment moment{"", "", "", "", flight::kApproachLanding, 1, 0};
    EXPECT_EQ(instant_of(moment, spans, "log"), at(31));
    moment.turn = 0;
    moment.share = 0.9;
    EXPECT_EQ(instant_of(moment, spans, "log"), at(9));
    moment.turn = 1;
    moment.phase = {flight::Scenario::approach};
    EXPECT_EQ(instant_of(moment, spans, "log"), at(38)) << "of 20 to 40";
    moment.phase = flight::kApproachInitial;
    EXPECT_EQ(instant_of(moment, spans, "log"), at(38));
}

TEST(GalleryMoments, AFlightWithoutTheMomentIsRefused) {
    const GalleryMoment third{"", "", "Third try", "", flight::kApproachFinal, 2, 0.5};
    test_support::expect_user_error([&] { static_cast<void>(instant_of(third, two_approaches(), "my.log")); },
                                    "my.log: flies the scenario approach 2 times, and the picture 'Third try' shows time 3");
}

TEST(GalleryMoments, AreTwelveWithNamesAndSentencesOfTheirOwn) {
    std::set<std::string> names, captions;
    for (const GalleryMoment& moment : gallery_moments()) {
        names.insert(moment.name);
        captions.insert(moment.caption);
        EXPECT_LE(std::string(moment.title).size(), 60u);
        EXPECT_EQ(std::string(moment.caption).back(), '.') << moment.name;
        EXPECT_GE(moment.share, 0);
        EXPECT_LE(moment.share, 1);
    }
    EXPECT_EQ(gallery_moments().size(), 12u);
    EXPECT_EQ(names.size(), 12u);
    EXPECT_EQ(captions.size(), 12u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_gallery_moments
