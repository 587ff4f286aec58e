#include <algorithm>
#include <glm/common.hpp>

#include "render_core/draw/drawers/terrain_drawer.hpp"
#include "render_core/terrain/projected_error.hpp"

namespace tedavis::draw {
namespace {

using design::BakedMap;
using terrain::SelectedChunk;

/// After the palette and the baked maps; eight units are enough on the smallest device, which traces nothing.
constexpr std::uint32_t kGroundMapUnit = design::kBakedMaps + 1, kGroundColorUnit = design::kBakedMaps + 2;

constexpr TerrainUniform kMapUniforms[design::kBakedMaps] = {kFormMap, kLightMap, kApertureMap, kHorizonMap, kDrapeMap};

struct PixelRect {
    GLint left = 0, bottom = 0, right = 0, top = 0;
    [[nodiscard]] bool is_empty() const { return left >= right || bottom >= top; }
};

/// The part of the picture in which a chunk may be seen, with a margin for rounding.
PixelRect part_of_picture(const SelectedChunk& chunk, const terrain::View& view) {
    constexpr double kMargin_px = 2;
    const auto reach_px = [&](double right, double down, double extent_px) {
        const double tangent = terrain::highest_tangent(*chunk.entry, view, {right, down}, double{greatest_lift_m(chunk.lift)});
        return static_cast<GLint>(std::clamp(0.5 * extent_px + tangent * view.focal_px + kMargin_px, 0.0, extent_px));
    };
    const auto width = static_cast<GLint>(view.width), height = static_cast<GLint>(view.height);
    return {width - reach_px(-1, 0, view.width), height - reach_px(0, 1, view.height), reach_px(1, 0, view.width),
            reach_px(0, -1, view.height)};
}

}  // namespace

/// Everything but what differs from chunk to chunk.
void TerrainDrawer::use_looks(gl::Gl& gl, const TerrainDrawInput& input, const DepthRange& range, bool deferred) {
    focus_.set(style().variant.focus.foci > 0 ? input.foci : nullptr, design_.foci, input.blurs_context);
    set_uniforms_of_programs(gl, deferred ? style().shading : style().programs, input, range);
    if (magnifies(input)) set_uniforms_of_programs(gl, styles_[magnified_style_].programs, input, range);
    if (focus_.is_any()) focus_.upload(gl, palette_, kFocusRow);
    if (palette_.valid()) palette_.bind(gl, 0);
    if (atlas_.is_started()) atlas_.bind(gl);
    if (drape_.is_started()) drape_.bind(gl, static_cast<std::uint32_t>(BakedMap::drape) + 1);
    if (has_ground_data()) ground_.bind(gl, kGroundMapUnit, kGroundColorUnit);
}

void TerrainDrawer::set_uniforms_of_programs(gl::Gl& gl, const ProgramTable& programs, const TerrainDrawInput& input,
                                             const DepthRange& range) const {
    const bool has_warnings = input.warning_colors || input.alert.is_shown();
    for (std::size_t bands = 0; bands < (has_warnings ? kBandVariants : 1); ++bands)
        for (const auto& of_focus : programs)
            for (const gl::Program& program : of_focus[bands])
                if (program.valid()) set_frame_uniforms(gl, program, input, range);
}

void TerrainDrawer::set_frame_uniforms(gl::Gl& gl, const gl::Program& program, const TerrainDrawInput& input,
                                       const DepthRange& range) const {
    program.use(gl);
    set_view_uniforms(gl, program, input.view, range);
    set_color_uniforms(gl, program, design_, input.haze_per_m);
    set_style_uniforms(gl, program, design_.terrain.style, input.view.focal_px);
    if (program.uniform(kTerrainAir) >= 0) set_air_uniforms(gl, program, kTerrainAir, input.air);
    gl->Uniform2f(program.uniform(kTerrainLeft), static_cast<float>(input.left.least), static_cast<float>(input.left.most));
    if (program.uniform(kTerrainShadow) >= 0)
        set_shadow_uniforms(gl, program, kTerrainShadow, input.shadow, glm::round(input.view.eye));
    if (focus_.is_any() && program.uniform(kTerrainFocus) >= 0)
        focus_.set_frame_uniforms(gl, program, kTerrainFocus, glm::round(input.view.eye));
    if (program.uniform(kTerrainAlert) >= 0)
        set_alert_uniforms(gl, program, kTerrainAlert, input.alert, glm::round(input.view.eye));
    if (is_coded()) set_height_range(gl, program, input.heights);
    gl->Uniform1i(program.uniform(kPalette), 0);
    for (std::size_t map = 0; map < design::kBakedMaps; ++map)
        gl->Uniform1i(program.uniform(kMapUniforms[map]), static_cast<GLint>(map + 1));
    if (has_ground_data()) ground_.set_frame_uniforms(gl, program, kGroundMapUnit, kGroundColorUnit);
    if (program.uniform(kGeometry) < 0) return;
    set_ray_uniforms(gl, program, input.view);
    gl->Uniform1i(program.uniform(kGeometry), static_cast<GLint>(kGeometryUnit));
}

std::size_t TerrainDrawer::page_variant(const terrain::ChunkEntry& entry, bool baked) const {
    if (baked && is_coast(entry)) return kWithCoast;
    if (!is_coded()) return baked ? kWithPages : kWithoutPages;
    return (entry.flags & (terrain::kChunkHasSea | terrain::kChunkHasVoid)) == 0 ? kWithPages : kWithoutPages;
}

const gl::Program& TerrainDrawer::use_program(gl::Gl& gl, const ProgramTable& programs, const terrain::ChunkEntry& entry,
                                              std::size_t pages, const TerrainDrawInput& input, bool in_focus) const {
    TerrainBands bands;
    if (input.warning_colors && !is_coded())
        bands = bands_within(design_.warning_bands, input.aircraft_msl_m - input.bands_lowered_m, input.gear_down,
                             entry.min_height_m, entry.max_height_m);
    // Codes of an alert have fewer steps, in the whole picture.
    const bool has_alert = is_coded() ? input.alert.is_shown() : input.alert.may_reach(double{entry.max_height_m});
    const std::size_t n = band_variant(std::max(bands.count, std::size_t{has_alert ? 1u : 0u}));
    const gl::Program& program = programs[in_focus ? kInFocus : kAcrossFoci][n][pages];
    program.use(gl);
    if (n > 0 && !is_coded()) {
        const auto count = static_cast<GLsizei>(kBandsOfVariant[n]);
        gl->Uniform4fv(program.uniform(kBandColor), count, bands.color);
        gl->Uniform1fv(program.uniform(kBandLower), count, bands.lower_m);
    }
    return program;
}

const gl::Program& TerrainDrawer::use_look(gl::Gl& gl, const ProgramTable& programs, const SelectedChunk& chunk,
                                           const TerrainDrawInput& input) const {
    const PageChoice page = page_of(chunk.key);
    const bool baked = page.slot != terrain::kNoSlot;
    const std::size_t pages = page_variant(*chunk.entry, baked);
    const FocusOfChunk focus = focus_.of_chunk(*chunk.entry, input.view);
    const gl::Program& program = use_program(gl, programs, *chunk.entry, pages, input, focus.is_in_focus);
    if (!focus.is_in_focus) GroundFocus::set_chunk_uniforms(gl, program, kTerrainFocus, focus);
    const terrain::Lattice& lattice = store_->lattice();
    set_chunk_uniforms(gl, program, {chunk, lattice, input.view.eye, input.light_direction}, design_.terrain.style);
    if (baked) set_page_uniforms(gl, program, lattice, chunk.key, page.owner, atlas_, page.slot);
    // Between land and missing data a filtered class would pass for sea.
    if (pages == kWithCoast) {
        const bool has_void = (store_->attribute_pages().entry(page.slot).flags & terrain::kChunkHasVoid) != 0;
        gl->Uniform1f(program.uniform(kCoastSharp), has_void ? 1.0f : 0.0f);
    }
    if (drape_.is_started()) {
        const PageChoice image = drape_of(chunk, input.view);
        if (image.slot != terrain::kNoSlot)
            set_drape_uniforms(gl, program, lattice, chunk.key, image.owner, drape_, image.slot);
        else
            set_no_drape(gl, program, drape_);
    }
    if (has_ground_data()) ground_.set_chunk_uniforms(gl, program, lattice, chunk.key);
    return program;
}

void TerrainDrawer::shade(gl::Gl& gl, base::Span<const SelectedChunk> selected, const TerrainDrawInput& input,
                          const gl::Texture& words) {
    use_looks(gl, input, {input.view.near_m, input.view.far_m}, true);
    words.bind(gl, kGeometryUnit);
    gl->Enable(GL_DEPTH_TEST);
    gl->Enable(GL_SCISSOR_TEST);
    gl->DepthFunc(GL_EQUAL);
    for (const SelectedChunk& chunk : selected) {
        const PixelRect part = part_of_picture(chunk, input.view);
        if (part.is_empty()) continue;
        const gl::Program& program = use_look(gl, style().shading, chunk, input);
        gl->Uniform1f(program.uniform(kChunkNumber), static_cast<float>(geometry_number(chunk)));
        gl->Scissor(part.left, part.bottom, part.right - part.left, part.top - part.bottom);
        screen_.draw(gl);
    }
    gl->DepthFunc(GL_LESS);
    gl->Disable(GL_SCISSOR_TEST);
    gl->Disable(GL_DEPTH_TEST);
}

}  // namespace tedavis::draw
