#include "host_sim/terrain_builder/inset_stages.hpp"

#include <gtest/gtest.h>

#include <GeographicLib/Geocentric.hpp>
#include <map>
#include <memory>
#include <stdexcept>
#include <unordered_map>

#include "host_sim/terrain_builder/terrain_build.hpp"
#include "host_sim/terrain_builder/terrain_check.hpp"
#include "render_core/terrain/chunk_payload.hpp"
#include "tests/host_sim/terrain_builder/chunk_side.hpp"
#include "tests/support/terrain/built_database.hpp"

namespace tedavis::host_sim::test_inset_stages {
namespace {

using namespace terrain;
using test_support::BuiltDatabase;
using test_support::BuiltMesh;
using test_support::part_of_side;
using test_support::side_of;

/// Coarse hills, and an inset in them that has its own idea of them: 40 m higher, with detail, and a hole.
struct TwoRasters {
    static constexpr double kCoarse_deg = 1.0 / 400;
    std::uint32_t density;                                                      // fine posts to a coarse one
    std::uint32_t width = density > 8 ? 7 : 20, height = density > 8 ? 6 : 16;  // of the inset, in coarse posts
    Raster coarse = test_support::make_raster(
        density > 8 ? 84 : 150, density > 8 ? 70 : 110,
        [](auto i, auto j) { return static_cast<float>(800 + 300 * std::sin(i * 0.2) * std::cos(j * 0.15)); }, 9.6, 47.1,
        kCoarse_deg);
    Raster fine = test_support::make_raster(
        width * density + 1, height* density + 1,
        [this](auto i, auto j) {
            const double x = i / double(density) + 60, y = j / double(density) + 50;
            const bool hole = x > 65 && x < 65.5 && y > 54 && y < 54.5;
            const double detail = 5 * static_cast<double>((i * 7 + j * 13) % 5);
            return hole ? std::nanf("") : static_cast<float>(840 + 300 * std::sin(x * 0.2) * std::cos(y * 0.15) + detail);
        },
        9.6 + 60 * kCoarse_deg, 47.1 - 50 * kCoarse_deg, kCoarse_deg / density);

    explicit TwoRasters(std::uint32_t fine_to_coarse) : density(fine_to_coarse) {}
    [[nodiscard]] TerrainSources sources() const {
        return TerrainSources(test_support::posts_of(coarse), {test_support::posts_of(fine)});
    }
    [[nodiscard]] std::vector<std::uint8_t> image(const BuildOptions& options = {}) const {
        const test_support::TemporaryFolder folder;
        build_terrain(sources(), folder.file("t.tdb"), options);
        const std::string bytes = folder.read("t.tdb");
        return {bytes.begin(), bytes.end()};
    }
};

std::vector<ChunkKey> existing_chunks(const BuiltDatabase& built) {
    std::vector<ChunkKey> keys;
    for (const ChunkKey& key : built.chunks())
        if (built.database.has_page(built.lattice().page_index(key)) && built.entry(key).vertex_count != 0) keys.push_back(key);
    return keys;
}

/// The true surface as the exact chunks of the file have it.
class ExactSurface {
public:
    explicit ExactSurface(const BuiltDatabase& built) : lattice_(built.lattice()) {
        for (const ChunkKey& key : existing_chunks(built)) {
            const ChunkEntry entry = built.entry(key);
            if (entry.children != 0) continue;
            const PostRange posts = lattice_.posts_of(key);
            Exact exact{1u << key.level, posts, {}};
            exact.surface_m.resize(std::size_t{exact.columns()} * ((posts.j1 - posts.j0) / exact.step + 1), std::nan(""));
            for (const ChunkVertex& v : built.vertices(entry)) {
                const double undulation =
                    geoid_.undulation(lattice_.latitude_rad(posts.j0 + v.j), lattice_.longitude_rad(posts.i0 + v.i)).m;
                exact.surface_m[exact.at(posts.i0 + v.i, posts.j0 + v.j)] =
                    v.post_class() == PostClass::void_ ? std::nan("") : v.height_m + undulation;
            }
            exact_[key.packed()] = std::move(exact);
        }
    }
    [[nodiscard]] std::optional<double> at(double latitude_deg, double longitude_deg) const {
        const LatticePoint p = lattice_.point(base::radians(latitude_deg), base::radians(longitude_deg));
        if (!p.inside) return std::nullopt;
        for (std::uint32_t level = 0; level < lattice_.levels(); ++level) {
            const std::uint32_t cells = kChunkCells << level;
            const auto inside = [&](double x, std::uint32_t posts) {
                return static_cast<std::uint32_t>(std::min(std::floor(x), posts - 2.0));
            };
            const auto found = exact_.find(
                ChunkKey{level, inside(p.i, lattice_.columns()) / cells, inside(p.j, lattice_.rows()) / cells}.packed());
            if (found != exact_.end()) return in_chunk(found->second, p);
        }
        return std::nullopt;
    }

private:
    struct Exact {
        std::uint32_t step;
        PostRange posts;
        std::vector<double> surface_m;  ///< of every step-th post, row by row

