#include "host_sim/reports/contact_sheet.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/reports/small_sheet.hpp"

namespace tedavis::host_sim::test_contact_sheet {
namespace {

std::vector<SheetBox> all_boxes(const ContactSheetLayout& layout) {
    std::vector<SheetBox> boxes{layout.title};
    for (const ContactSheetLayout::Group& group : layout.groups) {
        boxes.push_back(group.title);
        boxes.insert(boxes.end(), group.pictures.begin(), group.pictures.end());
        boxes.insert(boxes.end(), group.labels.begin(), group.labels.end());
    }
    return boxes;
}

bool apart(const SheetBox& a, const SheetBox& b) {
    return a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;
}

std::uint32_t dark_pixels(const RgbaPicture& picture, const SheetBox& box) {
    std::uint32_t count = 0;
    for (std::uint32_t y = box.y; y < box.y + box.height; ++y)
        for (std::uint32_t x = box.x; x < box.x + box.width; ++x)
            if (picture.pixels[(std::size_t{y} * picture.width + x) * 4] < 200) ++count;
    return count;
}

TEST(ContactSheet, NothingOverlapsOrLeavesTheSheet) {
    DrawnSheet sheet = test_support::small_sheet();
    for (const std::uint32_t columns : {1u, 2u, 3u, 7u}) {
        sheet.columns = columns;
        const ContactSheetLayout layout = lay_out_contact_sheet(sheet);
        const std::vector<SheetBox> boxes = all_boxes(layout);
        ASSERT_EQ(boxes.size(), 1u + 2 + 4 + 4);
        for (std::size_t n = 0; n < boxes.size(); ++n) {
            EXPECT_LE(boxes[n].x + boxes[n].width, layout.width);
            EXPECT_LE(boxes[n].y + boxes[n].height, layout.height);
            for (std::size_t m = 0; m < n; ++m) EXPECT_TRUE(apart(boxes[n], boxes[m])) << n << " and " << m;
        }
    }
}

TEST(ContactSheet, PicturesStandInRowsWithTheirLabelsBelow) {
    const ContactSheetLayout layout = lay_out_contact_sheet(test_support::small_sheet());
    const ContactSheetLayout::Group& first = layout.groups[0];
    EXPECT_EQ(first.pictures[0].y, first.pictures[1].y);
    EXPECT_LT(first.pictures[0].x, first.pictures[1].x);
    EXPECT_EQ(first.pictures[2].x, first.pictures[0].x) << "two a row";
    EXPECT_GT(first.pictures[2].y, first.labels[0].y);
    EXPECT_GT(layout.groups[1].title.y, first.labels[2].y);
    for (std::size_t n = 0; n < 3; ++n) {
        EXPECT_EQ(first.labels[n].x, first.pictures[n].x);
        EXPECT_EQ(first.labels[n].y, first.pictures[n].y + 48);
    }
}

TEST(ContactSheet, HoldsEveryPixelAndALabelForEach) {
    const DrawnSheet sheet = test_support::small_sheet();
    const ContactSheetLayout layout = lay_out_contact_sheet(sheet);
    const RgbaPicture drawn = draw_contact_sheet(sheet);
    ASSERT_EQ(drawn.width, layout.width);
    ASSERT_EQ(drawn.height, layout.height);
    for (std::size_t g = 0; g < sheet.groups.size(); ++g) {
        EXPECT_GT(dark_pixels(drawn, layout.groups[g].title), 20u);
        for (std::size_t n = 0; n < sheet.groups[g].pictures.size(); ++n) {
            const SheetBox& box = layout.groups[g].pictures[n];
            const std::uint8_t grey = sheet.groups[g].pictures[n].pixels.pixels[0];
            for (std::uint32_t y = box.y; y < box.y + box.height; ++y)
                for (std::uint32_t x = box.x; x < box.x + box.width; ++x)
                    ASSERT_EQ(drawn.pixels[(std::size_t{y} * drawn.width + x) * 4], grey);
            EXPECT_GT(dark_pixels(drawn, layout.groups[g].labels[n]), 20u);
        }
    }
    EXPECT_EQ(dark_pixels(drawn, {0, 0, drawn.width, layout.title.y}), 0u) << "the margin stays white";
    EXPECT_GT(dark_pixels(drawn, layout.title), 20u);
}

TEST(ContactSheet, AWordTooWideStaysInItsBox) {
    DrawnSheet sheet = test_support::small_sheet();
    sheet.groups[1].pictures[0].title = std::string(60, 'W');
    const ContactSheetLayout layout = lay_out_contact_sheet(sheet);
    const RgbaPicture drawn = draw_contact_sheet(sheet);
    const SheetBox& label = layout.groups[1].labels[0];
    const std::uint32_t beside = label.x + label.width;
    EXPECT_EQ(dark_pixels(drawn, {beside, label.y, drawn.width - beside, label.height}), 0u);
}

}  // namespace
}  // namespace tedavis::host_sim::test_contact_sheet
