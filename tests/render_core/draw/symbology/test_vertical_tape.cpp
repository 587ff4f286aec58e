#include "render_core/draw/symbology/vertical_tape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "tests/support/draw/symbology_scene.hpp"

namespace tedavis::draw::test_vertical_tape {
namespace {

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

TEST(VerticalTape, TheReadoutIsTheRoundedValue) {
    EXPECT_NE(written(speed_tape(123.4)).find("123"), std::string::npos);
    EXPECT_EQ(written(speed_tape(123.4)).find("124"), std::string::npos);
    EXPECT_NE(written(speed_tape(123.6)).find("124"), std::string::npos);
    VerticalTape altitude = speed_tape(4523);
    altitude.readout_step = 10;
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

TEST(VerticalTape, AFlaggedValueLooksDifferent) {
    VerticalTape tape = speed_tape(100);
    BatchStore normal, flagged;
    build_vertical_tape(Painter(normal.batch, layout()), tape);
    tape.show = policy::ElementShow::flagged;
    build_vertical_tape(Painter(flagged.batch, layout()), tape);
    const auto amber = [](const BatchStore& store) {
        int count = 0;
        for (const QuadVertex& v : store.batch.vertices())
            count +=
                v.rgba[0] == kCautionColor.red && v.rgba[1] == kCautionColor.green && v.rgba[2] == kCautionColor.blue ? 1 : 0;
        return count;
    };
    EXPECT_EQ(amber(normal), 0);
    EXPECT_GT(amber(flagged), 0);
}

}  // namespace
}  // namespace tedavis::draw::test_vertical_tape
