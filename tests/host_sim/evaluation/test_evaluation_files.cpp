#include "host_sim/evaluation/evaluation_files.hpp"

#include <gtest/gtest.h>

#include "host_sim/evaluation/picture_meter.hpp"
#include "tests/support/flights/evaluated_flights.hpp"

namespace tedavis::host_sim::test_evaluation_files {
namespace {

TEST(EvaluationFiles, AllViewsHaveThePicturesSize) {
    const test_support::TemporaryFolder place;
    const RgbaPicture picture = test_support::striped_picture(90, 50, 7);
    PictureMeter meter({});
    const PictureMeasures measures = meter.measure(picture, "p", nullptr, {});
    const FloatMap congestion{90, 50, 1, 1, std::vector<float>(90 * 50, 0.25f)};
    const PictureViews views = picture_views(picture, meter, measures, congestion, {});
    write_views(place.path(), "p", "p.png", picture, views, measures);
    const ViewFiles files = view_files(place.file("p"));
    for (const std::string& file :
         {files.saliency, files.heat, files.edges, files.regions, files.congestion, files.second_opinion}) {
        const RgbaPicture view = read_png(file);
        EXPECT_EQ(view.width, 90u) << file;
        EXPECT_EQ(view.height, 50u) << file;
    }
    EXPECT_GE(read_png(files.sheet).width, 4 * 90u);
    EXPECT_EQ(place.entries(), all_view_files("p").size());
    EXPECT_EQ(read_png(files.congestion).pixels[0], 64) << "a quarter";
    std::size_t white = 0;
    for (std::size_t at = 0; at < views.edges.pixels.size(); at += 4) white += views.edges.pixels[at] == 255 ? 1 : 0;
    EXPECT_GT(white, 0u);
}

TEST(EvaluationFiles, SmallViewsAreAtMost512Wide) {
    const RgbaPicture picture = test_support::striped_picture(1280, 20, 7);
    const PictureViews views{picture, picture, picture, picture, picture, picture};
    const test_support::TemporaryFolder place;
    const RgbaPicture small = read_png(place.write("s.png", small_views(picture, views).heat));
    EXPECT_EQ(small.width, 427u);
    EXPECT_EQ(small.height, 7u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_evaluation_files
