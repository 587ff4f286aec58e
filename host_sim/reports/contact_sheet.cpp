#include "host_sim/reports/contact_sheet.hpp"

#include <algorithm>

#include "host_sim/reports/picture_text.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::array<std::uint8_t, 3> kBlack{0x10, 0x10, 0x10}, kGrey{0x60, 0x60, 0x60};

/// Shares of a picture's width.
struct Measures {
    std::uint32_t gap, title, group_title, label, design;

    explicit Measures(std::uint32_t picture_width)
        : gap(std::max(4u, picture_width / 32)),
          title(std::max(16u, picture_width / 12)),
          group_title(std::max(14u, picture_width / 16)),
          label(std::max(10u, picture_width / 22)),
          design(std::max(8u, picture_width / 36)) {}
};

/// A line of text takes its size and a third.
std::uint32_t line_height(std::uint32_t size_px) { return size_px + size_px / 3; }

/// The baseline that centres capitals of `size_px` in the box's line.
float baseline(const SheetBox& box, std::uint32_t line_begin, std::uint32_t size_px) {
    return static_cast<float>(box.y + line_begin) + 1.05f * static_cast<float>(size_px);
}

void text_in(RgbaPicture& sheet, const SheetBox& box, std::uint32_t line_begin, const std::string& text, std::uint32_t size_px,
             const std::array<std::uint8_t, 3>& color) {
    const PictureTextStyle style = fitted(text, {static_cast<float>(size_px), color}, static_cast<float>(box.width));
    draw_text(sheet, text, static_cast<float>(box.x), baseline(box, line_begin, size_px), style);
}

void copy_into(RgbaPicture& sheet, const SheetBox& box, const RgbaPicture& picture) {
    for (std::uint32_t y = 0; y < box.height; ++y) {
        const std::uint8_t* from = &picture.pixels[std::size_t{y} * picture.width * 4];
        std::uint8_t* to = &sheet.pixels[((std::size_t{box.y} + y) * sheet.width + box.x) * 4];
        std::copy(from, from + std::size_t{box.width} * 4, to);
    }
}

/// Moves `y` below the group.
ContactSheetLayout::Group lay_out_group(const DrawnSheet::Group& group, const RgbaPicture& first, std::uint32_t columns,
                                        const Measures& m, std::uint32_t& y) {
    ContactSheetLayout::Group placed;
    const std::uint32_t text_width = columns * (first.width + m.gap) - m.gap;
    placed.title = {m.gap, y, text_width, line_height(m.group_title)};
    y += placed.title.height + m.gap / 2;
    const std::uint32_t label_height = line_height(m.label) + line_height(m.design);
    const std::uint32_t row_height = first.height + label_height + m.gap;
    for (std::uint32_t n = 0; n < group.pictures.size(); ++n) {
        const SheetBox box{m.gap + n % columns * (first.width + m.gap), y + n / columns * row_height, first.width, first.height};
        placed.pictures.push_back(box);
        placed.labels.push_back({box.x, box.y + box.height, box.width, label_height});
    }
    y += static_cast<std::uint32_t>((group.pictures.size() + columns - 1) / columns) * row_height;
    return placed;
}

}  // namespace

ContactSheetLayout lay_out_contact_sheet(const DrawnSheet& sheet) {
    const RgbaPicture& first = sheet.groups.front().pictures.front().pixels;
    const Measures m(first.width);
    ContactSheetLayout layout;
    layout.width = sheet.columns * (first.width + m.gap) + m.gap;
    layout.title = {m.gap, m.gap, layout.width - 2 * m.gap, line_height(m.title)};
    std::uint32_t y = layout.title.y + layout.title.height + m.gap;
    for (const DrawnSheet::Group& group : sheet.groups) layout.groups.push_back(lay_out_group(group, first, sheet.columns, m, y));
    layout.height = y;
    return layout;
}

RgbaPicture draw_contact_sheet(const DrawnSheet& sheet) {
    const ContactSheetLayout layout = lay_out_contact_sheet(sheet);
    const Measures m(sheet.groups.front().pictures.front().pixels.width);
    RgbaPicture drawn{layout.width, layout.height, {}};
    drawn.pixels.assign(std::size_t{layout.width} * layout.height * 4, 255);
    text_in(drawn, layout.title, 0, sheet.title, m.title, kBlack);
    for (std::size_t g = 0; g < sheet.groups.size(); ++g) {
        const ContactSheetLayout::Group& boxes = layout.groups[g];
        text_in(drawn, boxes.title, 0, sheet.groups[g].title, m.group_title, kBlack);
        for (std::size_t n = 0; n < boxes.pictures.size(); ++n) {
            const DrawnSheet::Picture& picture = sheet.groups[g].pictures[n];
            copy_into(drawn, boxes.pictures[n], picture.pixels);
            text_in(drawn, boxes.labels[n], 0, picture.title, m.label, kBlack);
            text_in(drawn, boxes.labels[n], line_height(m.label), picture.caption.empty() ? picture.design : picture.caption,
                    m.design, kGrey);
        }
    }
    return drawn;
}

}  // namespace tedavis::host_sim
