/// Splits what magnifiers move into parts in which their map is affine. A mesh that is drawn once for each part, clipped to it
/// and moved by that part's map, is exact whatever its triangles.
///
/// Pure; any thread.
#pragma once

#include "render_core/earth/magnifier.hpp"

namespace tedavis::earth {

/// A bound of an object: a box given by its centre and half axes (ECEF, m), enlarged by `more_m` on all sides.
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
    /// Limits between the outsides of several magnifiers: a point is outside all of them and nearest to this one where
    /// dot(limit, (east, north, 1)) >= 0 for each limit.
    glm::dvec3 limits[kLimits]{};
    /// Factor of lengths in this part: the square root of that of areas.
    [[nodiscard]] double scale() const;
};

/// Iterates over the parts of an object for which is_magnified() holds. Magnifiers and extent must outlive it.
class MagnifiedParts {
public:
    MagnifiedParts(const Magnifiers& magnifiers, const GroundExtent& extent) : magnifiers_(magnifiers), extent_(extent) {}
    /// Writes the next part; returns false when there is none.
    [[nodiscard]] bool next(MagnifiedPart& part);

private:
    void set_limits(MagnifiedPart& part) const;

    const Magnifiers& magnifiers_;
    const GroundExtent& extent_;
    std::size_t magnifier_ = 0, cell_ = 0;
};

/// Number of parts, that is, of draw calls; 1 for an object that is not magnified.
[[nodiscard]] std::uint32_t count_parts(const Magnifiers& magnifiers, const GroundExtent& extent);

}  // namespace tedavis::earth
