#include "render_core/draw/magnified_parts.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace tedavis::draw {
namespace {

using earth::Magnifier;

/// Of places in float, a few steps of what they are measured in: neighbouring parts overlap by that much.
constexpr double kRounding = 2.5e-7, kLeastOverlap_m = 0.05;

constexpr std::size_t kLensVectors = 6, kPartVectors = Magnifier::kMostSides + MagnifiedPart::kLimits + 1;

void put(float* to, const glm::dvec3& vector) {
    for (int n = 0; n < 3; ++n) to[n] = static_cast<float>(vector[n]);
}

void put(float* to, const glm::dvec3& vector, double fourth) {
    put(to, vector);
    to[3] = static_cast<float>(fourth);
}

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

bool is_magnified(const earth::Magnifiers& magnifiers, const GroundExtent& extent) {
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
/// from the other's.
void MagnifiedParts::set_limits(MagnifiedPart& part) const {
    for (glm::dvec3& limit : part.limits) limit = {0, 0, 1};
    if (!part.cell.is_outside) return;
    std::size_t used = 0;
    for (const Magnifier& other : magnifiers_) {
        if (&other == part.magnifier || !other.reaches(extent_.centre, extent_.radius_m())) continue;
        const glm::dvec2 towards = part.magnifier->in_plane(other.middle());
        const double apart_m = glm::length(towards);
        const double at_m = 0.5 * (apart_m + part.magnifier->reach_m() - other.reach_m());
        part.limits[used++] = {towards / -apart_m, at_m};
    }
}

void set_magnifier_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const MagnifiedPart& part,
                            const glm::dvec3& origin) {
    const Magnifier& magnifier = *part.magnifier;
    const glm::dmat2 moves = part.cell.slope - glm::dmat2(1.0);
    const glm::dvec3 middle = magnifier.middle() - origin;
    float lens[kLensVectors][4], within[kPartVectors][3];
    put(lens[0], magnifier.east(), magnifier.curvature_per_m().x);
    put(lens[1], magnifier.north(), magnifier.curvature_per_m().y);
    put(lens[2], magnifier.up(), 0);
    put(lens[3], middle, 0);
    put(lens[4], {moves[0].x, moves[1].x, part.cell.shift.x}, 0);
    put(lens[5], {moves[0].y, moves[1].y, part.cell.shift.y}, 0);
    for (std::size_t n = 0; n < Magnifier::kMostSides; ++n) put(within[n], part.cell.edges[n]);
    for (std::size_t n = 0; n < MagnifiedPart::kLimits; ++n) put(within[Magnifier::kMostSides + n], part.limits[n]);
    const double overlap_m = std::fmax(kRounding * glm::length(middle), kLeastOverlap_m);
    put(within[kPartVectors - 1], {part.cell.is_outside ? -1.0 : 1.0, overlap_m, static_cast<double>(part.cell.borders)});
    gl->Uniform4fv(program.uniform(first), kLensVectors, lens[0]);
    gl->Uniform3fv(program.uniform(first + 1), kPartVectors, within[0]);
}

}  // namespace tedavis::draw
