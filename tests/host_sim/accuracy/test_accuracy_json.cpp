#include "host_sim/accuracy/accuracy_json.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "host_sim/accuracy/knobs/frame_settings_knob.hpp"
#include "tests/host_sim/accuracy/made_knob.hpp"
#include "tests/support/flights/six_levels.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_accuracy_json {
namespace {

AccuracyReport made_report() {
    AccuracyReport report = test_support::made_report();
    report.knobs.push_back(test_support::made_knob_of_one_level());
    report.not_measured = {"another"};
    report.interrupted = true;
    report.budget_ms = 13;
    KnobPictures pictures;
    pictures.knob = "made";
    pictures.cheap_level = "1 steps";
    pictures.exact_level = "16 steps";
    pictures.place = {"a pose", "a command", 3, 4};
    pictures.errors = {1, 2, 0.25, 0.5};
    pictures.cheap.file = "made-cheap.png";
    report.knobs[0].pictures = pictures;
    report.knobs[0].levels[0].worst_pixel = KnobPixel{3, 4};
    FlightErrors flight;
    flight.flight = "a flight";
    flight.terrain = "alps.tdb";
    flight.asked_px = 1;
    flight.moments = {{10, 0.9, 0.5, 12, 100, "36,-84,1000,0,0,0"}};
    flight.lines = {{4, 3.5, 2.1, 600, 2}};
    report.flights = {flight};
    EffectUse use;
    use.name = "haze";
    use.contribution = "color";
    use.asked = use.skipped = 3;
    use.reasons = {{"nothing near", 3}};
    use.largest_difference = 1;
    use.worst_pose = "36,-84,1000,0,0,0";
    report.uncalled = UncalledEffects{"default", "es3-mid", 3, {use}};
    GovernorChoice choice;
    choice.costs = "costs.toml";
    choice.levels = test_support::six_levels();
    choice.deadline_ms = 33;
    choice.frames = {60, 0, 0, 15, 0, 5};
    report.governor = choice;
    report.control = NegativeControl{"steps", "m", "bad", "good", "here", 1e-9, {3, 4, 5, 6, 7}, {1, 1, 1, 1, 7}, true};
    report.comparisons = {
        {"old.json", "a processor", "a date", "1.0", true, {{"made", "4 steps", 1, 2, 3, 4, true, false}}, {"gone"}, {}}};
    return report;
}

TEST(AccuracyJson, IsReadAsItWasWritten) {
    const auto json = accuracy_json(made_report());
    EXPECT_EQ(accuracy_json(read_accuracy(json.dump(), "x.json")), json);
    EXPECT_EQ(json.at("knobs")[0].at("levels")[2].at("error").at("max"), 0.25);
    EXPECT_EQ(json.at("knobs")[0].at("reference").at("bound"), 1e-9);
    EXPECT_EQ(json.at("knobs")[0].at("only_level"), "");
    EXPECT_EQ(json.at("knobs")[1].at("only_level"), "one is enough");
    EXPECT_EQ(json.at("knobs")[1].at("levels")[0].at("offered"), true);
    EXPECT_EQ(json.at("knobs")[1].at("levels")[1].at("offered"), false);
    EXPECT_EQ(json.at("governor").at("levels")[5].at("given_up").size(), 7u);
    EXPECT_EQ(json.at("governor").at("levels")[3].at("frames"), 15);
    EXPECT_EQ(json.at("not_measured"), (std::vector<std::string>{"another"}));
}

TEST(AccuracyJson, StatesTheAnswersWithTheirMargin) {
    AccuracyReport report = test_support::made_report();
    report.knobs[0].noise = 0.25;
    EXPECT_TRUE(accuracy_json(report).at("answers").empty()) << "control: no budget was asked for, and no frame was measured";
    report.budget_ms = 16;
    auto answers = accuracy_json(report).at("answers");
    ASSERT_EQ(answers.size(), 1u);
    EXPECT_EQ(answers[0], nlohmann::ordered_json({{"knob", "made"},
                                                  {"budget_ms", 16},
                                                  {"level", "4 steps"},
                                                  {"spread_ms", 12},
                                                  {"margin", 0.25},
                                                  {"needed_ms", 15},
                                                  {"expected_share", 0.95}}));
    report.budget_ms = 3;
    answers = accuracy_json(report).at("answers");
    EXPECT_TRUE(answers[0].at("level").is_null());
    EXPECT_TRUE(answers[0].at("needed_ms").is_null());
    report.knobs[0].name = kFrameSettings;
    EXPECT_EQ(accuracy_json(report).at("answers").size(), 6u) << "and those of the first screen";
}

TEST(AccuracyJson, RefusesWhatItCannotRead) {
    const auto whole = accuracy_json(made_report());
    const auto read = [](const std::string& text) { return [text] { static_cast<void>(read_accuracy(text, "x.json")); }; };
    test_support::expect_user_error(read("[1, 2"), "x.json: is no JSON object");
    auto other = whole;
    other["schema"] = "tedavis.accuracy/0";
    test_support::expect_user_error(read(other.dump()), "'tedavis.accuracy/0'");
    auto cut = whole;
    cut.at("knobs")[0].at("levels")[1].erase("ms");
    test_support::expect_user_error(read(cut.dump()), "x.json: is not whole");
    EXPECT_NO_THROW(read(whole.dump())()) << "control";
}

TEST(AccuracyCsv, HasALineForEveryLevel) {
    const std::string csv = accuracy_csv(made_report());
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 9);
    EXPECT_THAT(csv, ::testing::HasSubstr("\nmade,\"4 steps\",4,12,12,12,\"m\","));
    const std::size_t head = static_cast<std::size_t>(std::count(csv.begin(), std::find(csv.begin(), csv.end(), '\n'), ','));
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), ',')), 9 * head) << "as many cells in every line";
}

}  // namespace
}  // namespace tedavis::host_sim::test_accuracy_json
