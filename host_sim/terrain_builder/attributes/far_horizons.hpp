/// Horizons beyond a tile's reach, handed down the pyramid: each level sees the posts 8 to 16 of its own from here, which
/// are 16 to 32 of the level below, and what the level above has seen. Every octave of distance is swept once.
///
/// A far horizon is kept as a line over the eye's height, tangent = intercept - per_m * height, because the posts of the
/// finer level stand higher and lower than the post that saw it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "host_sim/terrain_builder/attributes/height_planes.hpp"
#include "render_core/terrain/attribute_map.hpp"

namespace tedavis::host_sim {

/// Far horizons are made for so many posts round the inner ones as well: the level below needs them, for its apron.
inline constexpr int kFarMargin = 10;
/// The near end of what a level sees for the one below, in posts; the far end is kHorizonReach.
inline constexpr int kFarNearEnd = kHorizonReach / 2;
inline constexpr float kNoHorizon = -kNoHeight_m;

struct FarLines {
    std::array<float, terrain::kHorizonDirections> intercept;  ///< tangent seen from height 0; kNoHorizon: nothing in sight
    std::array<float, terrain::kHorizonDirections> per_m;      ///< 1 / distance of the horizon, metres
};

/// 132 bytes a post.
struct FarHorizons {
    int columns = 0, rows = 0;    ///< inner posts of its tile
    std::vector<FarLines> lines;  ///< row by row, (columns + 2 kFarMargin) by (rows + 2 kFarMargin)
    std::vector<float> known;     ///< 1, or 0 at posts without a height

    [[nodiscard]] std::size_t at(int column, int row) const {
        return index_of(column + kFarMargin, row + kFarMargin, columns + 2 * kFarMargin);
    }
};

/// The horizons of the level above as a tile looks them up; without any, nothing is seen beyond the tile's own reach.
struct FarView {
    const FarHorizons* horizons = nullptr;
    /// Where the tile's inner post (0,0) lies among the inner posts of the level above; one post of the tile is half a post
    /// there. With heights that are means of two by two posts: half the post's number there, less a quarter.
    double first_column = 0, first_row = 0;
};

/// Rows of far horizons at a tile's posts, interpolated linearly between the four posts round each; those without a height
/// do not count. Beyond the last post of the level above, its horizons go on.
class FarRow {
public:
    /// For columns from `first_column` on, `columns` of them, and what four posts at the last of them read beyond.
    FarRow(const FarView& view, int first_column, int columns);

    void read(int row);
    /// Tangents that four posts see, from the `index`-th column on, at these heights.
    [[nodiscard]] Lanes tangent(int direction, std::size_t index, Lanes height_m) const;
    [[nodiscard]] Lanes intercept(int direction, std::size_t index) const { return load(place(0, direction, index)); }
    [[nodiscard]] Lanes per_m(int direction, std::size_t index) const { return load(place(1, direction, index)); }

private:
    struct Column {
        int west, east;
        float part;  ///< of the eastern one
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

/// What the level below needs of this tile.
[[nodiscard]] FarHorizons make_far_horizons(const HeightPlanes& planes, const FarView& above);

}  // namespace tedavis::host_sim
