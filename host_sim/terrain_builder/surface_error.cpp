#include "host_sim/terrain_builder/surface_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tedavis::host_sim {
namespace {

using terrain::PostClass;

/// A corner relative to the window.
struct Corner {
    std::int32_t i, j;
    double surface_m;
};

struct Fraction {
    std::int32_t whole, rest;  // value = whole + rest / divisor, 0 <= rest < divisor
};

Fraction divide(std::int32_t dividend, std::int32_t divisor) {
    const std::int32_t quotient = dividend / divisor, rest = dividend % divisor;
    return rest < 0 ? Fraction{quotient - 1, rest + divisor} : Fraction{quotient, rest};
}

/// The lines that the true surface is folded along. A post is named by its line and its index on the line.
enum class Folds { rows, columns, diagonals };

struct OnLine {
    std::int32_t line, index;
};

template <Folds folds>
constexpr OnLine on_line(std::int32_t i, std::int32_t j) {
    if (folds == Folds::rows) return {j, i};
    if (folds == Folds::columns) return {i, j};
    return {i + j, i};
}

/// Lattice coordinates relative to the window.
struct Place {
    double i, j;
};

template <Folds folds>
constexpr Place place_of(double line, double index) {
    if (folds == Folds::rows) return {index, line};
    if (folds == Folds::columns) return {line, index};
    return {index, line - index};
}

struct Extreme {
    double difference = 0;  // drawn minus true
    Place place{};
};

class ErrorScan {
public:
    ErrorScan(const PostWindowView& posts, const Corner (&corners)[3])
        : posts_(posts),
          columns_(static_cast<std::int32_t>(posts.columns)),
          rows_(static_cast<std::int32_t>(posts.rows)),
          corners_(corners) {
        highest_.place = lowest_.place = {static_cast<double>(corners[0].i), static_cast<double>(corners[0].j)};
    }

    [[nodiscard]] PlacedError run(double area) {
        look_for_voids();
        scan_posts(area);
        for (int k = 0; k < 3; ++k) {
            const Corner &p = corners_[k], &q = corners_[(k + 1) % 3];
            scan_side<Folds::rows>(p, q, rows_);
            scan_side<Folds::columns>(p, q, columns_);
            scan_side<Folds::diagonals>(p, q, rows_ + columns_);
        }
        const SignedError error{highest_.difference, std::abs(lowest_.difference)};
        const Place place = error.above_m >= error.below_m ? highest_.place : lowest_.place;
        return {error, place.i + static_cast<double>(posts_.i0), place.j + static_cast<double>(posts_.j0)};
    }

private:
    struct Range {
        std::int32_t first, last;
    };

    [[nodiscard]] std::size_t at(std::int32_t i, std::int32_t j) const {
        return static_cast<std::size_t>(j) * posts_.columns + static_cast<std::size_t>(i);
    }
    [[nodiscard]] bool is_valid(std::size_t post) const { return posts_.post_class[post] < PostClass::void_; }
    /// By its north-west post.
    [[nodiscard]] bool has_cell(std::int32_t i, std::int32_t j) const {
        if (i < 0 || j < 0 || i + 1 >= columns_ || j + 1 >= rows_) return false;
        const std::size_t north = at(i, j), south = at(i, j + 1);
        return is_valid(north) && is_valid(north + 1) && is_valid(south) && is_valid(south + 1);
    }
    [[nodiscard]] bool touches_cell(std::int32_t i, std::int32_t j) const {
        return has_cell(i, j) || has_cell(i - 1, j) || has_cell(i, j - 1) || has_cell(i - 1, j - 1);
    }

    /// Most triangles lie inside the window, and none of the cells round them has a void corner: then all of it counts.
    void look_for_voids() {
        const auto [a, b, c] = corners_;
        const std::int32_t west = std::min({a.i, b.i, c.i}), east = std::max({a.i, b.i, c.i});
        const std::int32_t north = std::min({a.j, b.j, c.j}), south = std::max({a.j, b.j, c.j});
        whole_ = west >= 0 && north >= 0 && east < columns_ && south < rows_;
        for (std::int32_t j = north; whole_ && j <= south; ++j) {
            const PostClass* begin = posts_.post_class + at(west, j);
            const auto bytes = static_cast<std::size_t>(east - west + 1);
            whole_ = std::memchr(begin, static_cast<int>(PostClass::void_), bytes) == nullptr &&
                     std::memchr(begin, static_cast<int>(PostClass::outside), bytes) == nullptr;
        }
    }

    void include(double difference, Place place) {
        if (difference > highest_.difference) highest_ = {difference, place};
        if (difference < lowest_.difference) lowest_ = {difference, place};
    }

    void scan_posts(double area) {
        const auto [a, b, c] = corners_;
        const double hb = b.surface_m - a.surface_m, hc = c.surface_m - a.surface_m;
        const double per_i = (hb * (c.j - a.j) - hc * (b.j - a.j)) / area;
        const double per_j = (hc * (b.i - a.i) - hb * (c.i - a.i)) / area;
        const std::int32_t last = std::min(std::max({a.j, b.j, c.j}), rows_ - 1);
        for (std::int32_t j = std::max(std::min({a.j, b.j, c.j}), 0); j <= last; ++j) {
            const Range range = row_range(j);
            if (range.first <= range.last) scan_row(j, range, a.surface_m + per_j * (j - a.j) - per_i * a.i, per_i);
        }
    }

