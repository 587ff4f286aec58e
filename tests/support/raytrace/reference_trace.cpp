#include "tests/support/raytrace/reference_trace.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::test_support {
namespace {

using raytrace::CellSurface;
using raytrace::HeightGrid;
using raytrace::HitSide;
using raytrace::Ray;
using Real = long double;

constexpr Real kNever = std::numeric_limits<Real>::infinity();
constexpr Real kFarOff = 64;  ///< height steps above or below all posts

Real component(float value) { return std::abs(value) < 1e-30F ? 1e-30L : Real{value}; }

struct Straight {
    Real x, y, z, dx, dy, dz;
    explicit Straight(const Ray& ray)
        : x(ray.origin.x),
          y(ray.origin.y),
          z(ray.origin.z),
          dx(component(ray.direction.x)),
          dy(component(ray.direction.y)),
          dz(component(ray.direction.z)) {}
};

struct Span {
    Real begin, end;
    /// Keeps what lies between two values of origin + t * rate.
    void clip(Real origin, Real rate, Real low, Real high) {
        const Real a = (low - origin) / rate, b = (high - origin) / rate;
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
};

/// The whole numbers that a coordinate goes through.
class Lines {
public:
    Lines(Real origin, Real rate, Real begin) : origin_(origin), inverse_(1 / rate), step_(rate > 0 ? 1 : -1) {
        const Real at = origin + rate * begin;
        index_ = static_cast<std::int64_t>(rate < 0 ? std::ceil(at) - 1 : std::floor(at));
        is_still_ = rate == 0;
        set_next();
    }
    [[nodiscard]] std::int64_t index() const { return index_; }  ///< the coordinate lies between this and the next number
    [[nodiscard]] Real next() const { return next_; }            ///< when it reaches the next one
    void advance() {
        index_ += step_;
        set_next();
    }

private:
    void set_next() { next_ = is_still_ ? kNever : (static_cast<Real>(step_ > 0 ? index_ + 1 : index_) - origin_) * inverse_; }

    Real origin_, inverse_, next_ = kNever;
    std::int64_t index_ = 0, step_;
    bool is_still_ = false;
};

struct Cell {
    std::int64_t column = 0, row = 0;
    bool is_upper = false;  ///< the half at the post (column + 1, row + 1)
    bool has_surface = false;
    Real h00 = 0, h10 = 0, h01 = 0, h11 = 0;

    [[nodiscard]] Real range() const {
        return std::max(std::max(h00, h10), std::max(h01, h11)) - std::min(std::min(h00, h10), std::min(h01, h11));
    }
    [[nodiscard]] Real height(Real x, Real y, CellSurface surface) const {
        const Real u = x - static_cast<Real>(column), v = y - static_cast<Real>(row);
        if (surface == CellSurface::bilinear) return (h00 * (1 - u) + h10 * u) * (1 - v) + (h01 * (1 - u) + h11 * u) * v;
        return is_upper ? h11 + (1 - u) * (h01 - h11) + (1 - v) * (h10 - h11) : h00 + u * (h10 - h00) + v * (h01 - h00);
    }
};

/// What is known of the height over the surface up to now.
class Profile {
public:
    Profile(const Straight& line, FromBelow from_below) : line_(line), from_below_(from_below) {
        hit.clearance = hit.margin = kNever;
    }