        [[nodiscard]] std::uint32_t columns() const { return (posts.i1 - posts.i0) / step + 1; }
        [[nodiscard]] std::size_t at(std::uint32_t i, std::uint32_t j) const {
            return std::size_t{(j - posts.j0) / step} * columns() + (i - posts.i0) / step;
        }
    };
    [[nodiscard]] std::optional<double> in_chunk(const Exact& exact, const LatticePoint& p) const {
        const auto first = [&](double x, std::uint32_t posts) {
            return static_cast<std::uint32_t>(std::min(std::floor(x), posts - 2.0)) / exact.step * exact.step;
        };
        const std::uint32_t i = first(p.i, lattice_.columns()), j = first(p.j, lattice_.rows());
        const double u = (p.i - i) / exact.step, v = (p.j - j) / exact.step;
        const auto post = [&](std::uint32_t a, std::uint32_t b) {
            return exact.surface_m.at(exact.at(i + a * exact.step, j + b * exact.step));
        };
        const double nw = post(0, 0), ne = post(1, 0), sw = post(0, 1), se = post(1, 1);
        if (std::isnan(nw + ne + sw + se)) return std::nullopt;
        return u + v <= 1 ? nw + u * (ne - nw) + v * (sw - nw) : se + (1 - u) * (sw - se) + (1 - v) * (ne - se);
    }

    const Lattice& lattice_;
    GeoidEgm96 geoid_ = GeoidEgm96::installed();
    std::unordered_map<std::uint64_t, Exact> exact_;
};

void expect_stated_error_holds(const BuiltDatabase& built, const ExactSurface& truth, const ChunkKey& key, std::uint8_t mask) {
    const BuiltMesh mesh(built, key, mask);
    const double above_m = mask == 0 ? mesh.entry.above_m : std::max(mesh.entry.above_m, mesh.entry.strip_above_m),
                 below_m = mask == 0 ? mesh.entry.below_m : std::max(mesh.entry.below_m, mesh.entry.strip_below_m);
    constexpr int kSteps = 4;
    for (std::size_t n = 0; n < mesh.indices.size(); n += 3)
        for (int a = 0; a <= kSteps; ++a)
            for (int b = 0; a + b <= kSteps; ++b) {
                const double w[3] = {a / double(kSteps), b / double(kSteps), (kSteps - a - b) / double(kSteps)};
                double p[3] = {mesh.entry.centre_m[0], mesh.entry.centre_m[1], mesh.entry.centre_m[2]}, lat = 0, lon = 0,
                       height = 0;
                for (std::size_t k = 0; k < 3; ++k) {
                    const ChunkVertex& v = mesh.vertices[mesh.indices[n + k]];
                    p[0] += w[k] * v.x;
                    p[1] += w[k] * v.y;
                    p[2] += w[k] * v.z;
                }
                GeographicLib::Geocentric::WGS84().Reverse(p[0], p[1], p[2], lat, lon, height);
                const auto ground = truth.at(lat, lon);
                if (!ground) continue;
                constexpr double kRounding_m = 2e-3;  // posts between coarse ones have an undulation of their own
                ASSERT_LE(height - *ground, above_m + kRounding_m)
                    << key.level << "/" << key.i << "/" << key.j << " mask " << int{mask};
                ASSERT_LE(*ground - height, below_m + kRounding_m)
                    << key.level << "/" << key.i << "/" << key.j << " mask " << int{mask};
            }
}

/// Made once for all tests of a density.
struct Made {
    TwoRasters rasters;
    BuiltDatabase built{rasters.image()};
    ExactSurface truth{built};

