#include "render_core/draw/drawers/magnified_uniforms.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace tedavis::draw {
namespace {

using earth::MagnifiedPart;
using earth::Magnifier;

/// Of places in float, a few steps of what they are measured in: neighbouring parts overlap by that much.
constexpr double kRounding = 2.5e-7, kMinOverlap_m = 0.05;

constexpr std::size_t kLensVectors = 5, kPartVectors = Magnifier::kMaxSides + MagnifiedPart::kLimits + 1;

void put(float* to, const glm::dvec3& vector) {
    for (int n = 0; n < 3; ++n) to[n] = static_cast<float>(vector[n]);
}

}  // namespace

void set_magnifier_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const MagnifiedPart& part,
                            const glm::dvec3& origin) {
    const Magnifier& magnifier = *part.magnifier;
    const glm::dmat2 moves = part.cell.slope - glm::dmat2(1.0);
    const glm::dvec3 middle = magnifier.middle() - origin;
    float lens[kLensVectors][3], within[kPartVectors][3];
    put(lens[0], magnifier.east());
    put(lens[1], magnifier.north());
    put(lens[2], middle);
    put(lens[3], {moves[0].x, moves[1].x, part.cell.shift.x});
    put(lens[4], {moves[0].y, moves[1].y, part.cell.shift.y});
    for (std::size_t n = 0; n < Magnifier::kMaxSides; ++n) put(within[n], part.cell.edges[n]);
    for (std::size_t n = 0; n < MagnifiedPart::kLimits; ++n) put(within[Magnifier::kMaxSides + n], part.limits[n]);
    const double overlap_m = std::fmax(kRounding * glm::length(middle), kMinOverlap_m);
    put(within[kPartVectors - 1], {part.cell.is_outside ? -1.0 : 1.0, overlap_m, static_cast<double>(part.cell.borders)});
    gl->Uniform3fv(program.uniform(first), kLensVectors, lens[0]);
    gl->Uniform3fv(program.uniform(first + 1), kPartVectors, within[0]);
}

}  // namespace tedavis::draw
