/// Converts the hits of a traced picture to the codes that terrain programs write (terrain_code.frag): height, light and
/// distance of every pixel in four bytes.
///
/// Light is interpolated from the corners of the triangle that is hit, as in rasterization. A pixel is sea where more than half
/// of its cell's posts, weighted by nearness, are sea, and unknown where a corner of its triangle is void.
///
/// Pure. Thread  uses the workers; the codes do not depend on their number.
#pragma once

#include "render_core/design/terrain_style.hpp"
#include "render_core/draw/alert_zone_look.hpp"
#include "render_core/draw/drawers/color_table.hpp"
#include "render_core/draw/traced_ground.hpp"
#include "render_core/raytrace/view_kernels.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

/// The lights of a style, whose weighted sum codes contain.
struct CodedLight {
    std::size_t count = 0;                   ///< 0: everything is fully lit
    glm::dvec3 towards[design::kMaxLights];  ///< unit vectors, ECEF
    double weights[design::kMaxLights]{};    ///< their sum is 1
    double ambient = 1;
};
/// `towards`: one unit vector per light of the style, ECEF.
[[nodiscard]] CodedLight coded_light(const design::ShadeSettings& shade, const glm::dvec3* towards);

struct CodeInput {
    const TracedGround& ground;
    const raytrace::HitPicture& hits;  ///< of the view, with `u` and `v`
    const terrain::View& view;
    HeightSpan heights;  ///< of the whole database
    CodedLight light;
    const AlertZoneLook* alert = nullptr;  ///< null: no alert
};

/// The code of a pixel without terrain: sky.
inline constexpr std::uint8_t kNothingCode = 255;

/// Writes four bytes per pixel of the view into `codes`, rows from the bottom as in GL.
void write_codes(const CodeInput& input, base::Workers& workers, base::Span<std::uint8_t> codes);

}  // namespace tedavis::draw
