#include "tests/support/terrain/surface_gap.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

namespace tedavis::test_support {
namespace {

/// Weights of a lattice place in a triangle whose corners have lattice places; a corner at a pole lies on every meridian.
/// False outside.
bool weigh(const double (&i)[3], const double (&j)[3], const bool (&pole)[3], double pi, double pj, double (&w)[3]) {
    const int poles = int(pole[0]) + int(pole[1]) + int(pole[2]);
    if (poles > 1) return false;
    if (poles == 1) {
        const int apex = pole[0] ? 0 : (pole[1] ? 1 : 2), a = (apex + 1) % 3, b = (apex + 2) % 3;
        const double s = (pi - i[a]) / (i[b] - i[a]), t = (pj - j[apex]) / (j[a] + s * (j[b] - j[a]) - j[apex]);
        w[apex] = 1 - t;
        w[a] = t * (1 - s);
        w[b] = t * s;
    } else {
        const double det = (i[1] - i[0]) * (j[2] - j[0]) - (i[2] - i[0]) * (j[1] - j[0]);
        w[1] = ((pi - i[0]) * (j[2] - j[0]) - (i[2] - i[0]) * (pj - j[0])) / det;
        w[2] = ((i[1] - i[0]) * (pj - j[0]) - (pi - i[0]) * (j[1] - j[0])) / det;
        w[0] = 1 - w[1] - w[2];
    }
    return w[0] >= -1e-9 && w[1] >= -1e-9 && w[2] >= -1e-9;
}

}  // namespace

SurfaceGap surface_gap(const PostSurface& surface, const terrain::ChunkEntry& entry,
                       const std::vector<terrain::ChunkVertex>& vertices, const std::vector<std::uint16_t>& indices) {
    const terrain::PostRange posts = surface.lattice.posts_of(key_of(entry));
    const glm::dvec3 centre(entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]);
    SurfaceGap gap;
    for (std::size_t n = 0; n < indices.size(); n += 3) {
        double i[3], j[3], w[3];
        bool pole[3];
        glm::dvec3 corner[3];
        for (int k = 0; k < 3; ++k) {
            const terrain::ChunkVertex& v = vertices[indices[n + static_cast<std::size_t>(k)]];
            i[k] = posts.i0 + v.i;
            j[k] = posts.j0 + v.j;
            pole[k] = std::abs(surface.lattice.latitude_rad(posts.j0 + v.j)) > 1.5707963;
            corner[k] = centre + glm::dvec3(double{v.x}, double{v.y}, double{v.z});
        }
        for (double pj = std::min({j[0], j[1], j[2]}); pj <= std::max({j[0], j[1], j[2]}); ++pj)
            for (double pi = std::min({i[0], i[1], i[2]}); pi <= std::max({i[0], i[1], i[2]}); ++pi) {
                if (!weigh(i, j, pole, pi, pj, w)) continue;
                const std::size_t post = static_cast<std::size_t>(pj) * surface.columns + static_cast<std::size_t>(pi);
                const double drawn_above =
                    glm::dot(corner[0] * w[0] + corner[1] * w[1] + corner[2] * w[2] - surface.positions[post], surface.ups[post]);
                gap.above_m = std::max(gap.above_m, drawn_above);
                gap.below_m = std::max(gap.below_m, -drawn_above);
            }
    }
    return gap;
}

}  // namespace tedavis::test_support
