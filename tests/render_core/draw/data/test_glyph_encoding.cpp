#include "render_core/draw/data/glyph_encoding.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/LocalCartesian.hpp>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <vector>

#include "render_core/base/units.hpp"

namespace tedavis::draw::test_glyph_encoding {
namespace {

using base::radians;
using scene::GlyphValues;
using scene::SelectedGlyph;
using scene::ValueState;

const earth::Geodetic kPlace{radians(46.8), radians(9.8), earth::EllipsoidHeight{1500}};

SelectedGlyph glyph_of(float value, float north = 0) {
    SelectedGlyph glyph;
    glyph.summary.place = {300, -200, 100};
    glyph.summary.value = value;
    glyph.summary.north_mps = north;
    glyph.summary.speed_mps = std::hypot(value, north);
    glyph.summary.members = 1;
    glyph.summary.state = ValueState::valid;
    glyph.summary.uncertainty = scene::Uncertainty::from_level(0.25);
    glyph.size_m = 100;
    glyph.size_px = 40;
    return glyph;
}

design::DataScale scale_of(std::initializer_list<double> breaks = {}) {
    design::DataScale scale;
    EXPECT_TRUE(scale.palette.stops.try_push_back({0, {0, 0, 200}}));
    EXPECT_TRUE(scale.palette.stops.try_push_back({20, {200, 0, 0}}));
    for (const double limit : breaks) EXPECT_TRUE(scale.breaks.try_push_back(limit));
    return scale;
}

GlyphStyle wind_style() {
    GlyphStyle style;
    style.full_value = 20;
    return style;
}

struct Encoded {
    Encoded(const std::vector<SelectedGlyph>& glyphs, GlyphValues values, const GlyphStyle& style,
            const design::DataScale& scale = scale_of(), std::size_t most = 64)
        : room(most), batch(room) {
        left_out = encode_glyphs({glyphs.data(), glyphs.size()}, values, style, scale, earth::to_ecef(kPlace), batch);
    }
    [[nodiscard]] const GlyphInstance& only() const {
        EXPECT_EQ(batch.instances().size(), 1u);
        return batch.instances()[0];
    }
    [[nodiscard]] GlyphShape shape() const { return batch.runs()[0].shape; }
    std::vector<GlyphInstance> room;
    GlyphBatch batch;
    std::uint32_t left_out = 0;
};

GlyphShape shape_of_one(const SelectedGlyph& glyph, GlyphValues values, const GlyphStyle& style) {
    return Encoded({glyph}, values, style).shape();
}

glm::dvec3 direction_of(const GlyphInstance& glyph) {
    return glm::normalize(glm::dvec3(glyph.direction[0], glyph.direction[1], glyph.direction[2]));
}

/// Against the local frame of GeographicLib.
TEST(GlyphEncoding, ArrowsPointWhereTheWindBlowsTo) {
    const glm::dvec3 at = earth::to_ecef(kPlace) + glm::dvec3(300, -200, 100);
    const earth::Geodetic there = earth::from_ecef(at);
    const GeographicLib::LocalCartesian frame(base::degrees(there.latitude_rad), base::degrees(there.longitude_rad),
                                              there.height.m);
    for (double towards = 0; towards < 360; towards += 11) {
        const double east = 9 * std::sin(radians(towards)), north = 9 * std::cos(radians(towards));
        const Encoded encoded({glyph_of(static_cast<float>(east), static_cast<float>(north))}, GlyphValues::wind, wind_style());
        double latitude = 0, longitude = 0, height = 0;
        frame.Reverse(east, north, 0, latitude, longitude, height);
        const glm::dvec3 ahead = earth::to_ecef({radians(latitude), radians(longitude), earth::EllipsoidHeight{height}});
        EXPECT_GT(glm::dot(direction_of(encoded.only()), glm::normalize(ahead - at)), std::cos(radians(0.5))) << towards;
        EXPECT_EQ(encoded.shape(), GlyphShape::arrow);
    }
}

TEST(GlyphEncoding, DirectionsMayBeThoseOfACompass) {
    GlyphStyle style = wind_style();
    style.directions = 8;
    std::set<std::array<int, 3>> directions;
    for (double towards = 0; towards < 360; towards += 3) {
        const SelectedGlyph glyph =
            glyph_of(static_cast<float>(9 * std::sin(radians(towards))), static_cast<float>(9 * std::cos(radians(towards))));
        const Encoded coarse({glyph}, GlyphValues::wind, style), fine({glyph}, GlyphValues::wind, wind_style());
        const GlyphInstance& arrow = coarse.only();
        directions.insert({arrow.direction[0], arrow.direction[1], arrow.direction[2]});
        EXPECT_GT(glm::dot(direction_of(arrow), direction_of(fine.only())), std::cos(radians(23.5)));
    }
    EXPECT_EQ(directions.size(), 8u);
}

TEST(GlyphEncoding, SpeedIsInLengthAndColor) {
    const auto arrow = [](float speed) { return Encoded({glyph_of(speed)}, GlyphValues::wind, wind_style()).only(); };
    EXPECT_FLOAT_EQ(arrow(20).size_m.x, 100);
    EXPECT_FLOAT_EQ(arrow(30).size_m.x, 100) << "no longer than the full size";
    EXPECT_NEAR(arrow(10).size_m.x, 35 + 32.5, 1e-3);
    EXPECT_GT(arrow(1).size_m.x, 35);
    EXPECT_EQ(arrow(20).rgba[0], 200);
    EXPECT_EQ(arrow(10).rgba[0], 100);
    EXPECT_EQ(arrow(10).rgba[2], 100);
    GlyphStyle plain = wind_style();
    plain.sizing = GlyphSizing::alike;
    plain.is_colored = false;
    const Encoded encoded({glyph_of(5)}, GlyphValues::wind, plain);
    EXPECT_FLOAT_EQ(encoded.only().size_m.x, 100);
    EXPECT_EQ(encoded.only().rgba[0], plain.plain.red);
}

TEST(GlyphEncoding, ClassesGiveSizesInSteps) {
    GlyphStyle style = wind_style();
    style.sizing = GlyphSizing::classes;
    const design::DataScale scale = scale_of({5, 10, 15});
    std::set<float> lengths;
    for (float speed = 1; speed < 25; speed += 0.5f) {
        const Encoded encoded({glyph_of(speed)}, GlyphValues::wind, style, scale);
        lengths.insert(encoded.only().size_m.x);
    }
    EXPECT_EQ(lengths.size(), 4u);
    EXPECT_FLOAT_EQ(*lengths.rbegin(), 100);
    EXPECT_FLOAT_EQ(*lengths.begin(), 35);
}

TEST(GlyphEncoding, WhatHasNoDirectionOrNoValueHasItsSign) {
    const GlyphStyle style = wind_style();
    SelectedGlyph calm = glyph_of(0.1f), variable = glyph_of(0.1f), missing = glyph_of(9);
    variable.summary.speed_mps = 12;
    missing.summary.state = ValueState::missing;
    EXPECT_EQ(shape_of_one(calm, GlyphValues::wind, style), GlyphShape::ring);
    EXPECT_EQ(shape_of_one(variable, GlyphValues::wind, style), GlyphShape::crossed_ring);
    EXPECT_EQ(shape_of_one(missing, GlyphValues::wind, style), GlyphShape::cross);
    SelectedGlyph mixed = glyph_of(0);
    mixed.summary.is_mixed = true;
    GlyphStyle spheres = style;
    spheres.form = GlyphForm::sphere;
    EXPECT_EQ(shape_of_one(mixed, GlyphValues::category, spheres), GlyphShape::crossed_ring);
    EXPECT_EQ(shape_of_one(calm, GlyphValues::wind, spheres), GlyphShape::sphere) << "a speed needs no direction";
    const Encoded signs({calm, variable, missing}, GlyphValues::wind, style);
    ASSERT_EQ(signs.batch.runs().size(), 3u);
    for (const GlyphRun& run : signs.batch.runs()) {
        EXPECT_EQ(run.facing, GlyphFacing::eye);
        EXPECT_EQ(signs.batch.of(run)[0].direction[3], 127) << "upright";
    }
    const Encoded cross({missing}, GlyphValues::wind, style);
    EXPECT_EQ(cross.only().rgba[0], style.missing.red);
}

TEST(GlyphEncoding, UnknownUncertaintyIsNeverCertain) {
    GlyphStyle style;
    style.subject = GlyphSubject::uncertainty;
    for (const GlyphForm form : {GlyphForm::circle, GlyphForm::triangle, GlyphForm::tetrahedron}) {
        style.form = form;
        SelectedGlyph sure = glyph_of(3), unsure = sure, unknown = sure;
        sure.summary.uncertainty = scene::Uncertainty::from_level(0);
        unsure.summary.uncertainty = scene::Uncertainty::from_level(1);
        unknown.summary.uncertainty = {};
        design::DataScale scale = scale_of();
        scale.palette.stops[1].value = 1;
        const auto encoded = [&](const SelectedGlyph& glyph) {
            return Encoded({glyph}, GlyphValues::number, style, scale).only();
        };
        EXPECT_LT(encoded(sure).size_m.z, 0.5f * encoded(unsure).size_m.z);
        EXPECT_EQ(encoded(unknown).size_m, encoded(unsure).size_m);
        EXPECT_EQ(encoded(unsure).rgba[0], 200);
        EXPECT_EQ(encoded(unknown).rgba[2], style.unknown.blue);
        EXPECT_NE(encoded(unknown).rgba[1] + encoded(unknown).rgba[2], encoded(sure).rgba[1] + encoded(sure).rgba[2]);
    }
}

TEST(GlyphEncoding, SolidsStandByTheirHeight) {
    GlyphStyle style;
    style.full_value = 20;
    style.least_share = 0;
    for (const GlyphForm form : {GlyphForm::bar, GlyphForm::cone, GlyphForm::tetrahedron}) {
        style.form = form;
        const Encoded half({glyph_of(10)}, GlyphValues::number, style), full({glyph_of(20)}, GlyphValues::number, style);
        EXPECT_FLOAT_EQ(half.only().size_m.z, 50);
        EXPECT_FLOAT_EQ(full.only().size_m.z, 100);
        EXPECT_FLOAT_EQ(half.only().size_m.x, full.only().size_m.x);
    }
    style.form = GlyphForm::sphere;
    EXPECT_FLOAT_EQ(Encoded({glyph_of(10)}, GlyphValues::number, style).only().size_m.x, 50);
}

/// Against the local frame of GeographicLib.
TEST(GlyphEncoding, WhatFloatsHasALineDownToTheGround) {
    GlyphStyle style = wind_style();
    style.link_per_px = 1 / 700.0;
    SelectedGlyph high = glyph_of(12);
    high.summary.over_ground_m = 2300;
    const Encoded encoded({high}, GlyphValues::wind, style);
    ASSERT_EQ(encoded.batch.runs().size(), 2u);
    const GlyphRun& run = encoded.batch.runs()[1];
    EXPECT_EQ(run.shape, GlyphShape::stem);
    EXPECT_EQ(run.facing, GlyphFacing::eye_upright);
    ASSERT_EQ(run.count, kLinkParts);
    const glm::dvec3 eye = earth::to_ecef(kPlace), at = eye + glm::dvec3(high.summary.place);
    const earth::Geodetic there = earth::from_ecef(at);
    const GeographicLib::LocalCartesian frame(base::degrees(there.latitude_rad), base::degrees(there.longitude_rad),
                                              there.height.m);
    double latitude = 0, longitude = 0, height = 0;
    const auto below = [&](double down_m) {
        frame.Reverse(0, 0, -down_m, latitude, longitude, height);
        return earth::to_ecef({radians(latitude), radians(longitude), earth::EllipsoidHeight{height}}) - eye;
    };
    const GlyphInstance &line = encoded.batch.of(run)[0], &foot = encoded.batch.of(run)[1];
    EXPECT_LT(glm::length(glm::dvec3(line.place) - below(1150)), 0.05);
    EXPECT_FLOAT_EQ(line.size_m.x, 2300);
    EXPECT_NEAR(line.size_m.y, 2 * glm::length(high.summary.place) / 700, 1e-3) << "two pixels";
    EXPECT_LT(glm::length(glm::dvec3(foot.place) - below(2300 - 0.5 * double{foot.size_m.x})), 0.05);
    EXPECT_GT(foot.size_m.y, 2 * line.size_m.y);
    const GlyphInstance& arrow = encoded.batch.of(encoded.batch.runs()[0])[0];
    for (int n = 0; n < 4; ++n) EXPECT_EQ(line.rgba[n], arrow.rgba[n]);
}

TEST(GlyphEncoding, WhatStandsOrIsNotKnownToFloatHasNoLine) {
    GlyphStyle style = wind_style();
    style.link_per_px = 1 / 700.0;
    SelectedGlyph low = glyph_of(12), below = low, unknown = low, high = low;
    low.summary.over_ground_m = 4;
    below.summary.over_ground_m = -50;
    high.summary.over_ground_m = 300;
    EXPECT_EQ(Encoded({low, below, unknown}, GlyphValues::wind, style).batch.instances().size(), 3u);
    EXPECT_EQ(Encoded({low, below, unknown, high}, GlyphValues::wind, style).batch.instances().size(), 6u);
    EXPECT_EQ(Encoded({high}, GlyphValues::wind, wind_style()).batch.instances().size(), 1u) << "not asked for";
    const Encoded little({high, high}, GlyphValues::wind, style, scale_of(), 3);
    EXPECT_EQ(little.batch.instances().size(), 2u) << "lines have no room, the glyphs have";
    EXPECT_EQ(little.left_out, 2 * kLinkParts);
}

TEST(GlyphEncoding, SmallOnesArePlain) {
    GlyphStyle style = wind_style();
    SelectedGlyph small = glyph_of(9);
    small.size_px = 10;
    EXPECT_EQ(shape_of_one(small, GlyphValues::wind, style), GlyphShape::plain_arrow);
    style.form = GlyphForm::sphere;
    EXPECT_EQ(shape_of_one(small, GlyphValues::wind, style), GlyphShape::plain_sphere);
}

TEST(GlyphEncoding, TheLessSureAreGreyerAndAsLight) {
    GlyphStyle style = wind_style();
    style.form = GlyphForm::sphere;
    style.greying = 0.8;
    SelectedGlyph sure = glyph_of(20), unsure = glyph_of(20), missing = glyph_of(20);
    sure.summary.uncertainty = scene::Uncertainty::from_level(0);
    unsure.summary.uncertainty = scene::Uncertainty::from_level(1);
    missing.summary.state = ValueState::missing;
    const auto color = [&](const SelectedGlyph& glyph) {
        const GlyphInstance made = Encoded({glyph}, GlyphValues::number, style).only();
        return std::array<int, 4>{made.rgba[0], made.rgba[1], made.rgba[2], made.rgba[3]};
    };
    EXPECT_EQ(color(sure), (std::array<int, 4>{200, 0, 0, 255}));
    const double luma = 0.2126 * 200;
    EXPECT_NEAR(color(unsure)[0], 0.2 * 200 + 0.8 * luma, 1);
    EXPECT_NEAR(color(unsure)[1], 0.8 * luma, 1);
    EXPECT_EQ(color(unsure)[3], 255) << "it does not fade";
    EXPECT_EQ(color(missing)[0], style.missing.red) << "what is missing has no certainty to lose";
    unsure.summary.uncertainty = {};
    EXPECT_EQ(color(unsure), (std::array<int, 4>{255, 0, 255, 255})) << "unknown is no grade of grey";
}

TEST(GlyphEncoding, TheLessSureFadeAndLieInOrder) {
    GlyphStyle style = wind_style();
    style.fading = 0.8;
    SelectedGlyph sure = glyph_of(9), unsure = glyph_of(9), unknown = glyph_of(9);
    sure.summary.uncertainty = scene::Uncertainty::from_level(0);
    unsure.summary.uncertainty = scene::Uncertainty::from_level(1);
    unknown.summary.uncertainty = {};
    sure.summary.place = {100, 0, 0};
    unsure.summary.place = {300, 0, 0};
    unknown.summary.place = {200, 0, 0};
    const Encoded encoded({sure, unsure, unknown}, GlyphValues::wind, style);
    ASSERT_EQ(encoded.batch.runs().size(), 1u);
    EXPECT_TRUE(encoded.batch.runs()[0].is_transparent);
    const auto glyphs = encoded.batch.instances();
    EXPECT_EQ(glyphs[0].place.x, 300) << "the farthest first";
    EXPECT_EQ(glyphs[1].place.x, 200);
    EXPECT_EQ(glyphs[2].place.x, 100);
    EXPECT_EQ(glyphs[2].rgba[3], 255);
    EXPECT_EQ(glyphs[0].rgba[3], 51);
    EXPECT_EQ(glyphs[1].rgba[3], 255) << "unknown is neither sure nor unsure:";
    EXPECT_EQ(glyphs[1].rgba[1], 0);
    EXPECT_EQ(glyphs[1].rgba[2], 255) << "it has a colour of its own";
    EXPECT_FALSE(Encoded({sure}, GlyphValues::wind, wind_style()).batch.runs()[0].is_transparent);
}

TEST(GlyphEncoding, WhatFindsNoRoomIsCounted) {
    std::vector<SelectedGlyph> glyphs(10, glyph_of(9));
    glyphs[0].summary.state = ValueState::missing;
    const Encoded encoded(glyphs, GlyphValues::wind, wind_style(), scale_of(), 4);
    EXPECT_EQ(encoded.left_out, 9u) << "the arrows, and not the cross";
    EXPECT_EQ(encoded.batch.instances().size(), 1u);
    EXPECT_EQ(Encoded({}, GlyphValues::wind, wind_style()).left_out, 0u);
}

TEST(GlyphEncoding, AtThePolesAsWell) {
    for (const double latitude : {90.0, -90.0}) {
        SelectedGlyph glyph = glyph_of(3, 4);
        glyph.summary.place = {};
        std::vector<GlyphInstance> room(1);
        GlyphBatch batch(room);
        const earth::Ecef pole = earth::to_ecef({radians(latitude), 0, {}});
        encode_glyphs({&glyph, 1}, GlyphValues::wind, wind_style(), scale_of(), glm::dvec3(0, 0, pole.z), batch);
        EXPECT_NEAR(direction_of(batch.instances()[0]).z, 0, 0.02) << "level";
    }
}

}  // namespace
}  // namespace tedavis::draw::test_glyph_encoding
