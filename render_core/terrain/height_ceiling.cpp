#include "render_core/terrain/height_ceiling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/units.hpp"
#include "render_core/terrain/regular_chunk.hpp"

namespace tedavis::terrain {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kQuarterTurn_rad = 0.5 * base::kPi;
constexpr double kSlack_m = 1e-3;      // of places and sums, computed in doubles
constexpr double kSlack_cells = 2e-6;  // of lattice points
constexpr double kSlack_deg = 2e-6;    // of a lattice that closes round the Earth

/// Latitudes and longitudes, radians; `east` may be beyond 180 degrees.
struct GeographicArea {
    double south, north, west, east;
};

/// Calls `visit` with every whole number from `low` to `high` that is a line of a grid.
template <class Visit>
void for_grid_lines(double low, double high, std::uint32_t lines, const Visit& visit) {
    const double first = std::fmax(std::ceil(low), 0), last = std::fmin(std::floor(high), lines - 1.0);
    if (!(first <= last)) return;
    for (auto line = static_cast<std::uint32_t>(first); line <= static_cast<std::uint32_t>(last); ++line)
        visit(static_cast<double>(line));
}

/// The highest undulation over an area. It is bilinear between the grid's lines, hence highest where these and the area's sides
/// meet, or beside the meridian opposite to the grid's middle, where a grid that does not go round the Earth jumps.
double highest_undulation_m(const TerrainDatabase& database, const GeographicArea& area) {
    constexpr double kBeside_rad = 1e-9;
    const FileHeader& h = database.header();
    const double step = base::radians(h.undulation_step_deg), turn = 2 * base::kPi / step;
    const double west = base::radians(h.undulation_west_deg), north = base::radians(h.undulation_north_deg);
    const double middle = 0.5 * (h.undulation_columns - 1.0), middle_rad = west + middle * step;
    const double from = middle + std::remainder(area.west - middle_rad, 2 * base::kPi) / step;
    const double to = from + (area.east - area.west) / step;
    double highest_m = -kUnbounded;
    const auto include = [&](double latitude, double longitude) {
        highest_m = std::fmax(highest_m, database.undulation(latitude, longitude).m);
    };
    const auto include_parallel = [&](double latitude) {
        include(latitude, area.west);
        include(latitude, area.east);
        if (to + kBeside_rad / step >= middle + 0.5 * turn)
            for (const double beside : {-kBeside_rad, kBeside_rad}) include(latitude, middle_rad + base::kPi + beside);
        for (const double shift : {0.0, turn})
            for_grid_lines(from - shift, to - shift, h.undulation_columns,
                           [&](double column) { include(latitude, west + column * step); });
    };
    include_parallel(area.south);
    include_parallel(area.north);
    for_grid_lines((north - area.north) / step, (north - area.south) / step, h.undulation_rows,
                   [&](double row) { include_parallel(north - row * step); });
    return highest_m;
}

/// Of a block of an exact chunk.
struct BlockPosts {
    float highest_m = -std::numeric_limits<float>::infinity();
    bool has_void = false;
};

BlockPosts posts_of_block(const ExactChunk& chunk, const RegularGrid& grid, std::uint32_t column, std::uint32_t row) {
    const std::uint32_t a1 = std::min(column + HeightCeiling::kBlockCells, grid.columns - 1),
                        b1 = std::min(row + HeightCeiling::kBlockCells, grid.rows - 1);
    BlockPosts posts;
    for (std::uint32_t b = row; b <= b1; ++b)
        for (std::uint32_t a = column; a <= a1; ++a) {
            const ChunkVertex& post = chunk.vertices[grid.index_of(a, b)];
            if (post.post_class() == PostClass::void_)
                posts.has_void = true;
            else
                posts.highest_m = std::max(posts.highest_m, post.height_m);
        }
    return posts;
}

}  // namespace

/// The place and the radius as the angle that it has at most: on the sphere of the least radius of curvature.
class HeightCeiling::Disc {
public:
    Disc(const TerrainDatabase& database, double latitude_rad, double longitude_rad, double radius_m)
        : lattice_(database.lattice()),
          latitude_(latitude_rad),
          column_(lattice_.point(latitude_rad, longitude_rad).i),
          step_rad_(base::radians(database.header().step_lon_deg)),
          angle_(std::fmin((radius_m + kSlack_m) / earth::kMinCurvatureRadius_m, base::kPi)),
          haversine_(square(std::sin(0.5 * angle_))),
          cos_latitude_(std::cos(latitude_rad)),
          longitude_(longitude_rad),
          half_width_(has_pole() ? base::kPi : std::asin(std::fmin(std::sin(angle_) / cos_latitude_, 1))) {}

    /// Contains the disc.
    [[nodiscard]] GeographicArea area() const {
        return {std::fmax(latitude_ - angle_, -kQuarterTurn_rad), std::fmin(latitude_ + angle_, kQuarterTurn_rad),
                longitude_ - half_width_, longitude_ + half_width_};
    }

