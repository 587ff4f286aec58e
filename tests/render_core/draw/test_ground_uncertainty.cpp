#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <memory>
#include <string>

#include "tests/support/draw/ground_drawing.hpp"

namespace tedavis::draw::test_ground_uncertainty {
namespace {

using design::Color;
using design::IntrinsicUncertainty;
using design::UncertaintyOverlay;
using scene::Uncertainty;
using test_support::color_blend;
using test_support::color_difference;
using test_support::field_over;
using test_support::ground_design;
using test_support::level_ground;
using test_support::LoadedScene;
using test_support::RasterScene;

constexpr int kSide = 9;
constexpr std::size_t kPosts = kSide * kSide;
constexpr Color kInk{255, 255, 255};

design::DesignSettings opaque_design(IntrinsicUncertainty technique) {
    design::DesignSettings design = ground_design(technique);
    design.data.ground.opacity = 1;
    return design;
}
design::DesignSettings overlay_design(UncertaintyOverlay technique) {
    design::DesignSettings design = opaque_design(IntrinsicUncertainty::none);
    design.data.ground.overlay.technique = technique;
    design.data.ground.overlay.strength = 0.8;
    design.data.ground.overlay.mesh_m = 512;
    design.data.ground.overlay.color = kInk;
    return design;
}

/// The field with the same uncertainty everywhere.
host_sim::LayerDraft field_of_level(const RasterScene& ground, double level) {
    host_sim::LayerDraft draft = field_over(ground, kSide);
    draft.attributes[0].uncertainties.assign(kPosts, Uncertainty::from_level(level));
    return draft;
}
host_sim::LayerDraft unknown_field(const RasterScene& ground) {
    host_sim::LayerDraft draft = field_over(ground, kSide);
    draft.attributes[0].uncertainties.assign(kPosts, Uncertainty());
    return draft;
}
/// One value everywhere, which is dark.
host_sim::LayerDraft flat(host_sim::LayerDraft draft) {
    draft.attributes[0].values.assign(kPosts, 90);
    draft.attributes[0].values[0] = 0;  // so that there is a range; outside the part that is looked at
    draft.attributes[0].values[kPosts - 1] = 100;
    return draft;
}

/// A picture that outlives its drawing: one display at a time has the surface.
struct Drawn {
    explicit Drawn(const test_support::GroundDrawing& drawing)
        : picture(drawing.picture), field(drawing.field), view(drawing.input.view), ellipsoid_m(drawing.ellipsoid_m) {}
    [[nodiscard]] Color pixel(int column, int row) const { return picture.at(column + 0.5, row + 0.5); }
    [[nodiscard]] double level_at(int column, int row) const {
        const earth::Geodetic place = test_support::place_of(view, column, row, ellipsoid_m);
        return field.at(place.latitude_rad, place.longitude_rad, 0, 0).uncertainty.level();
    }

    test_support::ChunkPicture picture;
    scene::GridField field;
    terrain::View view;
    double ellipsoid_m;
};

/// Pixels in the middle of the field.
template <class Visit>
int visit_middle(Visit visit) {
    int all = 0;
    for (int row = 60; row < 180; ++row)
        for (int column = 100; column < 220; ++column, ++all) visit(column, row);
    return all;
}

double luminance(Color c) { return 0.2126 * c.red + 0.7152 * c.green + 0.0722 * c.blue; }

struct Spread {
    double mean = 0, deviation = 0;
};
Spread luminance_of(const Drawn& drawn) {
    double sum = 0, squares = 0;
    const int all = visit_middle([&](int column, int row) {
        const double level = luminance(drawn.pixel(column, row));
        sum += level;
        squares += level * level;
    });
    const double mean = sum / all;
    return {mean, std::sqrt(std::fmax(squares / all - mean * mean, 0))};
}

/// Of the pixels that differ from another picture's, with a third of the difference of a line.
double changed_share(const Drawn& a, const Drawn& b) {
    int changed = 0;
    const int all = visit_middle(
        [&](int column, int row) { changed += color_difference(a.pixel(column, row), b.pixel(column, row)) > 40 ? 1 : 0; });
    return static_cast<double>(changed) / all;
}

class GroundUncertaintyOf : public ::testing::TestWithParam<const char*> {
protected:
    /// Scenes stay as long as the test, for what is drawn asks them again.
    [[nodiscard]] Drawn draw(const host_sim::LayerDraft& draft, const design::DesignSettings& design) {
        loaded_.emplace_back(draft);
        if (drawing_ == nullptr || !drawing_->redraw(loaded_.back(), design)) {
            drawing_.reset();
            drawing_ = std::make_unique<test_support::GroundDrawing>(ground_, loaded_.back(), design, GetParam());
        }
        return Drawn(*drawing_);
    }
    static const RasterScene& level() {
        static const RasterScene ground = level_ground();
        return ground;
    }

