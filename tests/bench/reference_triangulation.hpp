/// What greedy insertion makes of a whole raster at once, without chunks and borders: the mesh that terrain is compared with.
///
/// Garland and Heckbert's algorithm (CMU-CS-95-181, 1995) by a way of its own: cavities (Bowyer, Watson, The Computer Journal
/// 24(2), 1981) instead of flips, and triangles drawn row by row instead of lists of posts. Shares no code with host_sim.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace tedavis::bench {

struct FieldPost {
    std::int32_t i = 0, j = 0;

    [[nodiscard]] bool operator==(const FieldPost& o) const { return i == o.i && j == o.j; }
};

/// Heights row by row. Posts that are not valid have no error, but must be seen: a triangle over some of them gets one as a
/// corner before anything else is refined, as chunks do it.
struct HeightField {
    std::int32_t columns = 0, rows = 0;
    std::vector<float> height_m;
    std::vector<std::uint8_t> valid;

    [[nodiscard]] std::size_t at(std::int32_t i, std::int32_t j) const {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i);
    }
    [[nodiscard]] std::size_t at(FieldPost post) const { return at(post.i, post.j); }
};

/// Positive when a, b, c turn clockwise seen from above (j runs south).
[[nodiscard]] inline std::int64_t cross(FieldPost a, FieldPost b, FieldPost c) {
    return std::int64_t{b.i - a.i} * (c.j - a.j) - std::int64_t{b.j - a.j} * (c.i - a.i);
}

struct WorstPost {
    double error_m = 0;
    FieldPost post;
};

/// Calls f with every post in a triangle and on its sides; the corners have an area and either winding.
template <class F>
void for_posts(FieldPost a, FieldPost b, FieldPost c, F f) {
    for (std::int32_t j = std::min({a.j, b.j, c.j}); j <= std::max({a.j, b.j, c.j}); ++j) {
        double first = std::numeric_limits<double>::max(), last = -1;
        for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}}) {
            if (p.j == q.j || j < std::min(p.j, q.j) || j > std::max(p.j, q.j)) continue;
            const double i = p.i + static_cast<double>(q.i - p.i) * (j - p.j) / (q.j - p.j);
            first = std::min(first, i);
            last = std::max(last, i);
        }
        // A quotient of whole numbers below 2^20 that is not whole itself is further from one than this.
        for (auto i = static_cast<std::int32_t>(std::ceil(first - 1e-7)); i <= last + 1e-7; ++i) f(FieldPost{i, j});
    }
}

/// Of the valid posts in a triangle.
[[nodiscard]] inline WorstPost worst_post(const HeightField& field, FieldPost a, FieldPost b, FieldPost c) {
    WorstPost worst;
    const auto area = static_cast<double>(cross(a, b, c));
    if (area == 0) return worst;
    const double za = field.height_m[field.at(a)], zb = field.height_m[field.at(b)] - za, zc = field.height_m[field.at(c)] - za;
    const double per_i = (zb * (c.j - a.j) - zc * (b.j - a.j)) / area, per_j = (zc * (b.i - a.i) - zb * (c.i - a.i)) / area;
    for_posts(a, b, c, [&](FieldPost post) {
        const double error = std::abs(za + per_i * (post.i - a.i) + per_j * (post.j - a.j) - field.height_m[field.at(post)]);
        if (error > worst.error_m && field.valid[field.at(post)] != 0) worst = {error, post};
    });
    return worst;
}

/// The void post nearest to the middle of a triangle that has some, but none at its corners, infinitely wrong. Error 0: it is
/// not such a triangle.
[[nodiscard]] inline WorstPost hidden_void(const HeightField& field, FieldPost a, FieldPost b, FieldPost c) {
    WorstPost hidden;
    for (const FieldPost corner : {a, b, c})
        if (field.valid[field.at(corner)] == 0) return hidden;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for_posts(a, b, c, [&](FieldPost post) {
        if (field.valid[field.at(post)] != 0) return;
        const std::int64_t di = 3 * std::int64_t{post.i} - a.i - b.i - c.i, dj = 3 * std::int64_t{post.j} - a.j - b.j - c.j;
        if (di * di + dj * dj >= least) return;
        least = di * di + dj * dj;
        hidden = {std::numeric_limits<double>::infinity(), post};
    });
    return hidden;
}

class ReferenceTriangulation {
public:
    /// The field must live as long.
    explicit ReferenceTriangulation(const HeightField& field)
        : field_(field), has_voids_(std::find(field.valid.begin(), field.valid.end(), 0) != field.valid.end()) {
        const FieldPost nw{0, 0}, ne{field.columns - 1, 0}, sw{0, field.rows - 1}, se{field.columns - 1, field.rows - 1};
        triangles_ = {{{nw, ne, se}, {-1, -1, 1}}, {{nw, se, sw}, {0, -1, -1}}};
        change_.assign(2, 0);
        measure(0);
        measure(1);
    }

