/// Goes over the posts under a drawn triangle mesh: an oracle for what a selection draws, on its own arithmetic.
#pragma once

#include <algorithm>
#include <functional>

#include "render_core/terrain/drawn_surface.hpp"
#include "tests/support/terrain/tdb_writer.hpp"

namespace tedavis::test_support {

/// Calls visit(i, j, drawn) for posts of the chunk, at most every `stride`-th that lies in a triangle without a pole corner.
inline void visit_drawn_posts(const WrittenTdb& tdb, const terrain::SelectedChunk& chunk, std::int64_t stride,
                              const std::function<void(std::uint32_t, std::uint32_t, const glm::dvec3&)>& visit) {
    const auto vertices = tdb.vertices(chunk.key);
    const auto indices = tdb.indices(chunk.key, chunk.coarser_edges);
    const terrain::PostRange posts = tdb.lattice().posts_of(chunk.key);
    const glm::dvec3 centre(chunk.entry->centre_m[0], chunk.entry->centre_m[1], chunk.entry->centre_m[2]);
    for (std::size_t n = 0; n < indices.size(); n += 3) {
        std::int64_t i[3], j[3];
        glm::dvec3 corner[3];
        bool polar = false;
        for (std::size_t k = 0; k < 3; ++k) {
            const terrain::ChunkVertex& v = vertices[indices[n + k]];
            i[k] = std::int64_t{posts.i0} + v.i;
            j[k] = std::int64_t{posts.j0} + v.j;
            const auto pi = static_cast<std::uint32_t>(i[k]), pj = static_cast<std::uint32_t>(j[k]);
            polar = polar || std::abs(tdb.lattice().latitude_rad(pj)) > 1.5707963;
            const double lift_m = double{terrain::vertex_lift_m(chunk.lift, posts, v)};
            corner[k] = centre + glm::dvec3(double{v.x}, double{v.y}, double{v.z}) + tdb.lattice().position(pi, pj, lift_m) -
                        tdb.lattice().position(pi, pj, 0);
        }
        if (polar) continue;
        const std::int64_t area = (i[1] - i[0]) * (j[2] - j[0]) - (i[2] - i[0]) * (j[1] - j[0]);
        const std::int64_t first_i = (std::min({i[0], i[1], i[2]}) + stride - 1) / stride * stride,
                           first_j = (std::min({j[0], j[1], j[2]}) + stride - 1) / stride * stride;
        for (std::int64_t pj = first_j; pj <= std::max({j[0], j[1], j[2]}); pj += stride)
            for (std::int64_t pi = first_i; pi <= std::max({i[0], i[1], i[2]}); pi += stride) {
                const std::int64_t b = (pi - i[0]) * (j[2] - j[0]) - (i[2] - i[0]) * (pj - j[0]),
                                   c = (i[1] - i[0]) * (pj - j[0]) - (pi - i[0]) * (j[1] - j[0]);
                const double wb = double(b) / double(area), wc = double(c) / double(area);
                if (wb < 0 || wc < 0 || wb + wc > 1) continue;
                visit(static_cast<std::uint32_t>(pi), static_cast<std::uint32_t>(pj),
                      corner[0] * (1 - wb - wc) + corner[1] * wb + corner[2] * wc);
            }
    }
}

}  // namespace tedavis::test_support