    void begin(Real t, Real over, const Cell& cell) {
        is_above_ = over > 0;
        trend_ = 0;
        is_open_ = true;
        note(t, over, cell.range());
        is_complete_ = !is_above_ && from_below_ == FromBelow::ends;
    }
    void end(Real t, Real over) {
        if (is_open_) note(t, over, last_range_);
        is_open_ = false;
    }
    /// A piece on which the function rises, or falls, or neither. `root` gives where it is zero.
    template <class Root>
    void add(Real t, Real over_begin, Real t_end, Real over_end, const Cell& cell, const Root& root) {
        const int trend = (over_end > over_begin) - (over_end < over_begin);
        if (trend * trend_ < 0) note(t, over_begin, std::max(cell.range(), last_range_));
        if (trend != 0) trend_ = trend;
        const Real range = std::max(cell.range(), last_range_);
        last_range_ = cell.range();
        if (hit.side != HitSide::none || is_above_ == (over_end > 0)) return;
        is_above_ = !is_above_;
        if (is_above_ && from_below_ == FromBelow::passes) return;
        hit.side = is_above_ ? HitSide::below : HitSide::above;
        hit.t = root();
        hit.t_scale = scale_at(hit.t, range) * (t_end - t) / std::abs(over_end - over_begin);
        hit.column = static_cast<std::uint32_t>(cell.column);
        hit.row = static_cast<std::uint32_t>(cell.row);
    }
    [[nodiscard]] bool is_open() const { return is_open_; }
    [[nodiscard]] bool is_complete() const { return is_complete_; }

    ReferenceHit hit;

private:
    /// The size of the numbers from which a height over the surface is made.
    [[nodiscard]] Real scale_at(Real t, Real range) const {
        const Real way = 1 + std::abs(t) * (std::abs(line_.dx) + std::abs(line_.dy));
        return 1 + std::abs(t * line_.dz) + way * range;
    }
    void note(Real t, Real over, Real range) {
        hit.clearance = std::min(hit.clearance, std::abs(over));
        hit.margin = std::min(hit.margin, std::abs(over) / scale_at(t, range));
        is_complete_ = hit.side != HitSide::none;  // only now: how deep a ray goes tells whether it could as well have missed
    }

    const Straight& line_;
    FromBelow from_below_;
    bool is_above_ = false, is_open_ = false, is_complete_ = false;
    int trend_ = 0;
    Real last_range_ = 0;
};

template <class Height>
class Walk {
public:
    Walk(const HeightGrid<Height>& grid, CellSurface surface, const Straight& line, const Span& span, FromBelow from_below)
        : grid_(grid),
          surface_(surface),
          line_(line),
          span_(span),
          columns_(line.x, line.dx, span.begin),
          rows_(line.y, line.dy, span.begin),
          diagonals_(line.x + line.y, line.dx + line.dy, span.begin),
          profile_(line, from_below) {}

