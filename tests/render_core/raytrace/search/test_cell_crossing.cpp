#include "render_core/raytrace/search/cell_crossing.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/files/hard_case.hpp"
#include "tests/support/raytrace/held_heights.hpp"
#include "tests/support/raytrace/surface_scene.hpp"

namespace tedavis::raytrace::test_cell_crossing {
namespace {

using test_support::Dice;
using test_support::kSurfaceKinds;

CellPatch patch_of(SurfaceKind kind, std::uint64_t seed, double height = 3) {
    auto heights = test_support::HeldHeights<float>(4, 4);
    Dice dice(seed);
    heights.fill([&](int, int) { return dice.between(-height, height); });
    SurfaceSettings settings;
    settings.kind = kind;
    settings.subdivisions = 3;
    return cell_patch(heights.grid(), settings, 1, 1);
}

/// Between two random points of the sides of the cell, at heights where something may be met.
CellRay random_stretch(Dice& dice) {
    const auto point = [&](double t) {
        const double along = dice.unit();
        const std::uint32_t side = dice.below(4);
        return RayPoint{t,
                        {1, 1,
                         side == 0   ? 0
                         : side == 1 ? 1
                                     : along,
                         side == 2   ? 0
                         : side == 3 ? 1
                                     : along},
                        dice.between(-3, 3)};
    };
    return {point(0), point(1)};
}

struct Sampled {
    bool is_hit = false;
    double s = 0, least = 0;  ///< how far the stretch keeps from the surface, where it is not met
};

/// By brute force: the first change of sign among many samples.
Sampled sampled_crossing(const CellPatch& patch, const CellRay& ray, int samples) {
    Sampled found;
    found.least = 1e30;
    const auto gap = [&](double s) {
        const RayPoint p = ray.at(s);
        return p.z - patch.at(p.place.u, p.place.v).height;
    };
    const bool is_below = gap(0) < 0;
    for (int n = 0; n <= samples; ++n) {
        const double s = n / static_cast<double>(samples), g = is_below ? -gap(s) : gap(s);
        found.least = std::min(found.least, g);
        if (g > 0) continue;
        found.is_hit = true;
        found.s = s;
        break;
    }
    return found;
}

TEST(CellCrossing, IsTheFirstChangeOfSignAmongManySamples) {
    constexpr int kSamples = 2000;
    for (const SurfaceKind kind : kSurfaceKinds) {
        Dice dice(static_cast<std::uint64_t>(kind) + 1);
        int hit_count = 0, from_below = 0;
        for (int n = 0; n < 4000; ++n) {
            const CellPatch patch = patch_of(kind, n);
            const CellRay ray = random_stretch(dice);
            const Crossing crossing = first_crossing(patch, {}, ray);
            const Sampled sampled = sampled_crossing(patch, ray, kSamples);
            if (!sampled.is_hit && crossing.is_hit) {
                // Between two samples: it must be real.
                const RayPoint p = ray.at(crossing.s);
                ASSERT_NEAR(p.z, patch.at(p.place.u, p.place.v).height, 1e-9);
                continue;
            }
            ASSERT_EQ(crossing.is_hit, sampled.is_hit) << static_cast<int>(kind) << ' ' << n << " kept " << sampled.least;
            if (!crossing.is_hit) continue;
            ++hit_count;
            from_below += crossing.is_from_below ? 1 : 0;
            ASSERT_LE(crossing.s, sampled.s + 1e-9);
            const RayPoint p = ray.at(crossing.s);
            ASSERT_NEAR(p.z, patch.at(p.place.u, p.place.v).height, 1e-8) << static_cast<int>(kind);
            // Nothing before it.
            for (double s = 0; s < crossing.s - 1e-9; s += 0.01) {
                const RayPoint before = ray.at(s);
                const double gap = before.z - patch.at(before.place.u, before.place.v).height;
                ASSERT_TRUE(crossing.is_from_below ? gap < 1e-9 : gap > -1e-9);
            }
        }
        EXPECT_GT(hit_count, 1000);
        EXPECT_GT(from_below, 300);
    }
}

/// The naive form, the textbook's: it loses all digits where the coefficient of s^2 is small.
double textbook_root(double g0, double g1, double a) {
    const double b = g1 - g0 - a;
    return (-b - std::sqrt(b * b - 4 * a * g0)) / (2 * a);
}

/// The naive judgement of a tangent: by the sign of the discriminant, in floats.
bool is_hit_by_discriminant(double g0, double g1, double a) {
    const auto c = static_cast<float>(g0), k = static_cast<float>(a), b = static_cast<float>(g1) - c - k;
    return b * b - 4 * k * c >= 0;
}

TEST(CellCrossing, QuadraticsNearlyFlatKeepTheirDigits) {
    Dice dice(9);
    double worst = 0, textbook = 0;
    int asked = 0, textbook_wrong = 0;
    for (int n = 0; n < 200000; ++n) {
        const double a = dice.between(-1, 1) * std::pow(10, -dice.between(0, 18));
        const double root = dice.between(0.01, 0.99), slope = -dice.between(0.1, 5);
        // g(s) = (s - root) * (slope + a * (s - root)), above zero at 0.
        const double g0 = -root * (slope - a * root), g1 = (1 - root) * (slope + a * (1 - root));
        if (g0 <= 0 || std::abs(slope) < 2 * std::abs(a)) continue;
        const Crossing found = first_root(g0, g1, a);
        ASSERT_TRUE(found.is_hit);
        ASSERT_NEAR(found.s, root, 1e-13) << a;
        worst = std::max(worst, std::abs(found.s - root));
        const double off = std::abs(textbook_root(g0, g1, a) - root);
        textbook = std::max(textbook, off);
        textbook_wrong += off > 1e-13 ? 1 : 0;
        ++asked;
    }
    EXPECT_GT(textbook_wrong, asked / 2) << "control";
    EXPECT_GT(textbook, 0.1);
    test_support::record_worst("A20", worst);
    test_support::record_control("A20", textbook);
}

TEST(CellCrossing, ATangentIsJudgedAsInLongDouble) {
    Dice dice(10);
    int unlike = 0, unlike_in_floats = 0;
    for (int n = 0; n < 1000000; ++n) {
        const double a = dice.between(0.01, 10), place = dice.between(0.05, 0.95);
        const double clearance = (n % 2 == 0 ? 1 : -1) * std::pow(10, -dice.between(3, 9)) * a;
        // a (s - place)^2 + clearance
        const double g0 = a * place * place + clearance, g1 = a * (1 - place) * (1 - place) + clearance;
        const long double b = (static_cast<long double>(g1) - g0) - a;
        const bool is_hit = static_cast<long double>(g0) - b * b / (4 * static_cast<long double>(a)) <= 0;
        unlike += first_root(g0, g1, a).is_hit != is_hit ? 1 : 0;
        unlike_in_floats += is_hit_by_discriminant(g0, g1, a) != is_hit ? 1 : 0;
    }
    EXPECT_EQ(unlike, 0);
    EXPECT_GT(unlike_in_floats, 50'000) << "control";
}

TEST(CellCrossing, NeighboursLeaveNoGapAtTheirSides) {
    // Rays through points of a shared side: the stretch before and the stretch behind agree about the point between.
    const auto heights = test_support::dice_heights<float>(8, 8, 3, 4);
    Dice dice(11);
    for (const SurfaceKind kind : kSurfaceKinds) {
        SurfaceSettings settings;
        settings.kind = kind;
        int slipped = 0, hit_count = 0;
        for (int n = 0; n < 20000; ++n) {
            const std::uint32_t column = 1 + dice.below(4), row = 1 + dice.below(5);
            const double v = dice.unit();
            const CellPatch left = cell_patch(heights.grid(), settings, column, row),
                            right = cell_patch(heights.grid(), settings, column + 1, row);
            // Aimed at the surface on the side itself.
            const double z = left.at(1, v).height, rise = dice.between(0.5, 3);
            const RayPoint from{
                0, {column, row, 0, std::clamp(v + dice.between(-1, 1), 0.0, 1.0)}, std::max(z, left.range().highest) + rise};
            const RayPoint middle{1, {column, row, 1, v}, z}, entered{1, {column + 1, row, 0, v}, z};
            const RayPoint to{
                2, {column + 1, row, 1, std::clamp(v + dice.between(-1, 1), 0.0, 1.0)}, right.range().lowest - rise};
            const Crossing before = first_crossing(left, {}, {from, middle}), behind = first_crossing(right, {}, {entered, to});
            slipped += !before.is_hit && !behind.is_hit ? 1 : 0;
            hit_count += before.is_hit ? 1 : 0;
        }
        EXPECT_EQ(slipped, 0);
        EXPECT_EQ(hit_count, 20000) << "the closed side belongs to both";
    }
}

}  // namespace
}  // namespace tedavis::raytrace::test_cell_crossing