    /// Whether ground between these posts is near enough: on the nearest of their meridians, the latitude that is nearest by
    /// great circle, or the one where they end before it.
    [[nodiscard]] bool touches(const PostRange& posts) const {
        const double north = lattice_.latitude_rad(posts.j0), south = lattice_.latitude_rad(posts.j1);
        if (std::fmax(latitude_ - north, south - latitude_) > angle_) return false;
        const double aside = longitude_to(posts), haversine_aside = square(std::sin(0.5 * aside));
        const auto is_near = [&](double latitude) {
            return square(std::sin(0.5 * (latitude - latitude_))) + cos_latitude_ * std::cos(latitude) * haversine_aside <=
                   haversine_;
        };
        // Beyond a quarter of the Earth the shortest way leads past a pole.
        if (aside > kQuarterTurn_rad) return is_near(north) || is_near(south);
        const double nearest = std::atan2(std::sin(latitude_), cos_latitude_ * std::cos(aside));
        return is_near(std::fmin(std::fmax(nearest, south), north));
    }

    [[nodiscard]] bool is_inside_lattice() const {
        constexpr double kSlack_rad = 2 * kSlack_m / earth::kMinCurvatureRadius_m;
        const GeographicArea area = this->area();
        if (area.north > lattice_.latitude_rad(0) + kSlack_rad) return false;
        if (area.south < lattice_.latitude_rad(lattice_.rows() - 1) - kSlack_rad) return false;
        const double last = lattice_.columns() - 1.0, half_width = half_width_ / step_rad_;
        if (lattice_.is_closed() || last >= turn() - kSlack_cells) return true;
        const double slack = kSlack_cells + kSlack_rad / (step_rad_ * std::fmax(cos_latitude_, kSlack_rad));
        for (const double column : {column_ - turn(), column_, column_ + turn()})
            if (column - half_width >= -slack && column + half_width <= last + slack) return true;
        return false;
    }

private:
    static double square(double x) { return x * x; }
    [[nodiscard]] bool has_pole() const { return std::abs(latitude_) + angle_ >= kQuarterTurn_rad; }
    /// Columns round the Earth.
    [[nodiscard]] double turn() const { return 2 * base::kPi / step_rad_; }
    /// The shorter way round the Earth to posts in the east or west, radians.
    [[nodiscard]] double longitude_to(const PostRange& posts) const {
        double columns = kUnbounded;
        for (const double column : {column_ - turn(), column_, column_ + turn()})
            columns = std::fmin(columns, std::fmax(posts.i0 - column, column - posts.i1));
        return std::fmin(std::fmax((columns - kSlack_cells) * step_rad_ - base::radians(kSlack_deg), 0), base::kPi);
    }

    const Lattice& lattice_;
    const double latitude_, column_, step_rad_, angle_, haversine_, cos_latitude_;
    const double longitude_, half_width_;
};

/// One query: all touched chunks of a level, then those of the next.
class HeightCeiling::Search {
public:
    Search(HeightCeiling& ceiling, const Disc& disc, double floor_msl_m)
        : ceiling_(ceiling), lattice_(ceiling.database_->lattice()), disc_(disc), floor_msl_m_(floor_msl_m) {}

    void run() {
        Chunks chunks, finer;
        if (!find_roots(chunks)) {
            include(double{ceiling_.database_->header().max_height_m});
            is_whole_ = false;
            return;
        }
        for (std::uint32_t level = lattice_.levels() - 1; level > 0 && descend(chunks, finer); --level) chunks = finer;
        for (const Chunk& chunk : chunks) settle(chunk);
    }

    [[nodiscard]] double highest_msl_m() const { return highest_msl_m_; }
    [[nodiscard]] bool is_whole() const { return is_whole_; }

private:
    struct Chunk {
        ChunkKey key;
        float highest_m;
        bool has_ground, has_void, is_exact;
    };
    using Chunks = base::FixedVector<Chunk, kMaxChunks>;

    void include(double msl_m) { highest_msl_m_ = std::fmax(highest_msl_m_, msl_m); }
    [[nodiscard]] bool is_low(const Chunk& chunk) const { return !chunk.has_ground || double{chunk.highest_m} < floor_msl_m_; }

    /// Adds a chunk if the disc touches it. Returns false if its entry cannot be read or there are too many.
    [[nodiscard]] bool add(const ChunkKey& key, Chunks& chunks) {
        if (!disc_.touches(lattice_.posts_of(key))) return true;
        const ChunkEntry* const entry = ceiling_.heights_->entry_of(key);
        if (entry == nullptr) return false;
        return chunks.try_push_back({key, entry->max_height_m, (entry->flags & (kChunkHasSea | kChunkHasLand)) != 0,
                                     (entry->flags & kChunkHasVoid) != 0, entry->children == 0});
    }

    [[nodiscard]] bool find_roots(Chunks& roots) {
        const std::uint32_t top = lattice_.levels() - 1;
        for (std::uint32_t j = 0; j < lattice_.grid_rows(top); ++j)
            for (std::uint32_t i = 0; i < lattice_.grid_columns(top); ++i)
                if (!add({top, i, j}, roots)) return false;
        return true;
    }

