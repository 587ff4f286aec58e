#include "render_core/earth/magnified_parts.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace tedavis::earth {
namespace {

constexpr double kOverLimits_m = Magnifiers::kMinApart_m / 4;

}  // namespace

double GroundExtent::radius_m() const {
    double squares = 0;
    for (const glm::dvec3& axis : half) squares += glm::dot(axis, axis);
    return std::sqrt(squares) + more_m;
}

double GroundExtent::along(const glm::dvec3& direction) const {
    double reach = more_m;
    for (const glm::dvec3& axis : half) reach += std::abs(glm::dot(axis, direction));
    return reach;
}

bool is_magnified(const Magnifiers& magnifiers, const GroundExtent& extent) {
    for (const Magnifier& magnifier : magnifiers)
        if (magnifier.reaches(extent.centre, extent.radius_m())) return true;
    return false;
}

double MagnifiedPart::scale() const { return std::sqrt(glm::determinant(cell.slope)); }

bool MagnifiedParts::next(MagnifiedPart& part) {
    for (; magnifier_ < magnifiers_.size(); ++magnifier_, cell_ = 0) {
        const Magnifier& magnifier = magnifiers_.begin()[magnifier_];
        if (!magnifier.reaches(extent_.centre, extent_.radius_m())) continue;
        const glm::dvec2 half(extent_.along(magnifier.east()), extent_.along(magnifier.north()));
        while (cell_ < magnifier.cell_count()) {
            part.magnifier = &magnifier;
            part.cell = magnifier.cell(cell_++);
            if (!part.cell.touches(magnifier.in_plane(extent_.centre), half)) continue;
            set_limits(part);
            return true;
        }
    }
    return false;
}

/// The plane outside is shared out by lines at right angles to those between the middles, each as far from the one's reach as
/// from the other's. Both draw what lies along them, for their planes are not quite the same.
void MagnifiedParts::set_limits(MagnifiedPart& part) const {
    for (glm::dvec3& limit : part.limits) limit = {0, 0, 1};
    if (!part.cell.is_outside) return;
    std::size_t used = 0;
    for (const Magnifier& other : magnifiers_) {
        if (&other == part.magnifier || !other.reaches(extent_.centre, extent_.radius_m())) continue;
        const glm::dvec2 towards = part.magnifier->in_plane(other.middle());
        const double apart_m = glm::length(towards);
        const double at_m = 0.5 * (apart_m + part.magnifier->reach_m() - other.reach_m());
        part.limits[used++] = {towards / -apart_m, at_m + kOverLimits_m};
    }
}

std::uint32_t count_parts(const Magnifiers& magnifiers, const GroundExtent& extent) {
    std::uint32_t count = 0;
    MagnifiedParts parts(magnifiers, extent);
    for (MagnifiedPart part; parts.next(part);) ++count;
    return count > 0 ? count : 1;
}

}  // namespace tedavis::earth
