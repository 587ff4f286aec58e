#include "render_core/terrain/near_ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <random>

#include "render_core/base/units.hpp"
#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::terrain::test_near_ground {
namespace {

using base::radians;
using test_support::FlakyBytes;
using test_support::TdbSpec;
using test_support::WrittenTdb;

TdbSpec rough() {
    TdbSpec spec;
    spec.columns = spec.rows = 161;
    spec.height_m = [](std::uint32_t i, std::uint32_t j) {
        return 1500 + 300 * std::sin(i * 0.09) * std::cos(j * 0.07) + 60 * std::sin(i * 1.3 + j * 2.1);
    };
    return spec;
}

/// A database, a query over it, and its true surface by other means.
struct Ground {
    explicit Ground(const TdbSpec& spec) : tdb(spec), bytes(tdb.bytes), database(open()), post_class(spec.post_class) {
        base::Arena arena(memory.data(), memory.size());
        EXPECT_TRUE(query.start(database, arena));
    }
    TerrainDatabase open() {
        base::Arena arena(table.data(), table.size());
        return TerrainDatabase::open(bytes, arena).value();
    }
    [[nodiscard]] double surface_m(std::uint32_t i, std::uint32_t j) const {
        return tdb.height_m(i, j) + WrittenTdb::undulation_m(tdb.lattice().latitude_rad(j));
    }
    /// Between posts `step` apart; nothing where there are none or the cell has a void corner.
    [[nodiscard]] std::optional<earth::Geodetic> place(double i, double j, std::uint32_t step = 1) const {
        const Lattice& lattice = tdb.lattice();
        if (!(i >= 0 && j >= 0 && i < lattice.columns() - 1.0 && j < lattice.rows() - 1.0)) return std::nullopt;
        const std::uint32_t a = static_cast<std::uint32_t>(i) / step * step, b = static_cast<std::uint32_t>(j) / step * step;
        for (const auto& [p, q] : {std::pair{a, b}, {a + step, b}, {a, b + step}, {a + step, b + step}})
            if (post_class && post_class(p, q) == PostClass::void_) return std::nullopt;
        const double u = (i - a) / step, v = (j - b) / step;
        const double ne = surface_m(a + step, b), sw = surface_m(a, b + step), nw = surface_m(a, b),
                     se = surface_m(a + step, b + step);
        const double height = u + v <= 1 ? nw + u * (ne - nw) + v * (sw - nw) : se + (1 - u) * (sw - se) + (1 - v) * (ne - se);
        const FileHeader& h = tdb.database().header();
        return earth::Geodetic{
            radians(h.north_deg - j * h.step_lat_deg), earth::wrap_longitude(radians(h.west_deg + i * h.step_lon_deg)), {height}};
    }
    [[nodiscard]] View view(double i, double j, double above_m, double heading_deg, double pitch_deg, double roll_deg = 0,
                            double width_deg = 60) const {
        // Over a void and beside the lattice the eye stands over post heights all the same.
        const FileHeader& h = tdb.database().header();
        const double latitude = radians(h.north_deg - j * h.step_lat_deg), longitude = radians(h.west_deg + i * h.step_lon_deg);
        const std::optional<earth::Geodetic> below = place(i, j);
        const double ground_m =
            below ? below->height.m
                  : surface_m(static_cast<std::uint32_t>(std::fmax(i, 0)), static_cast<std::uint32_t>(std::fmax(j, 0)));
        const glm::dmat3 body =
            earth::body_axes(latitude, longitude, radians(heading_deg), radians(pitch_deg), radians(roll_deg));
        View view;
        view.eye = earth::to_ecef({latitude, earth::wrap_longitude(longitude), {ground_m + above_m}});
        view.forward = body[0];
        view.right = body[1];
        view.down = body[2];
        view.width = 1024;
        view.height = 768;
        view.focal_px = 512 / std::tan(radians(0.5 * width_deg));
        return view;
    }

