// Signs among terrain: whole where the eye sees their places, and else not at all.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "render_core/display/element_painter.hpp"
#include "render_core/draw/symbology/symbology.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/gl/render_target.hpp"
#include "tests/support/display/filled_drawers.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/draw/built_element.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/terrain/drawn_meshes.hpp"
#include "tests/support/terrain/selection.hpp"

namespace tedavis::display::test_hidden_signs {
namespace {

using test_support::WrittenTdb;

constexpr std::uint32_t kWidth = 320, kHeight = 240;
constexpr double kPlain_m = 550, kLongitude_deg = 9.8;
constexpr base::Time kNow{1'700'000'000'000'000'000};

/// A plain, and a ridge of 1500 m along 46.75 N.
const WrittenTdb& ridge() {
    static const WrittenTdb tdb([] {
        test_support::TdbSpec spec;
        spec.columns = spec.rows = 129;
        spec.west_deg = 9.7;
        spec.north_deg = 46.85;
        spec.step_lon_deg = spec.step_lat_deg = 1 / 600.0;
        spec.height_m = [](std::uint32_t, std::uint32_t j) { return j == 60 ? 1500 : kPlain_m; };
        return spec;
    }());
    return tdb;
}

using Pixels = std::vector<std::uint8_t>;

/// Places with names, seen from 46.7 N over the plain to the north.
class Signs {
public:
    Signs(const std::string& device, const std::vector<double>& latitudes_deg) : Signs(device, draft(latitudes_deg)) {}
    Signs(const std::string& device, const host_sim::LayerDraft& places)
        : session_("egl", device, kWidth, kHeight), scene_(places), meshes_(ridge()) {
        const std::string_view lines[] = {effects::kSceneSolids, effects::kSceneGlyphs, effects::kSceneBillboards,
                                          effects::kSymbology};
        for (std::size_t n = 0; n < 4; ++n) {
            blocks_[n].resize(session_.device.budget.find(lines[n])->bytes);
            arenas_[n] = base::Arena(blocks_[n].data(), blocks_[n].size());
        }
        base::BudgetTable& budget = session_.device.budget;
        EXPECT_TRUE(typeface_.take(arenas_[3], draw::kSymbologyVertices));
        EXPECT_EQ(typeface_.start(session_.gl, budget, typeface_.batch()).message.view(), "");
        const ElementPlanner::Memory memory{arenas_[0], arenas_[1], arenas_[2]};
        const bool has_instances = draw::GlyphDrawer::has_instances(session_.gl);
        EXPECT_EQ(elements_.start(has_instances, budget, memory).message.view(), "");
        EXPECT_EQ(painter_.start(session_.gl, budget, memory, elements_, typeface_).message.view(), "");
        session_.gl.seal();
        const double latitude = base::radians(46.7), longitude = base::radians(kLongitude_deg);
        ground_.height = kPlain_m + WrittenTdb::undulation_m(latitude);
        frame_.view = test_support::free_view(earth::to_ecef({latitude, longitude, {900}}),
                                              earth::body_axes(latitude, longitude, 0, 0, 0), kWidth, kHeight, 10);
        test_support::ResidentTdb catalogue(ridge());
        EXPECT_TRUE(selection_.select(catalogue, frame_.view, {}).within_budget);
        design::DataElement element;
        element.layer = "places";
        element.technique = design::DataTechnique::billboard;
        element.color = {255, 200, 0};
        EXPECT_TRUE(asked_.try_push_back(element));
        elements_.set(&scene_.scene(), asked_);
    }
    ~Signs() {
        session_.gl.retire();
        painter_.destroy(session_.gl);
        typeface_.destroy(session_.gl);
    }
    Signs(const Signs&) = delete;
    Signs& operator=(const Signs&) = delete;