    const RasterScene& ground_ = level();
    std::deque<LoadedScene> loaded_;
    std::unique_ptr<test_support::GroundDrawing> drawing_;
};
INSTANTIATE_TEST_SUITE_P(Lanes, GroundUncertaintyOf, ::testing::Values("es2-small", "es3-mid"));

TEST_P(GroundUncertaintyOf, WhatIsCertainLooksAsItDoesWithoutATechnique) {
    const host_sim::LayerDraft certain = field_of_level(ground_, 0);
    const Drawn plain = draw(certain, opaque_design(IntrinsicUncertainty::none));
    const auto most = [&](const design::DesignSettings& design) {
        const Drawn drawn = draw(certain, design);
        int difference = 0;
        visit_middle([&](int column, int row) {
            difference = std::max(difference, color_difference(drawn.pixel(column, row), plain.pixel(column, row)));
        });
        return difference;
    };
    EXPECT_LE(most(opaque_design(IntrinsicUncertainty::bump)), 1);
    EXPECT_LE(most(opaque_design(IntrinsicUncertainty::blur)), 1);
    EXPECT_EQ(most(overlay_design(UncertaintyOverlay::fog)), 0);
    EXPECT_EQ(most(overlay_design(UncertaintyOverlay::contour)), 0);
    EXPECT_EQ(most(overlay_design(UncertaintyOverlay::halo)), 0);
    EXPECT_GT(most(overlay_design(UncertaintyOverlay::grid)), 100) << "but a mesh is finest where it is certain";
}

TEST_P(GroundUncertaintyOf, BumpsAreTheRougherTheLessSureAndKeepTheColorOnTheWhole) {
    double last = 0;
    const double mean = luminance_of(draw(flat(field_of_level(ground_, 0)), opaque_design(IntrinsicUncertainty::none))).mean;
    for (const double level : {0.25, 0.5, 1.0}) {
        const Spread spread = luminance_of(draw(flat(field_of_level(ground_, level)), opaque_design(IntrinsicUncertainty::bump)));
        EXPECT_GT(spread.deviation, 1.5 * last) << level;
        EXPECT_NEAR(spread.mean, mean, 0.15 * mean) << level;
        last = spread.deviation;
    }
    EXPECT_GT(last, 0.1 * mean);
}

TEST_P(GroundUncertaintyOf, BlurWashesEdgesOfClassesOutAndLeavesPlainsAsTheyAre) {
    design::DesignSettings design = opaque_design(IntrinsicUncertainty::blur);
    design.data.ground.uncertainty.strength = 1;
    for (const double limit : {20.0, 45.0, 70.0}) EXPECT_TRUE(design.data.ground.scale.breaks.try_push_back(limit));
    // The mean of the largest steps from a pixel to the next in each row.
    const auto step = [&](double level) {
        const Drawn drawn = draw(field_of_level(ground_, level), design);
        double sum = 0;
        for (int row = 60; row < 180; ++row) {
            int largest = 0;
            for (int column = 100; column < 220; ++column)
                largest = std::max(largest, color_difference(drawn.pixel(column, row), drawn.pixel(column + 1, row)));
            sum += largest;
        }
        return sum / 120;
    };
    const double certain = step(0), half = step(0.5), full = step(1);
    EXPECT_LT(half, 0.6 * certain);
    EXPECT_LE(full, 1.05 * half);
    EXPECT_LT(luminance_of(draw(flat(field_of_level(ground_, 0.5)), design)).deviation, 0.5);
}

TEST_P(GroundUncertaintyOf, FogHidesByTheLevelAndNeverCountsTheUnknownAsSure) {
    const host_sim::LayerDraft certain = flat(field_of_level(ground_, 0));
    const design::DesignSettings design = overlay_design(UncertaintyOverlay::fog);
    const double bare = luminance_of(draw(certain, design)).mean;
    for (const double level : {0.25, 0.5, 1.0}) {
        const Spread spread = luminance_of(draw(flat(field_of_level(ground_, level)), design));
        EXPECT_NEAR((spread.mean - bare) / (255 - bare), 0.8 * level, 0.08) << level;
        EXPECT_GT(spread.deviation, 1) << "clouds, no veil";
    }
    const Spread unknown = luminance_of(draw(flat(unknown_field(ground_)), design));
    EXPECT_GT((unknown.mean - bare) / (255 - bare), 0.6);
}

TEST_P(GroundUncertaintyOf, GradationsOfFogAreSteps) {
    design::DesignSettings design = overlay_design(UncertaintyOverlay::fog);
    design.data.ground.overlay.levels = 2;
    const auto mean = [&](double level) { return luminance_of(draw(flat(field_of_level(ground_, level)), design)).mean; };
    EXPECT_NEAR(mean(0.1), mean(0.45), 0.01);
    EXPECT_GT(mean(0.55), mean(0.45) + 50);
    EXPECT_NEAR(mean(0.55), mean(0.95), 0.01);
}

TEST_P(GroundUncertaintyOf, TheMeshIsTwiceAsWideFromOneGradationToTheNext) {
    const design::DesignSettings mesh = overlay_design(UncertaintyOverlay::grid);
    const Drawn plain = draw(flat(field_of_level(ground_, 0)), opaque_design(IntrinsicUncertainty::none));
    const auto share = [&](double level) { return changed_share(draw(flat(field_of_level(ground_, level)), mesh), plain); };
    const double finest = share(0), second = share(0.3), third = share(0.5);
    EXPECT_GT(finest, 0.1);
    EXPECT_NEAR(second / finest, 0.5, 0.15);
    EXPECT_NEAR(third / second, 0.5, 0.2);
    EXPECT_NEAR(share(0.22), second, 1e-9) << "the same gradation";
    design::DesignSettings fine = mesh;
    fine.data.ground.overlay.mesh_m = 64;  // two pixels
    EXPECT_LT(changed_share(draw(flat(field_of_level(ground_, 0)), fine), plain), 0.001) << "no lines closer than pixels";
    const Drawn unknown = draw(flat(unknown_field(ground_)), mesh);
    const Drawn least = draw(flat(field_of_level(ground_, 1)), mesh);
    int like_the_finest = 0;
    visit_middle([&](int column, int row) {
        const bool stripe = color_difference(unknown.pixel(column, row), test_support::kBareGround) < 3;
        like_the_finest += !stripe && color_difference(unknown.pixel(column, row), least.pixel(column, row)) > 80 ? 1 : 0;
    });
    EXPECT_LT(like_the_finest, 300);
}

/// Columns of pixels in the middle row band where lines stand, by the level there.
TEST_P(GroundUncertaintyOf, ContourAndHaloStandWhereTheLevelIsTheThreshold) {
    const host_sim::LayerDraft draft = flat(field_over(ground_, kSide));  // level from 0 in the west to 1 in the east
    const Drawn plain = draw(draft, opaque_design(IntrinsicUncertainty::none));
    for (const double threshold : {0.3, 0.6}) {
        int marked[2]{};
        for (const UncertaintyOverlay technique : {UncertaintyOverlay::contour, UncertaintyOverlay::halo}) {
            design::DesignSettings design = overlay_design(technique);
            design.data.ground.overlay.threshold = threshold;
            const Drawn drawn = draw(draft, design);
            double level_sum = 0;
            int& count = marked[technique == UncertaintyOverlay::halo ? 1 : 0];
            visit_middle([&](int column, int row) {
                if (color_difference(drawn.pixel(column, row), plain.pixel(column, row)) < 25) return;
                ++count;
                level_sum += drawn.level_at(column, row);
            });
            ASSERT_GT(count, 0);
            EXPECT_NEAR(level_sum / count, threshold, 0.03);
        }
        EXPECT_NEAR(marked[0] / 120.0, 6, 1.5) << "pixels across, rims included";
        EXPECT_GT(marked[1], 2 * marked[0]);
    }
    for (const double level : {0.1, 0.5, 0.9}) {
        design::DesignSettings design = overlay_design(UncertaintyOverlay::contour);
        const host_sim::LayerDraft even = flat(field_of_level(ground_, level));
        EXPECT_EQ(changed_share(draw(even, design), draw(even, opaque_design(IntrinsicUncertainty::none))), 0)
            << "no edge, no line, though all of it be at the threshold";
    }
}

TEST_P(GroundUncertaintyOf, TheUnknownIsMarkedInEveryTechnique) {
    const auto bare_share = [&](const design::DesignSettings& design) {
        const Drawn drawn = draw(flat(unknown_field(ground_)), design);
        int bare = 0;
        const int all = visit_middle([&](int column, int row) {
            // Under fog the ground's stripes are still lighter than the dark data between them.
            bare += luminance(drawn.pixel(column, row)) > 150 ? 1 : 0;
        });
        return static_cast<double>(bare) / all;
    };
    EXPECT_NEAR(bare_share(opaque_design(IntrinsicUncertainty::bump)), 1 / 3.0, 0.03);
    EXPECT_NEAR(bare_share(opaque_design(IntrinsicUncertainty::blur)), 1 / 3.0, 0.03);
    EXPECT_NEAR(bare_share(overlay_design(UncertaintyOverlay::contour)), 1 / 3.0, 0.03);
    EXPECT_NEAR(bare_share(overlay_design(UncertaintyOverlay::halo)), 1 / 3.0, 0.03);
    EXPECT_GT(bare_share(overlay_design(UncertaintyOverlay::grid)), 0.3);
    EXPECT_GT(bare_share(overlay_design(UncertaintyOverlay::fog)), 0.3);
}

TEST_P(GroundUncertaintyOf, AnOverlayStandsBesideATechniqueInTheColors) {
    design::DesignSettings both = overlay_design(UncertaintyOverlay::fog);
    both.data.ground.uncertainty = {IntrinsicUncertainty::saturation, 0.75, 0};
    const host_sim::LayerDraft draft = field_of_level(ground_, 0.5);
    const Drawn fog = draw(draft, overlay_design(UncertaintyOverlay::fog)), drawn = draw(draft, both);
    int greyer = 0;
    const auto chroma = [](Color c) { return std::max({c.red, c.green, c.blue}) - std::min({c.red, c.green, c.blue}); };
    const int all = visit_middle(
        [&](int column, int row) { greyer += chroma(drawn.pixel(column, row)) <= chroma(fog.pixel(column, row)) ? 1 : 0; });
    EXPECT_GT(greyer, 0.99 * all);
    EXPECT_GT(changed_share(drawn, draw(draft, opaque_design(IntrinsicUncertainty::saturation))), 0.3) << "and there is fog";
}

}  // namespace
}  // namespace tedavis::draw::test_ground_uncertainty