    WrittenTdb tdb;
    FlakyBytes bytes;
    std::vector<std::uint8_t> table = std::vector<std::uint8_t>(1 << 17);
    TerrainDatabase database;
    std::function<PostClass(std::uint32_t, std::uint32_t)> post_class;
    std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(HeightQuery::bytes_needed());
    HeightQuery query;
};

/// Moved pixels of what is drawn `above_m` over a true place; nothing where it is not in the picture.
std::optional<double> moved_px(const View& view, const earth::Geodetic& truth, double above_m) {
    earth::Geodetic raised = truth;
    raised.height.m += above_m;
    const glm::dvec3 t = earth::to_ecef(truth) - view.eye, d = earth::to_ecef(raised) - view.eye;
    const double depth = glm::dot(d, view.forward), true_depth = glm::dot(t, view.forward);
    const double x = glm::dot(d, view.right) / depth, y = glm::dot(d, view.down) / depth;
    if (depth < view.near_m || true_depth < view.near_m || std::abs(x) > view.half_width_tangent() ||
        std::abs(y) > view.half_height_tangent())
        return std::nullopt;
    return view.focal_px * std::hypot(x - glm::dot(t, view.right) / true_depth, y - glm::dot(t, view.down) / true_depth);
}

struct Found {
    int poses = 0, known = 0, points = 0;
    double greatest[NearGround::kMaxSteps]{};  ///< found over stated, of each step
    double mean = 0;                           ///< of the poses' greatest, of the first step
    int over_half = 0;                         ///< points that half the bound would not hold

