#include "host_sim/terrain_builder/mesh_difference.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "host_sim/terrain_builder/raster_options.hpp"

namespace tedavis::host_sim {
namespace {

using terrain::ChunkVertex;

std::uint32_t post_of(const ChunkVertex& v) { return std::uint32_t{v.j} << 16 | v.i; }

double position_difference_m(const ChunkVertices& a, const ChunkVertex& v, const ChunkVertices& b, const ChunkVertex& w) {
    const double* const o = a.centre_m;
    const double* const p = b.centre_m;
    return std::hypot(o[0] - p[0] + v.x - w.x, o[1] - p[1] + v.y - w.y, o[2] - p[2] + v.z - w.z);
}

class Comparison {
public:
    Comparison(const ChunkVertices& stated, const ChunkVertices& expected) : stated_(stated), expected_(expected) {
        for (const ChunkVertex& v : expected.vertices) at_post_.emplace(post_of(v), &v);
    }

    MeshDifference run(const terrain::PostRange& posts, const PostHeight& height_m) {
        std::vector<const ChunkVertex*> elsewhere;
        std::size_t shared = 0;
        for (const ChunkVertex& v : stated_.vertices) {
            const auto found = at_post_.find(post_of(v));
            if (found == at_post_.end()) {
                elsewhere.push_back(&v);
                continue;
            }
            ++shared;
            include(double{v.height_m} - found->second->height_m);
            include(position_difference_m(stated_, v, expected_, *found->second));
        }
        difference_.has_other_posts = !elsewhere.empty() || shared != at_post_.size();
        include_heights(elsewhere, posts, height_m);
        return difference_;
    }

private:
    void include(double difference_m) {
        difference_.largest_m =
            std::max(difference_.largest_m, std::isfinite(difference_m) ? std::abs(difference_m) : kHighestHeight_m);
    }
    void include_heights(std::vector<const ChunkVertex*>& vertices, const terrain::PostRange& posts, const PostHeight& height_m) {
        const auto block = [](const ChunkVertex* v) {
            return std::make_tuple(v->j / terrain::kChunkCells, v->i / terrain::kChunkCells, v->j, v->i);
        };
        std::sort(vertices.begin(), vertices.end(), [&](const auto* a, const auto* b) { return block(a) < block(b); });
        for (const ChunkVertex* v : vertices) {
            const std::uint32_t i = posts.i0 + v->i, j = posts.j0 + v->j;
            if (i > posts.i1 || j > posts.j1) continue;
            if (const std::optional<float> expected_m = height_m(i, j)) include(double{v->height_m} - *expected_m);
        }
    }

    const ChunkVertices &stated_, &expected_;
    std::unordered_map<std::uint32_t, const ChunkVertex*> at_post_;
    MeshDifference difference_;
};

}  // namespace

MeshDifference mesh_difference(const ChunkVertices& stated, const ChunkVertices& expected, const terrain::PostRange& posts,
                               const PostHeight& height_m) {
    return Comparison(stated, expected).run(posts, height_m);
}

}  // namespace tedavis::host_sim
