#include "host_sim/commands/evaluate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/layer_mask.hpp"
#include "tests/support/flights/evaluated_flights.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_evaluate {
namespace {

using test_support::CommandRun;
using ::testing::HasSubstr;
using ::testing::Not;

class EvaluateCommand : public ::testing::Test {
protected:
    CommandRun evaluate(const std::vector<std::string>& inputs, bool json = false, const std::string& fixations = "",
                        std::uint32_t threads = 2) {
        const EvaluateOptions options{inputs, place_.file("out"), fixations, orderings_, canny_, threads};
        return test_support::run_command([&](Console& console) { return run_evaluate(options, console); }, json);
    }
    std::string picture(const std::string& name, std::uint32_t stripe) {
        write_png(place_.file(name), view_of(test_support::striped_picture(80, 60, stripe)));
        return place_.file(name);
    }
    void refused_in(const std::string& folder, const std::vector<std::string>& inputs, const std::string& words) {
        const EvaluateOptions options{inputs, place_.file(folder), "", orderings_, {}, 1};
        test_support::expect_user_error(
            [&] { (void)test_support::run_command([&](Console& console) { return run_evaluate(options, console); }, false); },
            words);
        EXPECT_FALSE(std::filesystem::exists(place_.file(folder))) << "nothing is left";
    }
    void refused(const std::vector<std::string>& inputs, const std::string& words, const std::string& fixations = "") {
        test_support::expect_user_error([&] { (void)evaluate(inputs, false, fixations); }, words);
        EXPECT_FALSE(std::filesystem::exists(place_.file("out"))) << "nothing is left";
    }
    test_support::TemporaryFolder place_;
    std::string orderings_;
    std::optional<perception::CannySettings> canny_;
};

TEST_F(EvaluateCommand, PicturesGetNumbersAndViews) {
    const CommandRun run = evaluate({picture("plain.png", 0), picture("busy.png", 5)}, true);
    EXPECT_EQ(run.code, 0);
    const auto json = run.json();
    EXPECT_EQ(json["pictures"][0]["clutter"], 0.0);
    EXPECT_GT(json["pictures"][1]["clutter"], 0.1);
    EXPECT_EQ(json, nlohmann::json::parse(place_.read("out/evaluation.json")));
    EXPECT_TRUE(std::filesystem::exists(place_.file("out/" + json["pictures"][1]["saliency_map"].get<std::string>())));
    const std::string text = evaluate({picture("busy.png", 5)}).results;
    for (const char* part : {"1 picture", "busy.png", "busiest region"}) EXPECT_THAT(text, HasSubstr(part));
}

TEST_F(EvaluateCommand, PicturesAreHeldAgainstWhatIsReported) {
    orderings_ =
        place_.write("o.toml",
                     "[[ordering]]\ntitle = \"busier\"\nmeasure = \"clutter\"\nmore = \"busy.png\"\nless = \"plain.png\"\n"
                     "[[ordering]]\ntitle = \"wrong\"\nmeasure = \"clutter\"\nmore = \"plain.png\"\nless = \"busy.png\"\n"
                     "[[ordering]]\ntitle = \"other\"\nmeasure = \"clutter\"\nmore = \"other.png\"\nless = \"busy.png\"\n");
    const CommandRun run = evaluate({picture("plain.png", 0), picture("busy.png", 5)});
    EXPECT_EQ(run.code, 0);
    for (const char* part : {"holds    busier", "differs  wrong", "not measured"}) EXPECT_THAT(run.results, HasSubstr(part));
    const auto json = nlohmann::json::parse(place_.read("out/evaluation.json"));
    EXPECT_EQ(json["orderings"][1]["state"], "differs");
    test_support::write_striped_run(place_, "run", 3, {});
    refused_in("other", {place_.file("run")}, "--orderings: compares pictures");
}

TEST_F(EvaluateCommand, EdgesAreThoseOfTheThresholdsThatWereAskedFor) {
    const auto canny = [&] {
        const auto json = evaluate({picture("busy.png", 5)}, true).json();
        const auto& used = json["pictures"][0]["canny"];
        return std::array<double, 3>{used["sigma"], used["low"], used["high"]};
    };
    EXPECT_EQ(canny(), (std::array<double, 3>{1, 70, 170}));
    orderings_ = place_.write("o.toml",
                              "[canny]\nsigma = 2\nlow = 6\nhigh = 15\n[[ordering]]\ntitle = \"a\"\n"
                              "measure = \"clutter\"\nmore = \"a.png\"\nless = \"busy.png\"\n");
    EXPECT_EQ(canny(), (std::array<double, 3>{2, 6, 15}));
    canny_ = perception::CannySettings{0, 1, 2};
    EXPECT_EQ(canny(), (std::array<double, 3>{0, 1, 2})) << "the command's comes first";
}

TEST_F(EvaluateCommand, WarnsOfPicturesWithTheAccuracyDrawnOverThem) {
    test_support::write_striped_run(place_, "run", 3, {});
    EXPECT_THAT(evaluate({place_.file("run")}).notes, Not(HasSubstr("warning"))) << "control";
    test_support::write_run(
        place_, "marked", [](FrameResult& result) { result.has_accuracy_overlay = result.record.frame > 0; }, 3);
    for (std::uint64_t n = 0; n < 3; ++n)
        test_support::write_picture(place_, "marked", n, test_support::striped_picture(80, 60, 5));
    EXPECT_THAT(evaluate({place_.file("marked")}).notes, HasSubstr("2 of 3 pictures have the accuracy drawn over them"));
}

TEST_F(EvaluateCommand, MasksOfLayersAreNoPictures) {
    const std::vector<std::uint8_t> layers(80 * 60, 1);
    const std::string busy = picture("busy.png", 5);
    write_layer_mask(busy, {layers.data(), 80, 60});
    place_.write("sheet.json", "{\"layers\":[\"terrain\",\"data\"]}");
    const auto json = evaluate({busy, place_.file("busy.layers.png")}, true).json();
    ASSERT_EQ(json["pictures"].size(), 1u);
    EXPECT_EQ(json["pictures"][0]["layer_shares"]["data"], 1.0);
    refused_in("other", {place_.file("busy.layers.png")}, "name the picture");
}

TEST_F(EvaluateCommand, AFolderOfASheetStandsForItsPictures) {
    static_cast<void>(picture("b.png", 5));
    static_cast<void>(picture("a.png", 0));
    static_cast<void>(picture("sheet.png", 3));
    place_.write("sheet.json", "{\"pictures\":[{\"file\":\"b.png\"},{\"file\":\"a.png\"}]}");
    const auto json = evaluate({place_.file(".")}, true).json();
    ASSERT_EQ(json["pictures"].size(), 2u);
    EXPECT_GT(json["pictures"][0]["clutter"], json["pictures"][1]["clutter"]);
    place_.write("sheet.json", "{}");
    refused_in("other", {place_.file(".")}, "sheet.json: names no pictures");
}

TEST_F(EvaluateCommand, ARunGetsAReport) {
    test_support::write_striped_run(place_, "run", 12, {3, 8});
    const CommandRun run = evaluate({place_.file("run")});
    EXPECT_EQ(run.code, 0);
    for (const char* part : {"12 frames", "A: 3.0 s, takeoff.first_climb", "B: 8.0 s", "report.html"})
        EXPECT_THAT(run.results, HasSubstr(part));
    EXPECT_THAT(place_.read("out/report.html"), HasSubstr("id='moment-B'"));
    const auto json = nlohmann::json::parse(place_.read("out/evaluation.json"));
    EXPECT_EQ(json["pictures"].size(), 12u);
    EXPECT_TRUE(std::filesystem::exists(place_.file("out/A.sheet.png")));
    EXPECT_TRUE(std::filesystem::exists(place_.file("out/B.saliency.png")));
}

TEST_F(EvaluateCommand, TheResultDoesNotDependOnThreads) {
    test_support::write_striped_run(place_, "run", 12, {3, 8});
    (void)evaluate({place_.file("run")}, false, "", 1);
    const std::string report = place_.read("out/report.html"), json = place_.read("out/evaluation.json");
    (void)evaluate({place_.file("run")}, false, "", 3);
    EXPECT_EQ(place_.read("out/report.html"), report);
    EXPECT_EQ(place_.read("out/evaluation.json"), json);
}

TEST_F(EvaluateCommand, TwoRunsAreCompared) {
    test_support::write_striped_run(place_, "a", 12, {3, 8});
    test_support::write_striped_run(place_, "b", 12, {5});
    const auto json = evaluate({place_.file("a"), place_.file("b")}, true).json();
    EXPECT_EQ(json["runs"].size(), 2u);
    EXPECT_LT(json["differences"]["all"]["change"], 0) << "one busy picture less";
    EXPECT_EQ(json["runs"][1]["peaks"][0]["label"], "B1");
    EXPECT_TRUE(std::filesystem::exists(place_.file("out/B1.other.heat.png")));
}

TEST_F(EvaluateCommand, RecordedGazeIsScored) {
    const std::string gaze = place_.write("gaze.csv", "x,y\n0.1,0.5\n0.2,0.5\n");
    const CommandRun run = evaluate({picture("busy.png", 5)}, false, gaze);
    EXPECT_THAT(run.results, HasSubstr("recorded gaze on 1 picture: AUC "));
}

TEST_F(EvaluateCommand, SaysWhatIsWrong) {
    test_support::write_striped_run(place_, "run", 3, {});
    const std::string run = place_.file("run"), image = picture("a.png", 5);
    refused({run, image}, "pictures and runs together");
    refused({run, run, run}, "a third run");
    refused({place_.file("none.png")}, "no such file");
    refused({image}, "gaze.csv:2: 'x' is no number", place_.write("gaze.csv", "x,y\nx,1\n"));
    const EvaluateOptions over{{image}, run, "", "", {}, 1};
    test_support::expect_user_error(
        [&] { (void)test_support::run_command([&](Console& console) { return run_evaluate(over, console); }); }, "holds a run");
}

}  // namespace
}  // namespace tedavis::host_sim::test_evaluate
