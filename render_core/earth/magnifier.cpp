#include "render_core/earth/magnifier.hpp"

#include <algorithm>
#include <cmath>

namespace tedavis::earth {
namespace {

constexpr double kRootOfHalf = 0.70710678118654752;
constexpr double kTangentOfEighth = 0.41421356237309505;  // of half a sector of an octagon
/// What is farther from the plane than that is on another side of the Earth.
constexpr double kFarthestFromPlane_m = 1e6;

/// Of the sectors of an octagon; a square has every other one.
constexpr double kAxes[Magnifier::kMaxSides][2] = {{1, 0},  {kRootOfHalf, kRootOfHalf},   {0, 1},  {-kRootOfHalf, kRootOfHalf},
                                                   {-1, 0}, {-kRootOfHalf, -kRootOfHalf}, {0, -1}, {kRootOfHalf, -kRootOfHalf}};

glm::dvec2 beside(const glm::dvec2& axis) { return {-axis.y, axis.x}; }

double tangent_of_half_sector(bool is_square) { return is_square ? 1 : kTangentOfEighth; }

/// From the middle to a corner, for an edge so far away.
double corner_of(double edge_m, double tangent) { return edge_m * std::sqrt(1 + tangent * tangent); }

double outer_edge_m(const MagnifierSettings& settings, std::uint32_t compression) {
    const double growth = std::ldexp(1.0, static_cast<int>(settings.power)) - 1;
    return settings.radius_m * (1 + growth / (1 - std::ldexp(1.0, -static_cast<int>(compression))));
}

bool is_in_range(const MagnifierSettings& settings) {
    return settings.power >= 1 && settings.power <= kMaxMagnifierPower && settings.radius_m >= Magnifier::kMinRadius_m &&
           std::isfinite(settings.latitude_rad) && std::isfinite(settings.longitude_rad);
}

/// In a sector's coordinates: `normal` inwards, of any length, from where it is 0.
glm::dvec3 edge(const glm::dvec2& axis, const glm::dvec2& normal, double offset_m) {
    const double length = glm::length(normal);
    const glm::dvec2 inwards = (axis * normal.x + beside(axis) * normal.y) / length;
    return {inwards, offset_m / length};
}

void repeat_first(std::array<glm::dvec3, Magnifier::kMaxSides>& edges, std::size_t used) {
    for (std::size_t n = used; n < edges.size(); ++n) edges[n] = edges[0];
}

}  // namespace

double Magnifier::context_needed_m(const MagnifierSettings& settings, std::uint32_t compression) {
    const double outer_m = outer_edge_m(settings, compression);
    // Distance from a square is counted along its axes, and corners of the octagon reach farther than its edges.
    return (settings.is_square ? outer_m : corner_of(outer_m, kTangentOfEighth)) - settings.radius_m;
}

bool Magnifier::make(const MagnifierSettings& settings, Magnifier& magnifier) {
    if (!is_in_range(settings)) return false;
    std::uint32_t compression = 1;
    while (compression <= kMaxCompression && !(context_needed_m(settings, compression) <= settings.context_m)) ++compression;
    if (compression > kMaxCompression) return false;
    Magnifier made;
    made.tangent_ = tangent_of_half_sector(settings.is_square);
    made.inner_m_ = settings.radius_m;
    made.outer_m_ = outer_edge_m(settings, compression);
    made.corner_m_ = corner_of(made.inner_m_, made.tangent_);
    made.reach_m_ = corner_of(made.outer_m_, made.tangent_);
    if (!(made.reach_m_ <= kFarthest_m)) return false;
    made.sides_ = settings.is_square ? kMaxSides / 2 : kMaxSides;
    made.power_ = settings.power;
    made.compression_ = compression;
    made.factor_ = std::ldexp(1.0, static_cast<int>(settings.power));
    made.shrink_ = std::ldexp(1.0, -static_cast<int>(compression));
    made.middle_ = to_ecef({settings.latitude_rad, settings.longitude_rad, {0}});
    const glm::dmat3 axes = north_east_down(settings.latitude_rad, settings.longitude_rad);
    made.north_ = axes[0];
    made.east_ = axes[1];
    made.up_ = -axes[2];
    magnifier = made;
    return true;
}

glm::dvec2 Magnifier::in_plane(const Ecef& place) const {
    const glm::dvec3 from = place - middle_;
    return {glm::dot(from, east_), glm::dot(from, north_)};
}

glm::dvec2 Magnifier::axis(std::size_t sector) const {
    const double(&axis)[2] = kAxes[sector * (kMaxSides / sides_)];
    return {axis[0], axis[1]};
}

/// A place lies in the sector whose edges are farthest out there.
Magnifier::Sector Magnifier::sector_of(const glm::dvec2& place) const {
    Sector best{axis(0), glm::dot(place, axis(0)), 0};
    for (std::size_t n = 1; n < sides_; ++n)
        if (const double out = glm::dot(place, axis(n)); out > best.out) best = {axis(n), out, 0};
    best.along = glm::dot(place, beside(best.axis));
    return best;
}

/// Half as wide as the triangle on the inner edge is there; all of the edge in the focus.
double Magnifier::half_base_m(double out) const {
    const double share = std::clamp((outer_m_ - out) / (outer_m_ - inner_m_), 0.0, 1.0);
    return inner_m_ * tangent_ * share;
}

glm::dvec2 Magnifier::moved(const glm::dvec2& ground) const {
    if (power_ == 0) return ground;
    const Sector at = sector_of(ground);
    if (!(at.out < outer_m_)) return ground;
    if (at.out <= inner_m_) return ground * factor_;
    const double half = half_base_m(at.out);
    const double out = factor_ * inner_m_ + shrink_ * (at.out - inner_m_);
    return at.axis * out + beside(at.axis) * (at.along + (factor_ - 1) * std::clamp(at.along, -half, half));
}

glm::dvec2 Magnifier::moved_back(const glm::dvec2& shown) const {
    if (power_ == 0) return shown;
    const Sector at = sector_of(shown);
    if (!(at.out < outer_m_)) return shown;
    if (at.out <= factor_ * inner_m_) return shown / factor_;
    const double out = inner_m_ + (at.out - factor_ * inner_m_) / shrink_;
    const double half = half_base_m(out);
    const double along =
        std::abs(at.along) <= factor_ * half ? at.along / factor_ : at.along - std::copysign((factor_ - 1) * half, at.along);
    return at.axis * out + beside(at.axis) * along;
}

double Magnifier::jacobian(const glm::dvec2& ground) const {
    if (power_ == 0) return 1;
    const Sector at = sector_of(ground);
    if (!(at.out < outer_m_)) return 1;
    if (at.out <= inner_m_) return factor_ * factor_;
    return shrink_ * (std::abs(at.along) <= half_base_m(at.out) ? factor_ : 1);
}

Ecef Magnifier::shifted(const Ecef& place, const glm::dvec2& from, const glm::dvec2& to) const {
    const glm::dvec2 by = to - from;
    if (by == glm::dvec2(0)) return place;
    return place + east_ * by.x + north_ * by.y;
}

Ecef Magnifier::moved(const Ecef& place) const {
    if (!(std::abs(glm::dot(place - middle_, up_)) < kFarthestFromPlane_m)) return place;
    const glm::dvec2 ground = in_plane(place);
    return shifted(place, ground, moved(ground));
}

Ecef Magnifier::moved_back(const Ecef& shown) const {
    if (!(std::abs(glm::dot(shown - middle_, up_)) < kFarthestFromPlane_m)) return shown;
    const glm::dvec2 ground = in_plane(shown);
    return shifted(shown, ground, moved_back(ground));
}

double Magnifier::Cell::inside_m(const glm::dvec2& ground) const {
    const glm::dvec3 at(ground, 1);
    double least = glm::dot(edges[0], at);
    for (const glm::dvec3& edge : edges) least = std::fmin(least, glm::dot(edge, at));
    return is_outside ? -least : least;
}

bool Magnifier::Cell::touches(const glm::dvec2& middle, const glm::dvec2& half) const {
    for (const glm::dvec3& edge : edges) {
        const double reach = std::abs(edge.x) * half.x + std::abs(edge.y) * half.y;
        const double at_middle = glm::dot(edge, glm::dvec3(middle, 1));
        if (is_outside && at_middle - reach <= 0) return true;
        if (!is_outside && at_middle + reach < 0) return false;
    }
    return !is_outside;
}

Magnifier::Cell Magnifier::cell(std::size_t n) const {
    const bool is_focus = n == 0;
    if (!is_focus && n + 1 < cell_count()) return triangle((n - 1) / kTrianglesOfSector, (n - 1) % kTrianglesOfSector);
    Cell cell;
    for (std::size_t side = 0; side < sides_; ++side)
        cell.edges[side] = edge(axis(side), {-1, 0}, is_focus ? inner_m_ : outer_m_);
    repeat_first(cell.edges, sides_);
    cell.is_outside = !is_focus;
    if (!is_focus) return cell;
    cell.slope = glm::dmat2(factor_);
    cell.borders = Borders::all;
    return cell;
}

/// 0 stands on the inner edge; of the others one lies on each side of it.
Magnifier::Cell Magnifier::triangle(std::size_t sector, std::size_t n) const {
    const glm::dvec2 out = axis(sector), along = beside(out);
    const double width_m = outer_m_ - inner_m_, half_m = inner_m_ * tangent_, lean = half_m / width_m;
    const double side = n == 1 ? 1 : -1;
    Cell cell;
    // By columns: what a metre out, and a metre along, become.
    glm::dvec2 of_out = out * shrink_, of_along = along;
    cell.shift = out * ((factor_ - shrink_) * inner_m_);
    if (n == 0) {
        of_along = along * factor_;
        cell.edges[0] = edge(out, {1, 0}, -inner_m_);
        cell.edges[1] = edge(out, {-lean, -1}, lean * outer_m_);
        cell.edges[2] = edge(out, {-lean, 1}, lean * outer_m_);
    } else {
        of_out -= along * (side * (factor_ - 1) * lean);
        cell.shift += along * (side * (factor_ - 1) * lean * outer_m_);
        cell.borders = Borders::first;
        cell.edges[0] = edge(out, {-1, 0}, outer_m_);
        cell.edges[1] = edge(out, {lean, side}, -lean * outer_m_);
        cell.edges[2] = edge(out, {tangent_, -side}, 0);
    }
    repeat_first(cell.edges, 3);
    cell.slope = {of_out * out.x + of_along * along.x, of_out * out.y + of_along * along.y};
    return cell;
}

bool Magnifiers::add(const Magnifier& magnifier) {
    for (const Magnifier& other : all_)
        if (glm::distance(other.middle(), magnifier.middle()) < other.reach_m() + magnifier.reach_m() + kMinApart_m) return false;
    return all_.try_push_back(magnifier);
}

Ecef Magnifiers::moved(const Ecef& place) const {
    Ecef shown = place;
    for (const Magnifier& magnifier : all_) shown = magnifier.moved(shown);
    return shown;
}

Ecef Magnifiers::moved_back(const Ecef& shown) const {
    Ecef place = shown;
    for (const Magnifier& magnifier : all_) place = magnifier.moved_back(place);
    return place;
}

}  // namespace tedavis::earth