    /// Replaces chunks by their children where these could say more. Returns false if the children are too many.
    [[nodiscard]] bool descend(const Chunks& chunks, Chunks& finer) {
        finer.clear();
        for (const Chunk& chunk : chunks) {
            if (is_low(chunk)) {
                settle(chunk);
                continue;
            }
            if (chunk.is_exact ? !finer.try_push_back(chunk) : !add_children(chunk, finer)) return false;
        }
        return true;
    }

    /// A child that cannot be read is bounded by its parent.
    [[nodiscard]] bool add_children(const Chunk& chunk, Chunks& finer) {
        for (std::uint32_t quadrant = 0; quadrant < 4; ++quadrant) {
            const ChunkKey key = chunk.key.child(quadrant);
            if (!lattice_.contains(key) || add(key, finer)) continue;
            if (finer.full()) return false;
            include(double{chunk.highest_m});
            is_whole_ = false;
        }
        return true;
    }

    void settle(const Chunk& chunk) {
        const Blocks* const blocks = chunk.is_exact && !is_low(chunk) ? ceiling_.blocks_of(chunk.key) : nullptr;
        if (blocks != nullptr) return include_blocks(chunk.key, *blocks);
        if (chunk.has_ground) include(double{chunk.highest_m});
        if (chunk.has_void || (chunk.is_exact && !is_low(chunk))) is_whole_ = false;
    }

    void include_blocks(const ChunkKey& key, const Blocks& blocks) {
        const PostRange posts = lattice_.posts_of(key);
        const std::uint32_t side = kBlockCells << key.level;
        for (std::uint32_t j = posts.j0, row = 0; j < posts.j1; j += side, ++row)
            for (std::uint32_t i = posts.i0, n = row * kBlocks; i < posts.i1; i += side, ++n) {
                const bool has_void = (blocks.voids >> n & 1u) != 0;
                if (!(double{blocks.highest_m[n]} > highest_msl_m_) && !has_void) continue;
                if (!disc_.touches({i, j, std::min(i + side, posts.i1), std::min(j + side, posts.j1)})) continue;
                include(double{blocks.highest_m[n]});
                is_whole_ = is_whole_ && !has_void;
            }
    }

    HeightCeiling& ceiling_;
    const Lattice& lattice_;
    const Disc& disc_;
    const double floor_msl_m_;
    double highest_msl_m_ = -kUnbounded;
    bool is_whole_ = true;
};

std::uint64_t HeightCeiling::bytes_needed(std::uint32_t kept_chunks) { return kept_chunks * sizeof(Blocks) + alignof(Blocks); }

bool HeightCeiling::start(const TerrainDatabase& database, HeightQuery& heights, base::Arena& arena, std::uint32_t kept_chunks) {
    static_assert(kKeptChunks >= kMaxChunks && sizeof(Blocks) * kKeptChunks <= 24 * 1024);
    database_ = &database;
    heights_ = &heights;
    kept_ = arena.allocate_array<Blocks>(kept_chunks);
    return !kept_.empty();
}

CeilingAnswer HeightCeiling::over(double latitude_rad, double longitude_rad, double radius_m, double floor_m) {
    const bool holds = std::abs(latitude_rad) <= kQuarterTurn_rad && std::isfinite(longitude_rad) && radius_m >= 0 &&
                       std::isfinite(radius_m) && !std::isnan(floor_m);
    if (!holds) return {kUnbounded, false};
    const Disc disc(*database_, latitude_rad, longitude_rad, radius_m);
    const double to_ellipsoid_m = highest_undulation_m(*database_, disc.area()) + kSlack_m;
    Search search(*this, disc, floor_m - to_ellipsoid_m);
    search.run();
    return {search.highest_msl_m() + to_ellipsoid_m, search.is_whole() && disc.is_inside_lattice()};
}

/// Null where the chunk cannot be read.
const HeightCeiling::Blocks* HeightCeiling::blocks_of(const ChunkKey& key) {
    Blocks* place = kept_.data();
    for (Blocks& kept : kept_) {
        if (kept.asked != 0 && kept.chunk == key.packed()) {
            kept.asked = ++asked_;
            return &kept;
        }
        if (kept.asked < place->asked) place = &kept;
    }
    const PostRange range = database_->lattice().posts_of(key);
    const ExactChunk chunk = heights_->exact_chunk(range.i0, range.j0);
    if (chunk.entry == nullptr) return nullptr;
    *place = {key.packed(), ++asked_, 0, {}};
    const RegularGrid grid = regular_grid(range.i1 - range.i0, range.j1 - range.j0, key.level);
    for (std::uint32_t row = 0; row + 1 < grid.rows; row += kBlockCells)
        for (std::uint32_t column = 0; column + 1 < grid.columns; column += kBlockCells) {
            const std::uint32_t n = row / kBlockCells * kBlocks + column / kBlockCells;
            const BlockPosts posts = posts_of_block(chunk, grid, column, row);
            place->highest_m[n] = posts.highest_m;
            place->voids |= std::uint64_t{posts.has_void} << n;
        }
    return place;
}

}  // namespace tedavis::terrain
