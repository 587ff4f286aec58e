#include "render_core/draw/drawers/terrain_program.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace tedavis::draw {
namespace {

using design::BakedMap;
using design::TerrainShade;
using design::TerrainTexture;

constexpr gl::AttributeBinding kAttributes[] = {{"position", kTerrainPosition},
                                                {"height", kTerrainHeight},
                                                {"normal", kTerrainNormal},
                                                {"kind", kTerrainKind},
                                                {"place", kTerrainPlace}};

constexpr const char* kUniformNames[kTerrainUniforms] = {"chunk_offset",
                                                         "view_projection",
                                                         "to_local",
                                                         "haze_per_m",
                                                         "lift",
                                                         "place_end",
                                                         "earth_centre",
                                                         "flat_height",
                                                         "page_window",
                                                         "stroke_window",
                                                         "form_map",
                                                         "light_map",
                                                         "aperture_map",
                                                         "horizon_map",
                                                         "page_origin",
                                                         "page_scale",
                                                         "drape_map",
                                                         "drape_window",
                                                         "drape_origin",
                                                         "palette",
                                                         "palette_range",
                                                         "plain_color",
                                                         "sea_color",
                                                         "unknown_color",
                                                         "missing_color",
                                                         "natural_rock",
                                                         "natural_woods",
                                                         "haze_color",
                                                         "pixel",
                                                         "grid_window",
                                                         "grid_look",
                                                         "grid_spacing",
                                                         "lights",
                                                         "light",
                                                         "light_color",
                                                         "ambient_color",
                                                         "occlusion",
                                                         "line_color",
                                                         "form_lines",
                                                         "contour",
                                                         "strokes",
                                                         "page_texel",
                                                         "coast_sharp",
                                                         "band_color",
                                                         "band_lower",
                                                         "height_range",
                                                         "data_map",
                                                         "data_colors",
                                                         "data_size",
                                                         "data_scale",
                                                         "data_breaks",
                                                         "data_look",
                                                         "data_window",
                                                         "data_overlay",
                                                         "data_overlay_color",
                                                         "data_lowest",
                                                         "geometry",
                                                         "chunk_number",
                                                         "ray_axes",
                                                         kAirUniformNames[0],
                                                         kAirUniformNames[1],
                                                         kAirUniformNames[2],
                                                         kAirUniformNames[3],
                                                         kShadowUniformNames[0],
                                                         kShadowUniformNames[1],
                                                         kShadowUniformNames[2],
                                                         kShadowUniformNames[3],
                                                         "left",
                                                         kFocusUniformNames[0],
                                                         kFocusUniformNames[1],
                                                         kFocusUniformNames[2],
                                                         kFocusUniformNames[3],
                                                         kMagnifierUniformNames[0],
                                                         kMagnifierUniformNames[1],
                                                         kAlertUniformNames[0],
                                                         kAlertUniformNames[1]};
static_assert(kTerrainUniforms <= gl::kMaxUniforms);

constexpr const char* kTextureDefines[design::kTerrainTextures] = {
    "",
    "#define TEXTURE_HYPSOMETRIC 1\n#define PALETTE 1\n",
    "#define TEXTURE_SLOPE 1\n#define PALETTE 1\n",
    "#define TEXTURE_RELIEF 1\n#define PALETTE 1\n",
    "#define TEXTURE_OPENNESS 1\n#define PALETTE 1\n",
    "#define TEXTURE_IMAGE 1\n",
    "#define TEXTURE_MATERIAL 1\n#define PALETTE 1\n#define STROKES 1\n",
};
constexpr const char* kUncertaintyDefines[design::kIntrinsicUncertainties] = {
    "",
    "#define DATA_TRANSPARENCY 1\n",
    "#define DATA_SATURATION 1\n",
    "#define DATA_NOISE 1\n",
    "#define DATA_STROKES 1\n",
    "#define DATA_BIVARIATE 1\n",
    "#define DATA_BUMP 1\n",
    "#define DATA_BLUR 1\n",
};
constexpr const char* kOverlayDefines[design::kUncertaintyOverlays] = {
    "",
    "#define DATA_OVERLAY 1\n#define DATA_FOG 1\n",
    "#define DATA_OVERLAY 1\n#define DATA_MESH 1\n",
    "#define DATA_OVERLAY 1\n#define DATA_CONTOUR 1\n",
    "#define DATA_OVERLAY 1\n#define DATA_HALO 1\n",
};
constexpr const char* kMapDefines[design::kBakedMaps] = {"#define MAP_FORM 1\n", "#define MAP_LIGHT 1\n",
                                                         "#define MAP_APERTURE 1\n", "#define MAP_HORIZON 1\n",
                                                         "#define MAP_DRAPE 1\n"};

constexpr const char* kAlertZoneDefine = "#define ALERT_ZONE 1\n";
constexpr const char* kLiftedDefine = "#define LIFTED 1\n";

class DefineList {
public:
    void add(std::string_view line) { text_.append(line); }
    void add_if(bool wanted, std::string_view line) {
        if (wanted) add(line);
    }
    void add_number(std::string_view name, std::size_t number) {
        add("#define ");
        add(name);
        add(" ");
        add(base::digits(number).view());
        add("\n");
    }
    [[nodiscard]] const TerrainDefines& text() const { return text_; }

private:
    TerrainDefines text_;
};

void add_shade(DefineList& defines, const design::ShadeSettings& shade, bool needs_light) {
    const bool lit = shade.technique != TerrainShade::none;
    if (lit || needs_light)
        defines.add_number("LIGHTS", shade.technique == TerrainShade::lights ? shade.light_count : std::size_t{1});
    defines.add_if(lit || shade.ambient_occlusion > 0 || shade.openness > 0, "#define SHADED 1\n");
    defines.add_if(has_colored_light(shade), "#define LIGHT_COLORS 1\n");
    defines.add_if(shade.technique == TerrainShade::phong, "#define SHADE_PHONG 1\n");
    defines.add_if(shade.technique == TerrainShade::light_map, "#define SHADE_LIGHT_MAP 1\n");
    defines.add_if(shade.technique == TerrainShade::aperture, "#define SHADE_APERTURE 1\n");
    defines.add_if(shade.ambient_occlusion > 0 || shade.openness > 0, "#define OCCLUSION 1\n");
}

void add_sketch(DefineList& defines, const design::SketchSettings& sketch, bool strokes_by_texture) {
    const bool form_lines = sketch.ridges > 0 || sketch.valleys > 0;
    const bool strokes = sketch.hatching > 0 || sketch.stippling > 0;
    const bool any = form_lines || strokes || sketch.suggestive_contours > 0 || sketch.contours > 0;
    defines.add_if(any, "#define SKETCH 1\n");
    defines.add_if(form_lines, "#define FORM_LINES 1\n");
    defines.add_if(sketch.suggestive_contours > 0, "#define SUGGESTIVE 1\n");
    defines.add_if(sketch.contours > 0, "#define CONTOURS 1\n");
    defines.add_if(sketch.contours > 0 && sketch.illuminated, "#define ILLUMINATED 1\n");
    defines.add_if(strokes && !strokes_by_texture, "#define STROKES 1\n");
    defines.add_if(sketch.hatching > 0, "#define HATCHING 1\n");
    defines.add_if(sketch.stippling > 0, "#define STIPPLING 1\n");
}

void add_focus(DefineList& defines, const GroundFocusKind& focus, bool in_focus) {
    defines.add_if(focus.blurs, "#define FOCUS_BLUR 1\n");
    if (focus.foci == 0 || in_focus) return;
    defines.add_number("FOCI", focus.foci);
    defines.add_if(focus.has_paths, "#define FOCUS_PATHS 1\n");
    defines.add_if(focus.has_squares, "#define FOCUS_SQUARES 1\n");
    defines.add_if(focus.has_chebyshev, "#define FOCUS_CHEBYSHEV 1\n");
    defines.add_if(focus.has_lines, "#define FOCUS_LINES 1\n");
    defines.add_if(focus.has_halos, "#define FOCUS_HALOS 1\n");
    defines.add_if(focus.has_grids, "#define FOCUS_GRIDS 1\n");
    defines.add_if(focus.sketches, "#define FOCUS_SKETCH 1\n");
}

TerrainDefines code_defines(const design::TerrainStyle& style, const TerrainVariant& variant) {
    DefineList defines;
    if (style.shade.technique != TerrainShade::none)
        defines.add_number("LIGHTS", style.shade.technique == TerrainShade::lights ? style.shade.light_count : std::size_t{1});
    defines.add_if(variant.lifted, kLiftedDefine);
    defines.add_if(variant.flat, "#define FLAT 1\n");
    const bool coast = variant.coast && variant.maps[static_cast<std::size_t>(BakedMap::light)];
    defines.add_if(coast, "#define COAST 1\n");
    defines.add_if(variant.classes, "#define CLASSES 1\n");
    defines.add_if(variant.bands > 0, kAlertZoneDefine);
    return defines.text();
}

using VertexText = base::FixedString<kMaxTerrainDefines + kMaxShaderText>;
using FragmentText = base::FixedString<kMaxTerrainDefines + 4 * kMaxShaderText>;

void append_code(const TerrainVariant& variant, VertexText& vertex, FragmentText& fragment) {
    vertex.append(shader_text(k_terrain_place_vert));
    vertex.append(shader_text(k_alert_place_vert));
    vertex.append(shader_text(k_terrain_code_vert));
    if (variant.bands > 0) fragment.append(shader_text(k_alert_zone_frag));
    fragment.append(shader_text(k_terrain_code_frag));
}

/// What colours the ground, by its varyings.
void append_look(const design::TerrainStyle& style, const TerrainVariant& variant, FragmentText& fragment) {
    if (variant.ground_data) fragment.append(shader_text(k_ground_data_frag));
    if (variant.ground_data && variant.overlay != design::UncertaintyOverlay::none)
        fragment.append(shader_text(k_ground_overlay_frag));
    if (variant.air) fragment.append(shader_text(k_air_frag));
    if (variant.fine_distance) fragment.append(shader_text(k_fine_distance_frag));
    if (variant.shadows) fragment.append(shader_text(k_shadow_frag));
    fragment.append(shader_text(k_unknown_ground_frag));
    fragment.append(shader_text(k_terrain_image_frag));
    if (style.texture == TerrainTexture::material) fragment.append(shader_text(k_natural_ground_frag));
    fragment.append(shader_text(k_surface_line_frag));
    if (variant.focus.foci > 0) fragment.append(shader_text(k_focus_frag));
    if (variant.bands > 0) fragment.append(shader_text(k_alert_zone_frag));
    fragment.append(shader_text(k_terrain_ground_frag));
    fragment.append(shader_text(k_terrain_texture_frag));
    fragment.append(shader_text(k_terrain_shade_frag));
    fragment.append(shader_text(k_terrain_sketch_frag));
    fragment.append(shader_text(k_terrain_frag));
}

void append_color(const design::TerrainStyle& style, const TerrainVariant& variant, VertexText& vertex, FragmentText& fragment) {
    vertex.append(shader_text(k_terrain_place_vert));
    vertex.append(shader_text(k_alert_place_vert));
    vertex.append(shader_text(k_terrain_varyings_vert));
    vertex.append(shader_text(k_terrain_vert));
    append_look(style, variant, fragment);
}

void append_deferred(const design::TerrainStyle& style, const TerrainVariant& variant, VertexText& vertex,
                     FragmentText& fragment) {
    vertex = VertexText(shader_text(k_terrain_deferred_vert));
    append_look(style, variant, fragment);
    fragment.append(shader_text(k_alert_place_vert));
    fragment.append(shader_text(k_terrain_varyings_vert));
    fragment.append(shader_text(k_terrain_deferred_frag));
}

base::Result<gl::Program, base::Error> build(gl::Gl& gl, gl::ProgramSource source) {
    source.attributes = base::Span<const gl::AttributeBinding>(kAttributes);
    source.uniforms = base::Span<const char* const>(kUniformNames);
    return gl::build_program(gl, source);
}

}  // namespace

