#include "render_core/draw/drawers/data/solid_casters.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/draw/drawers/shadow_map.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/gl/draw_triangles.hpp"

namespace tedavis::draw {
namespace {

enum CastUniform : std::size_t { kCastAxes, kCastLevel, kCastAnchor, kCastFading, kCastCover, kCastUniforms };
constexpr const char* kNames[kCastUniforms] = {"shadow_axes", "caster_level", "anchor", "fading", "cover"};

bool is_in_level(const SolidPiece& piece, const CasterView& view) {
    const ShadowLevel& level = view.shadow.levels[view.level];
    const glm::dvec3 at = view.shadow.in_light(piece.anchor);
    const double away_m = std::max(std::fabs(at.x - level.middle_m.x), std::fabs(at.y - level.middle_m.y));
    return away_m <= level.half_m + double{piece.radius_m} + view.texel_m;
}

}  // namespace

void set_caster_level(gl::Gl& gl, GLint axes, GLint level, const CasterView& view, double swollen_m) {
    const ShadowLevel& of = view.shadow.levels[view.level];
    set_light_axes(gl, axes, view.shadow, view.eye);
    gl->Uniform4f(level, static_cast<float>(of.middle_m.x), static_cast<float>(of.middle_m.y), static_cast<float>(of.half_m),
                  static_cast<float>(swollen_m));
}

base::Error SolidCasters::start(gl::Gl& gl) {
    base::FixedString<kMaxShaderText> vertex(shader_text(k_caster_light_vert));
    vertex.append(shader_text(k_solid_vert));
    auto built =
        gl::build_program(gl, {"caster", vertex.view(), shader_text(k_caster_frag),
                               base::Span<const gl::AttributeBinding>(kSolidBindings), base::Span<const char* const>(kNames)});
    if (!built.ok()) return built.error();
    program_ = built.value();
    return {};
}

std::uint32_t SolidCasters::draw(gl::Gl& gl, base::Span<const SolidBuffers* const> solids, const CasterGroups& groups,
                                 const CasterView& view) const {
    std::uint32_t draws = 0;
    program_.use(gl);
    for (GLuint attribute = 0; attribute < kSolidAttributes; ++attribute) gl->EnableVertexAttribArray(attribute);
    for (const SolidBuffers* const buffers : solids) {
        buffers->bind(gl);
        for (const SolidPiece& piece : buffers->batch().pieces())
            if (casts_shadow(piece, groups) && is_in_level(piece, view))
                draws += draw_piece(gl, piece, (groups.thin >> piece.look.group & 1u) != 0, view);
    }
    for (GLuint attribute = 0; attribute < kSolidAttributes; ++attribute) gl->DisableVertexAttribArray(attribute);
    return draws;
}

std::uint32_t SolidCasters::draw_piece(gl::Gl& gl, const SolidPiece& piece, bool is_thin, const CasterView& view) const {
    set_solid_place(gl, program_.uniform(kCastAnchor), piece, view.eye);
    set_solid_fading(gl, program_.uniform(kCastFading), piece, 0);
    gl->Uniform4f(program_.uniform(kCastCover), piece.look.opacity, 0, 0, 0);
    point_solid_attributes(gl, piece);
    const std::uint32_t times = is_thin ? 2 : 1;
    for (std::uint32_t n = 0; n < times; ++n) {
        set_caster_level(gl, program_.uniform(kCastAxes), program_.uniform(kCastLevel), view, n * 0.5 * view.texel_m);
        gl::draw_triangles(gl, {piece.first_index, piece.indices, piece.vertices - 1});
    }
    return times;
}

}  // namespace tedavis::draw