    /// Inserts the worst post until none is further off; the count of triangles then. Tolerances may only fall.
    std::size_t refine(double tolerance_m) {
        while (!open_.empty() && open_.top().worst.error_m > tolerance_m) {
            const Open next = open_.top();
            open_.pop();
            if (next.change == change_[static_cast<std::size_t>(next.triangle)]) insert(next.worst.post, next.triangle);
        }
        return triangles_.size();
    }

private:
    /// Clockwise seen from above; neighbour k lies beyond the side from corner k to the next, -1 outside.
    struct Triangle {
        FieldPost corner[3];
        std::int32_t neighbour[3];
    };
    struct Side {
        FieldPost a, b;
        std::int32_t beyond;
    };
    struct Open {
        WorstPost worst;
        std::int32_t triangle;
        std::uint32_t change;

        bool operator<(const Open& o) const { return worst.error_m < o.worst.error_m; }
    };
    __extension__ using Wide = __int128;

    [[nodiscard]] Triangle& at(std::int32_t t) { return triangles_[static_cast<std::size_t>(t)]; }

    [[nodiscard]] static bool in_circle(const Triangle& t, FieldPost d) {
        Wide x[3], y[3], s[3];
        for (int k = 0; k < 3; ++k) {
            x[k] = t.corner[k].i - d.i;
            y[k] = t.corner[k].j - d.j;
            s[k] = x[k] * x[k] + y[k] * y[k];
        }
        return s[0] * (x[1] * y[2] - y[1] * x[2]) - s[1] * (x[0] * y[2] - y[0] * x[2]) + s[2] * (x[0] * y[1] - y[0] * x[1]) > 0;
    }

    /// All triangles whose circles hold the post give way to a fan round it.
    void insert(FieldPost post, std::int32_t home) {
        cavity_.assign(1, home);
        rim_.clear();
        for (std::size_t n = 0; n < cavity_.size(); ++n) {
            const Triangle t = at(cavity_[n]);
            for (int k = 0; k < 3; ++k) {
                const std::int32_t beyond = t.neighbour[k];
                if (std::find(cavity_.begin(), cavity_.end(), beyond) != cavity_.end()) continue;
                if (beyond >= 0 && in_circle(at(beyond), post))
                    cavity_.push_back(beyond);
                else
                    rim_.push_back({t.corner[k], t.corner[(k + 1) % 3], beyond});
            }
        }
        // On the raster's side the post lies on the rim itself.
        rim_.erase(std::remove_if(rim_.begin(), rim_.end(), [&](const Side& s) { return cross(s.a, s.b, post) == 0; }),
                   rim_.end());
        fill(post);
    }

    void fill(FieldPost post) {
        for (std::size_t n = 0; n < rim_.size(); ++n) {
            if (n == cavity_.size()) {
                cavity_.push_back(static_cast<std::int32_t>(triangles_.size()));
                triangles_.push_back({});
                change_.push_back(0);
            }
            const Side& side = rim_[n];
            at(cavity_[n]) = {{side.a, side.b, post}, {side.beyond, -1, -1}};
            if (side.beyond < 0) continue;
            Triangle& outer = at(side.beyond);
            for (int k = 0; k < 3; ++k)
                if (outer.corner[k] == side.b && outer.corner[(k + 1) % 3] == side.a) outer.neighbour[k] = cavity_[n];
        }
        for (std::size_t n = 0; n < rim_.size(); ++n)
            for (std::size_t m = 0; m < rim_.size(); ++m)
                if (rim_[n].b == rim_[m].a) {
                    at(cavity_[n]).neighbour[1] = cavity_[m];
                    at(cavity_[m]).neighbour[2] = cavity_[n];
                }
        for (std::size_t n = 0; n < rim_.size(); ++n) measure(cavity_[n]);
    }

    void measure(std::int32_t t) {
        const Triangle& triangle = at(t);
        const std::uint32_t change = ++change_[static_cast<std::size_t>(t)];
        const auto& [a, b, c] = triangle.corner;
        WorstPost worst;
        if (has_voids_) worst = hidden_void(field_, a, b, c);
        if (worst.error_m == 0) worst = worst_post(field_, a, b, c);
        if (worst.error_m > 0) open_.push({worst, t, change});
    }

    const HeightField& field_;
    const bool has_voids_;
    std::vector<Triangle> triangles_;
    std::vector<std::uint32_t> change_;  // of a triangle, so that an old measurement is known as such
    std::priority_queue<Open> open_;
    std::vector<std::int32_t> cavity_;
    std::vector<Side> rim_;
};

}  // namespace tedavis::bench
