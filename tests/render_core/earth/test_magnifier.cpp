// Oracle: the same map as a triangulation in long double: each triangle's corners are moved, what lies in it by its weights.
#include "render_core/earth/magnifier.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <random>
#include <vector>

#include "render_core/base/units.hpp"

namespace tedavis::earth::test_magnifier {
namespace {

using base::radians;
using Real = long double;

struct Point2 {
    Real x, y;
};
struct Weighted {
    std::array<Point2, 3> from, to;
};

/// Corners of a regular polygon whose edges lie so far away; an edge lies to the east.
std::vector<Point2> polygon(int sides, Real edge_m) {
    const Real half = std::acos(Real(-1)) / sides;
    std::vector<Point2> corners;
    for (int n = 0; n < sides; ++n) {
        const Real angle = half * (2 * n - 1);
        corners.push_back({edge_m / std::cos(half) * std::cos(angle), edge_m / std::cos(half) * std::sin(angle)});
    }
    return corners;
}

std::vector<Weighted> triangulation(int sides, Real inner_m, Real outer_m, Real factor) {
    const std::vector<Point2> in = polygon(sides, inner_m), out = polygon(sides, outer_m),
                              grown = polygon(sides, factor * inner_m);
    std::vector<Weighted> all;
    for (int n = 0; n < sides; ++n) {
        const int next = (n + 1) % sides;
        const Point2 middle{(out[n].x + out[next].x) / 2, (out[n].y + out[next].y) / 2};
        all.push_back({{Point2{0, 0}, in[n], in[next]}, {Point2{0, 0}, grown[n], grown[next]}});
        all.push_back({{in[n], middle, in[next]}, {grown[n], middle, grown[next]}});
        all.push_back({{in[n], out[n], middle}, {grown[n], out[n], middle}});
        all.push_back({{in[next], middle, out[next]}, {grown[next], middle, out[next]}});
    }
    return all;
}

Real area(const Point2& a, const Point2& b, const Point2& c) { return (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y); }

Point2 oracle(const std::vector<Weighted>& all, const Point2& p, bool back) {
    for (const Weighted& t : all) {
        const auto& from = back ? t.to : t.from;
        const auto& to = back ? t.from : t.to;
        const Real whole = area(from[0], from[1], from[2]);
        const Real a = area(p, from[1], from[2]) / whole, b = area(from[0], p, from[2]) / whole, c = 1 - a - b;
        if (a < -1e-15L || b < -1e-15L || c < -1e-15L) continue;
        return {a * to[0].x + b * to[1].x + c * to[2].x, a * to[0].y + b * to[1].y + c * to[2].y};
    }
    return p;
}

MagnifierSettings settings(bool is_square, std::uint32_t power, double radius_m = 2000) {
    MagnifierSettings of{radians(46.8), radians(9.8), is_square, radius_m, 0, power};
    of.context_m = Magnifier::context_needed_m(of, 2);
    return of;
}

Magnifier made(const MagnifierSettings& of) {
    Magnifier magnifier;
    EXPECT_TRUE(Magnifier::make(of, magnifier));
    return magnifier;
}

std::vector<Magnifier> all_kinds() {
    std::vector<Magnifier> all;
    for (const bool is_square : {false, true})
        for (std::uint32_t power = 1; power <= kMaxMagnifierPower; ++power)
            for (std::uint32_t compression = 1; compression <= kMaxCompression; ++compression) {
                MagnifierSettings of{radians(46.8), radians(9.8), is_square, 2000, 0, power};
                of.context_m = Magnifier::context_needed_m(of, compression);
                all.push_back(made(of));
                EXPECT_EQ(all.back().compression(), compression);
            }
    return all;
}

std::vector<Weighted> triangulation_of(const Magnifier& magnifier, bool is_square) {
    const Real growth = std::ldexp(Real(1), static_cast<int>(magnifier.power())) - 1;
    const Real shrink = std::ldexp(Real(1), -static_cast<int>(magnifier.compression()));
    return triangulation(is_square ? 4 : 8, 2000, 2000 * (1 + growth / (1 - shrink)), growth + 1);
}

/// Crowded within the reach.
glm::dvec2 some_place(std::mt19937_64& random, const Magnifier& magnifier) {
    std::uniform_real_distribution<double> share(-1.2, 1.2);
    const double reach_m = magnifier.reach_m() * (random() % 2 == 0 ? 1 : 0.2);
    return {reach_m * share(random), reach_m * share(random)};
}

TEST(Magnifier, MovesPlacesAsTheTriangulationDoesBothWays) {
    std::mt19937_64 random(7);
    const std::vector<Magnifier> kinds = all_kinds();
    for (std::size_t n = 0; n < kinds.size(); ++n) {
        const std::vector<Weighted> triangles = triangulation_of(kinds[n], n >= kinds.size() / 2);
        for (int k = 0; k < 4000; ++k) {
            const glm::dvec2 place = some_place(random, kinds[n]);
            const Point2 there = oracle(triangles, {place.x, place.y}, false), from = oracle(triangles, {place.x, place.y}, true);
            const glm::dvec2 moved = kinds[n].moved(place), back = kinds[n].moved_back(place);
            ASSERT_LT(std::hypot(moved.x - double(there.x), moved.y - double(there.y)), 1e-8)
                << n << ' ' << place.x << ' ' << place.y;
            ASSERT_LT(std::hypot(back.x - double(from.x), back.y - double(from.y)), 1e-8)
                << n << ' ' << place.x << ' ' << place.y;
        }
    }
}

TEST(Magnifier, JacobianIsAPowerOfTwoAndTheDifferencesAgree) {
    std::mt19937_64 random(8);
    for (const Magnifier& magnifier : all_kinds())
        for (int k = 0; k < 4000; ++k) {
            const glm::dvec2 place = some_place(random, magnifier);
            const double jacobian = magnifier.jacobian(place);
            ASSERT_GT(jacobian, 0);
            ASSERT_EQ(std::exp2(std::round(std::log2(jacobian))), jacobian);
            constexpr double kStep_m = 1e-3;
            const glm::dvec2 across = (magnifier.moved(place + glm::dvec2(kStep_m, 0)) - magnifier.moved(place)) / kStep_m;
            const glm::dvec2 along = (magnifier.moved(place + glm::dvec2(0, kStep_m)) - magnifier.moved(place)) / kStep_m;
            const double differences = across.x * along.y - across.y * along.x;
            ASSERT_GT(differences, 0);
            // Not where the step crosses a border.
            if (magnifier.jacobian(place + glm::dvec2(kStep_m, 0)) == jacobian &&
                magnifier.jacobian(place + glm::dvec2(0, kStep_m)) == jacobian &&
                jacobian != std::ldexp(1.0, -int(magnifier.compression()))) {
                ASSERT_NEAR(differences, jacobian, 1e-5 * jacobian);
            }
        }
}

TEST(Magnifier, InverseIsExactToAMicrometreInSpace) {
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> height(-500, 15000);
    double worst_m = 0;
    for (const Magnifier& magnifier : all_kinds())
        for (int k = 0; k < 4000; ++k) {
            const glm::dvec2 at = some_place(random, magnifier);
            const Ecef place =
                magnifier.middle() + magnifier.east() * at.x + magnifier.north() * at.y + magnifier.up() * height(random);
            worst_m = std::fmax(worst_m, glm::distance(magnifier.moved_back(magnifier.moved(place)), place));
            worst_m = std::fmax(worst_m, glm::distance(magnifier.moved(magnifier.moved_back(place)), place));
        }
    EXPECT_LT(worst_m, 1e-6);
    EXPECT_GT(worst_m, 0);
}

TEST(Magnifier, NothingMovesBeyondTheReachAndTheFocusGrowsByThePower) {
    std::mt19937_64 random(10);
    for (const Magnifier& magnifier : all_kinds())
        for (int k = 0; k < 2000; ++k) {
            const glm::dvec2 place = some_place(random, magnifier);
            const Ecef in_space = magnifier.middle() + magnifier.east() * place.x + magnifier.north() * place.y;
            ASSERT_LE(glm::distance(place, magnifier.moved(place)), magnifier.farthest_move_m() * (1 + 1e-12));
            if (glm::length(place) > magnifier.reach_m()) {
                ASSERT_EQ(magnifier.moved(in_space), in_space);
            }
            if (glm::length(place) < 2000) {
                ASSERT_EQ(magnifier.moved(place), place * magnifier.factor());
            }
        }
}

/// By how far out the polygon through a place has its edges.
double edge_m(const glm::dvec2& place, int sides) {
    double out = 0;
    for (int n = 0; n < sides; ++n) {
        const double angle = radians(360.0 * n / sides);
        out = std::fmax(out, place.x * std::cos(angle) + place.y * std::sin(angle));
    }
    return out;
}

TEST(Magnifier, WhatIsFartherOutIsShownFartherOut) {
    for (const bool is_square : {false, true}) {
        const Magnifier magnifier = made(settings(is_square, 3));
        const int sides = is_square ? 4 : 8;
        for (int direction = 0; direction < 360; direction += 7) {
            const glm::dvec2 out(std::cos(radians(direction)), std::sin(radians(direction)));
            double before = -1;
            for (int step = 0; step <= 2000; ++step) {
                const double shown = edge_m(magnifier.moved(out * (1.1 * magnifier.reach_m() * step / 2000)), sides);
                ASSERT_GT(shown, before);
                before = shown;
            }
        }
    }
}

TEST(Magnifier, CellsCoverThePlaneOnceAndMoveWhatTheMapMoves) {
    std::mt19937_64 random(11);
    for (const Magnifier& magnifier : all_kinds())
        for (int k = 0; k < 2000; ++k) {
            const glm::dvec2 place = some_place(random, magnifier);
            int well_inside = 0, inside = 0;
            for (std::size_t n = 0; n < magnifier.cell_count(); ++n) {
                const Magnifier::Cell cell = magnifier.cell(n);
                const double depth_m = cell.inside_m(place);
                if (depth_m < -1e-9) continue;
                ++inside;
                well_inside += depth_m > 1e-6 ? 1 : 0;
                ASSERT_TRUE(cell.touches(place, {0, 0}));
                ASSERT_LT(glm::distance(cell.slope * place + cell.shift, magnifier.moved(place)), 1e-7);
                if (depth_m > 1e-6) {
                    ASSERT_NEAR(glm::determinant(cell.slope), magnifier.jacobian(place), 1e-12);
                }
            }
            ASSERT_GE(inside, 1);
            ASSERT_LE(well_inside, 1);
        }
}

/// A rectangle that a cell is said not to touch holds nothing of it.
TEST(Magnifier, CellsAreNotMissed) {
    std::mt19937_64 random(12);
    std::uniform_real_distribution<double> share(-1, 1), side(10, 4000);
    int touched = 0, refused = 0;
    for (const Magnifier& magnifier : all_kinds())
        for (int k = 0; k < 300; ++k) {
            const glm::dvec2 middle = some_place(random, magnifier), half(side(random), side(random));
            for (std::size_t n = 0; n < magnifier.cell_count(); ++n) {
                const Magnifier::Cell cell = magnifier.cell(n);
                ++(cell.touches(middle, half) ? touched : refused);
                if (cell.touches(middle, half)) continue;
                for (int point = 0; point < 20; ++point)
                    ASSERT_LT(cell.inside_m(middle + half * glm::dvec2(share(random), share(random))), 0);
            }
        }
    EXPECT_GT(touched, 1000);
    EXPECT_GT(refused, 1000);
}

TEST(Magnifier, HeightsOverThePlaneAreKeptAndOverTheEllipsoidNearlySo) {
    std::mt19937_64 random(13);
    const MagnifierSettings wide{radians(46.8), radians(9.8), false, 10'000, 1e6, 3};
    for (const MagnifierSettings& of : {settings(false, 2), settings(true, 3), wide}) {
        const Magnifier magnifier = made(of);
        double most_m = 0;
        for (int k = 0; k < 4000; ++k) {
            const glm::dvec2 at = some_place(random, magnifier);
            const Ecef place = magnifier.middle() + magnifier.east() * at.x + magnifier.north() * at.y + magnifier.up() * 3000.0;
            const Ecef shown = magnifier.moved(place);
            ASSERT_NEAR(glm::dot(shown - place, magnifier.up()), 0, 1e-6);
            const double rise_m = from_ecef(shown).height.m - from_ecef(place).height.m;
            ASSERT_GE(rise_m, -1e-6 - 0.01 * magnifier.farthest_rise_m());
            most_m = std::fmax(most_m, rise_m);
        }
        EXPECT_LE(most_m, magnifier.farthest_rise_m());
        EXPECT_GT(most_m, 0.1 * magnifier.farthest_rise_m());
    }
}

TEST(Magnifier, RefusesWhatWouldFoldOrHasNoRoom) {
    Magnifier magnifier = made(settings(false, 1));
    const double reach_m = magnifier.reach_m();
    MagnifierSettings of = settings(false, 1);
    // As much as the focus takes, the context must have: less would fold.
    of.context_m = 0.999 * Magnifier::context_needed_m(of, kMaxCompression);
    EXPECT_FALSE(Magnifier::make(of, magnifier));
    of = settings(true, 1);
    of.context_m = of.radius_m;
    EXPECT_FALSE(Magnifier::make(of, magnifier));
    for (const std::uint32_t power : {0u, kMaxMagnifierPower + 1}) {
        of = settings(false, 1);
        of.power = power;
        EXPECT_FALSE(Magnifier::make(of, magnifier));
    }
    of = settings(false, 1);
    of.radius_m = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(Magnifier::make(of, magnifier));
    of = {0, 0, false, 60'000, 1e9, 4};
    EXPECT_FALSE(Magnifier::make(of, magnifier));
    EXPECT_EQ(magnifier.reach_m(), reach_m);
}

TEST(Magnifier, TheLeastCompressionThatFitsIsTaken) {
    for (const bool is_square : {false, true}) {
        MagnifierSettings of = settings(is_square, 2);
        of.context_m = 1e5;
        EXPECT_EQ(made(of).compression(), 1u);
        of.context_m = 0.999 * Magnifier::context_needed_m(of, 1);
        EXPECT_EQ(made(of).compression(), 2u);
        of.context_m = 0.999 * Magnifier::context_needed_m(of, 2);
        EXPECT_EQ(made(of).compression(), 3u);
    }
}

TEST(Magnifiers, RefuseWhatReachesIntoAnother) {
    Magnifiers all;
    MagnifierSettings of = settings(false, 1);
    ASSERT_TRUE(all.add(made(of)));
    const double reach_m = made(of).reach_m();
    of.latitude_rad += 1.9 * reach_m / kMeanRadius_m;
    EXPECT_FALSE(all.add(made(of)));
    EXPECT_EQ(all.size(), 1u);
    of.latitude_rad += 0.2 * reach_m / kMeanRadius_m;
    EXPECT_TRUE(all.add(made(of)));
    const Ecef place = to_ecef({of.latitude_rad + 1e-5, of.longitude_rad, {700}});
    EXPECT_EQ(all.moved(place), made(of).moved(place));
    EXPECT_NE(all.moved(place), place);
    EXPECT_LT(glm::distance(all.moved_back(all.moved(place)), place), 1e-6);
}

TEST(Magnifier, OtherSidesOfTheEarthStay) {
    const Magnifier magnifier = made(settings(false, 2));
    const Ecef place = -magnifier.middle() + magnifier.east() * 100.0;
    EXPECT_EQ(magnifier.moved(place), place);
    EXPECT_EQ(magnifier.moved_back(place), place);
}

}  // namespace
}  // namespace tedavis::earth::test_magnifier
