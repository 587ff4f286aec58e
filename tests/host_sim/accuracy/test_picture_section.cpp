#include "host_sim/accuracy/picture_section.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host_sim/reports/base64.hpp"
#include "tests/host_sim/accuracy/whole_report.hpp"

namespace tedavis::host_sim::test_picture_section {
namespace {

using ::testing::HasSubstr;

TEST(PictureSection, HoldsEveryPictureAndNeedsNoFile) {
    const KnobPictures pictures = test_support::made_pictures();
    const std::string html = picture_section(pictures);
    for (const ReportPicture* const picture : {&pictures.cheap, &pictures.exact, &pictures.color_map, &pictures.perceived_map,
                                               &pictures.metric_map, &pictures.cheap_crop, &pictures.exact_crop})
        EXPECT_THAT(html, HasSubstr("base64," + base64(picture->png))) << picture->file;
    EXPECT_THAT(html, ::testing::Not(HasSubstr(".png'"))) << "no file is referred to";
}

TEST(PictureSection, PutsTheCheapPictureOverTheExactOneUpToTheSlider) {
    const KnobPictures pictures = test_support::made_pictures();
    const std::string html = picture_section(pictures);
    EXPECT_LT(html.find(base64(pictures.exact.png)), html.find("class='over'"));
    EXPECT_THAT(html, HasSubstr("left: 1 steps; right: 16 steps"));
    EXPECT_THAT(picture_style(), HasSubstr("clip-path:inset(0 calc(100% - var(--end)) 0 0)"));
    EXPECT_THAT(html, HasSubstr("setProperty('--end'"));
}

}  // namespace
}  // namespace tedavis::host_sim::test_picture_section
