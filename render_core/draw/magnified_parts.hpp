/// What magnifiers move is drawn part by part: their map is linear in each, so that a mesh, whatever its triangles, lies where it
/// should to the last pixel. Each part is a draw of the whole mesh by that linear map, and a fragment outside the part is left
/// out (shaders/magnified.vert, magnified.frag). What no magnifier reaches is drawn once, by programs that know of none.
///
/// Programs have the two uniforms of kMagnifierUniformNames, call magnified() and leave_other_parts(), and are built with the
/// line kMagnifiedDefine. Pure but for set_magnifier_uniforms(), which is for the GL thread.
#pragma once

#include <string_view>

#include "render_core/earth/magnifier.hpp"
#include "render_core/gl/program.hpp"

namespace tedavis::draw {

/// Where something may lie: a box with half axes round a centre (ECEF, m), and so much more on all sides.
struct GroundExtent {
    glm::dvec3 centre{0};
    glm::dvec3 half[3]{};
    double more_m = 0;

    [[nodiscard]] double radius_m() const;
    [[nodiscard]] double along(const glm::dvec3& direction) const;
};

[[nodiscard]] bool is_magnified(const earth::Magnifiers& magnifiers, const GroundExtent& extent);

struct MagnifiedPart {
    static constexpr std::size_t kLimits = earth::Magnifiers::kMost - 1;

    const earth::Magnifier* magnifier = nullptr;
    earth::Magnifier::Cell cell;
    /// Of what is outside of several: of each that near it. Inside where dot(limit, (east, north, 1)) >= 0.
    glm::dvec3 limits[kLimits]{};
    /// By how much lengths grow in it, as areas do.
    [[nodiscard]] double scale() const;
};

/// The parts of something that is_magnified(), one after the other: first() and then next() while it is true.
class MagnifiedParts {
public:
    MagnifiedParts(const earth::Magnifiers& magnifiers, const GroundExtent& extent) : magnifiers_(magnifiers), extent_(extent) {}
    /// False when there is no other.
    [[nodiscard]] bool next(MagnifiedPart& part);

private:
    void set_limits(MagnifiedPart& part) const;

    const earth::Magnifiers& magnifiers_;
    const GroundExtent& extent_;
    std::size_t magnifier_ = 0, cell_ = 0;
};

inline constexpr std::size_t kMagnifierUniforms = 2;
inline constexpr const char* kMagnifierUniformNames[kMagnifierUniforms] = {"lens", "lens_part"};
inline constexpr std::string_view kMagnifiedDefine = "#define MAGNIFIED 1\n";

/// Of the program in use, whose list has those names from `first` on; its places are measured from `origin` (ECEF).
void set_magnifier_uniforms(gl::Gl& gl, const gl::Program& program, std::size_t first, const MagnifiedPart& part,
                            const glm::dvec3& origin);

}  // namespace tedavis::draw
