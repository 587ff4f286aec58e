#include "render_core/scene/outer_outline.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/scene/polygon_triangles.hpp"

namespace tedavis::scene {
namespace {

constexpr double kLongestTip = 2;  // of the side that it stands for

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Positive where c lies to the left of the way from a to b.
double side_of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) { return cross(b - a, c - a); }

bool is_between(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& on_line) {
    return glm::dot(on_line - a, on_line - b) <= 0;
}

/// Whether two stretches have a place in common, their ends included.
bool touch(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
    const double ca = side_of(c, d, a), cb = side_of(c, d, b), ac = side_of(a, b, c), ad = side_of(a, b, d);
    if (((ca > 0 && cb < 0) || (ca < 0 && cb > 0)) && ((ac > 0 && ad < 0) || (ac < 0 && ad > 0))) return true;
    return (ca == 0 && is_between(c, d, a)) || (cb == 0 && is_between(c, d, b)) || (ac == 0 && is_between(a, b, c)) ||
           (ad == 0 && is_between(a, b, d));
}

class Outline {
public:
    explicit Outline(base::Span<glm::dvec2> corners)
        : corners_(corners), count_(corners.size()), turn_(twice_area(corners) < 0 ? -1 : 1) {}

    [[nodiscard]] std::size_t count() const { return count_; }
    /// Twice.
    [[nodiscard]] double area() const { return std::fabs(twice_area({corners_.data(), count_})); }

    [[nodiscard]] bool crosses_itself() const {
        for (std::size_t n = 0; n < count_; ++n)
            for (std::size_t m = n + 2; m < count_; ++m)
                if ((m + 1) % count_ != n && touch(at(n), at(n + 1), at(m), at(m + 1))) return true;
        return false;
    }

    /// One step at the n-th corner, which may add so much to twice the area. Returns what it adds; negative: no step.
    double step(std::size_t n, double most) {
        const double filled = fill(n, most);
        return filled >= 0 ? filled : extend(n, most);
    }

private:
    [[nodiscard]] const glm::dvec2& at(std::size_t n) const { return corners_[n % count_]; }
    [[nodiscard]] double bend(std::size_t n) const { return turn_ * side_of(at(n + count_ - 1), at(n), at(n + 1)); }

    /// Whether a stretch touches none of the sides from the first-th corner on.
    [[nodiscard]] bool is_clear(const glm::dvec2& from, const glm::dvec2& to, std::size_t first, std::size_t sides) const {
        for (std::size_t n = first; n < first + sides; ++n)
            if (touch(from, to, at(n), at(n + 1))) return false;
        return true;
    }

    /// Leaves the n-th corner out where it bends inwards, or not at all.
    double fill(std::size_t n, double most) {
        const double added = -bend(n);
        if (!(added >= 0 && added <= most)) return -1;
        if (added == 0 && glm::dot(at(n) - at(n + count_ - 1), at(n + 1) - at(n)) < 0) return -1;  // a spike
        // All sides but the two that go and the two beside the new one, which share its ends.
        if (count_ > 4 && !is_clear(at(n + count_ - 1), at(n + 1), n + 2, count_ - 4)) return -1;
        remove(n);
        return added;
    }

    /// Leaves the side behind the n-th corner out where both its corners bend outwards.
    double extend(std::size_t n, double most) {
        const glm::dvec2 &before = at(n + count_ - 1), from = at(n), to = at(n + 1), &behind = at(n + 2);
        if (!(bend(n) > 0 && bend(n + 1) > 0)) return -1;
        const glm::dvec2 in = from - before, out = to - behind;
        const double meeting = -turn_ * cross(in, out);
        if (!(meeting > 0)) return -1;  // never, or on the other side
        const glm::dvec2 tip = from + in * (cross(to - from, out) / cross(in, out));
        const double added = std::fabs(side_of(from, to, tip));
        const bool is_spike = glm::distance(tip, 0.5 * (from + to)) > kLongestTip * glm::distance(from, to);
        if (!(added <= most) || is_spike) return -1;
        if (!is_clear(from, tip, n + 2, count_ - 3) || !is_clear(tip, to, n + 2, count_ - 3)) return -1;
        corners_[n % count_] = tip;
        remove((n + 1) % count_);
        return added;
    }

    void remove(std::size_t n) {
        for (std::size_t k = n % count_; k + 1 < count_; ++k) corners_[k] = corners_[k + 1];
        --count_;
    }

    base::Span<glm::dvec2> corners_;
    std::size_t count_;
    double turn_;  ///< 1: counter-clockwise
};

}  // namespace

std::size_t simplify_outwards(base::Span<glm::dvec2> corners, double most_growth) noexcept {
    Outline outline(corners);
    if (!(most_growth > 0) || corners.size() <= kFewestOutlineCorners || outline.crosses_itself()) return corners.size();
    double left = most_growth * outline.area();
    double most = std::ldexp(left, 1 - kOutlineRounds);
    for (int round = 0; round < kOutlineRounds; ++round, most *= 2) {
        // A corner that stays is passed, one that goes makes the outline shorter: no more steps than corners.
        for (std::size_t n = 0; n < outline.count() && outline.count() > kFewestOutlineCorners;) {
            const double added = outline.step(n, std::fmin(most, left));
            if (added >= 0)
                left -= added;
            else
                ++n;
        }
    }
    return outline.count();
}

}  // namespace tedavis::scene
