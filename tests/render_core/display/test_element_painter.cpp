#include "render_core/display/element_painter.hpp"

#include "tests/support/display/shown_elements.hpp"

namespace tedavis::display::test_element_painter {
namespace {

using ElementPainterTest = test_support::ShownElements;

TEST_F(ElementPainterTest, WhatStandsIsUploadedOnceUntilItIsBuiltAnew) {
    ask_for("zones", design::DataTechnique::prism);
    plan();
    const auto uploaded = [&] {
        session_.gl.begin_frame();
        painter_.prepare(session_.gl, elements_.planned());
        return session_.gl.frame().uploaded_bytes;
    };
    const std::uint64_t first = uploaded();
    EXPECT_LT(uploaded(), first) << "only what moves";
    plan();
    EXPECT_EQ(uploaded(), first) << "control: it has been built anew";
}

TEST_F(ElementPainterTest, NothingIsDrawnOfAPlanThatShowsNothing) {
    ask_for("zones", design::DataTechnique::prism);
    plan();
    EXPECT_GT(drawn_pixels(), 0u) << "control";
    elements_.rest();
    EXPECT_EQ(drawn_pixels(), 0u);
}

}  // namespace
}  // namespace tedavis::display::test_element_painter
