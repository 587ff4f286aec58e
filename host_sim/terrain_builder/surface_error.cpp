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

class ErrorScan {
public:
    ErrorScan(const PostWindowView& posts, const Corner (&corners)[3])
        : posts_(posts),
          columns_(static_cast<std::int32_t>(posts.columns)),
          rows_(static_cast<std::int32_t>(posts.rows)),
          corners_(corners) {}

    [[nodiscard]] SignedError run(double area) {
        scan_posts(area);
        for (int k = 0; k < 3; ++k) {
            const Corner &p = corners_[k], &q = corners_[(k + 1) % 3];
            scan_side<Folds::rows>(p, q, rows_);
            scan_side<Folds::columns>(p, q, columns_);
            scan_side<Folds::diagonals>(p, q, rows_ + columns_);
        }
        return {highest_, std::abs(lowest_)};
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

    void include(double difference) {
        highest_ = std::max(highest_, difference);
        lowest_ = std::min(lowest_, difference);
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
        const bool whole = is_whole(j, range);
        const float* surface = posts_.surface_m + at(0, j);
        double highest = highest_, lowest = lowest_;
        for (std::int32_t i = range.first; i <= range.last; ++i) {
            if (!whole && !touches_cell(i, j)) continue;
            const double difference = height_at_zero + per_i * i - surface[i];
            highest = std::max(highest, difference);
            lowest = std::min(lowest, difference);
        }
        highest_ = highest;
        lowest_ = lowest;
    }

    /// No post of the cells round the range is void: none of its posts needs a closer look.
    [[nodiscard]] bool is_whole(std::int32_t j, Range range) const {
        if (columns_ < 2 || rows_ < 2) return false;
        const std::int32_t west = std::max(range.first - 1, 0), east = std::min(range.last + 1, columns_ - 1);
        const auto bytes = static_cast<std::size_t>(east - west + 1);
        for (std::int32_t row = std::max(j - 1, 0); row <= std::min(j + 1, rows_ - 1); ++row)
            for (const PostClass none : {PostClass::void_, PostClass::outside})
                if (std::memchr(posts_.post_class + at(west, row), static_cast<int>(none), bytes) != nullptr) return false;
        return true;
    }

    /// Where a side crosses folds between posts. Crossings at posts are visited as posts.
    template <Folds folds>
    void scan_side(const Corner& a, const Corner& b, std::int32_t lines) {
        const bool turned = on_line<folds>(a.i, a.j).line > on_line<folds>(b.i, b.j).line;
        const Corner &from = turned ? b : a, &to = turned ? a : b;
        const OnLine p = on_line<folds>(from.i, from.j), q = on_line<folds>(to.i, to.j);
        const std::int32_t length = q.line - p.line;
        if (length == 0 || (q.index - p.index) % length == 0) return;
        for (std::int32_t line = std::max(p.line + 1, 0); line < std::min(q.line, lines); ++line) {
            const Fraction cut = divide((q.index - p.index) * (line - p.line), length);
            const std::int32_t index = p.index + cut.whole;
            if (cut.rest == 0 || !touches_cell_between<folds>(line, index)) continue;
            const double share = static_cast<double>(line - p.line) / length, part = static_cast<double>(cut.rest) / length;
            const double drawn = from.surface_m + (to.surface_m - from.surface_m) * share;
            const double before = surface_at<folds>(line, index), behind = surface_at<folds>(line, index + 1);
            include(drawn - (before + (behind - before) * part));
        }
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
    double highest_ = 0, lowest_ = 0;  // of drawn minus true
};

}  // namespace

SignedError triangle_error(const PostWindowView& posts, const MeshCorner& a, const MeshCorner& b, const MeshCorner& c) {
    const auto relative = [&](const MeshCorner& corner) {
        return Corner{static_cast<std::int32_t>(corner.i - posts.i0), static_cast<std::int32_t>(corner.j - posts.j0),
                      corner.surface_m};
    };
    const Corner corners[3] = {relative(a), relative(b), relative(c)};
    const double area = static_cast<double>(b.i - a.i) * static_cast<double>(c.j - a.j) -
                        static_cast<double>(b.j - a.j) * static_cast<double>(c.i - a.i);
    if (area == 0) return {};
    return ErrorScan(posts, corners).run(area);
}

}  // namespace tedavis::host_sim
