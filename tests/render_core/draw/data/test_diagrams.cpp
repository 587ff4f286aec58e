#include "render_core/draw/data/diagrams.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "tests/support/draw/billboard_room.hpp"

namespace tedavis::draw::test_diagrams {
namespace {

using test_support::BillboardRoom;
using test_support::ElementOfTest;

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();
constexpr design::Color kMissingColor{255, 0, 255};

host_sim::LayerDraft samples(const std::vector<scene::ScenePoint>& points) {
    host_sim::LayerDraft layer;
    layer.name = "samples";
    layer.role = scene::LayerRole::sample;
    layer.height_datum = scene::HeightDatum::ellipsoid;
    layer.points = points;
    return layer;
}

void bind(host_sim::LayerDraft& layer, const char* name, const std::vector<float>& values) {
    host_sim::AttributeDraft attribute;
    attribute.name = name;
    attribute.of = scene::AttributeOf::feature;
    attribute.values = values;
    layer.attributes.push_back(attribute);
}

struct Diagrams {
    explicit Diagrams(const host_sim::LayerDraft& layer) : test(layer) { count = add_diagrams(room.sheet, test.input()); }
    /// Boxes and lines of a colour: the highest and the lowest point of each.
    [[nodiscard]] std::vector<Rect> shapes(design::Color color) const {
        std::vector<Rect> found;
        const auto all = room.drawn();
        for (std::size_t n = 0; n + 3 < all.size(); n += 4) {
            const QuadVertex& vertex = all[n];
            if (vertex.rgba[0] != color.red || vertex.rgba[1] != color.green || vertex.rgba[2] != color.blue) continue;
            const auto [left, right] = std::minmax({all[n].x, all[n + 1].x, all[n + 2].x, all[n + 3].x});
            const auto [top, bottom] = std::minmax({all[n].y, all[n + 1].y, all[n + 2].y, all[n + 3].y});
            found.push_back({left, top, right - left, bottom - top});
        }
        return found;
    }
    ElementOfTest test;
    BillboardRoom room;
    ElementCount count;
};

TEST(Diagrams, APointAloneHasABarAnAttribute) {
    host_sim::LayerDraft layer = samples({BillboardRoom::point(4000, -700, 1000), BillboardRoom::point(4000, 700, 1000)});
    bind(layer, "a", {0, 10});
    bind(layer, "b", {5, 10});
    bind(layer, "c", {kMissing, 3});
    const Diagrams diagrams(layer);
    EXPECT_EQ(diagrams.count.drawn, 2u);
    std::vector<Rect> bars = diagrams.shapes(diagrams.test.element.color);
    bars.erase(std::remove_if(bars.begin(), bars.end(), [](const Rect& bar) { return bar.width < 8; }), bars.end());
    ASSERT_EQ(bars.size(), 5u) << "of six values one is missing";
    const auto left = std::count_if(bars.begin(), bars.end(), [](const Rect& bar) { return bar.x < 400; });
    EXPECT_EQ(left, 2);
    const float tallest =
        std::max_element(bars.begin(), bars.end(), [](const Rect& a, const Rect& b) { return a.height < b.height; })->height;
    for (const Rect& bar : bars) {
        EXPECT_GT(bar.height, 3) << "the least can be seen";
        // Those on the right are the largest of the layer, but for the only one of its attribute.
        if (bar.x > 400 && bar.x < 560) {
            EXPECT_LE(bar.height, tallest);
        }
    }
    EXPECT_EQ(diagrams.shapes(kMissingColor).size(), 2u) << "a cross";
}

TEST(Diagrams, PointsAboveEachOtherAreOneProfile) {
    host_sim::LayerDraft layer =
        samples({BillboardRoom::point(4000, 0, 800), BillboardRoom::point(4000, 0, 1000), BillboardRoom::point(4000, 0, 1200),
                 BillboardRoom::point(4000, 0, 1400), BillboardRoom::point(4000, 2000, 1000)});
    bind(layer, "temperature", {290, 285, kMissing, 275, 280});
    const Diagrams diagrams(layer);
    EXPECT_EQ(diagrams.count.drawn, 5u) << "four in one and one alone";
    std::vector<Rect> knots = diagrams.shapes(diagrams.test.element.color);
    knots.erase(
        std::remove_if(knots.begin(), knots.end(), [](const Rect& r) { return r.width > 8 || r.height > 8 || r.x > 450; }),
        knots.end());
    ASSERT_EQ(knots.size(), 3u);
    EXPECT_GT(knots[0].y, knots[1].y) << "higher up";
    EXPECT_GT(knots[1].y, knots[2].y);
    EXPECT_GT(knots[0].x, knots[1].x) << "and colder";
    EXPECT_GT(knots[1].x, knots[2].x);
    EXPECT_EQ(diagrams.shapes(kMissingColor).size(), 2u) << "a cross";
}

TEST(Diagrams, ALinkLeadsFromTheLowestPointToTheGround) {
    host_sim::LayerDraft layer = samples({BillboardRoom::point(4000, 0, 1400), BillboardRoom::point(4000, 0, 900)});
    bind(layer, "a", {0, 10});
    const auto bottom = [&](bool link) {
        Diagrams diagrams(layer);
        diagrams.test.element.link = link;
        diagrams.room.begin();
        EXPECT_EQ(add_diagrams(diagrams.room.sheet, diagrams.test.input()).drawn, 2u);
        return static_cast<double>(diagrams.room.bounds().bottom());
    };
    const double px_per_m = BillboardRoom().view.focal_px / 4000;
    EXPECT_NEAR(bottom(false), 300 + 100 * px_per_m, 2) << "900 m, seen from 1000 m";
    EXPECT_NEAR(bottom(true), 300 + 400 * px_per_m, 3) << "the ground is at 600 m";
}

TEST(Diagrams, WhatHasNoRoomOrPlaceIsHidden) {
    host_sim::LayerDraft layer = samples({BillboardRoom::point(4000, 0, 1000), BillboardRoom::point(4100, 10, 1000),
                                          BillboardRoom::point(-4000, 0, 1000), BillboardRoom::point(90'000, 0, 1000)});
    bind(layer, "a", {1, 2, 3, 4});
    const Diagrams diagrams(layer);
    EXPECT_EQ(diagrams.count.drawn, 1u);
    EXPECT_EQ(diagrams.count.hidden, 3u);
    EXPECT_NEAR(diagrams.room.drawn()[0].distance_m, 4000 * (1 - terrain::LineOfSight::kTail), 3) << "the nearest";
    EXPECT_EQ(Diagrams(samples({})).count.all(), 0u);
}

TEST(Diagrams, WithoutAnAttributeTheySaySo) {
    const Diagrams diagrams(samples({BillboardRoom::point(4000, 0, 1000)}));
    EXPECT_EQ(diagrams.count.drawn, 1u);
    EXPECT_EQ(diagrams.shapes(kMissingColor).size(), 2u);
}

TEST(Diagrams, WithLittleDetailAKnotIsTheMeanOfItsNeighbours) {
    host_sim::LayerDraft layer = samples({BillboardRoom::point(4000, 0, 800), BillboardRoom::point(4000, 0, 1000),
                                          BillboardRoom::point(4000, 0, 1200), BillboardRoom::point(4000, 0, 1400)});
    bind(layer, "temperature", {290, 270, 280, kMissing});
    ElementOfTest test(layer);
    test.element.detail = 0.25;
    BillboardRoom room;
    const ElementCount count = add_diagrams(room.sheet, test.input());
    EXPECT_EQ(count.aggregated, 4u);
    EXPECT_EQ(count.drawn + count.hidden, 0u);
    Diagrams whole(layer);
    const auto middles = [](const std::vector<Rect>& all) {
        std::vector<Rect> knots;
        for (const Rect& one : all)
            if (one.width <= 8 && one.height <= 8) knots.push_back(one);
        return knots;
    };
    const std::vector<Rect> three = middles(whole.shapes(whole.test.element.color));
    Diagrams one(layer);
    one.room.begin();
    one.test.element.detail = 0.25;
    static_cast<void>(add_diagrams(one.room.sheet, one.test.input()));
    const std::vector<Rect> mean = middles(one.shapes(one.test.element.color));
    ASSERT_EQ(three.size(), 3u);
    ASSERT_EQ(mean.size(), 1u);
    EXPECT_NEAR(mean[0].center().x, (three[0].center().x + three[1].center().x + three[2].center().x) / 3, 0.5);
    const std::vector<Rect> all = one.shapes(one.test.element.color);
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Rect& line) {
        return std::abs(line.width - (three[0].center().x - three[1].center().x)) < 4;
    })) << "from the least to the largest";
    EXPECT_EQ(one.shapes(kMissingColor).size(), 2u) << "one of them is missing";
}

TEST(Diagrams, WithLittleDetailAPointHasItsFirstBars) {
    host_sim::LayerDraft layer = samples({BillboardRoom::point(4000, 0, 1000), BillboardRoom::point(9000, 90000, 1000)});
    for (const char* const name : {"a", "b", "c", "d"}) bind(layer, name, {1, 2});
    const auto bars = [&](double detail) {
        Diagrams diagrams(layer);
        diagrams.room.begin();
        diagrams.test.element.detail = detail;
        EXPECT_EQ(add_diagrams(diagrams.room.sheet, diagrams.test.input()).drawn, 1u);
        const std::vector<Rect> all = diagrams.shapes(diagrams.test.element.color);
        return std::count_if(all.begin(), all.end(), [](const Rect& bar) { return bar.width >= 6; });
    };
    EXPECT_EQ(bars(1), 4);
    EXPECT_EQ(bars(0.5), 2);
    EXPECT_EQ(bars(0), 1);
}

}  // namespace
}  // namespace tedavis::draw::test_diagrams
