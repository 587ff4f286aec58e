#include "render_core/raytrace/surface/patch_posts.hpp"

#include <initializer_list>

namespace tedavis::raytrace {
namespace {

constexpr int kRing = 4;

struct RingPosts {
    double (*z)[kRing];
    bool is_there[kRing][kRing];
    bool is_column_inside[kRing], is_row_inside[kRing];
};

/// What continues a side of the ring is one step and two steps further in.
int next_inwards(int n) { return n == 0 ? 1 : 2; }
int second_inwards(int n) { return n == 0 ? 2 : 1; }

template <class Height>
void read_ring(const HeightGrid<Height>& grid, std::uint32_t column, std::uint32_t row, RingPosts& ring) {
    for (int j = 0; j < kRing; ++j) {
        const std::uint32_t line = row + static_cast<std::uint32_t>(j) - 1;  // -1 wraps beyond every grid
        ring.is_row_inside[j] = line < grid.rows;
        for (int i = 0; i < kRing; ++i) {
            const std::uint32_t place = column + static_cast<std::uint32_t>(i) - 1;
            ring.is_column_inside[i] = place < grid.columns;
            const bool is_inside = ring.is_row_inside[j] && ring.is_column_inside[i];
            const Height height = is_inside ? grid.at(place, line) : HeightGrid<Height>::kVoid;
            ring.is_there[j][i] = height != HeightGrid<Height>::kVoid;
            ring.z[j][i] = static_cast<double>(height);
        }
    }
}

void continue_sides(RingPosts& ring) {
    for (int n = 1; n <= 2; ++n)
        for (const int side : {0, 3}) {
            const int a = next_inwards(side), b = second_inwards(side);
            if (!ring.is_there[side][n]) ring.z[side][n] = 2 * ring.z[a][n] - ring.z[b][n];
            if (!ring.is_there[n][side]) ring.z[n][side] = 2 * ring.z[n][a] - ring.z[n][b];
        }
}

void continue_corners(RingPosts& ring) {
    for (const int j : {0, 3})
        for (const int i : {0, 3}) {
            if (ring.is_there[j][i]) continue;
            const int a = next_inwards(j), b = next_inwards(i);
            if (!ring.is_row_inside[j]) {
                ring.z[j][i] = 2 * ring.z[a][i] - ring.z[second_inwards(j)][i];
            } else if (!ring.is_column_inside[i]) {
                ring.z[j][i] = 2 * ring.z[j][b] - ring.z[j][second_inwards(i)];
            } else {
                ring.z[j][i] = ring.z[j][b] + ring.z[a][i] - ring.z[a][b];
            }
        }
}

}  // namespace

template <class Height>
PatchPosts patch_posts(const HeightGrid<Height>& grid, std::uint32_t column, std::uint32_t row) {
    PatchPosts posts;
    RingPosts ring{posts.z, {}, {}, {}};
    read_ring(grid, column, row, ring);
    posts.has_surface = ring.is_there[1][1] && ring.is_there[1][2] && ring.is_there[2][1] && ring.is_there[2][2];
    if (!posts.has_surface) return posts;
    continue_sides(ring);
    continue_corners(ring);
    return posts;
}

template PatchPosts patch_posts(const HeightGrid<std::int16_t>&, std::uint32_t, std::uint32_t);
template PatchPosts patch_posts(const HeightGrid<float>&, std::uint32_t, std::uint32_t);

}  // namespace tedavis::raytrace
