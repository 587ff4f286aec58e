#include "render_core/terrain/lattice.hpp"

#include <cmath>

#include "render_core/base/check.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::terrain {
namespace {

constexpr double kPole_rad = 1.5707963267948966;

std::uint32_t chunks_across(std::uint32_t posts, std::uint32_t level) {
    const std::uint32_t cells = kChunkCells << level;
    return (posts - 1 + cells - 1) / cells;
}

std::uint32_t pages_across(std::uint32_t chunks) { return (chunks + kPageChunks - 1) / kPageChunks; }

std::uint32_t least(std::uint32_t a, std::uint32_t b) { return a < b ? a : b; }

}  // namespace

Lattice::Lattice(const FileHeader& header)
    : west_deg_(header.west_deg),
      north_deg_(header.north_deg),
      step_lon_deg_(header.step_lon_deg),
      step_lat_deg_(header.step_lat_deg),
      columns_(header.columns),
      rows_(header.rows),
      levels_(header.levels),
      flags_(header.lattice_flags) {
    TEDAVIS_CHECK(levels_ <= kMaxLevels && columns_ >= 2 && rows_ >= 2);
    for (std::uint32_t level = 0; level < levels_; ++level)
        first_page_[level + 1] = first_page_[level] + page_columns(level) * page_rows(level);
}

double Lattice::latitude_rad(std::uint32_t j) const {
    if (j == 0 && (flags_ & kLatticeNorthPole) != 0) return kPole_rad;
    if (j == rows_ - 1 && (flags_ & kLatticeSouthPole) != 0) return -kPole_rad;
    const double regular_row = (flags_ & kLatticeNorthPole) != 0 ? j - 1.0 : j;
    return base::radians(north_deg_ - step_lat_deg_ * regular_row);
}

double Lattice::longitude_rad(std::uint32_t i) const {
    const std::uint32_t column = is_closed() && i == columns_ - 1 ? 0 : i;
    return base::radians(west_deg_ + step_lon_deg_ * column);
}

earth::Ecef Lattice::position(std::uint32_t i, std::uint32_t j, double ellipsoid_height_m) const {
    const double latitude = latitude_rad(j);
    if (std::abs(latitude) == kPole_rad) {
        const double polar_radius_m = earth::kSemiMajorAxis_m * (1 - earth::kFlattening);
        return {0, 0, std::copysign(polar_radius_m + ellipsoid_height_m, latitude)};
    }
    return earth::to_ecef({latitude, longitude_rad(i), {ellipsoid_height_m}});
}

LatticePoint Lattice::point(double latitude_rad, double longitude_rad) const {
    const double width_deg = step_lon_deg_ * (columns_ - 1), latitude_deg = base::degrees(latitude_rad);
    // The equal of the longitude nearest to the middle of the database, so that a database across the antimeridian works.
    const double middle_deg = west_deg_ + 0.5 * width_deg;
    const double east_deg = std::remainder(base::degrees(longitude_rad) - middle_deg, 360.0) + 0.5 * width_deg;
    LatticePoint point{east_deg / step_lon_deg_, 0, false};
    const double last_i = columns_ - 1.0, last_j = rows_ - 1.0;
    // Rows beside a pole have their own spacing.
    const bool north_pole = (flags_ & kLatticeNorthPole) != 0, south_pole = (flags_ & kLatticeSouthPole) != 0;
    const double first_regular = north_pole ? 1 : 0, last_regular = south_pole ? last_j - 1 : last_j;
    point.j = (north_deg_ - latitude_deg) / step_lat_deg_ + first_regular;
    if (north_pole && point.j < 1) point.j = (90 - latitude_deg) / (90 - north_deg_);
    if (south_pole && point.j > last_regular) {
        const double last_deg = north_deg_ - step_lat_deg_ * (last_regular - first_regular);
        point.j = last_regular + (last_deg - latitude_deg) / (last_deg + 90);
    }
    // Degrees and radians do not convert back exactly: a border post asked for by its own place must count as inside.
    constexpr double kRounding = 1e-6;
    point.inside =
        point.i >= -kRounding && point.j >= -kRounding && point.i <= last_i + kRounding && point.j <= last_j + kRounding;
    if (point.inside) {
        point.i = std::fmin(std::fmax(point.i, 0.0), last_i);
        point.j = std::fmin(std::fmax(point.j, 0.0), last_j);
    }
    return point;
}

std::uint32_t Lattice::grid_columns(std::uint32_t level) const { return chunks_across(columns_, level); }
std::uint32_t Lattice::grid_rows(std::uint32_t level) const { return chunks_across(rows_, level); }

bool Lattice::contains(const ChunkKey& key) const {
    return key.level < levels_ && key.i < grid_columns(key.level) && key.j < grid_rows(key.level);
}

PostRange Lattice::posts_of(const ChunkKey& key) const {
    const std::uint32_t cells = kChunkCells << key.level;
    return {key.i * cells, key.j * cells, least((key.i + 1) * cells, columns_ - 1), least((key.j + 1) * cells, rows_ - 1)};
}

ChunkKey Lattice::neighbour(const ChunkKey& key, EdgeBit side) const {
    const std::uint32_t last_i = grid_columns(key.level) - 1, last_j = grid_rows(key.level) - 1;
    switch (side) {
        case kEdgeNorth: return key.j > 0 ? ChunkKey{key.level, key.i, key.j - 1} : kNoChunk;
        case kEdgeSouth: return key.j < last_j ? ChunkKey{key.level, key.i, key.j + 1} : kNoChunk;
        case kEdgeWest:
            if (key.i > 0) return {key.level, key.i - 1, key.j};
            return is_closed() ? ChunkKey{key.level, last_i, key.j} : kNoChunk;
        case kEdgeEast:
            if (key.i < last_i) return {key.level, key.i + 1, key.j};
            return is_closed() ? ChunkKey{key.level, 0, key.j} : kNoChunk;
    }
    return kNoChunk;
}

std::uint32_t Lattice::page_columns(std::uint32_t level) const { return pages_across(grid_columns(level)); }
std::uint32_t Lattice::page_rows(std::uint32_t level) const { return pages_across(grid_rows(level)); }

std::uint32_t Lattice::page_index(const ChunkKey& key) const {
    return first_page_[key.level] + key.j / kPageChunks * page_columns(key.level) + key.i / kPageChunks;
}

}  // namespace tedavis::terrain
