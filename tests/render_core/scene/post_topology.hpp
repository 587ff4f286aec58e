/// The topology of a surface in a volume, found without a triangle: from the posts inside and outside alone.
#pragma once

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "tests/support/scene/surface_topology.hpp"
#include "tests/support/scene/volume_surface.hpp"

namespace tedavis::test_support {

/// What lies inside of a surface that is linear on tetrahedra can be drawn together to the
/// corners, edges, triangles and tetrahedra whose posts are all inside, so both have one Euler number; a closed surface has
/// twice that of what it encloses, and one piece fewer than there are regions of posts on either side.
class PostTopology {
public:
    PostTopology(const Volume& volume, float level)
        : volume_(volume), level_(level), sets_(volume.values.size()), everywhere_(volume.values.size(), true) {
        for (std::uint32_t z = 0; z < volume.nz; ++z)
            for (std::uint32_t y = 0; y < volume.ny; ++y)
                for (std::uint32_t x = 0; x < volume.nx; ++x) count_from(x, y, z);
    }
    [[nodiscard]] long surface_euler_number() const { return 2 * euler_; }
    [[nodiscard]] std::size_t surface_pieces() { return sets_.count(everywhere_) - 1; }
    std::set<std::array<double, 3>> crossings;  ///< of edges between posts inside and outside

private:
    struct Post {
        std::uint32_t x, y, z;
    };
    [[nodiscard]] std::size_t index(const Post& p) const { return (std::size_t{p.z} * volume_.ny + p.y) * volume_.nx + p.x; }
    [[nodiscard]] bool inside(const Post& p) const { return volume_.values[index(p)] >= level_; }
    [[nodiscard]] bool step(Post& p, int axes) const {
        p = {p.x + (axes & 1), p.y + (axes >> 1 & 1), p.z + (axes >> 2 & 1)};
        return p.x < volume_.nx && p.y < volume_.ny && p.z < volume_.nz;
    }
    /// Chains of posts whose lowest is this one, each above the one before it in a cell.
    void count_from(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        const Post lowest{x, y, z};
        if (inside(lowest)) ++euler_;
        for (int axes = 1; axes < 8; ++axes) {
            Post upper = lowest;
            if (!step(upper, axes)) continue;
            if (inside(upper) == inside(lowest))
                sets_.join(index(lowest), index(upper));
            else
                add_crossing(lowest, upper);
            if (inside(upper) && inside(lowest)) euler_ += chains_above(lowest, axes);
        }
    }
    /// The edge to `axes` above, triangles and tetrahedra over it with posts between or above; each is counted by its top edge.
    [[nodiscard]] long chains_above(const Post& lowest, int axes) const {
        long sum = -1;
        for (int more = 1; more < 8; ++more) {
            if ((more & axes) != 0) continue;
            Post top = lowest;
            if (!step(top, axes | more) || !inside(top)) continue;
            ++sum;
            for (int last = 1; last < 8; ++last) {
                Post peak = lowest;
                if ((last & (axes | more)) == 0 && step(peak, axes | more | last) && inside(peak)) --sum;
            }
        }
        return sum;
    }
    void add_crossing(const Post& a, const Post& b) {
        const long double of_a = volume_.values[index(a)], of_b = volume_.values[index(b)];
        const long double t = std::min(std::max((level_ - of_a) / (of_b - of_a), 1 / 2048.0L), 1 - 1 / 2048.0L);
        crossings.insert({static_cast<double>(a.x + t * (b.x - a.x)), static_cast<double>(a.y + t * (b.y - a.y)),
                          static_cast<double>(a.z + t * (b.z - a.z))});
    }

    const Volume& volume_;
    float level_;
    DisjointSets sets_;
    std::vector<bool> everywhere_;
    long euler_ = 0;
};

}  // namespace tedavis::test_support