    /// Columns that a row cuts from the triangle, inside the window.
    [[nodiscard]] Range row_range(std::int32_t j) const {
        Range range{columns_, -1};
        for (int k = 0; k < 3; ++k) {
            const Corner *p = &corners_[k], *q = &corners_[(k + 1) % 3];
            if (p->j > q->j) std::swap(p, q);
            if (p->j == q->j || j < p->j || j > q->j) continue;
            const Fraction cut = divide((q->i - p->i) * (j - p->j), q->j - p->j);
            range.first = std::min(range.first, p->i + cut.whole + (cut.rest != 0 ? 1 : 0));
            range.last = std::max(range.last, p->i + cut.whole);
        }
        return {std::max(range.first, 0), std::min(range.last, columns_ - 1)};
    }

    void scan_row(std::int32_t j, Range range, double height_at_zero, double per_i) {
        const float* surface = posts_.surface_m + at(0, j);
        const auto difference = [&](std::int32_t i) { return height_at_zero + per_i * i - surface[i]; };
        double highest = highest_.difference, lowest = lowest_.difference;
        for (std::int32_t i = range.first; whole_ && i <= range.last; ++i) {
            highest = std::max(highest, difference(i));
            lowest = std::min(lowest, difference(i));
        }
        if (whole_ && highest == highest_.difference && lowest == lowest_.difference) return;
        for (std::int32_t i = range.first; i <= range.last; ++i)
            if (whole_ || touches_cell(i, j)) include(difference(i), {static_cast<double>(i), static_cast<double>(j)});
    }

    /// Where a side crosses folds between posts. Crossings at posts are visited as posts.
    template <Folds folds>
    void scan_side(const Corner& a, const Corner& b, std::int32_t lines) {
        const bool turned = on_line<folds>(a.i, a.j).line > on_line<folds>(b.i, b.j).line;
        const Corner &from = turned ? b : a, &to = turned ? a : b;
        const OnLine p = on_line<folds>(from.i, from.j), q = on_line<folds>(to.i, to.j);
        const std::int32_t length = q.line - p.line, first = std::max(p.line + 1, 0), last = std::min(q.line, lines) - 1;
        if (first > last) return;
        const Fraction step = divide(q.index - p.index, length);
        if (step.rest == 0) return;
        Fraction cut = divide((q.index - p.index) * (first - p.line), length);
        const double part = 1.0 / length, climb_m = (to.surface_m - from.surface_m) * part;
        for (std::int32_t line = first; line <= last; ++line, cut = advanced(cut, step, length)) {
            const std::int32_t index = p.index + cut.whole;
            if (cut.rest == 0 || !(whole_ || touches_cell_between<folds>(line, index))) continue;
            const double before = surface_at<folds>(line, index), behind = surface_at<folds>(line, index + 1);
            const double share = cut.rest * part;
            const double difference = from.surface_m + climb_m * (line - p.line) - (before + (behind - before) * share);
            if (difference > highest_.difference || difference < lowest_.difference)
                include(difference, place_of<folds>(line, index + share));
        }
    }

    [[nodiscard]] static Fraction advanced(Fraction at, Fraction step, std::int32_t divisor) {
        const std::int32_t rest = at.rest + step.rest;
        return rest < divisor ? Fraction{at.whole + step.whole, rest} : Fraction{at.whole + step.whole + 1, rest - divisor};
    }

    template <Folds folds>
    [[nodiscard]] double surface_at(std::int32_t line, std::int32_t index) const {
        if (folds == Folds::rows) return posts_.surface_m[at(index, line)];
        if (folds == Folds::columns) return posts_.surface_m[at(line, index)];
        return posts_.surface_m[at(index, line - index)];
    }

    /// Of the places between two posts of a line.
    template <Folds folds>
    [[nodiscard]] bool touches_cell_between(std::int32_t line, std::int32_t index) const {
        if (folds == Folds::rows) return has_cell(index, line) || has_cell(index, line - 1);
        if (folds == Folds::columns) return has_cell(line, index) || has_cell(line - 1, index);
        return has_cell(index, line - index - 1);
    }

    const PostWindowView& posts_;
    const std::int32_t columns_, rows_;
    const Corner (&corners_)[3];
    bool whole_ = false;  // inside the window, no void in the rectangle round it
    Extreme highest_, lowest_;
};

}  // namespace

PlacedError placed_triangle_error(const PostWindowView& posts, const MeshCorner& a, const MeshCorner& b, const MeshCorner& c) {
    const auto relative = [&](const MeshCorner& corner) {
        return Corner{static_cast<std::int32_t>(corner.i - posts.i0), static_cast<std::int32_t>(corner.j - posts.j0),
                      corner.surface_m};
    };
    const Corner corners[3] = {relative(a), relative(b), relative(c)};
    const double area = static_cast<double>(b.i - a.i) * static_cast<double>(c.j - a.j) -
                        static_cast<double>(b.j - a.j) * static_cast<double>(c.i - a.i);
    if (area == 0) return {{}, static_cast<double>(a.i), static_cast<double>(a.j)};
    return ErrorScan(posts, corners).run(area);
}

SignedError triangle_error(const PostWindowView& posts, const MeshCorner& a, const MeshCorner& b, const MeshCorner& c) {
    return placed_triangle_error(posts, a, b, c).error;
}

}  // namespace tedavis::host_sim
