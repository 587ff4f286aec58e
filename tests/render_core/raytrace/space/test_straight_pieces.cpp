#include "render_core/raytrace/space/straight_pieces.hpp"

#include <gtest/gtest.h>

#include <random>

#include "render_core/base/units.hpp"
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::raytrace::test_straight_pieces {
namespace {

constexpr double kAngle = 5e-5, kFar = 150000;

/// The largest angle between rays of the world and their pieces, over angles that are allowed.
double worst_share(double latitude_deg, bool is_cut) {
    test_support::TdbSpec spec;
    spec.north_deg = latitude_deg;
    spec.columns = spec.rows = 33;
    spec.height_m = [](std::uint32_t, std::uint32_t) { return 0.0; };
    spec.measured = false;
    const test_support::WrittenTdb tdb(spec);
    const GroundSpace space(tdb.database(), {0, 0, 32, 32}, 1);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1, 1);
    double worst = 0;
    for (int n = 0; n < 300; ++n) {
        const earth::Ecef eye = space.position({16, 16, 6000 + 6000 * any(random)});
        const earth::Geodetic at = earth::from_ecef(eye);
        const glm::dmat3 body = earth::body_axes(at.latitude_rad, at.longitude_rad, 4 * any(random), 0.6 * any(random), 0);
        const PieceEnds ends = cut_rays(eye, kAngle, 1, kFar);
        EXPECT_EQ(ends.end[ends.count], kFar);
        for (int piece = 0; piece < (is_cut ? ends.count : 1); ++piece) {
            const double from = ends.end[piece], to = is_cut ? ends.end[piece + 1] : kFar;
            const StraightPiece line = straight_piece(space, eye, body[0], from, to);
            for (int step = 1; step <= 8; ++step) {
                const double t = from + (to - from) * step / 8;
                const glm::dvec3 off = space.position(line.origin + t * line.direction) - (eye + t * body[0]);
                worst = std::max(worst, glm::length(glm::cross(off, body[0])) / t / kAngle);
            }
        }
    }
    return worst;
}

TEST(StraightPieces, AreOffByNoMoreThanTheyMay) {
    for (const double latitude_deg : {0.0, 25.0, 46.8, 61.0, 70.0, -75.0})
        EXPECT_LT(worst_share(latitude_deg, true), 1) << latitude_deg;
}

TEST(StraightPieces, OneLineForAllOfARayIsFurtherOff) { EXPECT_GT(worst_share(46.8, false), 20); }

TEST(StraightPieces, SayWhereTheyEndWhenThereAreTooMany) {
    const earth::Ecef near_pole = earth::to_ecef({base::radians(89.9), 0, {3000}});
    const PieceEnds ends = cut_rays(near_pole, kAngle, 1, 400000);
    EXPECT_EQ(ends.count, PieceEnds::kMax);
    EXPECT_LT(ends.end[ends.count], 400000);
    for (int n = 0; n < ends.count; ++n) EXPECT_LT(ends.end[n], ends.end[n + 1]);
}

TEST(StraightPieces, AreRaysOfTheTracer) {
    test_support::TdbSpec spec;
    spec.columns = spec.rows = 33;
    spec.height_m = [](std::uint32_t, std::uint32_t) { return 0.0; };
    spec.measured = false;
    const test_support::WrittenTdb tdb(spec);
    const GroundSpace space(tdb.database(), {0, 0, 32, 32}, 0.5);
    const earth::Ecef eye = space.position({0, 0, 4000});
    const glm::dvec3 direction = glm::normalize(space.position({60, 20, 3000}) - eye);
    const PieceEnds ends = cut_rays(eye, kAngle, 1, 50000);
    for (int piece = 0; piece < ends.count; ++piece) {
        const Ray ray = ray_of(space, eye, direction, ends, piece);
        EXPECT_EQ(ray.from, static_cast<float>(ends.end[piece]));
        EXPECT_EQ(ray.gap == 0, piece == 0);
        const double t = 0.5 * (static_cast<double>(ray.from) + static_cast<double>(ray.to));
        const glm::dvec3 place = ray.origin + t * glm::dvec3(ray.direction);
        EXPECT_LT(glm::length(space.position(place) - (eye + t * direction)), 2 * kAngle * t);
    }
}

}  // namespace
}  // namespace tedavis::raytrace::test_straight_pieces