    [[nodiscard]] double greatest_of_all() const { return *std::max_element(std::begin(greatest), std::end(greatest)); }
};

struct Heights {
    double least_m = 1, most_m = 120;
};

/// Poses of every attitude over the places that `pick` gives, and true places round them, most of them near.
Found search(
    Ground& ground, int poses, const std::function<std::pair<double, double>(std::mt19937&)>& pick, const Heights& heights = {},
    const std::function<std::uint32_t(double, double)>& step = [](double, double) { return 1u; }) {
    std::mt19937 random(5);
    const auto uniform = [&random](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    const auto magnitude = [&uniform](double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); };
    const double posts_per_m = 1 / (6.37e6 * radians(ground.tdb.database().header().step_lat_deg));
    Found found;
    for (int n = 0; n < poses; ++n, ++found.poses) {
        const auto [i, j] = pick(random);
        const double above_m = magnitude(heights.least_m, heights.most_m);
        const View view = ground.view(i, j, above_m, uniform(0, 360), n % 3 == 0 ? uniform(-90, 90) : uniform(-35, 10),
                                      n % 4 == 0 ? uniform(-180, 180) : 0, uniform(20, 100));
        const NearGround near = near_ground(ground.query, view);
        if (near.count == 0) continue;
        ++found.known;
        double pose_greatest = 0;
        for (int k = 0; k < 3000; ++k) {
            const double away = magnitude(0.05, 5 * heights.most_m) * posts_per_m, turn = uniform(0, 2 * base::kPi);
            const double at_i = i + 1.4 * away * std::cos(turn), at_j = j + away * std::sin(turn);
            const std::optional<earth::Geodetic> truth = ground.place(at_i, at_j, step(at_i, at_j));
            if (!truth) continue;
            const int tried = k % 2 == 0 ? 0 : k / 2 % near.count;
            for (const double above : {-near.steps[tried].margin_m, near.steps[tried].margin_m})
                if (const std::optional<double> px = moved_px(view, *truth, above)) {
                    const double share = *px / near.px(std::abs(above));
                    ++found.points;
                    found.over_half += share > 0.5 ? 1 : 0;
                    found.greatest[tried] = std::max(found.greatest[tried], share);
                    if (tried == 0) pose_greatest = std::max(pose_greatest, share);
                }
        }
        found.mean += pose_greatest;
    }
    found.mean /= std::max(found.known, 1);
    return found;
}

std::pair<double, double> anywhere(std::mt19937& random) {
    std::uniform_real_distribution<double> post(0.1, 159.9);
    const double i = post(random);
    return {i, post(random)};
}

TEST(NearGround, NoPlaceMovesFurtherInThePicture) {
    Ground ground(rough());
    const Found found = search(ground, 250, anywhere);
    EXPECT_GT(found.points, 50'000);
    EXPECT_EQ(found.known, found.poses);
    EXPECT_LE(found.greatest_of_all(), 1);
    EXPECT_GT(found.greatest[0], 0.9) << "the bound is tight";
    EXPECT_GT(found.mean, 0.4) << "and not in one pose alone";
    EXPECT_GT(found.over_half, 1000) << "half of it would not hold";
}

TEST(NearGround, HighAboveItErrorsOfMetresAreBoundedToo) {
    Ground ground(rough());
    const Found found = search(ground, 200, anywhere, {100, 4000});
    EXPECT_GT(found.points, 25'000);
    EXPECT_LE(found.greatest_of_all(), 1);
    for (int step = 0; step < 5; ++step) EXPECT_GT(found.greatest[step], 0.5) << step;
    EXPECT_GT(found.mean, 0.2);
}

TEST(NearGround, CornersOfChunksAndTheLatticesEnds) {
    Ground ground(rough());
    const Found found = search(ground, 120, [](std::mt19937& random) {
        const auto near = [&random](double post) {
            return std::clamp(post + std::uniform_real_distribution<double>(-0.1, 0.1)(random), 0.0, 160.0);
        };
        const double i = near(32.0 * static_cast<double>(random() % 6));
        return std::pair{i, near(32.0 * static_cast<double>(random() % 6))};
    });
    EXPECT_EQ(found.known, found.poses);
    EXPECT_GT(found.points, 20'000);
    EXPECT_LE(found.greatest_of_all(), 1);
    EXPECT_GT(found.greatest[0], 0.85);
}

/// Cliffs of hundreds of metres beside the eye: no slope says how far the ground is.
TEST(NearGround, StepsBesideTheEye) {
    TdbSpec spec = rough();
    spec.height_m = [](std::uint32_t i, std::uint32_t j) { return 800.0 + 600 * ((i / 5 + j / 7) % 2) + (i * 7 + j * 3) % 4; };
    Ground ground(spec);
    const Found found = search(ground, 150, anywhere);
    EXPECT_GT(found.points, 30'000);
    EXPECT_LE(found.greatest_of_all(), 1);
    EXPECT_GT(found.greatest[0], 0.9);
}

TEST(NearGround, GroundBesideAVoidCountsAndTheVoidDoesNot) {
    TdbSpec spec = rough();
    spec.post_class = [](std::uint32_t i, std::uint32_t j) {
        return (i / 8 + j / 8) % 2 == 0 ? PostClass::void_ : i % 3 == 0 ? PostClass::sea : PostClass::land;
    };
    Ground ground(spec);
    const Found found = search(ground, 150, anywhere);
    EXPECT_GT(found.points, 10'000);
    EXPECT_LE(found.greatest_of_all(), 1);
    EXPECT_GT(found.greatest[0], 0.85);
    spec.post_class = [](std::uint32_t, std::uint32_t) { return PostClass::void_; };
    Ground nothing(spec);
    EXPECT_EQ(near_ground(nothing.query, nothing.view(50, 50, 3, 0, -20)).px(1), 0) << "no error where no surface is";
}

TEST(NearGround, FinerPostsBesideCoarserOnes) {
    TdbSpec spec = rough();
    spec.is_exact = [](const ChunkKey& key) { return key.level == 2 && key.i == 0; };
    Ground ground(spec);
    ASSERT_TRUE(ground.tdb.has({2, 0, 0}) && !ground.tdb.has({1, 0, 0}) && ground.tdb.has({0, 4, 0}));
    const auto step = [](double i, double) { return i < 128 ? 4u : 1u; };
    const Found found = search(
        ground, 150,
        [](std::mt19937& random) {
            const double i = std::uniform_real_distribution<double>(100, 140)(random);
            return std::pair{i, std::uniform_real_distribution<double>(1, 127)(random)};
        },
        {}, step);
    EXPECT_GT(found.points, 10'000);
    EXPECT_LE(found.greatest_of_all(), 1);
    EXPECT_GT(found.greatest[0], 0.8);
}

TEST(NearGround, AcrossTheAntimeridianAsAnywhere) {
    TdbSpec spec = rough();
    Ground here(spec);
    spec.west_deg = 180 - 80.2 * spec.step_lon_deg;
    Ground there(spec);
    int known = 0;
    for (double i = 70; i < 90; i += 0.7)
        for (const double above_m : {1.5, 12.0}) {
            const NearGround a = near_ground(here.query, here.view(i, 60.3, above_m, 20 * i, -12)),
                             b = near_ground(there.query, there.view(i, 60.3, above_m, 20 * i, -12));
            EXPECT_NEAR(b.px(0.01) / a.px(0.01), 1, 0.02) << "but for the rounding of posts";
            EXPECT_EQ(a.count, b.count);
            known += a.count > 0 ? 1 : 0;
        }
    EXPECT_GT(known, 40);
}

TEST(NearGround, RoundTheEarthTheSeamIsNoEnd) {
    TdbSpec spec;
    spec.columns = 2881;
    spec.rows = 33;
    spec.west_deg = -180;
    spec.north_deg = 2;
    spec.step_lon_deg = spec.step_lat_deg = 0.125;
    spec.lattice_flags = kLatticeClosed;
    spec.height_m = [](std::uint32_t i, std::uint32_t j) { return 300 + 200 * std::sin((i % 96) * base::kPi / 48 + j * 0.3); };
    spec.measured = false;
    Ground ground(spec);
    for (double i = 0; i < 4; i += 0.37)
        for (const double turn : {0.0, 2880.0}) {
            View seam = ground.view(turn + (turn > 0 ? -i : i) + 1e-9, 16.4, 400, 70, -8);
            const double base_i = turn > 0 ? 2880 - i : i;
            View away = ground.view(base_i < 1440 ? base_i + 1440 : base_i - 1440, 16.4, 400, 70, -8);
            seam.near_m = away.near_m = 8;
            const NearGround a = near_ground(ground.query, seam), b = near_ground(ground.query, away);
            EXPECT_GT(a.count, 0);
            EXPECT_NEAR(a.px(0.01) / b.px(0.01), 1, 0.05) << i << ": so far apart, posts are rounded to metres";
        }
}

/// Beyond what a look at the posts can say, boxes bound it; and what cannot be bounded is not said.
TEST(NearGround, WhatCannotBeReadIsBoundedByWhatIsLarger) {
    Ground ground(rough()), fresh(rough()), deaf(rough());
    const View close = ground.view(70, 70, 3, 40, -10);
    EXPECT_GT(near_ground(fresh.query, fresh.view(70, 70, 3000, 40, -10)).count, 0) << "from high above, entries are enough";
    fresh.bytes.fails = deaf.bytes.fails = true;
    const double by_near_plane =
        0.01 * close.focal_px / close.near_m * std::hypot(1, close.half_width_tangent(), close.half_height_tangent());
    EXPECT_GT(near_ground(fresh.query, close).px(0.01), near_ground(ground.query, close).px(0.01)) << "posts cannot be had";
    EXPECT_LE(near_ground(fresh.query, close).px(0.01), 1.1 * by_near_plane) << "nothing is drawn nearer than that";
    EXPECT_TRUE(std::isinf(near_ground(deaf.query, close).px(0.01))) << "nothing can be had";
    EXPECT_TRUE(std::isinf(near_ground(ground.query, close).px(1e4))) << "larger than any margin";
}

TEST(NearGround, NothingIsSaidOfViewsThatAreNone) {
    Ground ground(rough());
    const View close = ground.view(70, 70, 3, 40, -10);
    EXPECT_GT(near_ground(ground.query, close).count, 0);
    for (const double number : {std::nan(""), std::numeric_limits<double>::infinity()}) {
        View strange = close;
        strange.eye.x = number;
        EXPECT_EQ(near_ground(ground.query, strange).count, 0);
        strange = close;
        strange.forward = glm::dvec3(number);
        EXPECT_EQ(near_ground(ground.query, strange).count, 0);
        strange = close;
        strange.focal_px = number;
        EXPECT_EQ(near_ground(ground.query, strange).count, 0);
    }
}

TEST(NearGround, BesideThePoleAsAnywhere) {
    TdbSpec spec = test_support::whole_earth(145, 73);
    spec.height_m = [](std::uint32_t, std::uint32_t) { return 50.0; };
    spec.measured = false;
    Ground earth(spec);
    const View view = earth.view(20, 1.5, 2000, 0, -10);
    const NearGround near = near_ground(earth.query, view);
    ASSERT_GT(near.count, 0);
    EXPECT_LT(near.px(1), view.focal_px / 500);
}

TEST(NearGround, HigherIsLessWiderIsMoreAndLargerErrorsAreMore) {
    Ground ground(rough());
    double last = std::numeric_limits<double>::infinity();
    for (const double above_m : {2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 512.0, 2048.0}) {
        const NearGround near = near_ground(ground.query, ground.view(70.5, 64.2, above_m, 0, -90));
        EXPECT_LT(near.px(0.01), last);
        last = near.px(0.01);
        for (int n = 1; n < near.count; ++n) EXPECT_GE(near.steps[n].px_per_m, near.steps[n - 1].px_per_m);
    }
    for (int n = 0; n < 60; ++n) {
        View view = ground.view(40 + n, 80.3, 2 + n % 7, 37 * n, n - 50);
        const double narrow = near_ground(ground.query, view).px(0.01);
        view.width = 1400;
        view.height = 1000;
        EXPECT_GE(near_ground(ground.query, view).px(0.01), narrow);
    }
    const View up = ground.view(70.5, 64.2, 2, 0, 90);
    EXPECT_LT(near_ground(ground.query, up).px(0.01), 0.01 * up.focal_px / 50) << "the sky alone is in view";
}

TEST(NearGround, AsksForFewChunksAndKeepsThem) {
    Ground ground(rough());
    const View corner = ground.view(64.01, 64.01, 2, 0, -10);
    EXPECT_GT(near_ground(ground.query, corner).count, 0);
    const int reads = ground.bytes.reads;
    const NearGround again = near_ground(ground.query, corner);
    EXPECT_EQ(ground.bytes.reads, reads);
    EXPECT_EQ(again.px(0.01), near_ground(ground.query, corner).px(0.01));
}

}  // namespace
}  // namespace tedavis::terrain::test_near_ground