bool operator==(const TerrainVariant& a, const TerrainVariant& b) noexcept {
    const auto all = [](const TerrainVariant& v) {
        return std::tie(v.bands, v.baked, v.coast, v.classes, v.lifted, v.flat, v.output, v.deferred, v.ground_data,
                        v.uncertainty, v.overlay, v.air, v.fine_distance, v.shafts, v.shadows, v.in_focus, v.magnified);
    };
    return all(a) == all(b) && std::equal(std::begin(a.maps), std::end(a.maps), std::begin(b.maps));
}

TerrainDefines terrain_defines(const design::TerrainStyle& style, const TerrainVariant& variant) {
    DefineList defines;
    if (variant.output == TerrainOutput::code) return code_defines(style, variant);
    defines.add(kTextureDefines[static_cast<std::size_t>(style.texture)]);
    const design::SketchSettings& sketch = style.sketch;
    add_shade(defines, style.shade, sketch.hatching > 0 || sketch.stippling > 0 || (sketch.contours > 0 && sketch.illuminated));
    const bool strokes_by_texture = style.texture == TerrainTexture::material;
    const bool strokes_by_sketch = sketch.hatching > 0 || sketch.stippling > 0;
    add_sketch(defines, sketch, strokes_by_texture);
    if (variant.ground_data) {
        defines.add("#define GROUND_DATA 1\n");
        defines.add_if(!strokes_by_texture && !strokes_by_sketch, "#define STROKES 1\n");
        defines.add(kUncertaintyDefines[static_cast<std::size_t>(variant.uncertainty)]);
        defines.add(kOverlayDefines[static_cast<std::size_t>(variant.overlay)]);
    }
    defines.add_if(variant.baked, "#define BAKED 1\n");
    const bool coast = variant.baked && variant.coast && variant.maps[static_cast<std::size_t>(BakedMap::light)];
    defines.add_if(coast, "#define COAST 1\n");
    for (std::size_t n = 0; n < design::kBakedMaps; ++n) {
        const auto map = static_cast<BakedMap>(n);
        const bool is_there = variant.maps[n] && (variant.baked || map == BakedMap::drape);
        defines.add_if(is_there && (needs_map(style, map) || (coast && map == BakedMap::light)), kMapDefines[n]);
    }
    defines.add_if(style.grid.is_shown(), "#define SURFACE_GRID 1\n");
    if (variant.bands > 0) defines.add_number("WARNING_BANDS", variant.bands);
    defines.add_if(variant.bands > 0, kAlertZoneDefine);
    defines.add_if(variant.lifted, kLiftedDefine);
    defines.add_if(variant.flat, "#define FLAT 1\n");
    defines.add_if(variant.air, "#define AIR 1\n");
    defines.add_if(variant.fine_distance, "#define FINE_DISTANCE 1\n");
    defines.add_if(variant.shadows, "#define SHADOWS 1\n");
    defines.add_if(variant.shafts, "#define SHAFTS 1\n");
    add_focus(defines, variant.focus, variant.in_focus);
    defines.add_if(variant.output == TerrainOutput::color_and_distance, "#define DISTANCE_IN_ALPHA 1\n");
    defines.add_if(variant.magnified, kMagnifiedDefine);
    defines.add_if(variant.deferred, "#define DEFERRED 1\n#undef VARYING\n#define VARYING\n");
    return defines.text();
}

base::Result<gl::Program, base::Error> build_terrain_program(gl::Gl& gl, const design::TerrainStyle& style,
                                                             const TerrainVariant& variant) {
    const TerrainDefines defines = terrain_defines(style, variant);
    VertexText vertex(defines.view());
    FragmentText fragment(defines.view());
    if (variant.magnified) {
        vertex.append(shader_text(k_magnified_vert));
        fragment.append(shader_text(k_magnified_frag));
    }
    if (variant.output == TerrainOutput::code)
        append_code(variant, vertex, fragment);
    else if (variant.deferred)
        append_deferred(style, variant, vertex, fragment);
    else
        append_color(style, variant, vertex, fragment);
    return build(gl, {"terrain", vertex.view(), fragment.view(), {}, {}, true});
}

}  // namespace tedavis::draw
