#include "render_core/draw/drawers/terrain_drawer.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/gl/draw_triangles.hpp"
#include "render_core/terrain/projected_error.hpp"

namespace tedavis::draw {
namespace {

using design::BakedMap;
using terrain::ChunkVertex;
using terrain::SelectedChunk;

constexpr std::uint32_t kPaletteTexels = 1024;  // below the 8 bit steps of colour for any palette that is not a staircase
constexpr std::uint64_t kSlotVertexBytes = std::uint64_t{terrain::kMaxChunkVertices} * sizeof(ChunkVertex);
constexpr std::uint64_t kSlotIndices = terrain::ChunkIndices::kMaxIndices;

void point_attributes(gl::Gl& gl, terrain::SlotIndex slot) {
    const std::uint64_t start = slot * kSlotVertexBytes;
    const auto at = [&](std::size_t offset) {
        return reinterpret_cast<const void*>(static_cast<std::uintptr_t>(start + offset));
    };
    constexpr GLsizei kStride = sizeof(ChunkVertex);
    gl->VertexAttribPointer(kTerrainPosition, 3, GL_FLOAT, GL_FALSE, kStride, at(offsetof(ChunkVertex, x)));
    gl->VertexAttribPointer(kTerrainHeight, 1, GL_FLOAT, GL_FALSE, kStride, at(offsetof(ChunkVertex, height_m)));
    gl->VertexAttribPointer(kTerrainNormal, 3, GL_BYTE, GL_TRUE, kStride, at(offsetof(ChunkVertex, normal)));
    gl->VertexAttribPointer(kTerrainKind, 1, GL_UNSIGNED_BYTE, GL_FALSE, kStride, at(offsetof(ChunkVertex, kind)));
    gl->VertexAttribPointer(kTerrainPlace, 2, GL_UNSIGNED_SHORT, GL_FALSE, kStride, at(offsetof(ChunkVertex, i)));
}

bool has_foci(DrawnDesigns designs) {
    bool has = false;
    for (const DrawnDesign& design : designs) has = has || design.has_focus;
    return has;
}

}  // namespace

base::Error TerrainDrawer::start(gl::Gl& gl, const terrain::TerrainStore& store, terrain::ChunkIndices& indices,
                                 DrawnDesigns designs, effects::DeviceSettings& device, base::Arena& staging) {
    store_ = &store;
    chunk_indices_ = &indices;
    design_ = *designs[0].design;
    if (base::Error error = start_memory(gl, device, staging)) return error;
    if (base::Error error = start_pages(gl, designs, device, staging)) return error;
    if (base::Error error = start_drape(gl, device, staging)) return error;
    if (base::Error error = start_ground(gl, designs, device)) return error;
    bool are_coded = true, are_deferred = false;
    for (const DrawnDesign& design : designs) {
        are_coded = are_coded && design.output == TerrainOutput::code;
        are_deferred = are_deferred || design.is_deferred;
        if (base::Error error = add_style(gl, design, false)) return error;
        if (!design::magnifies(*design.design)) continue;
        if (base::Error error = add_style(gl, design, true)) return error;
    }
    magnified_style_ = style_of(designs[0], true);
    if (are_deferred)
        if (base::Error error = screen_.start(gl, device.budget)) return error;
    return are_coded ? base::Error{} : start_palette(gl, device, has_foci(designs));
}

base::Error TerrainDrawer::add_style(gl::Gl& gl, const DrawnDesign& design, bool is_magnified) {
    const std::size_t known = style_of(design, is_magnified);
    if (known < styles_.size() && has_shading(styles_[known], design)) return {};
    if (known < styles_.size()) return build_programs(gl, styles_[known], true);
    if (!styles_.try_push_back({design.design->terrain.style, variant_of(design, is_magnified), {}, {}}))
        return base::make_error("the design names more phases' designs than kMaxPhaseDesigns; remove some");
    if (base::Error error = build_programs(gl, styles_.back(), false)) return error;
    return design.is_deferred ? build_programs(gl, styles_.back(), true) : base::Error{};
}

bool TerrainDrawer::shows(const DrawnDesign& design) const {
    const bool has_parts = !design::magnifies(*design.design) || style_of(design, true) < styles_.size();
    const std::size_t known = style_of(design, false);
    return has_parts && known < styles_.size() && has_shading(styles_[known], design);
}

base::Error TerrainDrawer::start_memory(gl::Gl& gl, effects::DeviceSettings& device, base::Arena& staging) {
    const std::uint32_t slots = device.max_chunk_slots;
    slots_ = staging.allocate_array<GpuSlot>(slots);
    if (slots_.empty()) return base::shortage_error(effects::kStaging, staging, "max_chunk_slots");
    for (GpuSlot& slot : slots_) slot = GpuSlot{};
    auto vertices = gl::make_buffer(gl, *device.budget.find(effects::kTerrainVertices), gl::BufferKind::vertices,
                                    gl::BufferUse::streamed, slots * kSlotVertexBytes);
    if (!vertices.ok()) return vertices.error();
    vertices_ = static_cast<gl::Buffer&&>(vertices.value());
    auto indices = gl::make_buffer(gl, *device.budget.find(effects::kTerrainIndices), gl::BufferKind::indices,
                                   gl::BufferUse::streamed, slots * kSlotIndices * sizeof(std::uint16_t));
    if (!indices.ok()) return indices.error();
    indices_ = static_cast<gl::Buffer&&>(indices.value());
    return {};
}

base::Error TerrainDrawer::start_palette(gl::Gl& gl, effects::DeviceSettings& device, bool with_foci) {
    auto palette =
        gl::make_texture(gl, *device.budget.find(effects::kRenderTargets),
                         {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, kPaletteTexels, with_foci ? kFocusRow + 1 : 1});
    if (!palette.ok()) return palette.error();
    palette_ = static_cast<gl::Texture&&>(palette.value());
    upload_palette(gl);
    return {};
}

base::Error TerrainDrawer::start_ground(gl::Gl& gl, DrawnDesigns designs, effects::DeviceSettings& device) {
    for (const DrawnDesign& design : designs)
        if (design.design->data.ground.is_shown)
            return ground_.start(gl, *device.budget.find(effects::kSceneGround), device.capability.gl.max_texture_px);
    return {};
}

TerrainVariant TerrainDrawer::variant_of(const DrawnDesign& drawn, bool is_magnified) const {
    const design::DesignSettings& design = *drawn.design;
    TerrainVariant variant;
    variant.output = drawn.output;
    variant.magnified = is_magnified;
    variant.lifted = design.terrain.conservative_up;
    variant.flat = design.view.reference == design::Reference::flat;
    variant.ground_data = design.data.ground.is_shown;
    if (variant.ground_data) {
        variant.uncertainty = design.data.ground.uncertainty.technique;
        variant.overlay = design.data.ground.overlay.technique;
    }
    variant.fine_distance = has_air_in_picture(drawn);
    variant.air = design.sky.air.is_shown && !variant.fine_distance;
    variant.shafts = has_shafts_only(design) && drawn.output == TerrainOutput::color_and_distance;
    variant.shadows = design.effects.shadows.on_ground > 0;
    if (drawn.has_focus) variant.focus = ground_focus_kind(design.foci);
    for (std::size_t map = 0; map < design::kBakedMaps; ++map) variant.maps[map] = atlas_.has(static_cast<BakedMap>(map));
    variant.maps[static_cast<std::size_t>(BakedMap::drape)] = drape_.is_started();
    return variant;
}

std::size_t TerrainDrawer::style_of(const DrawnDesign& design, bool is_magnified) const {
    const TerrainVariant variant = variant_of(design, is_magnified);
    for (std::size_t n = 0; n < styles_.size(); ++n)
        if (variant == styles_[n].variant && covers(styles_[n].variant.focus, variant.focus) &&
            same_programs(styles_[n].style, design.design->terrain.style))
            return n;
    return styles_.size();
}

base::Error TerrainDrawer::build_programs(gl::Gl& gl, Style& style, bool deferred) {
    TerrainVariant variant = style.variant;
    variant.deferred = deferred;
    const bool is_coded = variant.output == TerrainOutput::code;
    for (std::size_t bands = 0; bands < (is_coded ? kCodeBandVariants : kBandVariants); ++bands)
        for (std::size_t n = 0; n < kPageVariants * (variant.focus.foci > 0 ? kFocusVariants : 1); ++n) {
            const std::size_t pages = n % kPageVariants, focus = n / kPageVariants;
            const bool land_codes = is_coded && pages == kWithPages;
            if (pages > 0 && !atlas_.is_started() && !land_codes) continue;
            if (pages == kWithCoast && !database_has_coast()) continue;
            variant.bands = kBandsOfVariant[bands];
            variant.baked = pages > 0;
            variant.coast = pages == kWithCoast;
            variant.classes = !land_codes;
            variant.in_focus = focus == kInFocus;
            auto program = build_terrain_program(gl, style.style, variant);
            if (!program.ok()) return program.error();
            (deferred ? style.shading : style.programs)[focus][bands][pages] = program.value();
        }
    return {};
}

void TerrainDrawer::destroy(gl::Gl& gl) {
    for (Style& style : styles_)
        for (ProgramTable* const programs : {&style.programs, &style.shading})
            for (auto& of_focus : *programs)
                for (auto& of_bands : of_focus)
                    for (gl::Program& program : of_bands) program.destroy(gl);
    screen_.destroy(gl);
    ground_.destroy(gl);
    drape_.destroy(gl);
    atlas_.destroy(gl);
    palette_.destroy(gl);
    indices_.destroy(gl);
    vertices_.destroy(gl);
}

void TerrainDrawer::set_design(gl::Gl& gl, const DrawnDesign& design) {
    style_ = style_of(design, false);
    magnified_style_ = style_of(design, true);
    TEDAVIS_CHECK(style_ < styles_.size());
    design_ = *design.design;
    if (ground_.has_data() && has_ground_data()) ground_.set_look(gl, design_.data.ground);
    if (palette_.valid()) upload_palette(gl);
}

bool TerrainDrawer::set_ground_data(gl::Gl& gl, const scene::GridSlice* slice) {
    if (slice != nullptr) return has_ground_data() && ground_.upload(gl, *slice, design_.data.ground);
    ground_.clear();
    return true;
}

void TerrainDrawer::upload_palette(gl::Gl& gl) {
    const design::Palette& palette = design_.terrain.palette;
    const double low = palette.stops[0].value, high = palette.stops.back().value;
    std::uint8_t texels[kPaletteTexels * 4];
    for (std::uint32_t n = 0; n < kPaletteTexels; ++n) {
        const design::Color c = design::color_of_value(palette, low + (high - low) * n / (kPaletteTexels - 1));
        texels[4 * n] = c.red;
        texels[4 * n + 1] = c.green;
        texels[4 * n + 2] = c.blue;
        texels[4 * n + 3] = 255;
    }
    TEDAVIS_CHECK(palette_.upload(gl, {0, 0, kPaletteTexels, 1}, texels));
}

bool TerrainDrawer::prepare(gl::Gl& gl, base::Span<const SelectedChunk> selected, const TerrainDrawInput& input) {
    for (const SelectedChunk& chunk : selected)
        if (chunk.slot == terrain::kNoSlot || !upload_chunk(gl, chunk) || !upload_page(gl, chunk, input) ||
            !upload_drape(gl, chunk, input.view))
            return false;
    return true;
}

bool TerrainDrawer::upload_chunk(gl::Gl& gl, const SelectedChunk& chunk) {
    GpuSlot& gpu = slots_[chunk.slot];
    const std::uint32_t generation = store_->generation(chunk.slot);
    if (gpu.generation != generation) {
        const base::Span<const ChunkVertex> vertices = store_->vertices(chunk.slot);
        const std::uint64_t bytes = vertices.size() * sizeof(ChunkVertex);
        if (!vertices_.upload(gl, chunk.slot * kSlotVertexBytes, vertices.data(), bytes)) return false;
        gpu = {generation, 0, 0, false};
    }
    if (gpu.indexed && gpu.coarser_edges == chunk.coarser_edges) return true;
    const terrain::IndexList list = chunk_indices_->of(chunk);
    if (!list.sound || !indices_.upload(gl, chunk.slot * kSlotIndices * sizeof(std::uint16_t), list.indices.data(),
                                        list.indices.size() * sizeof(std::uint16_t)))
        return false;
    gpu = {generation, static_cast<std::uint32_t>(list.indices.size()), chunk.coarser_edges, true};
    return true;
}

void TerrainDrawer::draw(gl::Gl& gl, base::Span<const SelectedChunk> selected, const TerrainDrawInput& input,
                         const DepthRange& range, TerrainDrawResult& result) {
    use_looks(gl, input, range, false);
    vertices_.bind(gl);
    indices_.bind(gl);
    for (GLuint attribute = 0; attribute < kTerrainAttributes; ++attribute) gl->EnableVertexAttribArray(attribute);
    for (const SelectedChunk& chunk : selected) {
        const DepthRange depths = terrain::depth_span(*chunk.entry, input.view, double{greatest_lift_m(chunk.lift)});
        if (overlap(depths, range) && slots_[chunk.slot].indexed) draw_chunk(gl, chunk, input, result);
    }
    for (GLuint attribute = 0; attribute < kTerrainAttributes; ++attribute) gl->DisableVertexAttribArray(attribute);
}

void TerrainDrawer::draw_chunk(gl::Gl& gl, const SelectedChunk& chunk, const TerrainDrawInput& input, TerrainDrawResult& result) {
    const bool is_in_parts =
        magnifies(input) &&
        earth::is_magnified(input.view.magnifiers, terrain::extent_of(*chunk.entry, double{greatest_lift_m(chunk.lift)}));
    const ProgramTable& programs = is_in_parts ? styles_[magnified_style_].programs : style().programs;
    const gl::Program& program = use_look(gl, programs, chunk, input);
    point_attributes(gl, chunk.slot);
    is_in_parts ? draw_parts(gl, program, chunk, input, result) : draw_mesh(gl, chunk, result);
}

void TerrainDrawer::draw_mesh(gl::Gl& gl, const SelectedChunk& chunk, TerrainDrawResult& result) const {
    const std::uint32_t index_count = slots_[chunk.slot].index_count;
    gl::draw_triangles(gl, {static_cast<std::uint32_t>(chunk.slot * kSlotIndices), index_count,
                            static_cast<std::uint32_t>(chunk.entry->vertex_count - 1)});
    result.triangles += index_count / 3;
    ++result.draws;
}

/// Lines and strokes are as wide on the screen in each.
void TerrainDrawer::draw_parts(gl::Gl& gl, const gl::Program& program, const SelectedChunk& chunk, const TerrainDrawInput& input,
                               TerrainDrawResult& result) const {
    const earth::GroundExtent extent = terrain::extent_of(*chunk.entry, double{greatest_lift_m(chunk.lift)});
    earth::MagnifiedParts parts(input.view.magnifiers, extent);
    for (earth::MagnifiedPart part; parts.next(part);) {
        set_magnifier_uniforms(gl, program, kTerrainMagnifier, part, glm::round(input.view.eye));
        set_pixel_uniform(gl, program, design_.terrain.style, input.view.focal_px * part.scale());
        draw_mesh(gl, chunk, result);
    }
}

}  // namespace tedavis::draw