    explicit Made(std::uint32_t density) : rasters(density) {}
};

const Made& made(std::uint32_t density) {
    static std::map<std::uint32_t, std::unique_ptr<Made>> kept;
    std::unique_ptr<Made>& one = kept[density];
    if (one == nullptr) one = std::make_unique<Made>(density);
    return *one;
}

class InsetBuild : public ::testing::TestWithParam<std::uint32_t> {
protected:
    const TwoRasters& rasters_ = made(GetParam()).rasters;
    const BuiltDatabase& built_ = made(GetParam()).built;
    const ExactSurface& truth_ = made(GetParam()).truth;
};

TEST_P(InsetBuild, StatedErrorsHold) {
    for (const ChunkKey& key : existing_chunks(built_)) {
        constexpr std::uint32_t kEach[] = {19, 4};  // of the finest levels, where there are many, all alike
        if (key.level < std::size(kEach) && (key.i + key.j) % kEach[key.level] != 0) continue;
        expect_stated_error_holds(built_, truth_, key, 0);
        std::uint8_t sides = 0;
        for (const EdgeBit side : {kEdgeNorth, kEdgeEast, kEdgeSouth, kEdgeWest}) {
            const ChunkKey beside = built_.lattice().neighbour(key, side);
            const bool other = key.level + 1 < built_.lattice().levels() && beside != kNoChunk && beside.parent() != key.parent();
            if (other) sides = static_cast<std::uint8_t>(sides | side);
        }
        if (sides != 0) expect_stated_error_holds(built_, truth_, key, sides);
    }
}

TEST_P(InsetBuild, BordersAgreeBitForBit) {
    int finer = 0;
    for (const ChunkKey& key : existing_chunks(built_)) {
        const PostRange posts = built_.lattice().posts_of(key);
        for (const auto& [side, other] :
             {std::pair{kEdgeEast, kEdgeWest}, {kEdgeSouth, kEdgeNorth}, {kEdgeWest, kEdgeEast}, {kEdgeNorth, kEdgeSouth}}) {
            const ChunkKey beside = built_.lattice().neighbour(key, side);
            if (beside == kNoChunk) continue;
            const bool exists =
                built_.database.has_page(built_.lattice().page_index(beside)) && built_.entry(beside).vertex_count != 0;
            EXPECT_TRUE(!exists || side_of(built_, key, side, true) == side_of(built_, beside, other, true));
            if (key.level + 1 == built_.lattice().levels() || beside.parent() == key.parent()) continue;
            const bool along_j = side == kEdgeEast || side == kEdgeWest;
            const std::uint32_t first = along_j ? posts.j0 : posts.i0, last = along_j ? posts.j1 : posts.i1;
            EXPECT_EQ(side_of(built_, key, side, false), part_of_side(side_of(built_, beside.parent(), other, true), first, last))
                << key.level << "/" << key.i << "/" << key.j;
            finer += exists ? 0 : 1;
        }
    }
    EXPECT_GT(finer, 8) << "chunks beside exact ones of the next level";
}

TEST_P(InsetBuild, IsTheInsetInsideTheCoarseRasterOutsideAndHasNoStep) {
    const GeoidEgm96 geoid = GeoidEgm96::installed();
    const auto height = [&](double x, double y) {  // in coarse posts
        const double lat = 47.1 - y * TwoRasters::kCoarse_deg, lon = 9.6 + x * TwoRasters::kCoarse_deg;
        const auto surface = truth_.at(lat, lon);
        return surface ? *surface - geoid.undulation(base::radians(lat), base::radians(lon)).m : std::nan("");
    };
    const auto coarse = [&](std::uint32_t i, std::uint32_t j) { return rasters_.coarse.height_m[rasters_.coarse.at(i, j)]; };
    EXPECT_NEAR(height(20, 30), coarse(20, 30), 0.01);
    EXPECT_NEAR(height(20.5, 30), 0.5 * (coarse(20, 30) + coarse(21, 30)), 0.01);
    if (GetParam() >= 8) {  // with room for the blend: 32 posts from the rim, and from the hole
        const std::uint32_t i = rasters_.density == 8 ? 14 : 3, j = rasters_.density == 8 ? 11 : 3;
        EXPECT_NEAR(height(60 + i, 50 + j), rasters_.fine.height_m[rasters_.fine.at(i * GetParam(), j * GetParam())], 0.01);
    }
    double steepest = 0;
    for (double x = 50; x < 90; x += 0.05) steepest = std::max(steepest, std::abs(height(x + 0.05, 53) - height(x, 53)) / 0.05);
    EXPECT_LT(steepest, 20.0 * GetParam() + 60 + 40.0 * GetParam() / 16) << "detail, hills and blend, metres a coarse post";
}

TEST_P(InsetBuild, PayloadsAndAttributesAreWhatTheDisplayExpects) {
    for (const ChunkKey& key : existing_chunks(built_)) {
        const ChunkEntry entry = built_.entry(key);
        EXPECT_TRUE(payload_holds(built_.lattice(), entry, {built_.image.data() + entry.payload.offset, entry.payload.bytes}));
        EXPECT_EQ(entry.attributes.bytes != 0, entry.children != 0) << key.level;
    }
}

TEST_P(InsetBuild, ThreadsAndInterruptionsChangeNothing) {
    BuildOptions one;
    one.threads = 1;
    EXPECT_EQ(rasters_.image(one), built_.image);
    const test_support::TemporaryFolder folder;
    BuildOptions options;
    options.between_records = std::chrono::milliseconds(0);
    bool whole = false;
    for (int attempt = 0; attempt < 1000 && !whole; ++attempt) {
        int left = GetParam() > 8 ? 241 : 61;
        options.progress = [&left](std::string_view, std::uint64_t, std::uint64_t) {
            if (--left == 0) throw std::runtime_error("stop");
        };
        try {
            build_terrain(rasters_.sources(), folder.file("t.tdb"), options);
            whole = true;
        } catch (const std::runtime_error&) {
        }
    }
    EXPECT_EQ(folder.read("t.tdb"), std::string(built_.image.begin(), built_.image.end()));
}

INSTANTIATE_TEST_SUITE_P(Densities, InsetBuild, ::testing::Values(2u, 8u, 32u));

TEST(InsetStages, ACheckFindsAMetreInTheInset) {
    TwoRasters rasters(4);
    const test_support::TemporaryFolder folder;
    build_terrain(rasters.sources(), folder.file("t.tdb"), {});
    EXPECT_EQ(check_terrain(folder.file("t.tdb"), rasters.sources(), {}).violations, 0u);
    rasters.fine.height_m[rasters.fine.at(40, 40)] += 1;
    const TerrainCheck changed = check_terrain(folder.file("t.tdb"), rasters.sources(), {});
    EXPECT_GT(changed.violations, 2u);
    EXPECT_GT(changed.worst_excess_m, 0.1);
}

}  // namespace
}  // namespace tedavis::host_sim::test_inset_stages
