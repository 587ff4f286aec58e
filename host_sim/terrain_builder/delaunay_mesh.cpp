#include "host_sim/terrain_builder/delaunay_mesh.hpp"

#include <algorithm>

namespace tedavis::host_sim {
namespace {

constexpr int next(int k) { return k == 2 ? 0 : k + 1; }
constexpr int previous(int k) { return k == 0 ? 2 : k - 1; }

constexpr std::int64_t dot(MeshPost apex, MeshPost a, MeshPost b) {
    return std::int64_t{a.i - apex.i} * (b.i - apex.i) + std::int64_t{a.j - apex.j} * (b.j - apex.j);
}

/// How far a diagonal is from i + j = const.
constexpr std::int64_t slant(MeshPost a, MeshPost b) {
    const std::int64_t d = std::int64_t{b.i} + b.j - a.i - a.j;
    return d * d;
}

}  // namespace

DelaunayMesh::DelaunayMesh(const std::vector<MeshPost>& border) : vertices_(border) {
    MeshPost far;
    for (const MeshPost& post : border) far = {std::max(far.i, post.i), std::max(far.j, post.j)};
    const auto index_of = [&](MeshPost post) {
        return static_cast<std::uint32_t>(std::find(border.begin(), border.end(), post) - border.begin());
    };
    const std::uint32_t nw = 0, ne = index_of({far.i, 0}), se = index_of(far), sw = index_of({0, far.j});
    triangles_.reserve(4 * border.size());
    triangles_.push_back({{nw, sw, ne}, {kNone, 1, kNone}});
    triangles_.push_back({{se, ne, sw}, {kNone, 0, kNone}});
    place_on_side(nw, ne);
    place_on_side(ne, se);
    place_on_side(se, sw);
    place_on_side(sw, static_cast<std::uint32_t>(border.size()));
}

/// The border vertices between two corners, one after the other: each splits what is left of the side.
void DelaunayMesh::place_on_side(std::uint32_t first, std::uint32_t last) {
    const std::uint32_t corner = last == vertices_.size() ? 0 : last;
    std::uint32_t triangle = hull_triangle(corner, first);
    for (std::uint32_t vertex = first + 1; vertex < last; ++vertex) {
        const Triangle& t = triangles_[triangle];
        int side = 0;
        while (t.corner[side] != corner || t.corner[next(side)] != vertex - 1) ++side;
        split_side(triangle, side, vertex);
        legalise();
        triangle = *std::find_if(star_.begin(), star_.end(), [&](std::uint32_t s) {
            return triangles_[s].corner[2] == corner && triangles_[s].beyond[2] == kNone;
        });
    }
}

std::uint32_t DelaunayMesh::hull_triangle(std::uint32_t from, std::uint32_t to) const {
    const auto has_side = [&](const Triangle& t) {
        for (int k = 0; k < 3; ++k)
            if (t.corner[k] == from && t.corner[next(k)] == to) return true;
        return false;
    };
    return static_cast<std::uint32_t>(std::find_if(triangles_.begin(), triangles_.end(), has_side) - triangles_.begin());
}

std::uint32_t DelaunayMesh::locate(MeshPost post, std::uint32_t start) const {
    // In a Delaunay triangulation a walk over sides that see the post ends (Edelsbrunner, Combinatorica 10(3), 1990).
    std::uint32_t at = start, on_side = kNone;
    for (int k = 0; k < 3;) {
        const std::int64_t side = turn(corner(at, k), corner(at, next(k)), post);
        if (side < 0) {
            at = triangles_[at].beyond[k];
            on_side = kNone;
            k = 0;
            continue;
        }
        if (side == 0) on_side = triangles_[at].beyond[k];
        ++k;
    }
    return std::min(at, on_side);
}

std::uint32_t DelaunayMesh::insert(MeshPost post, std::uint32_t triangle) {
    const auto vertex = static_cast<std::uint32_t>(vertices_.size());
    vertices_.push_back(post);
    int side = 0;
    while (side < 3 && turn(corner(triangle, side), corner(triangle, next(side)), post) != 0) ++side;
    if (side < 3)
        split_side(triangle, side, vertex);
    else
        split_inside(triangle, vertex);
    legalise();
    return vertex;
}

void DelaunayMesh::split_inside(std::uint32_t triangle, std::uint32_t p) {
    const Triangle old = triangles_[triangle];
    const auto second = static_cast<std::uint32_t>(triangles_.size()), third = second + 1;
    const auto [a, b, c] = old.corner;
    triangles_[triangle] = {{p, a, b}, {third, old.beyond[0], second}};
    triangles_.push_back({{p, b, c}, {triangle, old.beyond[1], third}});
    triangles_.push_back({{p, c, a}, {second, old.beyond[2], triangle}});
    relink(old.beyond[1], triangle, second);
    relink(old.beyond[2], triangle, third);
    star_ = open_ = {triangle, second, third};
}

void DelaunayMesh::split_side(std::uint32_t triangle, int side, std::uint32_t p) {
    const Triangle old = triangles_[triangle];
    const std::uint32_t a = old.corner[side], b = old.corner[next(side)], c = old.corner[previous(side)];
    const std::uint32_t beyond_bc = old.beyond[next(side)], beyond_ca = old.beyond[previous(side)];
    const std::uint32_t other = old.beyond[side];
    const auto second = static_cast<std::uint32_t>(triangles_.size()), other_second = other == kNone ? kNone : second + 1;
    triangles_[triangle] = {{p, b, c}, {other_second, beyond_bc, second}};
    triangles_.push_back({{p, c, a}, {triangle, beyond_ca, other}});
    relink(beyond_ca, triangle, second);
    star_ = open_ = {triangle, second};
    if (other == kNone) return;
    const Triangle opposite = triangles_[other];
    const int back = side_towards(other, triangle);
    const std::uint32_t d = opposite.corner[previous(back)];
    const std::uint32_t beyond_ad = opposite.beyond[next(back)], beyond_db = opposite.beyond[previous(back)];
    triangles_[other] = {{p, a, d}, {second, beyond_ad, other_second}};
    triangles_.push_back({{p, d, b}, {other, beyond_db, triangle}});
    relink(beyond_db, other, other_second);
    star_.insert(star_.end(), {other, other_second});
    open_ = star_;
}

/// Flips sides opposite the new vertex until all are Delaunay; every flip brings one more triangle to the star.
void DelaunayMesh::legalise() {
    while (!open_.empty()) {
        const std::uint32_t triangle = open_.back();
        const Triangle& t = triangles_[triangle];
        const std::uint32_t other = t.beyond[1];
        open_.pop_back();
        if (other == kNone) continue;
        const int back = side_towards(other, triangle);
        if (!must_flip(t.corner[0], t.corner[1], t.corner[2], triangles_[other].corner[previous(back)])) continue;
        flip(triangle, other, back);
        star_.push_back(other);
        open_.insert(open_.end(), {triangle, other});
    }
}

/// Whether d lies in the circle through p, a, b: the angles at p and d over the side ab exceed two right angles. No product
/// exceeds 2^62, for dot and cross product of two sides are at most 2^31.
bool DelaunayMesh::must_flip(std::uint32_t p, std::uint32_t a, std::uint32_t b, std::uint32_t d) const {
    const MeshPost vp = vertices_[p], va = vertices_[a], vb = vertices_[b], vd = vertices_[d];
    const std::int64_t sine = turn(vp, va, vb) * dot(vd, vb, va) + dot(vp, va, vb) * turn(vd, vb, va);
    return sine < 0 || (sine == 0 && slant(vp, vd) < slant(va, vb));
}

void DelaunayMesh::flip(std::uint32_t triangle, std::uint32_t other, int back) {
    const Triangle t = triangles_[triangle], o = triangles_[other];
    const std::uint32_t p = t.corner[0], a = t.corner[1], b = t.corner[2], d = o.corner[previous(back)];
    const std::uint32_t beyond_ad = o.beyond[next(back)], beyond_db = o.beyond[previous(back)];
    triangles_[triangle] = {{p, a, d}, {t.beyond[0], beyond_ad, other}};
    triangles_[other] = {{p, d, b}, {triangle, beyond_db, t.beyond[2]}};
    relink(beyond_ad, other, triangle);
    relink(t.beyond[2], triangle, other);
}

int DelaunayMesh::side_towards(std::uint32_t triangle, std::uint32_t neighbour) const {
    const Triangle& t = triangles_[triangle];
    return t.beyond[0] == neighbour ? 0 : t.beyond[1] == neighbour ? 1 : 2;
}

void DelaunayMesh::relink(std::uint32_t triangle, std::uint32_t before, std::uint32_t now) {
    if (triangle != kNone) triangles_[triangle].beyond[side_towards(triangle, before)] = now;
}

}  // namespace tedavis::host_sim
