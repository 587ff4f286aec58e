/// What magnifiers move, part by part: their map is linear in each, so that a mesh that is drawn by it, whatever its triangles,
/// lies where it should to the last pixel, once what is outside the part is left out.
///
/// Pure; any thread.
#pragma once

#include "render_core/earth/magnifier.hpp"

namespace tedavis::earth {

/// Where something may lie: a box with half axes round a centre (ECEF, m), and so much more on all sides.
struct GroundExtent {
    glm::dvec3 centre{0};
    glm::dvec3 half[3]{};
    double more_m = 0;

    [[nodiscard]] double radius_m() const;
    [[nodiscard]] double along(const glm::dvec3& direction) const;
};

[[nodiscard]] bool is_magnified(const Magnifiers& magnifiers, const GroundExtent& extent);

struct MagnifiedPart {
    static constexpr std::size_t kLimits = Magnifiers::kMax - 1;

    const Magnifier* magnifier = nullptr;
    Magnifier::Cell cell;
    /// Of what is outside of several: of each that near it. Inside where dot(limit, (east, north, 1)) >= 0.
    glm::dvec3 limits[kLimits]{};
    /// By how much lengths grow in it, as areas do.
    [[nodiscard]] double scale() const;
};

/// The parts of something that is_magnified(), one after the other; both must stay.
class MagnifiedParts {
public:
    MagnifiedParts(const Magnifiers& magnifiers, const GroundExtent& extent) : magnifiers_(magnifiers), extent_(extent) {}
    /// False when there is no other.
    [[nodiscard]] bool next(MagnifiedPart& part);

private:
    void set_limits(MagnifiedPart& part) const;

    const Magnifiers& magnifiers_;
    const GroundExtent& extent_;
    std::size_t magnifier_ = 0, cell_ = 0;
};

/// How many draws that takes; 1 for what is not magnified.
[[nodiscard]] std::uint32_t count_parts(const Magnifiers& magnifiers, const GroundExtent& extent);

}  // namespace tedavis::earth
