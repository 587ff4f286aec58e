#include "host_sim/evaluation/evaluate_pictures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host_sim/evaluation/evaluation_work.hpp"
#include "tests/support/flights/evaluated_flights.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_evaluate_pictures {
namespace {

using ::testing::ElementsAre;

class EvaluatePictures : public ::testing::Test {
protected:
    std::string picture(const std::string& name, std::uint32_t stripe) {
        write_png(place_.file(name), view_of(test_support::striped_picture(80, 60, stripe)));
        return place_.file(name);
    }
    test_support::TemporaryFolder place_;
    test_support::TestWork work_{2};
};

TEST_F(EvaluatePictures, EachHasMeasuresAndViews) {
    const std::vector<std::string> files = {picture("a.png", 0), picture("b.png", 5)};
    std::filesystem::create_directory(place_.file("out"));
    const auto evaluated = evaluate_pictures(files, place_.file("out"), nullptr, work_.work());
    ASSERT_EQ(evaluated.size(), 2u);
    EXPECT_EQ(evaluated[0].measures.clutter, 0) << "a plain picture";
    EXPECT_GT(evaluated[1].measures.clutter, 0.1);
    EXPECT_TRUE(std::filesystem::exists(place_.file("out/b.saliency.png")));
    ASSERT_TRUE(evaluated[0].measures.opinions && evaluated[1].measures.opinions);
    EXPECT_EQ(evaluated[0].measures.opinions->feature_congestion, 0);
    EXPECT_GT(evaluated[1].measures.opinions->subband_entropy, 0.5);
    EXPECT_EQ(agreement_over_pictures(evaluated).feature_congestion.alike, 1u) << "all measures see the stripes";
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(place_.file("out")), {}), 14);
}

TEST_F(EvaluatePictures, NothingStaysWhereOneIsFaulty) {
    const std::vector<std::string> files = {picture("a.png", 5), picture("b.png", 5), place_.write("c.png", "none")};
    std::filesystem::create_directory(place_.file("out"));
    test_support::expect_user_error([&] { (void)evaluate_pictures(files, place_.file("out"), nullptr, work_.work()); }, "c.png");
    EXPECT_TRUE(std::filesystem::is_empty(place_.file("out")));
}

TEST_F(EvaluatePictures, WhereItIsStoppedThePicturesSoFarStay) {
    const std::vector<std::string> files = {picture("a.png", 5), picture("b.png", 5), picture("c.png", 5)};
    std::filesystem::create_directory(place_.file("out"));
    test_support::TestWork stopped(1, 2);
    EXPECT_EQ(evaluate_pictures(files, place_.file("out"), nullptr, stopped.work()).size(), 2u);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(place_.file("out")), {}), 14);
}

TEST_F(EvaluatePictures, NamesOfViewsDiffer) {
    EXPECT_THAT(view_names({"x/a.png", "y/a.jpg", "a.b.png", "a.png"}), ElementsAre("a", "a-2", "a.b", "a-3"));
    EXPECT_THAT(view_names({"a-2.png", "a.png", "b/a.png"}), ElementsAre("a-2", "a", "a-3"));
}

TEST_F(EvaluatePictures, InputsAreNeverOverwritten) {
    const std::vector<std::string> files = {picture("a.png", 5), picture("a.heat.png", 5)};
    test_support::expect_user_error([&] { (void)evaluate_pictures(files, place_.path(), nullptr, work_.work()); },
                                    "is also an input");
}

TEST_F(EvaluatePictures, GazeFindsItsPicture) {
    const FixationFile file = read_fixations(place_.write("g.csv", "file,x,y\na.png,1,1\nd/a.png,2,2\nb.png,3,3\nc.png,4,4\n"));
    const auto gaze = gaze_of_pictures(file, {"d/a.png", "b.png"});
    EXPECT_EQ(gaze[0].size(), 2u);
    EXPECT_EQ(gaze[1].size(), 1u);
    const FixationFile nameless = read_fixations(place_.write("n.csv", "x,y\n1,1\n"));
    EXPECT_EQ(gaze_of_pictures(nameless, {"a.png"})[0].size(), 1u);
    test_support::expect_user_error([&] { (void)gaze_of_pictures(nameless, {"a.png", "b.png"}); }, "no column file");
}

// The odd disk among equals is where people look: the map must tell that better than chance, and gaze elsewhere worse.
TEST_F(EvaluatePictures, GazeOnTheOddDiskScoresAboveChance) {
    RgbaPicture disks = test_support::striped_picture(320, 240, 0);
    const auto disk = [&](int cx, int cy, std::array<std::uint8_t, 3> color) {
        for (int y = cy - 12; y <= cy + 12; ++y)
            for (int x = cx - 12; x <= cx + 12; ++x)
                if ((x - cx) * (x - cx) + (y - cy) * (y - cy) <= 144)
                    std::copy(color.begin(), color.end(),
                              &disks.pixels[(static_cast<std::size_t>(y) * 320 + static_cast<std::size_t>(x)) * 4]);
    };
    for (int y = 40; y < 240; y += 80)
        for (int x = 40; x < 320; x += 80) disk(x, y, {90, 120, 200});
    disk(200, 120, {220, 60, 40});
    write_png(place_.file("disks.png"), view_of(disks));
    const auto score = [&](const std::string& rows) {
        const FixationFile file = read_fixations(place_.write("gaze.csv", "x,y\n" + rows));
        return *evaluate_pictures({place_.file("disks.png")}, place_.path(), &file, work_.work())[0].measures.gaze;
    };
    const GazeScore on_it = score("198,118\n203,122\n200,126\n"), beside = score("160,80\n82,79\n161,161\n2,238\n");
    EXPECT_GT(on_it.auc, 0.9);
    EXPECT_GT(*on_it.nss, 2);
    EXPECT_LT(beside.auc, 0.5);
    EXPECT_LT(*beside.nss, 0);
}

}  // namespace
}  // namespace tedavis::host_sim::test_evaluate_pictures
