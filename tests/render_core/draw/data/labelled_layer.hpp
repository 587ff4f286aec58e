/// A layer of a test with icons and names, decided as a display decides them, and put onto a sheet.
#pragma once

#include <vector>

#include "render_core/draw/data/billboards.hpp"
#include "render_core/draw/data/label_features.hpp"
#include "tests/support/draw/billboard_room.hpp"

namespace tedavis::test_support {

class LabelShapesOfTest final : public draw::LabelShapes {
public:
    LabelShapesOfTest(const draw::ElementInput& input, const draw::SignView& view) : input_(input), view_(view) {}
    draw::LabelShape shape(draw::LabelKey key) override { return draw::label_shape(input_, draw::feature_of(key), view_); }

private:
    const draw::ElementInput& input_;
    const draw::SignView& view_;
};

/// The first interval of a view.
inline void decide_labels(draw::LabelPlanner& planner, const draw::ElementInput& input, const draw::SignView& view,
                          const design::LabelSettings& settings = {}) {
    const draw::Rect screen{0, 0, static_cast<float>(view.view.width), static_cast<float>(view.view.height)};
    planner.forget();
    planner.begin({1, screen, view.text_px}, settings);
    EXPECT_TRUE(planner.add_group(draw::label_group(input)));
    draw::offer_features(input, 0, view, settings, planner);
    LabelShapesOfTest shapes(input, view);
    planner.settle(shapes);
}

/// Onto the room's sheet as it has begun.
inline draw::ElementCount add_labelled(BillboardRoom& room, ElementOfTest& test) {
    std::vector<unsigned char> block(1u << 16);
    base::Arena arena(block.data(), block.size());
    draw::LabelPlanner planner;
    EXPECT_TRUE(planner.start(arena));
    const draw::ElementInput input = test.input();
    decide_labels(planner, input, room.sheet.eye());
    draw::ElementCount count;
    for (const draw::Label& label : planner.labels()) {
        if (label.level == draw::LabelLevel::none) continue;
        const std::uint32_t feature = draw::feature_of(label.key);
        draw::BillboardShape shape;
        if (!draw::billboard_shape(input, feature, room.sheet.eye(), label.level == draw::LabelLevel::name, shape)) continue;
        const draw::BillboardAnswer answer = draw::add_billboard(room.sheet, input, feature, shape, {label.side, label.stem});
        count.drawn += answer.fate == draw::BillboardFate::stands ? 1 : 0;
    }
    count.hidden = input.layer.entry->feature_count - count.drawn;
    return count;
}

}  // namespace tedavis::test_support
