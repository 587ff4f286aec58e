#include "render_core/terrain/height_ceiling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <random>

#include "render_core/base/hash.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/files/flaky_bytes.hpp"
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::terrain::test_height_ceiling {
namespace {

using base::degrees;
using base::radians;
using test_support::FlakyBytes;
using test_support::TdbSpec;
using test_support::WrittenTdb;

constexpr double kNoFloor_m = -std::numeric_limits<double>::infinity();

TdbSpec rough(std::uint32_t side = 161) {
    TdbSpec spec;
    spec.columns = spec.rows = side;
    spec.height_m = [](std::uint32_t i, std::uint32_t j) {
        return 1500 + 300 * std::sin(i * 0.09) * std::cos(j * 0.07) + 60 * std::sin(i * 1.3 + j * 2.1);
    };
    spec.measured = false;
    return spec;
}

/// The directory's ranges as the terrain builder states them: of all valid posts below a chunk.
void state_ranges(WrittenTdb& tdb) {
    std::vector<ChunkKey> keys = tdb.keys();
    for (auto key = keys.rbegin(); key != keys.rend(); ++key) {
        ChunkEntry& entry = tdb.entry_in_file(*key);
        constexpr auto kKinds = static_cast<std::uint8_t>(kChunkHasSea | kChunkHasLand | kChunkHasVoid);
        float low = 1e9f, high = -1e9f;
        const auto include = [&](float from, float to, unsigned flags) {
            entry.flags = static_cast<std::uint8_t>(entry.flags | (flags & kKinds));
            if ((flags & (kChunkHasSea | kChunkHasLand)) == 0) return;
            low = std::min(low, from);
            high = std::max(high, to);
        };
        entry.flags = static_cast<std::uint8_t>(entry.flags & ~kKinds);
        if (entry.children == 0)
            for (const ChunkVertex& v : tdb.vertices(*key))
                include(v.height_m, v.height_m,
                        v.post_class() == PostClass::void_ ? kChunkHasVoid
                        : v.post_class() == PostClass::sea ? kChunkHasSea
                                                           : kChunkHasLand);
        for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant)
            if ((entry.children >> quadrant & 1u) != 0) {
                const ChunkEntry& child = tdb.entry_in_file(key->child(quadrant));
                include(child.min_height_m, child.max_height_m, child.flags);
            }
        entry.min_height_m = low <= high ? low : 0;
        entry.max_height_m = low <= high ? high : 0;
        tdb.sign_page(*key);
    }
}

struct Place {
    double latitude_rad, longitude_rad;
};

double distance_m(const Place& a, const Place& b) {
    return earth::surface_distance_m({a.latitude_rad, a.longitude_rad, {}}, {b.latitude_rad, b.longitude_rad, {}});
}

/// A database, the ceiling over it, and the truth from all of its posts.
struct Ground {
    explicit Ground(TdbSpec of, std::uint32_t kept_chunks = HeightCeiling::kKeptChunks) : spec(std::move(of)), tdb(spec) {
        state_ranges(tdb);
        bytes.content = tdb.bytes;
        start(kept_chunks);
    }
    void start(std::uint32_t kept_chunks = HeightCeiling::kKeptChunks) {
        base::Arena tables(table.data(), table.size()), arena(memory.data(), memory.size());
        database = TerrainDatabase::open(bytes, tables).value();
        EXPECT_TRUE(query.start(database, arena));
        EXPECT_TRUE(ceiling.start(database, query, arena, kept_chunks));
    }
    CeilingAnswer over(const Place& place, double radius_m, double floor_m = kNoFloor_m) {
        return ceiling.over(place.latitude_rad, place.longitude_rad, radius_m, floor_m);
    }
    [[nodiscard]] bool has_north_pole() const { return (spec.lattice_flags & kLatticeNorthPole) != 0; }
    [[nodiscard]] bool has_south_pole() const { return (spec.lattice_flags & kLatticeSouthPole) != 0; }
    [[nodiscard]] double row_deg(double j) const {
        const double last = spec.rows - 1.0, first = has_north_pole() ? 1 : 0;
        if (has_north_pole() && j < 1) return 90 - j * (90 - spec.north_deg);
        if (has_south_pole() && j > last - 1) {
            const double last_deg = spec.north_deg - (last - 1 - first) * spec.step_lat_deg;
            return last_deg - (j - last + 1) * (last_deg + 90);
        }
        return spec.north_deg - (j - first) * spec.step_lat_deg;
    }
    [[nodiscard]] Place place(double i, double j) const {
        return {radians(row_deg(j)), radians(spec.west_deg + i * spec.step_lon_deg)};
    }
    [[nodiscard]] bool is_void(std::uint32_t i, std::uint32_t j) const {
        return spec.post_class && spec.post_class(i, j) == PostClass::void_;
    }
    /// Lattice posts along the side of a cell of the exact chunk there.
    [[nodiscard]] std::uint32_t spacing(std::uint32_t i, std::uint32_t j) const {
        for (std::uint32_t level = 0;; ++level)
            if (const ChunkKey key{level, i / (kChunkCells << level), j / (kChunkCells << level)}; tdb.has(key))
                return 1u << level;
    }

    TdbSpec spec;
    WrittenTdb tdb;
    FlakyBytes bytes{{}};
    std::vector<std::uint8_t> table = std::vector<std::uint8_t>(1 << 17);
    TerrainDatabase database;
    std::vector<std::uint8_t> memory = std::vector<std::uint8_t>(HeightQuery::bytes_needed() + HeightCeiling::bytes_needed());
    HeightQuery query;
    HeightCeiling ceiling;
};

/// What the ground in a disc truly is, by looking at every cell of the database.
class Truth {
public:
    Truth(const Ground& ground, const Place& centre, double radius_m)
        : ground_(ground), centre_(centre), radius_m_(radius_m), columns_(ground.spec.columns - 1), rows_(ground.spec.rows - 1) {
        const double reach_deg = degrees(1.02 * radius_m / 6.33e6) + 1e-6, latitude_deg = degrees(centre.latitude_rad);
        for (std::uint32_t j = 0; j < rows_; ++j) {
            if (ground.row_deg(j + 1) > latitude_deg + reach_deg || ground.row_deg(j) < latitude_deg - reach_deg) continue;
            for (std::uint32_t i = 0; i < columns_; ++i) look_at(i, j);
        }
        walk_rim();
    }
    double touched_msl_m = kNoFloor_m;  ///< highest known post of the cells that the disc certainly touches
    double widened_msl_m = kNoFloor_m;  ///< and of those at most 4 cells beside ones that it may touch
    double surface_m = kNoFloor_m;      ///< highest known surface above the ellipsoid that was found inside
    bool has_void = false, may_have_void = false;
    bool leaves = false, may_leave = false;  ///< the lattice

private:
    [[nodiscard]] double undulation_m(double latitude_rad) const { return WrittenTdb::undulation_m(latitude_rad); }

    void look_at(std::uint32_t i, std::uint32_t j) {
        const double nearest_m = distance_to_cell_m(i, j);
        if (nearest_m > 1.01 * radius_m_ + 0.05) return;
        const auto spacing = static_cast<std::int64_t>(ground_.spacing(i, j)), a = i / spacing * spacing,
                   b = j / spacing * spacing;
        if (nearest_m <= radius_m_) {
            for (const std::int64_t y : {b, b + spacing})
                for (const std::int64_t x : {a, a + spacing}) include_touched(x, y);
            for (std::uint32_t y = j; y <= j + 1; ++y)
                for (std::uint32_t x = i; x <= i + 1; ++x)
                    if (distance_m(centre_, ground_.place(x, y)) <= radius_m_) include_surface(x, y);
        }
        for (std::int64_t y = std::max<std::int64_t>(b - 4 * spacing, 0); y <= b + 5 * spacing && y <= rows_; ++y)
            for (std::int64_t x = a - 4 * spacing; x <= a + 5 * spacing; ++x) include_widened(x, y);
    }
    /// The least of distances to points of the cell, hence never too small.
    [[nodiscard]] double distance_to_cell_m(std::uint32_t i, std::uint32_t j) const {
        const Place north_west = ground_.place(i, j), south_east = ground_.place(i + 1, j + 1);
        const double middle = 0.5 * (north_west.longitude_rad + south_east.longitude_rad);
        const double half_width = 0.5 * (south_east.longitude_rad - north_west.longitude_rad);
        const double east = std::remainder(centre_.longitude_rad - middle, 2 * base::kPi);
        const double longitude = middle + std::clamp(east, -half_width, half_width);
        const auto to = [&](double latitude) { return distance_m(centre_, {latitude, longitude}); };
        double least_m = to(std::clamp(centre_.latitude_rad, south_east.latitude_rad, north_west.latitude_rad));
        for (int n = 0; n <= 4; ++n)
            least_m =
                std::min(least_m, to(north_west.latitude_rad + 0.25 * n * (south_east.latitude_rad - north_west.latitude_rad)));
        return least_m;
    }
    void include_touched(std::int64_t x, std::int64_t y) {
        const auto i = static_cast<std::uint32_t>(std::min<std::int64_t>(x, columns_)),
                   j = static_cast<std::uint32_t>(std::min<std::int64_t>(y, rows_));
        if (ground_.is_void(i, j))
            has_void = true;
        else
            touched_msl_m = std::max(touched_msl_m, ground_.tdb.height_m(i, j));
    }
    void include_widened(std::int64_t x, std::int64_t y) {
        const bool round = (ground_.spec.lattice_flags & kLatticeClosed) != 0;
        if (!round && (x < 0 || x > columns_)) return;
        const auto i = static_cast<std::uint32_t>((x + columns_) % columns_), j = static_cast<std::uint32_t>(y);
        for (const std::uint32_t column : {x == columns_ ? static_cast<std::uint32_t>(columns_) : i, i}) {
            if (!round && column != x) continue;
            if (ground_.is_void(column, j))
                may_have_void = true;
            else
                widened_msl_m = std::max(widened_msl_m, ground_.tdb.height_m(column, j));
        }
    }
    void include_surface(std::uint32_t i, std::uint32_t j) {
        if (!ground_.is_void(i, j))
            surface_m = std::max(surface_m, ground_.tdb.height_m(i, j) + undulation_m(ground_.place(i, j).latitude_rad));
    }
    /// Triangles reach their greatest height in the disc at a corner inside it, or on its rim.
    void walk_rim() {
        for (int n = 0; n < 360; ++n)
            for (const double share : {0.0, 0.5, 0.97, 0.999, 1.02}) {
                const Place p = from_centre(radians(n), share * radius_m_);
                const std::optional<double> msl_m = surface_msl_m(p);
                const bool is_outside = !is_inside(p), is_in_disc = distance_m(centre_, p) <= radius_m_;
                may_leave = may_leave || is_outside;
                leaves = leaves || (is_outside && is_in_disc);
                if (msl_m && is_in_disc) surface_m = std::max(surface_m, *msl_m + undulation_m(p.latitude_rad));
            }
    }
    [[nodiscard]] Place from_centre(double azimuth, double away_m) const {
        const double angle = away_m / earth::kMeanRadius_m, s = std::sin(centre_.latitude_rad),
                     c = std::cos(centre_.latitude_rad);
        const double latitude = std::asin(std::clamp(s * std::cos(angle) + c * std::sin(angle) * std::cos(azimuth), -1.0, 1.0));
        return {latitude, centre_.longitude_rad +
                              std::atan2(std::sin(azimuth) * std::sin(angle) * c, std::cos(angle) - s * std::sin(latitude))};
    }
    struct Post {
        double i, j;
    };
    [[nodiscard]] Post post_of(const Place& p) const {
        const TdbSpec& spec = ground_.spec;
        const double width_deg = columns_ * spec.step_lon_deg, latitude_deg = degrees(p.latitude_rad);
        const double i = (std::remainder(degrees(p.longitude_rad) - spec.west_deg - 0.5 * width_deg, 360) + 0.5 * width_deg) /
                         spec.step_lon_deg;
        const double first = ground_.has_north_pole() ? 1 : 0;
        double j = (spec.north_deg - latitude_deg) / spec.step_lat_deg + first;
        if (ground_.has_north_pole() && j < 1) j = (90 - latitude_deg) / (90 - spec.north_deg);
        if (const double last_deg = ground_.row_deg(rows_ - 1.0); ground_.has_south_pole() && latitude_deg < last_deg)
            j = rows_ - 1 + (last_deg - latitude_deg) / (last_deg + 90);
        return {i, j};
    }
    [[nodiscard]] bool is_inside(const Place& p) const {
        const Post post = post_of(p);
        return post.i >= -1e-6 && post.i <= static_cast<double>(columns_) + 1e-6 && post.j >= -1e-6 &&
               post.j <= static_cast<double>(rows_) + 1e-6;
    }
    /// Nothing in a cell with a void corner, and in the row at a pole, whose triangles are narrow.
    [[nodiscard]] std::optional<double> surface_msl_m(const Place& p) const {
        if (!is_inside(p)) return std::nullopt;
        const Post post = post_of(p);
        const auto a = static_cast<std::uint32_t>(std::clamp(post.i, 0.0, columns_ - 1.0)),
                   b = static_cast<std::uint32_t>(std::clamp(post.j, 0.0, rows_ - 1.0));
        if ((ground_.has_north_pole() && b == 0) || (ground_.has_south_pole() && b == rows_ - 1)) return std::nullopt;
        for (const auto& [i, j] : {std::pair{a, b}, {a + 1, b}, {a, b + 1}, {a + 1, b + 1}})
            if (ground_.is_void(i, j)) return std::nullopt;
        const double u = post.i - a, v = post.j - b;
        const auto at = [&](std::uint32_t i, std::uint32_t j) { return ground_.tdb.height_m(a + i, b + j); };
        if (u + v <= 1) return at(0, 0) + u * (at(1, 0) - at(0, 0)) + v * (at(0, 1) - at(0, 0));
        return at(1, 1) + (1 - u) * (at(0, 1) - at(1, 1)) + (1 - v) * (at(1, 0) - at(1, 1));
    }

    const Ground& ground_;
    const Place centre_;
    const double radius_m_;
    const std::int64_t columns_, rows_;
};

struct Tally {
    int discs = 0, whole = 0, partial = 0;
    int missed_by_centre = 0;       ///< a sample at the centre is lower than the ground in the disc, by a metre or more
    int missed_by_half_radius = 0;  ///< a bound over half the radius is no bound
};

/// Asks for a disc and holds the answer against the truth.
void check_disc(Ground& ground, Ground& forgetful, const Place& place, double radius_m, Tally& tally) {
    const Truth truth(ground, place, radius_m);
    const CeilingAnswer answer = ground.over(place, radius_m), again = forgetful.over(place, radius_m);
    SCOPED_TRACE(::testing::Message() << degrees(place.latitude_rad) << ", " << degrees(place.longitude_rad) << ", " << radius_m);
    EXPECT_EQ(answer.height_m, again.height_m) << "the cache does not matter";
    EXPECT_EQ(answer.is_whole, again.is_whole);
    const double reach_rad = 1.01 * radius_m / 6.335e6 + 1e-9;
    EXPECT_GE(answer.height_m, truth.surface_m);
    EXPECT_GE(answer.height_m, truth.touched_msl_m + WrittenTdb::undulation_m(place.latitude_rad - reach_rad));
    EXPECT_LE(answer.height_m, truth.widened_msl_m + 0.01 + WrittenTdb::undulation_m(place.latitude_rad + reach_rad));
    EXPECT_FALSE(answer.is_whole && (truth.has_void || truth.leaves));
    EXPECT_TRUE(answer.is_whole || truth.may_have_void || truth.may_leave);
    ++tally.discs;
    (answer.is_whole ? tally.whole : tally.partial) += 1;
    const HeightAnswer centre = ground.query.at(place.latitude_rad, place.longitude_rad);
    const double centre_m = centre.height.m + centre.undulation.m;
    if (centre.status == HeightStatus::land && centre_m + 1 < truth.surface_m) ++tally.missed_by_centre;
    if (ground.over(place, 0.5 * radius_m).height_m < truth.surface_m) ++tally.missed_by_half_radius;
}

template <class Choose>
Tally check_discs(const TdbSpec& spec, int discs, double max_radius_m, const Choose& choose) {
    Ground ground(spec), forgetful(spec, 1);
    std::mt19937 random(5);
    Tally tally;
    for (int n = 0; n < discs && !::testing::Test::HasFailure(); ++n) {
        const auto [i, j] = choose(random);
        const double radius_m = max_radius_m * std::pow(std::uniform_real_distribution<double>(0, 1)(random), 2);
        check_disc(ground, forgetful, ground.place(i, j), n % 20 == 0 ? 0 : radius_m, tally);
    }
    return tally;
}

auto posts_between(double i0, double i1, double j0, double j1) {
    return [=](std::mt19937& random) {
        const double i = std::uniform_real_distribution<double>(i0, i1)(random);
        return std::pair{i, std::uniform_real_distribution<double>(j0, j1)(random)};
    };
}

TEST(HeightCeiling, BoundsHillsAndNotMuchMore) {
    const Tally tally = check_discs(rough(), 300, 1500, posts_between(0, 160, 0, 160));
    EXPECT_EQ(tally.discs, 300);
    EXPECT_GT(tally.missed_by_centre, 200) << "a sample of the centre misses what is beside it";
    EXPECT_GT(tally.missed_by_half_radius, 50) << "the truth would tell a bound that is too low";
    EXPECT_GT(tally.whole, 200);
    EXPECT_GT(tally.partial, 20) << "beside the lattice's ends";
}

TEST(HeightCeiling, BoundsStepsAndLonelySummits) {
    TdbSpec spec = rough();
    spec.height_m = [](std::uint32_t i, std::uint32_t j) {
        return i % 13 == 5 && j % 11 == 7 ? 3000.0 + i + j : 800.0 + 600 * ((i / 5 + j / 7) % 2) + (i * 7 + j * 3) % 4;
    };
    const Tally tally = check_discs(spec, 300, 700, posts_between(0, 160, 0, 160));
    EXPECT_EQ(tally.discs, 300);
    EXPECT_GT(tally.missed_by_centre, 150);
    EXPECT_GT(tally.missed_by_half_radius, 10);
}

TEST(HeightCeiling, CornersOfChunksAndBlocksAndTheLatticesEnds) {
    const Tally tally = check_discs(rough(), 300, 150, [](std::mt19937& random) {
        const auto near = [&random] {
            return 4.0 * static_cast<double>(random() % 41) + std::uniform_real_distribution<double>(-0.1, 0.1)(random);
        };
        const double i = near();
        return std::pair{i, near()};
    });
    EXPECT_EQ(tally.discs, 300);
}

TEST(HeightCeiling, VoidsAreUnknownAndTheirNeighboursCount) {
    TdbSpec spec = rough();
    spec.post_class = [](std::uint32_t i, std::uint32_t j) {
        return (i / 20 + j / 20) % 3 == 0 ? PostClass::void_ : i % 3 == 0 ? PostClass::sea : PostClass::land;
    };
    const Tally tally = check_discs(spec, 300, 900, posts_between(0, 160, 0, 160));
    EXPECT_EQ(tally.discs, 300);
    EXPECT_GT(tally.whole, 30);
    EXPECT_GT(tally.partial, 30);
    spec.post_class = [](std::uint32_t, std::uint32_t) { return PostClass::void_; };
    Ground nothing(spec);
    const CeilingAnswer answer = nothing.over(nothing.place(50, 50), 500);
    EXPECT_EQ(answer.height_m, kNoFloor_m);
    EXPECT_FALSE(answer.is_whole);
}

TEST(HeightCeiling, CoarserExactChunksBesideFinerOnes) {
    TdbSpec spec = rough();
    spec.is_exact = [](const ChunkKey& key) { return key.level == 2 && key.i == 0; };
    // The coarse chunk ends at post 128.
    const Tally tally = check_discs(spec, 300, 1500, posts_between(90, 150, 0, 128));
    EXPECT_EQ(tally.discs, 300);
    EXPECT_GT(tally.missed_by_half_radius, 20);
}

TEST(HeightCeiling, AcrossTheAntimeridian) {
    TdbSpec spec = rough();
    spec.west_deg = 180 - 80.2 * spec.step_lon_deg;
    const Tally tally = check_discs(spec, 250, 1500, posts_between(70, 90, 0, 160));
    EXPECT_EQ(tally.discs, 250);
    EXPECT_GT(tally.missed_by_half_radius, 40);
    Ground east(spec), west(spec);
    const Place place = east.place(85, 60.3);
    EXPECT_NEAR(east.over(place, 900).height_m,
                west.over({place.latitude_rad, place.longitude_rad - 2 * base::kPi}, 900).height_m, 1e-6);
}

TEST(HeightCeiling, RoundTheEarthAndAtThePoles) {
    TdbSpec spec = test_support::whole_earth(145, 73);
    spec.height_m = [](std::uint32_t i, std::uint32_t j) {
        return j == 0 ? 2835.0 : j == 72 ? 2600.0 : 1500 + 900 * std::sin(i * 2.1 + j * 1.7) + 10.0 * (i % 7);
    };
    spec.measured = false;
    for (const double j : {0.0, 70.0}) {
        const Tally tally = check_discs(spec, 200, 390e3, posts_between(0, 144, j, j + 2));
        EXPECT_EQ(tally.discs, 200);
        EXPECT_EQ(tally.partial, 0) << "nothing is outside";
    }
    // Rising to the east, where a disc beside the pole reaches farthest north of its centre.
    TdbSpec slope = test_support::whole_earth(577, 289);
    slope.height_m = [](std::uint32_t i, std::uint32_t j) { return 5.0 * i + std::sin(2.0 * j); };
    slope.measured = false;
    EXPECT_EQ(check_discs(slope, 120, 390e3, posts_between(100, 400, 10, 24)).discs, 120);
    for (const double i : {-1.0, 143.0}) {
        const Tally tally = check_discs(spec, 200, 390e3, posts_between(i, i + 2, 1, 71));
        EXPECT_EQ(tally.discs, 200);
        EXPECT_EQ(tally.partial, 0) << "nothing is outside";
    }
}

TEST(HeightCeiling, BeyondThePoleTheShortestWayLeadsPastIt) {
    TdbSpec spec = test_support::whole_earth(145, 73);
    spec.height_m = [](std::uint32_t i, std::uint32_t j) { return j == 0 || j == 72 || i % 36 != 0 ? 100.0 : 1000.0 + i; };
    spec.measured = false;
    // The highest meridian lies more than a quarter of the Earth in the east or west.
    for (const double j : {0.0, 70.9}) {
        const Tally tally = check_discs(spec, 60, 390e3, posts_between(20, 52, j, j + 1.1));
        EXPECT_EQ(tally.discs, 60);
        EXPECT_GT(tally.missed_by_half_radius + tally.missed_by_centre, 10);
    }
}

TEST(HeightCeiling, ALargerDiscIsNeverLower) {
    Ground ground(rough(321));
    std::mt19937 random(3);
    for (int n = 0; n < 60; ++n) {
        const auto [i, j] = posts_between(0, 320, 0, 320)(random);
        double last_m = kNoFloor_m;
        for (double radius_m = 0; radius_m < 60e3; radius_m = 1.3 * radius_m + 20) {
            const double height_m = ground.over(ground.place(i, j), radius_m).height_m;
            EXPECT_GE(height_m, last_m) << i << ", " << j << ", " << radius_m;
            last_m = height_m;
        }
    }
}

TEST(HeightCeiling, AFloorOnlyDecidesWhatIsBelowIt) {
    Ground ground(rough());
    std::mt19937 random(8);
    int below = 0;
    for (int n = 0; n < 300; ++n) {
        const auto [i, j] = posts_between(10, 150, 10, 150)(random);
        const double radius_m = std::uniform_real_distribution<double>(0, 800)(random);
        const double highest_m = ground.over(ground.place(i, j), radius_m).height_m;
        for (const double above_m : {-300.0, -1.0, 0.0, 1e-6, 1.0, 300.0}) {
            const CeilingAnswer answer = ground.over(ground.place(i, j), radius_m, highest_m + above_m);
            EXPECT_EQ(answer.height_m<highest_m + above_m, above_m> 0) << above_m;
            EXPECT_GE(answer.height_m, highest_m) << "a bound all the same";
            below += above_m > 0 ? 1 : 0;
        }
    }
    EXPECT_EQ(below, 900);
}

TEST(HeightCeiling, GroundFarBelowIsNeverRead) {
    Ground ground(rough(321));
    const Place place = ground.place(160.2, 150.7);
    EXPECT_LT(ground.over(place, 700, 4000).height_m, 4000);
    const int reads = ground.bytes.reads;
    EXPECT_EQ(reads, 3 + 1) << "the file is opened, and the top level's page read";
    EXPECT_GT(ground.over(place, 700, 1000).height_m, 1000);
    EXPECT_GT(ground.bytes.reads, reads + 1);
    const int all = ground.bytes.reads;
    EXPECT_GT(ground.over(place, 700, 1000).height_m, 1000);
    EXPECT_EQ(ground.bytes.reads, all) << "what is kept is not read again";
}

TEST(HeightCeiling, WideDiscsAreBoundedByCoarserEntriesWithFewReads) {
    Ground ground(rough(641));
    for (const double radius_m : {3e3, 6e3, 9e3, 15e3, 40e3}) {
        const Place place = ground.place(320.4, 310.8);
        const int reads = ground.bytes.reads;
        const CeilingAnswer answer = ground.over(place, radius_m);
        const Truth truth(ground, place, radius_m);
        EXPECT_GE(answer.height_m, truth.surface_m) << radius_m;
        EXPECT_TRUE(std::isfinite(answer.height_m));
        EXPECT_EQ(answer.is_whole, radius_m < 20e3);
        EXPECT_LE(ground.bytes.reads - reads, static_cast<int>(HeightCeiling::kMaxChunks + 16)) << "chunks, and pages";
    }
}

TEST(HeightCeiling, WhatIsDamagedIsBoundedByTheDirectoryAndNotWhole) {
    Ground ground(rough());
    const ChunkKey key{0, 2, 2};
    const ChunkEntry entry = ground.tdb.entry_in_file(key);
    const Place place = ground.place(80, 80);
    const CeilingAnswer sound = ground.over(place, 200);
    EXPECT_TRUE(sound.is_whole);
    ground.start();
    ground.bytes.content[entry.payload.offset + 10] ^= 1;
    const CeilingAnswer damaged = ground.over(place, 200);
    EXPECT_FALSE(damaged.is_whole);
    EXPECT_GE(damaged.height_m, sound.height_m);
    EXPECT_NEAR(damaged.height_m, double{entry.max_height_m} + WrittenTdb::undulation_m(place.latitude_rad), 0.02);
    EXPECT_TRUE(ground.over(ground.place(10, 10), 200).is_whole);
    ground.bytes.content[entry.payload.offset + 10] ^= 1;
    EXPECT_EQ(ground.over(place, 200).height_m, sound.height_m) << "and read again";
}

TEST(HeightCeiling, ADamagedDirectoryIsBoundedByWhatIsCoarser) {
    for (const std::uint32_t level : {0u, 1u, 4u}) {
        Ground ground(rough(321));
        const Place place = ground.place(80, 80);
        const CeilingAnswer sound = ground.over(place, 300);
        ground.start();
        const std::uint64_t offset = ground.database.page_offset(
            ground.database.lattice().page_index({level, 80 / (kChunkCells << level), 80 / (kChunkCells << level)}));
        ground.bytes.content[offset + 100] ^= 1;
        const CeilingAnswer damaged = ground.over(place, 300);
        EXPECT_TRUE(sound.is_whole);
        EXPECT_FALSE(damaged.is_whole);
        EXPECT_GT(damaged.height_m, sound.height_m);
        EXPECT_LE(damaged.height_m, double{ground.database.header().max_height_m} + 30) << "finite";
    }
}

struct UndulationGrid {
    double west_deg, north_deg, step_deg;
    std::uint32_t columns, rows;
};

/// Level ground over an undulation that is rougher than any, and jumps at the meridian opposite to the grid's middle.
struct Undulated {
    Undulated(TdbSpec spec, const UndulationGrid& of) : ground(level(std::move(spec))) {
        FileHeader& h = ground.tdb.header();
        EXPECT_LE(of.columns * of.rows, h.undulation_columns * h.undulation_rows) << "as much room as the file has";
        h.undulation_west_deg = of.west_deg;
        h.undulation_north_deg = of.north_deg;
        h.undulation_step_deg = of.step_deg;
        h.undulation_columns = of.columns;
        h.undulation_rows = of.rows;
        std::mt19937 random(12);
        std::vector<float> grid(std::size_t{of.columns} * of.rows);
        for (float& undulation : grid) undulation = std::uniform_real_distribution<float>(-50, 50)(random);
        std::memcpy(ground.tdb.bytes.data() + h.undulation_offset, grid.data(), grid.size() * sizeof(float));
        h.undulation_crc = base::crc32(grid.data(), grid.size() * sizeof(float));
        ground.tdb.sign_header();
        ground.bytes.content = ground.tdb.bytes;
        ground.start();
    }
    static TdbSpec level(TdbSpec spec) {
        spec.height_m = [](std::uint32_t, std::uint32_t) { return 100.0; };
        return spec;
    }
    /// Whether the corners of the area alone would not bound the undulation in the disc.
    bool check(const Place& place, double radius_m) {
        const double angle = radius_m / 6.335e6, cos_latitude = std::cos(place.latitude_rad);
        const bool has_pole = std::abs(place.latitude_rad) + angle > 0.5 * base::kPi;
        const double half_width = has_pole ? base::kPi : std::asin(std::sin(angle) / cos_latitude);
        double highest_m = kNoFloor_m, at_corners_m = kNoFloor_m, wider_m = kNoFloor_m;
        constexpr int kRows = 40, kColumns = 200;
        for (int y = -kRows; y <= kRows; ++y)
            for (int x = -kColumns; x <= kColumns; ++x) {
                const auto at = [&](double factor) {
                    return Place{std::clamp(place.latitude_rad + factor * y / kRows * angle, -0.5 * base::kPi, 0.5 * base::kPi),
                                 place.longitude_rad + factor * x / kColumns * half_width};
                };
                const double undulation = undulation_m(at(1));
                wider_m = std::max({wider_m, undulation, undulation_m(at(1.02))});
                if (distance_m(place, at(1)) <= radius_m) highest_m = std::max(highest_m, undulation);
                if (std::abs(x * y) == kRows * kColumns) at_corners_m = std::max(at_corners_m, undulation);
            }
        const double bound_m = ground.over(place, radius_m).height_m - 100;
        EXPECT_GE(bound_m, highest_m) << radius_m;
        EXPECT_LE(bound_m, wider_m + 8) << "between the samples it changes by a few metres; " << radius_m;
        return highest_m > at_corners_m + 1;
    }
    [[nodiscard]] double undulation_m(const Place& p) const {
        return ground.database.undulation(p.latitude_rad, p.longitude_rad).m;
    }
    Ground ground;
};

TEST(HeightCeiling, TheUndulationIsHighestBetweenItsPostsOrAtThem) {
    // Grids over the ground; with their east end in it; opposite to it; and one round the Earth that closes there.
    for (const UndulationGrid& grid : {UndulationGrid{8.95, 47.05, 0.01, 37, 19},
                                       {8.70, 47.05, 0.01, 37, 19},
                                       {9.06 + 180 - 0.18, 47.05, 0.01, 37, 19},
                                       {9.06, 47.5, 1.2, 301, 2}}) {
        Undulated undulated(rough(), grid);
        std::mt19937 random(4);
        int by_posts = 0;
        for (int n = 0; n < 40; ++n) {
            const auto [i, j] = posts_between(30, 130, 30, 130)(random);
            const double radius_m = 180e3 * grid.step_deg * std::uniform_real_distribution<double>(0, 1)(random);
            by_posts += undulated.check(undulated.ground.place(i, j), radius_m) ? 1 : 0;
        }
        EXPECT_GT(by_posts, 5) << "corners alone would miss it";
    }
}

TEST(HeightCeiling, TheUndulationRoundAPoleIsThatOfAllMeridians) {
    Undulated undulated(test_support::whole_earth(145, 73), {-180, 90, 3, 121, 5});
    int by_posts = 0;
    for (double longitude_deg = -180; longitude_deg < 180; longitude_deg += 17)
        by_posts += undulated.check({radians(89.6), radians(longitude_deg)}, 60e3) ? 1 : 0;
    EXPECT_GT(by_posts, 5);
}

TEST(HeightCeiling, RefusesASmallArenaAndStrangeNumbers) {
    Ground ground(rough());
    base::Arena arena(ground.memory.data(), HeightCeiling::bytes_needed() / 2);
    EXPECT_FALSE(HeightCeiling().start(ground.database, ground.query, arena));
    EXPECT_LE(HeightCeiling::bytes_needed(), 24u * 1024);
    const Place place = ground.place(80, 80);
    for (const double number : {std::nan(""), std::numeric_limits<double>::infinity()})
        for (const CeilingAnswer& answer :
             {ground.over({number, place.longitude_rad}, 100), ground.over({place.latitude_rad, number}, 100),
              ground.over(place, number), ground.over({2, place.longitude_rad}, 100), ground.over(place, -1)}) {
            EXPECT_EQ(answer.height_m, std::numeric_limits<double>::infinity());
            EXPECT_FALSE(answer.is_whole);
        }
    const CeilingAnswer elsewhere = ground.over({-0.5, 2}, 500);
    EXPECT_EQ(elsewhere.height_m, kNoFloor_m);
    EXPECT_FALSE(elsewhere.is_whole);
}

}  // namespace
}  // namespace tedavis::terrain::test_height_ceiling
