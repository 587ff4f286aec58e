#include "host_sim/comparison/comparison_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host_sim/comparison/made_runs.hpp"

namespace tedavis::host_sim::test_comparison_words {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

RunComparison two_designs() {
    ComparedRun a = made_run("out/a", 10), b = with_log(made_run("out/b", 10), a.log);
    a.design = "configs/default.toml";
    b.design = "cruise";
    return compared_runs(a, b, {});
}

TEST(ComparisonWords, TheTitleSaysWhatIsCompared) {
    EXPECT_EQ(comparison_title(two_designs()), "The same flight with two designs: A default.toml, B cruise");
    ComparedRun a = made_run("out/a/", 10), b = made_run("out/b", 10);
    a.log = "x/one.log", b.log = "y/two.log";
    EXPECT_EQ(comparison_title(compared_runs(a, b, {})), "Two flights: A one.log, B two.log");
    a.log = "x/flight.log", b.log = "y/flight.log";
    EXPECT_EQ(comparison_title(compared_runs(a, b, {})), "Two flights: A a, B b");
    EXPECT_EQ(comparison_title(compared_runs(a, a, {})), "Two runs of the same flight");
    ComparedRun night = a;
    night.light = "night";
    EXPECT_EQ(comparison_title(compared_runs(a, night, {})), "Two runs of the same flight, with another light: A none, B night");
}

TEST(ComparisonWords, WhereNothingDiffersItIsSaid) {
    const ComparedRun run = made_run("a", 10);
    EXPECT_THAT(difference_sentences(compared_runs(run, run, {})), ElementsAre(HasSubstr("Nothing differs")));
}

TEST(ComparisonWords, NumbersAreThoseOfTheRuns) {
    ComparedRun a = made_run("a", 10), b = with_log(made_run("b", 10), "a.log");
    for (ComparedFrame& frame : b.frames) {
        frame.values[kLabelsPlaced] = 8;
        frame.values[kAltitude] += 100;
        frame.effects = {"fog"};
    }
    b.frames[4].values[kHeightAboveTerrain] = 400 - 95.1;
    b.frames[6].phase = "approach.final";
    b.frames[6].terrain_alert = 2;
    const auto sentences = difference_sentences(compared_runs(a, b, {}));
    EXPECT_THAT(sentences, Contains(HasSubstr("B came 312 ft (95 m) closer to the ground in flight: A to 1312 ft (400 m)")));
    EXPECT_THAT(sentences, Contains(HasSubstr("B placed 30 labels more: 80 against 50 in 10 frames of each")));
    EXPECT_THAT(sentences, Contains(HasSubstr("B flew 328 ft (100 m) higher than A")));
    EXPECT_THAT(sentences, Contains(HasSubstr("1 effect was drawn in unequally many of 10 frames: shadow (A 10, B 0)")));
    EXPECT_THAT(sentences, Contains(HasSubstr("The flight phase differs in 1 of 10 instants, first at 6.0 s: cruise in A, "
                                              "approach.final in B")));
    EXPECT_THAT(sentences, Contains(HasSubstr("caution in 0 and warning in 1 of 10 in B")));
    EXPECT_THAT(sentences, Contains(HasSubstr("The pictures are equal in all 10 instants")));
    for (const std::string& sentence : sentences) EXPECT_EQ(sentence.back(), '.');
    const auto exchanged = difference_sentences(compared_runs(with_log(b, "b.log"), with_log(a, "b.log"), {}));
    EXPECT_THAT(exchanged, Contains(HasSubstr("A came 312 ft (95 m) closer to the ground in flight")));
    EXPECT_THAT(exchanged, Contains(HasSubstr("B placed 30 labels fewer")));
}

TEST(ComparisonWords, TheIntroductionStatesTheAlignment) {
    const auto sentences = run_introductions(two_designs());
    EXPECT_THAT(sentences, Contains(HasSubstr("A is out/a: 10 frames of a.log, 0.0 s to 9.0 s, with the design default.toml")));
    EXPECT_THAT(sentences, Contains(HasSubstr("aligned by its time. B has a counterpart to all 10 frames of A")));
    EXPECT_THAT(sentences, Contains("They differ in this: design default.toml in A, cruise in B."));
}

TEST(ComparisonWords, WarnsOfSizesAndMissingPictures) {
    ComparedRun a = made_run("a", 3), b = with_log(made_run("b", 3), "a.log");
    b.size = "640x480";
    EXPECT_THAT(comparison_warnings(compared_runs(a, b, {})), Contains(HasSubstr("are 960x540 and those of b 640x480")));
    EXPECT_THAT(comparison_warnings(compared_runs(a, b, {})), Contains(HasSubstr("b has no pictures")));
    a.frames[0].picture = b.frames[0].picture = "x.png";
    b.size = a.size;
    EXPECT_THAT(comparison_warnings(compared_runs(a, b, {})), IsEmpty());
}

TEST(ComparisonWords, AnInstantHasBothTimesWhereTheyDiffer) {
    EXPECT_EQ(instant_words(two_designs(), 3), "3.0 s");
    ComparedRun a = made_run("a", 10), b = made_run("b", 10);
    b.frames[3].time_s = 3.2;
    EXPECT_EQ(instant_words(compared_runs(a, b, {Alignment::place, 3000}), 3), "A 3.0 s, B 3.2 s");
}

TEST(ComparisonWords, RunsWithoutHashesClaimNoEqualPictures) {
    ComparedRun a = made_run("a", 10);
    for (ComparedFrame& frame : a.frames) frame.hash = "0000000000000000";
    const RunComparison alike = compared_runs(a, a, {});
    EXPECT_THAT(difference_sentences(alike), ElementsAre(HasSubstr("the pictures of none are known")));
    EXPECT_THAT(comparison_warnings(alike), Contains(HasSubstr("a has no hash of the picture in all 10 records")));
    ComparedRun b = a;
    b.frames[4].values[kAltitude] += 100;
    for (const std::string& sentence : difference_sentences(compared_runs(a, b, {})))
        EXPECT_THAT(sentence, Not(HasSubstr("picture")));
    for (std::size_t n = 0; n < 4; ++n) a.frames[n].hash = b.frames[n].hash = "5f";
    EXPECT_THAT(difference_sentences(compared_runs(a, b, {})),
                Contains("The pictures are equal in all 4 instants in which both records have their hash."));
    EXPECT_THAT(difference_sentences(compared_runs(a, a, {})), ElementsAre(HasSubstr("the pictures in the 4 that have them.")));
}

TEST(ComparisonWords, MeasuredTimesAreToldThoughNothingDiffers) {
    const ComparedRun a = made_run("a", 10);
    ComparedRun b = a;
    for (ComparedFrame& frame : b.frames) frame.values[kFrameTime] = 40;
    EXPECT_THAT(difference_sentences(compared_runs(a, b, {})),
                ElementsAre(HasSubstr("Nothing differs"), HasSubstr("30.0 ms in A and 40.0 ms in B")));
}

TEST(ComparisonWords, EqualIsSaidOfTheInstantsThatKnowIt) {
    ComparedRun a = made_run("a", 10), b = a;
    for (std::size_t n = 0; n < 4; ++n) a.frames[n].values[kAltitude] = kUnknown;
    b.frames[9].values[kLabelsPlaced] = 9;
    const auto sentences = difference_sentences(compared_runs(a, b, {}));
    EXPECT_THAT(sentences, Contains("Equal where both know it, in instants: altitude (6 of 10)."));
    EXPECT_THAT(sentences, Contains("Known in one run alone, in instants: altitude (4 of 10)."));
    EXPECT_THAT(sentences, Contains(StartsWith("Equal in all instants: height above terrain")));
    EXPECT_THAT(sentences, Not(Contains(AllOf(StartsWith("Equal in all"), HasSubstr("altitude")))));
}

TEST(ComparisonWords, WithoutThePhaseNothingIsSaidOfTheGround) {
    ComparedRun a = made_run("a", 10), b = a;
    b.frames[0].values[kHeightAboveTerrain] = 0;
    EXPECT_THAT(difference_sentences(compared_runs(a, b, {})),
                Contains(AllOf(StartsWith("B came 1312 ft"), HasSubstr("; each over its frames in flight"))));
    for (ComparedRun* const run : {&a, &b})
        for (ComparedFrame& frame : run->frames) frame.phase = "unknown";
    EXPECT_THAT(difference_sentences(compared_runs(a, a, {})),
                ElementsAre(StartsWith("Nothing differs in what is known: pictures, alerts, effects and")));
    for (const std::string& sentence : difference_sentences(compared_runs(a, b, {}))) {
        EXPECT_THAT(sentence, Not(HasSubstr("to the ground")));
        EXPECT_THAT(sentence, Not(HasSubstr("flight phase")));
    }
}

TEST(ComparisonWords, TheClosestPointIsThatOfTheSummary) {
    ComparedRun a = made_run("a", 10), b = made_run("b", 10);
    a.closest = nlohmann::ordered_json::parse(R"({"by_height": [{"time_s": 3.5, "height_above_terrain_m": 30.48}]})");
    EXPECT_THAT(
        difference_sentences(compared_runs(a, b, {})),
        Contains(AllOf(HasSubstr("A to 100 ft (30 m) above it at 3.5 s, B to 1312 ft (400 m) at 0.0 s; A over its whole run"),
                       HasSubstr(", B over its frames in flight"))));
    b.closest = nlohmann::ordered_json::parse(R"({"by_height": [{"time_s": 7, "height_above_terrain_m": 60.96}]})");
    EXPECT_THAT(
        difference_sentences(compared_runs(a, b, {})),
        Contains(AllOf(StartsWith("A came 100 ft (30 m) closer"), HasSubstr("each over its whole run, between its frames"))));
}

TEST(ComparisonWords, WhereTheFramesOfBRepeatNumbersArePerFrame) {
    ComparedRun a = made_run("a", 41), b = with_log(made_run("b", 11, 0, 4), "a.log");
    b.frames[5].values[kLabelsPlaced] = 16;
    b.frames[5].effects = {};
    b.frames[5].terrain_alert = 1;
    const RunComparison runs = compared_runs(a, b, {});
    EXPECT_THAT(run_introductions(runs)[2], HasSubstr("They are 11 frames of B"));
    EXPECT_THAT(run_introductions(compared_runs(a, a, {}))[2], Not(HasSubstr("They are")));
    EXPECT_THAT(
        difference_sentences(runs),
        AllOf(Contains("B placed 1.0 labels more per frame in the mean: 6.0 in 11 frames of B, 5.0 in 41 frames of A."),
              Contains("2 effects were drawn in unequal parts of the frames, 41 of A and 11 of B: fog (A 41, B 10), shadow "
                       "(A 41, B 10)."),
              Contains("Frames with terrain alerts: caution in 0 and warning in 0 of 41 in A, caution in 1 and "
                       "warning in 0 of 11 in B.")));
}

TEST(ComparisonWords, LongRunsSayHowManyFramesWereLookedAt) {
    ComparedRun a = made_run("a", 8000), b = made_run("b", 100);
    EXPECT_THAT(run_introductions(compared_runs(a, b, {Alignment::place, 3000}))[2],
                HasSubstr("every 3rd frame of A and every frame of B was looked at. B has a counterpart to "));
    EXPECT_THAT(run_introductions(compared_runs(a, b, {Alignment::place, 3000}))[2],
                HasSubstr(" of 2667 frames of A that were looked at"));
    EXPECT_THAT(run_introductions(compared_runs(b, b, {Alignment::place, 3000}))[2], Not(HasSubstr("looked at")));
}

TEST(ComparisonWords, FramesThatDoNotMeetAreSaid) {
    const ComparedRun a = made_run("a", 10);
    const auto words = [&a](double first_s) {
        std::string all;
        for (const std::string& one : run_introductions(compared_runs(a, with_log(made_run("b", 10, first_s), a.log), {})))
            all += one;
        return all;
    };
    EXPECT_THAT(words(0.4), HasSubstr("lie up to 0.4 s from these moments"));
    EXPECT_THAT(words(-0.3), HasSubstr("lie up to 0.3 s from these moments"));
    EXPECT_THAT(words(0), Not(HasSubstr("from these moments")));
}

}  // namespace
}  // namespace tedavis::host_sim::test_comparison_words
