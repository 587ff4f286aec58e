#include "host_sim/commands/compare.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files/run_folders.hpp"
#include "tests/support/programs/command_run.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_compare {
namespace {

using test_support::expect_user_error;
using ::testing::HasSubstr;
using ::testing::Not;

class CompareCommand : public ::testing::Test {
protected:
    CompareCommand() {
        for (const char* name : {"a", "b"}) {
            test_support::write_run(place_, name,
                                    [&](FrameResult& result) { result.record.labels.placed = name[0] == 'a' ? 2 : 5; });
            place_.write(std::string(name) + "/summary.json", R"({"log": "x.log", "size": "8x8"})");
            const RgbaPicture picture{8, 8, std::vector<std::uint8_t>(256, 9)};
            for (std::uint64_t n = 0; n < 5; ++n) test_support::write_picture(place_, name, n, picture);
        }
    }
    test_support::CommandRun compare(const std::string& output, bool json = false, const std::string& b = "b") {
        CompareOptions options{place_.file("a"), place_.file(b), place_.file(output), {}};
        return test_support::run_command([&](Console& console) { return run_compare(options, console); }, json);
    }
    test_support::TemporaryFolder place_;
};

TEST_F(CompareCommand, WritesThePageAndItsJson) {
    const auto text = compare("out/page.html");
    EXPECT_EQ(text.code, 0);
    EXPECT_EQ(text.notes, "");
    EXPECT_THAT(text.results, HasSubstr("B placed 15 labels more: 25 against 10 in 5 frames of each."));
    EXPECT_THAT(place_.read("out/page.html"), HasSubstr("Side by side"));
    const auto json = nlohmann::json::parse(place_.read("out/compare.json"));
    EXPECT_EQ(json["instants"].size(), 5u);
    EXPECT_EQ(compare("out/page.html", true).json(), json) << "it may be written again";
    EXPECT_EQ(compare("out/self.html", true, "a").json()["equal"], true);
}

TEST_F(CompareCommand, SaysWhyTheMapHasNoTerrainAndWhatAWithinChanges) {
    EXPECT_EQ(compare("out/page.html").code, 0);
    EXPECT_THAT(place_.read("out/page.html"), HasSubstr("The map has no terrain: neither run names a terrain database."));
    for (const char* name : {"a", "b"})
        place_.write(std::string(name) + "/summary.json", R"({"log": "x.log", "terrain": "j.tdb"})");
    EXPECT_EQ(compare("out/page.html").code, 0);
    EXPECT_THAT(place_.read("out/page.html"), HasSubstr("j.tdb of " + place_.file("a") + " is neither in its folder"));
    const std::string gone = place_.file("gone/j.tdb");
    place_.write("a/summary.json", R"({"log": "x.log", "terrain": ")" + gone + R"("})");
    EXPECT_EQ(compare("out/page.html").code, 0);
    EXPECT_THAT(place_.read("out/page.html"),
                HasSubstr(gone + " of " + place_.file("a") + " is neither there nor in the folder of the run."));
    place_.write("a/summary.json", R"({"log": "x.log", "terrain": "j.tdb"})");
    place_.write("j.tdb", "no database");  // beside the folders of the runs
    EXPECT_EQ(compare("out/page.html").code, 0);
    EXPECT_THAT(place_.read("out/page.html"), Not(HasSubstr("is neither in its folder")));
    EXPECT_THAT(place_.read("out/page.html"), HasSubstr("The map has no terrain: "));
    CompareOptions options{place_.file("a"), place_.file("b"), place_.file("out/page.html"), {std::nullopt, 50.0}};
    const auto run = test_support::run_command([&](Console& console) { return run_compare(options, console); }, false);
    EXPECT_THAT(run.notes, HasSubstr("aligned by time, so that --within changes nothing"));
}

TEST_F(CompareCommand, BadInputLeavesNothing) {
    expect_user_error([&] { (void)compare("out/page.html", false, "none"); }, "name a folder that replay or fly wrote");
    expect_user_error([&] { (void)compare("a"); }, "name the page in it");
    expect_user_error([&] { (void)compare("out/compare.json"); }, "name the page otherwise");
    place_.write("notes.html", "mine");
    expect_user_error([&] { (void)compare("notes.html"); }, "notes.html");
    place_.write("a/frames/000000.png", "damaged");
    expect_user_error([&] { (void)compare("out/page.html"); }, "000000.png");
    EXPECT_FALSE(std::filesystem::exists(place_.file("out")));
    EXPECT_EQ(place_.read("notes.html"), "mine");
}

}  // namespace
}  // namespace tedavis::host_sim::test_compare
