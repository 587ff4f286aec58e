/// Data elements of a small scene, shown without a display round them.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "render_core/display/element_painter.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/effects/device.hpp"
#include "tests/support/display/filled_drawers.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/draw/built_element.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::test_support {

inline constexpr base::Time kNoDate{0}, kNow{1'700'000'000'000'000'000};
inline constexpr std::int64_t kHour_ns = 3'600'000'000'000;

/// Areas that may not be entered, masts and air over 46.8 N 9.8 E.
inline host_sim::SceneDraft scene_draft() {
    host_sim::SceneDraft draft = small_scene();
    draft.layers[2].valid_from_ns = kNow.ns;
    draft.layers[2].valid_until_ns = kNow.ns + kHour_ns;
    return draft;
}

class ShownElements : public ::testing::Test {
protected:
    explicit ShownElements(const host_sim::SceneDraft& draft = scene_draft()) : session_("egl", "es3-mid"), scene_(draft) {
        const std::uint64_t bytes[] = {line(effects::kSceneSolids), line(effects::kSceneGlyphs), line(effects::kSceneBillboards),
                                       line(effects::kSymbology)};
        for (std::size_t n = 0; n < 4; ++n) {
            blocks_[n].resize(bytes[n]);
            arenas_[n] = base::Arena(blocks_[n].data(), blocks_[n].size());
        }
        base::BudgetTable& budget = session_.device.budget;
        EXPECT_TRUE(typeface_.take(arenas_[3], draw::kSymbologyVertices));
        EXPECT_EQ(typeface_.start(session_.gl, budget, typeface_.batch()).message.view(), "");
        const display::ElementPlanner::Memory memory{arenas_[0], arenas_[1], arenas_[2]};
        const bool has_instances = draw::GlyphDrawer::has_instances(session_.gl);
        EXPECT_EQ(elements_.start(has_instances, budget, memory).message.view(), "");
        EXPECT_EQ(painter_.start(session_.gl, budget, memory, elements_, typeface_).message.view(), "");
        session_.gl.seal();
        const glm::dvec3 eye = earth::to_ecef({base::radians(46.7), base::radians(9.82), {3000}});
        frame_.view = free_view(eye, earth::body_axes(base::radians(46.7), base::radians(9.82), 0, 0, 0), 64, 48, 10);
    }
    ~ShownElements() override {
        session_.gl.retire();
        painter_.destroy(session_.gl);
        typeface_.destroy(session_.gl);
    }
    std::uint64_t line(std::string_view name) { return session_.device.budget.find(name)->bytes; }
    design::DataElement& ask_for(std::string_view layer, design::DataTechnique technique) {
        design::DataElement element;
        element.layer = layer;
        element.technique = technique;
        EXPECT_TRUE(asked_.try_push_back(element));
        return asked_.back();
    }
    void plan(base::Time now = kNow) {
        elements_.set(&scene_.scene(), asked_);
        elements_.plan({ground_, frame_.view, {255, 0, 255}, flight::time_of_source(now)});
    }
    [[nodiscard]] display::ElementState state(std::size_t n) const { return elements_.reports()[n].state; }
    /// Pixels that are not the background.
    std::size_t drawn_pixels() {
        gl::bind_surface(session_.gl, *session_.surface);
        session_.gl->ClearColor(0, 0, 0, 1);
        session_.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        session_.gl->Enable(GL_DEPTH_TEST);
        const display::PlannedElements planned = elements_.planned();
        painter_.prepare(session_.gl, planned);
        static_cast<void>(painter_.draw(session_.gl, planned, frame_, {{{10, 100'000}, {}}, 1}, 0));
        static_cast<void>(painter_.draw_signs(session_.gl, planned, frame_.view.width, frame_.view.height));
        EXPECT_EQ(session_.gl.denied().total, 0u);
        const auto pixels = session_.pixels();
        std::size_t drawn = 0;
        for (std::size_t n = 0; n < pixels.size(); n += 4) drawn += pixels[n] + pixels[n + 1] + pixels[n + 2] > 0 ? 1 : 0;
        return drawn;
    }

    GlSession session_;
    LoadedScene scene_;
    std::vector<unsigned char> blocks_[4];
    base::Arena arenas_[4];
    LevelGround ground_;
    design::DataElementList asked_;
    FilledQuads typeface_;
    display::ElementPlanner elements_;
    display::ElementPainter painter_;
    draw::DataFrame frame_;
};

}  // namespace tedavis::test_support
