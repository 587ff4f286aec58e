#include "render_core/draw/data/billboards.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "render_core/draw/data/placement.hpp"
#include "tests/render_core/draw/data/labelled_layer.hpp"

namespace tedavis::draw::test_billboards {
namespace {

using test_support::BillboardRoom;
using test_support::ElementOfTest;

constexpr float kOnGround = std::numeric_limits<float>::quiet_NaN();

host_sim::LayerDraft layer_of(const std::vector<scene::ScenePoint>& points, const std::vector<std::string>& names = {}) {
    host_sim::LayerDraft layer;
    layer.name = "places";
    layer.role = scene::LayerRole::place;
    layer.points = points;
    layer.names = names;
    return layer;
}

ElementCount built(BillboardRoom& room, ElementOfTest& test, const QuadBatch* symbology = nullptr) {
    room.begin(symbology);
    return test_support::add_labelled(room, test);
}

TEST(Billboards, StandOverTheirPlaces) {
    // The ground lies 400 m below the eye: 0.1 of 4 km.
    ElementOfTest test(layer_of({BillboardRoom::point(4000, 800, kOnGround)}, {"Davos"}));
    BillboardRoom room;
    const ElementCount count = built(room, test);
    EXPECT_EQ(count.drawn, 1u);
    EXPECT_EQ(count.hidden, 0u);
    const BillboardSheet::Spot spot = room.sheet.spot(placed(test.input(), test.input().layer.points[0]).place);
    const Rect bounds = room.bounds([](const QuadVertex& vertex) { return vertex.extent_x >= 0; });
    EXPECT_NEAR(spot.at.x, 400 + room.view.focal_px * 0.2, 0.5);
    EXPECT_NEAR(bounds.center().x, spot.at.x, 0.5);
    EXPECT_NEAR(bounds.bottom(), spot.at.y, 4) << "the foot of its stem";
    EXPECT_LT(bounds.y, spot.at.y - 20);
    EXPECT_GT(room.glyph_vertices(), 0u);
    for (const QuadVertex& vertex : room.links.vertices())
        EXPECT_NEAR(vertex.distance_m, 4000 * (1 - terrain::LineOfSight::kTail), 3);
    EXPECT_EQ(room.links.vertices().size(), 8u);
}

TEST(Billboards, WhatIsBehindFarOrNowhereIsHiddenAndCounted) {
    const float high = 1000;
    ElementOfTest test(layer_of({BillboardRoom::point(-500, 0, high), BillboardRoom::point(200'000, 0, high),
                                 BillboardRoom::point(1000, 900, high), BillboardRoom::point(1000, 0, high)}));
    BillboardRoom room;
    ElementCount count = built(room, test);
    EXPECT_EQ(count.drawn, 1u);
    EXPECT_EQ(count.hidden, 3u);
    ElementOfTest lost(layer_of({BillboardRoom::point(1000, 0, kOnGround)}));
    lost.ground.is_known = false;
    count = built(room, lost);
    EXPECT_EQ(count.hidden, 1u);
    EXPECT_TRUE(room.drawn().empty());
    ElementOfTest none(layer_of({}));
    EXPECT_EQ(built(room, none).all(), 0u);
}

TEST(Billboards, TheNearestHasTheRoomAndTheHigherClassComesSooner) {
    std::vector<scene::ScenePoint> points{BillboardRoom::point(3000, 0, 900), BillboardRoom::point(2000, 0, 933)};
    std::vector<std::string> names{"A", "B"};
    for (int n = 1; n < 18; ++n) {
        points.push_back(BillboardRoom::point(3000 + 10 * n, 5, 900));
        names.emplace_back("Ort");
    }
    host_sim::LayerDraft layer = layer_of(points, names);
    ElementOfTest test(layer);
    BillboardRoom room;
    ElementCount count = built(room, test);
    EXPECT_GT(count.drawn, 2u) << "some on longer stems";
    EXPECT_GT(count.hidden, 1u);
    EXPECT_EQ(count.all(), 19u);
    EXPECT_NEAR(room.drawn()[0].distance_m, 2000, 20);
    host_sim::AttributeDraft kind;
    kind.name = "kind";
    kind.scale = scene::AttributeScale::ordinal;
    kind.of = scene::AttributeOf::feature;
    kind.classes = {"village", "town"};
    kind.values.assign(19, 0);
    kind.values[2] = 1;
    layer.attributes.push_back(kind);
    ElementOfTest classed(layer);
    count = built(room, classed);
    EXPECT_NEAR(room.drawn()[0].distance_m, 3010, 30) << "a town counts for more than a nearer village";
}

TEST(Billboards, DetailIsTheShareThatHasNames) {
    std::vector<scene::ScenePoint> points;
    std::vector<std::string> names;
    for (int n = 0; n < 4; ++n) {
        points.push_back(BillboardRoom::point(4000, -1500 + 1000 * n, 1000));
        names.emplace_back("Ort");
    }
    for (const scene::LayerRole role : {scene::LayerRole::obstacle, scene::LayerRole::place}) {
        host_sim::LayerDraft layer = layer_of(points, names);
        layer.role = role;
        ElementOfTest test(layer);
        BillboardRoom room;
        for (const double detail : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            test.element.detail = detail;
            const auto named = static_cast<std::uint32_t>(detail * 4);
            const ElementCount count = built(room, test);
            EXPECT_EQ(count.drawn, role == scene::LayerRole::place ? named : 4u) << "no obstacle is ever left out";
            EXPECT_EQ(count.all(), 4u);
            EXPECT_EQ(room.glyph_vertices(), std::size_t{named} * 3 * 2 * 4) << "letters, their halo, corners";
        }
    }
}

TEST(Billboards, SizesFollowTheDistanceWithinLimits) {
    BillboardRoom room;
    const auto height = [&](double distance_m) {
        ElementOfTest test(layer_of({BillboardRoom::point(distance_m, 0, 1000)}));
        EXPECT_EQ(built(room, test).drawn, 1u);
        return room.bounds().height;
    };
    EXPECT_GT(height(1800), height(2600));
    EXPECT_NEAR(height(200), height(400), 0.2);
    EXPECT_NEAR(height(20'000), height(40'000), 0.2);
}

TEST(Billboards, AValueMayStandForTheSize) {
    host_sim::LayerDraft layer = layer_of({BillboardRoom::point(4000, -700, 1000), BillboardRoom::point(4000, 700, 1000)});
    host_sim::AttributeDraft people;
    people.name = "people";
    people.of = scene::AttributeOf::feature;
    people.values = {100, 1000};
    layer.attributes.push_back(people);
    ElementOfTest test(layer);
    test.element.size_attribute = "people";
    BillboardRoom room;
    EXPECT_EQ(built(room, test).drawn, 2u);
    const Rect few = room.bounds([](const QuadVertex& vertex) { return vertex.x < 400; });
    const Rect many = room.bounds([](const QuadVertex& vertex) { return vertex.x > 400; });
    EXPECT_GT(many.width, few.width * 1.4f);
}

TEST(Billboards, ALinkLeadsDownToTheGround) {
    ElementOfTest test(layer_of({BillboardRoom::point(4000, 0, 1200)}));
    BillboardRoom room;
    EXPECT_EQ(built(room, test).drawn, 1u);
    const float free = room.bounds().bottom();
    test.element.link = true;
    EXPECT_EQ(built(room, test).drawn, 1u);
    scene::ScenePoint foot = BillboardRoom::point(4000, 0, kOnGround);
    EXPECT_NEAR(room.bounds().bottom(), room.sheet.spot(placed(test.input(), foot).place).at.y, 4);
    EXPECT_GT(room.bounds().bottom(), free + 50);
    test.ground.is_known = false;
    EXPECT_EQ(built(room, test).drawn, 1u) << "no ground, no link";
    EXPECT_NEAR(room.bounds().bottom(), free, 0.1);
}

/// Control: another line has its sign there.
TEST(Billboards, P32OfARunwayThatIsNearThereIsNone) {
    const auto drawn = [](double ahead_m, scene::LayerRole role) {
        host_sim::LayerDraft line = layer_of({BillboardRoom::point(ahead_m, 0, 900), BillboardRoom::point(ahead_m + 1, 0, 900)});
        line.shape = scene::LayerShape::lines;
        line.role = role;
        line.starts = {0, 2};
        ElementOfTest test(line);
        BillboardRoom room;
        return built(room, test).drawn;
    };
    EXPECT_EQ(drawn(3000, scene::LayerRole::runway), 0u);
    EXPECT_EQ(drawn(4000, scene::LayerRole::runway), 1u);
    EXPECT_EQ(drawn(3000, scene::LayerRole::road), 1u);
}

TEST(Billboards, LinesAndAreasHaveOneInTheirMiddle) {
    host_sim::LayerDraft runway = layer_of({BillboardRoom::point(6000, 0, 900), BillboardRoom::point(7000, 0, 900)});
    runway.shape = scene::LayerShape::lines;
    runway.role = scene::LayerRole::runway;
    runway.starts = {0, 2};
    ElementOfTest line(runway);
    BillboardRoom room;
    EXPECT_EQ(built(room, line).drawn, 1u);
    EXPECT_NEAR(room.drawn()[0].distance_m, 6500 * (1 - terrain::LineOfSight::kTail), 25);

    host_sim::LayerDraft storm = layer_of({BillboardRoom::point(3000, -500, 0), BillboardRoom::point(3000, 500, 0),
                                           BillboardRoom::point(4000, 500, 0), BillboardRoom::point(4000, -500, 0)});
    storm.shape = scene::LayerShape::areas;
    storm.role = scene::LayerRole::storm_cell;
    storm.starts = {0, 4};
    storm.data_time_ns = 1'000'000'000'000;
    for (const char* name : {"speed", "toward"}) {
        host_sim::AttributeDraft motion;
        motion.name = name;
        motion.of = scene::AttributeOf::feature;
        motion.values = {name[0] == 's' ? 10.0f : 0.0f};
        storm.attributes.push_back(motion);
    }
    ElementOfTest area(storm);
    EXPECT_EQ(built(room, area).drawn, 1u);
    EXPECT_NEAR(room.drawn()[0].distance_m, 3500 * (1 - terrain::LineOfSight::kTail), 5);
    area.has_date = true;
    area.time_ns = storm.data_time_ns + 100'000'000'000;
    EXPECT_EQ(built(room, area).drawn, 1u);
    EXPECT_NEAR(room.drawn()[0].distance_m, 4500 * (1 - terrain::LineOfSight::kTail), 5) << "10 m/s north for 100 s";
}

/// A mast whose top is as high as the eye, and symbology about it.
struct Mast {
    explicit Mast(scene::LayerRole role) : test(layer(role)) { at = room.sheet.spot(placed(test.input(), point()).place).at; }
    static host_sim::LayerDraft layer(scene::LayerRole role) {
        host_sim::LayerDraft mast = layer_of({BillboardRoom::point(4000, 0, 1000)}, {"Mast"});
        mast.role = role;
        return mast;
    }
    [[nodiscard]] scene::ScenePoint point() { return test.input().layer.points[0]; }
    /// With boxes from the spot.
    ElementCount build(const std::vector<Rect>& boxes) {
        BillboardRoom symbology;
        for (const Rect& box : boxes) EXPECT_TRUE(symbology.batch.box({at.x + box.x, at.y + box.y, box.width, box.height}, {}));
        return built(room, test, &symbology.batch);
    }
    [[nodiscard]] Rect icon() const {
        return room.bounds([](const QuadVertex& vertex) { return vertex.extent_x >= 0; });
    }
    ElementOfTest test;
    BillboardRoom room;
    Point at;
};

const std::vector<Rect> kBesides{{20, -60, 80, 50}, {-100, -60, 80, 50}}, kOver{{-100, -30, 200, 10}};

TEST(Billboards, AnObstacleIsAsHighAsItLooks) {
    Mast mast(scene::LayerRole::obstacle);
    EXPECT_EQ(mast.build({}).drawn, 1u);
    const Rect free = mast.icon();
    EXPECT_GT(mast.room.glyph_vertices(), 0u);
    EXPECT_EQ(mast.build(kBesides).drawn, 1u);
    EXPECT_EQ(mast.room.glyph_vertices(), 0u) << "first the name goes";
    EXPECT_NEAR(mast.icon().y, free.y, 0.1);
    EXPECT_EQ(mast.build(kOver).drawn, 1u);
    EXPECT_EQ(mast.room.glyph_vertices(), 0u);
    EXPECT_NEAR(mast.icon().center().y, mast.at.y, 2) << "then the stem";
    EXPECT_TRUE(mast.room.links.vertices().empty());
    Mast place(scene::LayerRole::place);
    EXPECT_EQ(place.build(kOver).drawn, 1u);
    EXPECT_LT(place.icon().y, free.y - 20) << "others are lifted";
    EXPECT_GT(place.room.glyph_vertices(), 0u);
}

TEST(Billboards, ANameFindsRoomAboveItsIconOrOnALongerStem) {
    Mast free(scene::LayerRole::place), above(scene::LayerRole::place), lifted(scene::LayerRole::place);
    EXPECT_EQ(free.build({}).drawn, 1u);
    const std::size_t letters = free.room.glyph_vertices();
    EXPECT_GT(letters, 0u);
    const Rect right{28, -18, 300, 18}, left{-328, -18, 300, 18}, ceiling{-324, -400, 648, 330};
    EXPECT_EQ(above.build({right, left, ceiling}).drawn, 1u);
    EXPECT_EQ(above.room.glyph_vertices(), letters);
    EXPECT_NEAR(above.icon().y, free.icon().y, 0.1) << "the stem is the short one";
    EXPECT_EQ(lifted.build({{-324, -32, 648, 20}}).drawn, 1u);
    EXPECT_EQ(lifted.room.glyph_vertices(), letters);
    EXPECT_LT(lifted.icon().y, free.icon().y - 20);
}

TEST(Billboards, AnAirspaceStandsAtItsTopWithItsLimits) {
    host_sim::LayerDraft zone = layer_of({BillboardRoom::point(3000, -500, 0), BillboardRoom::point(3000, 500, 0),
                                          BillboardRoom::point(4000, 500, 0), BillboardRoom::point(4000, -500, 0)},
                                         {"Range"});
    zone.shape = scene::LayerShape::areas;
    zone.role = scene::LayerRole::no_go;
    zone.starts = {0, 4};
    BillboardRoom room;
    ElementOfTest bare(zone);
    EXPECT_EQ(built(room, bare).drawn, 1u);
    const std::size_t name_alone = room.glyph_vertices();
    host_sim::AttributeDraft ceiling;
    ceiling.name = "ceiling";
    ceiling.of = scene::AttributeOf::feature;
    ceiling.values = {900};
    zone.attributes.push_back(ceiling);
    ElementOfTest limited(zone);
    EXPECT_EQ(built(room, limited).drawn, 1u);
    EXPECT_GT(room.glyph_vertices(), name_alone + 8 * 8) << "?-2953 MSL";
    const BillboardSheet::Spot top = room.sheet.spot(placed(limited.input(), BillboardRoom::point(3500, 0, 900)).place);
    const Rect stem = room.bounds([](const QuadVertex& vertex) { return vertex.distance_m > 0; });
    EXPECT_NEAR(stem.bottom(), top.at.y, 4) << "at the ceiling";
    BillboardRoom walls;
    const Rect taken = room.bounds([](const QuadVertex& vertex) { return vertex.extent_x < 0; });
    zone.names = {"A name that is far too long for"};
    ElementOfTest wordy(zone);
    EXPECT_TRUE(walls.batch.box({0, 0, top.at.x - 30, 600}, {}));
    EXPECT_TRUE(walls.batch.box({top.at.x + taken.width + 40, 0, 800, 600}, {}));
    EXPECT_EQ(built(room, wordy, &walls.batch).drawn, 1u);
    EXPECT_EQ(room.glyph_vertices(), 2 * 4 * 9u) << "?-2953 MSL";
    limited.element.detail = 0;
    EXPECT_EQ(built(room, limited).drawn, 1u);
    EXPECT_EQ(room.glyph_vertices(), 0u);
}

TEST(Billboards, AnObstacleWithoutRoomIsCounted) {
    host_sim::LayerDraft pair = Mast::layer(scene::LayerRole::obstacle);
    pair.points.push_back(BillboardRoom::point(4010, 0, 1000));
    pair.names = {"", ""};
    ElementOfTest test(pair);
    BillboardRoom room;
    const ElementCount count = built(room, test);
    EXPECT_EQ(count.drawn, 1u);
    EXPECT_EQ(count.hidden, 1u) << "it would cover the nearer one";
    pair.points[1] = BillboardRoom::point(4010, 800, 1000);
    ElementOfTest apart(pair);
    EXPECT_EQ(built(room, apart).drawn, 2u);
}

TEST(Billboards, StemsAreNoLinks) {
    Mast mast(scene::LayerRole::obstacle);
    const auto is_grey = [](const QuadVertex& vertex) {
        return vertex.rgba[1] > 0 && std::abs(vertex.rgba[0] - vertex.rgba[1]) < 10 &&
               std::abs(vertex.rgba[1] - vertex.rgba[2]) < 10;
    };
    const auto greys = [&] {
        const auto vertices = mast.room.links.vertices();
        return std::count_if(vertices.begin(), vertices.end(), is_grey);
    };
    EXPECT_EQ(mast.build({}).drawn, 1u);
    EXPECT_EQ(greys(), 4);
    EXPECT_EQ(mast.room.links.vertices().size(), 8u) << "a stem and its rim";
    mast.test.element.link = true;
    EXPECT_EQ(mast.build({}).drawn, 1u);
    EXPECT_EQ(greys(), 4);
    EXPECT_GT(mast.room.links.vertices().size(), 8u) << "a link has the element's colour";
}

TEST(Billboards, NothingIsDrawnByHalfInAFullBatch) {
    std::vector<scene::ScenePoint> points;
    for (int n = 0; n < 20; ++n) points.push_back(BillboardRoom::point(4000, -2000 + 200 * n, 1000));
    ElementOfTest test(layer_of(points));
    BillboardRoom room(700);
    const ElementCount count = built(room, test);
    EXPECT_GT(count.drawn, 0u);
    EXPECT_GT(count.hidden, 0u);
    EXPECT_EQ(count.all(), 20u);
    EXPECT_EQ(room.batch.use().refused + room.links.use().refused, 0u);
}

}  // namespace
}  // namespace tedavis::draw::test_billboards