    draw::ElementCount plan(bool over_ridge) {
        terrain::LineOfSight sight(ridge().lattice(), {selection_.chunks.data(), selection_.chunks.size()}, meshes_, frame_.view);
        const ElementFrame frame{ground_, frame_.view, {}, kNow};
        elements_.plan(frame);
        elements_.plan_signs(frame, {14, over_ridge ? &sight : nullptr});
        return elements_.reports()[0].count;
    }
    [[nodiscard]] const LabelCounts& labels() const { return elements_.label_counts(); }
    /// `depth`: of a surface over the whole picture, 0 before everything, 1 behind it. Top row first.
    Pixels picture(float depth) {
        gl::bind_surface(session_.gl, *session_.surface);
        session_.gl->ClearColor(0, 0, 0.4f, 1);
        session_.gl->ClearDepthf(depth);
        session_.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        session_.gl->ClearDepthf(1);
        session_.gl->Enable(GL_DEPTH_TEST);
        const PlannedElements planned = elements_.planned();
        painter_.prepare(session_.gl, planned);
        static_cast<void>(painter_.draw(session_.gl, planned, frame_, {{{10, 100'000}, {}}, 1}, 0));
        static_cast<void>(painter_.draw_signs(session_.gl, planned, kWidth, kHeight));
        EXPECT_EQ(session_.gl.denied().total, 0u);
        Pixels rgba = session_.pixels();
        for (std::size_t row = 0; row < kHeight / 2; ++row)
            std::swap_ranges(rgba.begin() + static_cast<std::ptrdiff_t>(row * kWidth * 4),
                             rgba.begin() + static_cast<std::ptrdiff_t>((row + 1) * kWidth * 4),
                             rgba.begin() + static_cast<std::ptrdiff_t>((kHeight - 1 - row) * kWidth * 4));
        return rgba;
    }

private:
    static host_sim::LayerDraft draft(const std::vector<double>& latitudes_deg) {
        host_sim::LayerDraft layer;
        layer.name = "places";
        layer.role = scene::LayerRole::place;
        for (const double latitude_deg : latitudes_deg) {
            const double aside_deg = layer.points.empty() ? -0.012 : 0.012;
            layer.points.push_back(
                test_support::scene_point(latitude_deg, kLongitude_deg + aside_deg, std::numeric_limits<float>::quiet_NaN()));
            layer.names.emplace_back("03/24");
        }
        return layer;
    }

    test_support::GlSession session_;
    test_support::LoadedScene scene_;
    test_support::MeshesOfTest meshes_;
    test_support::Selection selection_;
    std::vector<unsigned char> blocks_[4];
    base::Arena arenas_[4];
    test_support::LevelGround ground_;
    design::DataElementList asked_;
    test_support::FilledQuads typeface_;
    ElementPlanner elements_;
    ElementPainter painter_;
    draw::DataFrame frame_;
};

struct Difference {
    std::size_t pixels = 0, top = kHeight, bottom = 0;
};
Difference difference(const Pixels& a, const Pixels& b) {
    Difference found;
    for (std::size_t n = 0; n < a.size(); n += 4) {
        if (std::equal(a.begin() + static_cast<std::ptrdiff_t>(n), a.begin() + static_cast<std::ptrdiff_t>(n + 4),
                       b.begin() + static_cast<std::ptrdiff_t>(n)))
            continue;
        ++found.pixels;
        found.top = std::min(found.top, n / 4 / kWidth);
        found.bottom = std::max(found.bottom, n / 4 / kWidth);
    }
    return found;
}

struct Shot {
    Pixels pixels;
    draw::ElementCount count;
};
/// One session after the other: each makes its surface current.
Shot shot(const std::string& device, const std::vector<double>& latitudes_deg, bool over_ridge, float depth = 1) {
    Signs signs(device, latitudes_deg);
    const draw::ElementCount count = signs.plan(over_ridge);
    return {signs.picture(depth), count};
}

TEST(HiddenSigns, BehindARidgeNothingOfASignIsLeft) {
    for (const char* device : {"es2-small", "es3-mid"}) {
        const Shot both = shot(device, {46.73, 46.78}, true), front = shot(device, {46.73}, true), none = shot(device, {}, true);
        EXPECT_EQ(both.count.drawn, 1u) << device;
        EXPECT_EQ(both.count.hidden, 1u);
        EXPECT_EQ(difference(both.pixels, front.pixels).pixels, 0u) << device;
        EXPECT_GT(difference(both.pixels, none.pixels).pixels, 200u);
        const Shot without = shot(device, {46.73, 46.78}, false);
        EXPECT_EQ(without.count.drawn, 2u) << "but for the ridge there is room";
        EXPECT_GT(difference(without.pixels, both.pixels).pixels, 200u);
    }
}

/// As terrain that stands before everything would cut it.
TEST(HiddenSigns, NothingCutsASignButItsStem) {
    for (const char* device : {"es2-small", "es3-mid"}) {
        const Pixels free = shot(device, {46.73}, true).pixels, cut = shot(device, {46.73}, true, 0).pixels,
                     empty = shot(device, {}, true).pixels;
        const Difference stem = difference(free, cut), sign = difference(cut, empty);
        EXPECT_GT(stem.pixels, 20u) << "what has a depth is cut";
        EXPECT_LT(stem.pixels, 100u);
        EXPECT_GT(sign.pixels, 200u);
        EXPECT_GE(stem.top + 2, sign.bottom) << "the stem stands below icon and name";
    }
}

/// So many of many people behind the ridge that no room is left for the village before it.
host_sim::LayerDraft crowd(bool has_village) {
    host_sim::LayerDraft layer;
    layer.name = "places";
    layer.role = scene::LayerRole::place;
    host_sim::AttributeDraft people;
    people.name = "population";
    people.of = scene::AttributeOf::feature;
    const auto add = [&](double latitude_deg, double longitude_deg, float count) {
        layer.points.push_back(test_support::scene_point(latitude_deg, longitude_deg, std::numeric_limits<float>::quiet_NaN()));
        layer.names.emplace_back("Village");
        people.values.push_back(count);
    };
    if (has_village) add(46.73, kLongitude_deg, 100);
    for (int n = 0; n < 200; ++n) add(46.77 + 0.0003 * n, kLongitude_deg + 0.03 * std::sin(0.7 * n), 1e6f);
    layer.attributes = {people};
    return layer;
}

TEST(HiddenSigns, WhatIsHiddenLeavesItsRoomToOthers) {
    const auto placed = [](bool has_village, bool over_ridge) {
        Signs signs("es3-mid", crowd(has_village));
        static_cast<void>(signs.plan(over_ridge));
        return signs.labels().placed;
    };
    EXPECT_EQ(placed(true, true), 1u);
    EXPECT_EQ(placed(false, true), 0u);
    const std::uint32_t behind = placed(false, false);
    EXPECT_GT(behind, 5u);
    EXPECT_EQ(placed(true, false), behind) << "a control: but for the ridge the village has no room";
}

}  // namespace
}  // namespace tedavis::display::test_hidden_signs
