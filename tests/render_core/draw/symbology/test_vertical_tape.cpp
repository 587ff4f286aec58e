#include "render_core/draw/symbology/vertical_tape.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "render_core/draw/font_atlas.hpp"
#include "tests/support/draw/batch_shapes.hpp"
#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_vertical_tape {
namespace {

using test_support::BatchShape;
using test_support::BatchStore;
using test_support::text_of;

const Layout& layout() {
    static const Layout made = make_layout(1024, 768, 96);
    return made;
}

VerticalTape speed_tape(double value) {
    VerticalTape tape;
    tape.box = layout().airspeed;
    tape.value = value;
    tape.label = "IAS KT";
    return tape;
}

std::string written(const VerticalTape& tape) {
    BatchStore store;
    build_vertical_tape(Painter(store.batch, layout()), tape);
    EXPECT_EQ(store.batch.use().refused, 0u);
    return text_of(store.batch);
}

TEST(VerticalTape, TheReadoutSaysTheNearestReadingFirst) {
    EXPECT_NE(written(speed_tape(123.4)).find("123"), std::string::npos);
    EXPECT_EQ(written(speed_tape(123.4)).find("124"), std::string::npos);
    EXPECT_NE(written(speed_tape(123.6)).find("124"), std::string::npos);
    VerticalTape altitude = speed_tape(4527);
    altitude.readout = {20, 2};
    EXPECT_NE(written(altitude).find("4520"), std::string::npos);
}

TEST(VerticalTape, ScaleNumbersMoveDownAsTheValueGrows) {
    const auto height_of_first_vertex = [](double value) {
        BatchStore store;
        VerticalTape tape = speed_tape(value);
        build_vertical_tape(Painter(store.batch, layout()), tape);
        // The tick of 120 is the only line that moves by the whole difference; its vertices do.
        std::multiset<float> heights;
        for (const QuadVertex& v : store.batch.vertices()) heights.insert(v.y);
        return heights;
    };
    const auto before = height_of_first_vertex(120), after = height_of_first_vertex(122);
    const float down = layout().airspeed.height * 2 / 100;
    int moved = 0;
    for (const float y : before)
        for (const float z : after) moved += std::abs(z - y - down) < 0.51f ? 1 : 0;
    EXPECT_GT(moved, 20);
    EXPECT_NE(before, after);
}

TEST(VerticalTape, NothingIsWrittenBelowTheScalesEnd) {
    VerticalTape tape = speed_tape(10);
    EXPECT_EQ(written(tape).find('-'), std::string::npos);
    tape.lowest = -100;
    EXPECT_NE(written(tape).find('-'), std::string::npos) << "control: a scale that goes on shows them";
}

/// A number of the scale whose capitals cross an edge of the readout, by the height of its glyphs' middle.
bool crosses_readout(const QuadBatch& batch, const TapeLayout& parts, float bottom) {
    const float half = font_atlas().cap_height_em * kTapeTextSize * layout().text_px / 2;
    const auto shapes = test_support::shapes_of(batch);
    return std::any_of(shapes.begin(), shapes.end(), [&](const BatchShape& shape) {
        const float y = shape.bounds.center().y;
        const bool is_inside = shape.bounds.y >= parts.readout.y - 0.1f && shape.bounds.bottom() <= bottom + 0.1f;
        return shape.letter != 0 && !is_inside && y + half > parts.readout.y && y - half < bottom;
    });
}

TEST(VerticalTape, NoNumberOfTheScaleShowsThroughBesideTheReadout) {
    for (const policy::ElementShow show : {policy::ElementShow::normal, policy::ElementShow::flagged}) {
        int numbers = 0;
        for (double value = 60; value < 120; value += 0.37) {
            VerticalTape tape = speed_tape(value);
            tape.show = show;
            BatchStore store;
            const Painter painter(store.batch, layout());
            build_vertical_tape(painter, tape);
            const TapeLayout parts = tape_layout(painter, tape);
            const float bottom = show == policy::ElementShow::flagged ? parts.stale.bottom() : parts.readout.bottom();
            ASSERT_FALSE(crosses_readout(store.batch, parts, bottom)) << value;
            for (const BatchShape& shape : test_support::shapes_of(store.batch))
                numbers += shape.letter != 0 && shape.bounds.y > bottom ? 1 : 0;
            painter.text("120", {parts.readout.x + 20, parts.readout.y - 2}, TextAnchor::left, kTapeTextSize);
            ASSERT_TRUE(crosses_readout(store.batch, parts, bottom)) << "control";
        }
        EXPECT_GT(numbers, 300) << "the scale still has numbers";
    }
}

TEST(VerticalTape, RowsAndScaleShareTheBoxWithoutOverlap) {
    BatchStore store;
    const Painter painter(store.batch, layout());
    VerticalTape tape = speed_tape(120);
    const TapeLayout plain = tape_layout(painter, tape);
    EXPECT_TRUE(plain.selected.empty());
    EXPECT_TRUE(plain.minimum.empty());
    tape.selected = {policy::ElementShow::normal, "140", "SPD SEL", test_support::day_color(SymbolRole::selected)};
    tape.minimum = {policy::ElementShow::failed, "", "MIN", test_support::day_color(SymbolRole::selected)};
    const TapeLayout parts = tape_layout(painter, tape);
    for (const Rect* box : {&parts.selected, &parts.label, &parts.minimum, &parts.scale.box})
        EXPECT_TRUE(tape.box.shrunk(-0.01f).contains(*box));
    EXPECT_FLOAT_EQ(parts.selected.bottom(), parts.label.y);
    EXPECT_FLOAT_EQ(parts.label.bottom(), parts.scale.box.y);
    EXPECT_FLOAT_EQ(parts.scale.box.bottom(), parts.minimum.y);
    EXPECT_LT(parts.scale.box.height, plain.scale.box.height);
}

/// Of the boldest tick at this height.
float strokes_of(const QuadBatch& batch, const TapeLayout& parts, float y) {
    float height = 0;
    for (const BatchShape& shape : test_support::shapes_in(batch, {parts.scale.box.x, y - 1, parts.scale.box.width, 2},
                                                           test_support::day_color(SymbolRole::scale)))
        if (shape.bounds.width < layout().text_px) height = std::max(height, shape.bounds.height);
    return height / layout().stroke_px;
}

TEST(VerticalTape, EveryFifthTickIsBoldAndEveryTenthBolder) {
    VerticalTape tape = speed_tape(130);
    tape.emphasis = 5;
    BatchStore store;
    const Painter painter(store.batch, layout());
    build_vertical_tape(painter, tape);
    const TapeLayout parts = tape_layout(painter, tape);
    for (const auto& [unit, strokes] : {std::pair(120, 1), std::pair(150, 2), std::pair(100, 3)})
        EXPECT_NEAR(strokes_of(store.batch, parts, parts.scale.y_of(unit)), strokes, 0.01) << unit;
}

TEST(VerticalTape, FlagsGetRoomBeyondTheEdge) {
    BatchStore store;
    const Painter painter(store.batch, layout());
    VerticalTape tape = speed_tape(120);
    tape.ticks_right = true;
    const float edge = tape_layout(painter, tape).scale.edge;
    ASSERT_TRUE(tape.marks.flags.try_push_back({130, "VR", test_support::day_color(SymbolRole::scale)}));
    EXPECT_FLOAT_EQ(tape_layout(painter, tape).scale.edge, edge - kFlagWidth * layout().text_px);
    build_vertical_tape(painter, tape);
    const Rect scale = tape_layout(painter, tape).scale.box;
    const Rect beyond{edge - kFlagWidth * layout().text_px, scale.y, kFlagWidth * layout().text_px, scale.height};
    EXPECT_EQ(test_support::text_in(store.batch, beyond, test_support::day_color(SymbolRole::scale)), "VR");
}

TEST(VerticalTape, AFailedValueKeepsTheRowOfWhatIsSelected) {
    VerticalTape tape = speed_tape(120);
    tape.show = policy::ElementShow::failed;
    tape.failure = "SPD FAIL";
    tape.selected = {policy::ElementShow::normal, "140", "SPD SEL", test_support::day_color(SymbolRole::selected)};
    EXPECT_EQ(written(tape), "140SPDFAIL");
    tape.show = policy::ElementShow::absent;
    EXPECT_EQ(written(tape), "");
}

TEST(VerticalTape, AFlaggedValueLooksDifferent) {
    VerticalTape tape = speed_tape(100);
    BatchStore normal, flagged;
    build_vertical_tape(Painter(normal.batch, layout()), tape);
    tape.show = policy::ElementShow::flagged;
    build_vertical_tape(Painter(flagged.batch, layout()), tape);
    const auto amber = [](const BatchStore& store) {
        int count = 0;
        for (const QuadVertex& v : store.batch.vertices())
            count += v.rgba[0] == test_support::day_color(SymbolRole::caution).red &&
                             v.rgba[1] == test_support::day_color(SymbolRole::caution).green &&
                             v.rgba[2] == test_support::day_color(SymbolRole::caution).blue
                         ? 1
                         : 0;
        return count;
    };
    EXPECT_EQ(amber(normal), 0);
    EXPECT_GT(amber(flagged), 0);
}

}  // namespace
}  // namespace tedavis::draw::test_vertical_tape