    ReferenceHit run() {
        Real t = span_.begin;
        while (!profile_.is_complete()) {
            const Real diagonal = surface_ == CellSurface::two_triangles ? diagonals_.next() : kNever;
            const Real next = std::min(std::min(columns_.next(), rows_.next()), diagonal);
            const Real end = std::min(next, span_.end);
            if (end > t) pass(t, end);
            t = std::max(t, end);
            if (next >= span_.end) break;
            if (columns_.next() == next) {
                columns_.advance();
            } else if (rows_.next() == next) {
                rows_.advance();
            } else {
                diagonals_.advance();
            }
        }
        if (!profile_.is_complete()) profile_.end(t, last_over_);
        return profile_.hit;
    }

private:
    [[nodiscard]] Real over(Real t, const Cell& cell) const {
        return line_.z + t * line_.dz - cell.height(line_.x + t * line_.dx, line_.y + t * line_.dy, surface_);
    }
    [[nodiscard]] Cell cell_here() const {
        Cell cell;
        cell.column = columns_.index();
        cell.row = rows_.index();
        cell.is_upper = diagonals_.index() > cell.column + cell.row;
        if (cell.column < 0 || cell.row < 0 || cell.column + 1 >= grid_.columns || cell.row + 1 >= grid_.rows) return cell;
        const Height* const upper = grid_.row(static_cast<std::uint32_t>(cell.row)) + cell.column;
        const Height* const lower = upper + grid_.stride;
        constexpr Height none = HeightGrid<Height>::kVoid;
        cell.has_surface = upper[0] != none && upper[1] != none && lower[0] != none && lower[1] != none;
        cell.h00 = upper[0];
        cell.h10 = upper[1];
        cell.h01 = lower[0];
        cell.h11 = lower[1];
        return cell;
    }
    void pass(Real begin, Real end) {
        const Cell cell = cell_here();
        if (!cell.has_surface) {
            profile_.end(begin, last_over_);
            return;
        }
        const Real over_begin = over(begin, cell), over_end = over(end, cell);
        if (!profile_.is_open()) profile_.begin(begin, over_begin, cell);
        if (profile_.is_complete()) return;
        if (surface_ == CellSurface::two_triangles) {
            profile_.add(begin, over_begin, end, over_end, cell,
                         [&] { return begin + (end - begin) * over_begin / (over_begin - over_end); });
        } else {
            pass_patch(begin, over_begin, end, over_end, cell);
        }
        last_over_ = over_end;
    }
    void pass_patch(Real begin, Real over_begin, Real end, Real over_end, const Cell& cell) {
        const Real over_middle = over((begin + end) / 2, cell);
        const Real a = 2 * (over_begin - 2 * over_middle + over_end), b = 4 * over_middle - 3 * over_begin - over_end;
        const Real turn = -b / (2 * a);
        if (!(turn > 0 && turn < 1)) {
            add_bent(begin, over_begin, end, over_end, cell);
            return;
        }
        const Real middle = begin + turn * (end - begin), over_turn = over(middle, cell);
        add_bent(begin, over_begin, middle, over_turn, cell);
        if (!profile_.is_complete()) add_bent(middle, over_turn, end, over_end, cell);
    }
    void add_bent(Real begin, Real over_begin, Real end, Real over_end, const Cell& cell) {
        profile_.add(begin, over_begin, end, over_end, cell, [&] { return bisected(begin, over_begin > 0, end, cell); });
    }
    [[nodiscard]] Real bisected(Real low, bool is_above, Real high, const Cell& cell) const {
        for (int n = 0; n < 80; ++n) {
            const Real middle = (low + high) / 2;
            ((over(middle, cell) > 0) == is_above ? low : high) = middle;
        }
        return (low + high) / 2;
    }

    const HeightGrid<Height>& grid_;
    CellSurface surface_;
    const Straight& line_;
    Span span_;
    Lines columns_, rows_, diagonals_;
    Profile profile_;
    Real last_over_ = 0;
};

}  // namespace

template <class Height>
ReferenceTracer<Height>::ReferenceTracer(const HeightGrid<Height>& grid, CellSurface surface)
    : grid_(grid), surface_(surface), lowest_(kNever), highest_(-kNever) {
    for (std::uint32_t row = 0; row < grid.rows; ++row) {
        for (std::uint32_t column = 0; column < grid.columns; ++column) {
            const Height height = grid.at(column, row);
            if (height == HeightGrid<Height>::kVoid) continue;
            lowest_ = std::min(lowest_, static_cast<Real>(height));
            highest_ = std::max(highest_, static_cast<Real>(height));
        }
    }
}

template <class Height>
ReferenceHit ReferenceTracer<Height>::trace(const Ray& ray, FromBelow from_below) const {
    const Straight line(ray);
    Span span{ray.from, ray.to};
    span.clip(line.x, line.dx, 0, Real(grid_.columns - 1));
    span.clip(line.y, line.dy, 0, Real(grid_.rows - 1));
    if (lowest_ <= highest_) span.clip(line.z, line.dz, lowest_ - kFarOff, highest_ + kFarOff);
    if (!(span.begin <= span.end) || lowest_ > highest_) {
        ReferenceHit nothing;
        nothing.clearance = nothing.margin = kNever;
        return nothing;
    }
    return Walk<Height>(grid_, surface_, line, span, from_below).run();
}

template class ReferenceTracer<std::int16_t>;
template class ReferenceTracer<float>;

}  // namespace tedavis::test_support
