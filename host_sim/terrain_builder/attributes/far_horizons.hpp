/// Horizons beyond a tile's reach, passed down the pyramid: each level searches the posts at 8 to 16 of its own spacings, which
/// are 16 to 32 of the next finer level, and adds the result of the next coarser level. Every octave of distance is searched
/// once.
///
/// A far horizon is stored as a linear function of the eye's height, tangent = intercept - per_m * height, because posts of the
/// finer level are higher or lower than the post for which it was found.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host_sim/terrain_builder/attributes/height_planes.hpp"
#include "render_core/terrain/attribute_map.hpp"

namespace tedavis::host_sim {

/// Number of posts around the inner ones for which far horizons are made, too: the finer level needs them for its apron.
inline constexpr int kFarMargin = 10;
/// The near end of the distances that a level searches for the finer one, in posts; the far end is kHorizonReach.
inline constexpr int kFarNearEnd = kHorizonReach / 2;
inline constexpr float kNoHorizon = -kNoHeight_m;

struct FarLines {
    std::array<float, terrain::kHorizonDirections> intercept;  ///< tangent seen from height 0; kNoHorizon: nothing in sight
    std::array<float, terrain::kHorizonDirections> per_m;      ///< 1 / distance of the horizon, metres
};

/// Far horizons of a tile, 132 bytes per post.
struct FarHorizons {
    int columns = 0, rows = 0;    ///< inner posts of its tile
    std::vector<FarLines> lines;  ///< row by row, (columns + 2 kFarMargin) by (rows + 2 kFarMargin)
    std::vector<float> known;     ///< 1, or 0 at posts without a height

    [[nodiscard]] std::size_t at(int column, int row) const {
        return index_of(column + kFarMargin, row + kFarMargin, columns + 2 * kFarMargin);
    }
};

/// The far horizons of the coarser level for a tile; null: there are no horizons beyond the tile's own reach.
struct FarView {
    const FarHorizons* horizons = nullptr;
    /// Position of the tile's inner post (0,0) in inner posts of the coarser level; one post of the tile is half a post there. As
    /// heights are means of two by two posts, it is half the post's number there, less a quarter.
    double first_column = 0, first_row = 0;
};

/// Rows of far horizons at a tile's posts, interpolated linearly between the four posts around each, without those that have no
/// height. Beyond the last post of the coarser level, its horizons are repeated.
class FarRow {
public:
    /// For `columns` columns from `first_column` on, and those that a read of kLanes posts at the last one needs.
    FarRow(const FarView& view, int first_column, int columns);

    void read(int row);
    /// Tangents of the far horizon at four posts from the `index`-th column on, for eyes at these heights.
    [[nodiscard]] Lanes tangent(int direction, std::size_t index, Lanes height_m) const;
    [[nodiscard]] Lanes intercept(int direction, std::size_t index) const { return load(place(0, direction, index)); }
    [[nodiscard]] Lanes per_m(int direction, std::size_t index) const { return load(place(1, direction, index)); }

private:
    struct Column {
        int west, east;
        float part;  ///< weight of the eastern post
    };

    [[nodiscard]] const float* place(std::size_t line, int direction, std::size_t index) const {
        return &values_[(line * terrain::kHorizonDirections + static_cast<std::size_t>(direction)) * count_ + index];
    }
    void mix(std::size_t index, const std::array<std::size_t, 4>& corners, const std::array<float, 4>& weights);

    const FarView view_;
    std::size_t count_;
    std::vector<Column> columns_;
    std::vector<float> values_;  ///< intercepts of direction 0, 1 ..., then per_m
};

/// Returns the far horizons of this tile for the next finer level.
[[nodiscard]] FarHorizons make_far_horizons(const HeightPlanes& planes, const FarView& above);

}  // namespace tedavis::host_sim
