#include "render_core/draw/terrain_drawer.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "render_core/draw/shader_texts.hpp"
#include "render_core/gl/draw_triangles.hpp"

namespace tedavis::draw {
namespace {

using terrain::ChunkVertex;

constexpr std::uint32_t kPaletteTexels = 1024;  // below the 8 bit steps of colour for any palette that is not a staircase
constexpr std::uint64_t kSlotVertexBytes = std::uint64_t{terrain::kMaxChunkVertices} * sizeof(ChunkVertex);
constexpr std::uint64_t kSlotIndices = std::uint64_t{terrain::kMaxChunkTriangles} * 3;

enum Attribute : GLuint { kPosition, kHeight, kNormal, kKind, kPlace };
constexpr gl::AttributeBinding kAttributes[] = {
    {"position", kPosition}, {"height", kHeight}, {"normal", kNormal}, {"kind", kKind}, {"place", kPlace}};

enum Uniform : std::size_t {
    kChunkOffset,
    kViewProjection,
    kLightDirection,
    kLight,
    kHaze,
    kPalette,
    kPaletteRange,
    kSeaColor,
    kHazeColor,
    kCommonUniforms
};
constexpr const char* kCommonNames[kCommonUniforms] = {"chunk_offset",  "view_projection", "light_direction",
                                                       "light",         "haze_per_m",      "palette",
                                                       "palette_range", "sea_color",       "haze_color"};

/// Bands that a program can tell apart; most chunks meet two at most, and each costs every fragment.
constexpr std::size_t kBandsOfProgram[TerrainDrawer::kBandVariants] = {0, 2, design::kMaxWarningBands};
constexpr const char* kBandDefines[] = {"", "#define WARNING_BANDS 2\n", "#define WARNING_BANDS 8\n"};
static_assert(design::kMaxWarningBands == 8);
constexpr const char* kRasterEndsDefine = "#define RASTER_ENDS 1\n";

/// Perspective with the view's axes in ECEF, from eye-relative metres to clip space (z -1..1).
glm::dmat4 view_projection(const terrain::View& view, const glm::dvec3& eye_fraction) {
    const double n = view.near_m, f = view.far_m;
    const double sx = 1.0 / view.half_width_tangent(), sy = 1.0 / view.half_height_tangent();
    const glm::dvec3 rows[3] = {view.right * sx, -view.down * sy, view.forward};
    const double zs = (f + n) / (f - n), zo = -2.0 * f * n / (f - n);
    glm::dmat4 m(0.0);
    for (int c = 0; c < 3; ++c) m[c] = {rows[0][c], rows[1][c], rows[2][c] * zs, rows[2][c]};
    const double depth = -glm::dot(rows[2], eye_fraction);
    m[3] = {-glm::dot(rows[0], eye_fraction), -glm::dot(rows[1], eye_fraction), depth * zs + zo, depth};
    return m;
}

void set_color(gl::Gl& gl, GLint location, design::Color c) {
    gl->Uniform4f(location, static_cast<float>(c.red) / 255.0f, static_cast<float>(c.green) / 255.0f,
                  static_cast<float>(c.blue) / 255.0f, static_cast<float>(c.alpha) / 255.0f);
}

void point_attributes(gl::Gl& gl, terrain::SlotIndex slot) {
    const std::uint64_t start = slot * kSlotVertexBytes;
    const auto at = [&](std::size_t offset) {
        return reinterpret_cast<const void*>(static_cast<std::uintptr_t>(start + offset));
    };
    constexpr GLsizei kStride = sizeof(ChunkVertex);
    gl->VertexAttribPointer(kPosition, 3, GL_FLOAT, GL_FALSE, kStride, at(offsetof(ChunkVertex, x)));
    gl->VertexAttribPointer(kHeight, 1, GL_FLOAT, GL_FALSE, kStride, at(offsetof(ChunkVertex, height_m)));
    gl->VertexAttribPointer(kNormal, 3, GL_BYTE, GL_TRUE, kStride, at(offsetof(ChunkVertex, normal)));
    gl->VertexAttribPointer(kKind, 1, GL_UNSIGNED_BYTE, GL_FALSE, kStride, at(offsetof(ChunkVertex, level_and_class)));
    gl->VertexAttribPointer(kPlace, 2, GL_UNSIGNED_SHORT, GL_FALSE, kStride, at(offsetof(ChunkVertex, i)));
}

}  // namespace

gl::GlError TerrainDrawer::start(gl::Gl& gl, const terrain::TerrainDatabase& database, terrain::ChunkCache& cache,
                                 const design::DesignSettings& design, effects::DeviceSettings& device, base::Arena& staging) {
    database_ = &database;
    cache_ = &cache;
    const std::uint32_t slots = device.max_chunk_slots;
    slots_ = staging.allocate_array<GpuSlot>(slots);
    index_staging_ = staging.allocate_array<std::uint16_t>(kSlotIndices);
    scratch_ = static_cast<terrain::ChunkMeshScratch*>(staging.allocate(sizeof *scratch_, alignof(terrain::ChunkMeshScratch)));
    if (slots_.empty() || index_staging_.empty() || scratch_ == nullptr)
        return gl::make_error(
            "the budget line 'staging' is too small for the terrain's index staging; raise it in the device file");

    base::BudgetLine* vertex_line = device.budget.find(effects::kTerrainVertices);
    base::BudgetLine* index_line = device.budget.find(effects::kTerrainIndices);
    base::BudgetLine* palette_line = device.budget.find(effects::kRenderTargets);
    auto vertices =
        gl::make_buffer(gl, *vertex_line, gl::BufferKind::vertices, gl::BufferUse::streamed, slots * kSlotVertexBytes);
    if (!vertices.ok()) return vertices.error();
    vertices_ = static_cast<gl::Buffer&&>(vertices.value());
    auto indices = gl::make_buffer(gl, *index_line, gl::BufferKind::indices, gl::BufferUse::streamed,
                                   slots * kSlotIndices * sizeof(std::uint16_t));
    if (!indices.ok()) return indices.error();
    indices_ = static_cast<gl::Buffer&&>(indices.value());
    auto palette = gl::make_texture(gl, *palette_line, {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, kPaletteTexels, 1});
    if (!palette.ok()) return palette.error();
    palette_ = static_cast<gl::Texture&&>(palette.value());
    if (gl::GlError error = build_programs(gl); !error.sentence.empty()) return error;
    set_design(gl, design);
    return {};
}

gl::GlError TerrainDrawer::build_programs(gl::Gl& gl) {
    for (std::size_t bands = 0; bands < kBandVariants; ++bands)
        for (const bool ends : {false, true}) {
            auto program = build_variant(gl, bands, ends);
            if (!program.ok()) return program.error();
            programs_[bands][ends ? 1 : 0] = program.value();
        }
    return {};
}

base::Result<TerrainDrawer::Variant, gl::GlError> TerrainDrawer::build_variant(gl::Gl& gl, std::size_t bands, bool raster_ends) {
    Variant variant;
    const char* names[kCommonUniforms + 3];
    std::size_t count = 0;
    const auto add = [&](const char* name) {
        names[count] = name;
        return count++;
    };
    for (const char* name : kCommonNames) add(name);
    if (bands > 0) {
        variant.band_color = add("band_color");
        variant.band_lower = add("band_lower");
    }
    if (raster_ends) variant.last_place = add("last_place");
    base::FixedString<kMaxShaderText> vertex(raster_ends ? kRasterEndsDefine : ""), fragment(vertex.view());
    vertex.append(shader_text(k_terrain_vert));
    fragment.append(kBandDefines[bands]);
    fragment.append(shader_text(k_terrain_frag));
    auto program =
        gl::build_program(gl, {"terrain", vertex.view(), fragment.view(), base::Span<const gl::AttributeBinding>(kAttributes),
                               base::Span<const char* const>(names, count)});
    if (!program.ok()) return base::fail(program.error());
    variant.program = program.value();
    return variant;
}

void TerrainDrawer::destroy(gl::Gl& gl) {
    for (auto& of_bands : programs_)
        for (Variant& variant : of_bands) variant.program.destroy(gl);
    palette_.destroy(gl);
    indices_.destroy(gl);
    vertices_.destroy(gl);
}

void TerrainDrawer::set_design(gl::Gl& gl, const design::DesignSettings& design) {
    design_ = design;
    const design::Palette& palette = design.terrain.palette;
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

bool TerrainDrawer::prepare(gl::Gl& gl, base::Span<const terrain::SelectedChunk> selected, std::uint64_t frame) {
    frame_ = frame;
    uploaded_ = 0;
    for (const terrain::SelectedChunk& chunk : selected) {
        const terrain::SlotIndex slot = cache_->acquire(chunk.chunk, frame);
        if (slot == terrain::kNoSlot || !upload(gl, slot, chunk)) return false;
    }
    return true;
}

bool TerrainDrawer::upload(gl::Gl& gl, terrain::SlotIndex slot, const terrain::SelectedChunk& selected) {
    GpuSlot& gpu = slots_[slot];
    const base::Span<const ChunkVertex> vertices = cache_->vertices(slot);
    if (gpu.loads != cache_->slot(slot).loads) {
        if (!vertices_.upload(gl, slot * kSlotVertexBytes, vertices.data(), vertices.size() * sizeof(ChunkVertex))) return false;
        uploaded_ += vertices.size() * sizeof(ChunkVertex);
        gpu.loads = cache_->slot(slot).loads;
        gpu.indexed = false;
    }
    if (gpu.indexed && gpu.coarser_edges == selected.coarser_edges) return true;
    const terrain::ChunkEntry& entry = database_->entry(selected.chunk);
    const terrain::FileHeader& header = database_->header();
    const terrain::MeshCount mesh =
        terrain::build_chunk_indices(vertices, {entry.level, entry.i, entry.j, header.columns - 1, header.rows - 1},
                                     selected.coarser_edges, *scratch_, index_staging_);
    if (!mesh.sound || !indices_.upload(gl, slot * kSlotIndices * sizeof(std::uint16_t), index_staging_.data(),
                                        mesh.indices * sizeof(std::uint16_t)))
        return false;
    uploaded_ += mesh.indices * sizeof(std::uint16_t);
    gpu = {gpu.loads, mesh.indices, selected.coarser_edges, true};
    return true;
}

TerrainDrawResult TerrainDrawer::draw(gl::Gl& gl, base::Span<const terrain::SelectedChunk> selected,
                                      const TerrainDrawInput& input) {
    TerrainDrawResult result;
    result.uploaded_bytes = uploaded_;
    const glm::dvec3 eye_whole = glm::round(input.view.eye);
    for (std::size_t bands = 0; bands < (input.warning_colors ? kBandVariants : 1); ++bands)
        for (const Variant& variant : programs_[bands]) set_frame_uniforms(gl, variant.program, input, eye_whole);
    palette_.bind(gl, 0);
    vertices_.bind(gl);
    indices_.bind(gl);
    for (GLuint attribute = kPosition; attribute <= kPlace; ++attribute) gl->EnableVertexAttribArray(attribute);
    for (const terrain::SelectedChunk& chunk : selected) draw_chunk(gl, chunk, input, eye_whole, result);
    for (GLuint attribute = kPosition; attribute <= kPlace; ++attribute) gl->DisableVertexAttribArray(attribute);
    result.complete = result.draws == selected.size();
    return result;
}

void TerrainDrawer::set_frame_uniforms(gl::Gl& gl, const gl::Program& program, const TerrainDrawInput& input,
                                       const glm::dvec3& eye_whole) const {
    program.use(gl);
    const glm::dmat4 matrix = view_projection(input.view, input.view.eye - eye_whole);
    float values[16];
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) values[4 * c + r] = static_cast<float>(matrix[c][r]);
    gl->UniformMatrix4fv(program.uniform(kViewProjection), 1, GL_FALSE, values);
    const glm::vec3 light(input.light_direction);
    gl->Uniform3f(program.uniform(kLightDirection), light.x, light.y, light.z);
    const auto ambient = static_cast<float>(design_.terrain.light.ambient);
    gl->Uniform2f(program.uniform(kLight), ambient, 1.0f - ambient);
    const double haze_m = design_.sky.haze_distance_m;
    gl->Uniform1f(program.uniform(kHaze), haze_m > 0 ? static_cast<float>(1.0 / haze_m) : 0.0f);
    gl->Uniform1i(program.uniform(kPalette), 0);
    const double low = design_.terrain.palette.stops[0].value, high = design_.terrain.palette.stops.back().value;
    gl->Uniform2f(program.uniform(kPaletteRange), static_cast<float>(low),
                  high > low ? static_cast<float>(1.0 / (high - low)) : 0.0f);
    set_color(gl, program.uniform(kSeaColor), design_.terrain.sea);
    set_color(gl, program.uniform(kHazeColor), design_.sky.haze);
}

/// The program that tells the bands of this chunk apart, in use and with them.
const TerrainDrawer::Variant& TerrainDrawer::use_variant(gl::Gl& gl, const terrain::ChunkEntry& entry,
                                                         const TerrainDrawInput& input) const {
    TerrainBands bands;
    if (input.warning_colors)
        bands =
            bands_within(design_.warning_bands, input.aircraft_msl_m, input.gear_down, entry.min_height_m, entry.max_height_m);
    std::size_t n = 0;
    while (kBandsOfProgram[n] < bands.count) ++n;
    const bool raster_ends = (entry.flags & terrain::kChunkHasOutside) != 0;
    const Variant& variant = programs_[n][raster_ends ? 1 : 0];
    variant.program.use(gl);
    if (n > 0) {
        const auto count = static_cast<GLsizei>(kBandsOfProgram[n]);
        gl->Uniform4fv(variant.program.uniform(variant.band_color), count, bands.color);
        gl->Uniform1fv(variant.program.uniform(variant.band_lower), count, bands.lower_m);
    }
    if (raster_ends) {
        const std::int64_t side = std::int64_t{terrain::kChunkCells} << entry.level;
        const auto beyond = [&](std::uint32_t posts, std::uint32_t at) { return static_cast<float>(posts - 1 - at * side); };
        gl->Uniform2f(variant.program.uniform(variant.last_place), beyond(database_->header().columns, entry.i),
                      beyond(database_->header().rows, entry.j));
    }
    return variant;
}

void TerrainDrawer::draw_chunk(gl::Gl& gl, const terrain::SelectedChunk& selected, const TerrainDrawInput& input,
                               const glm::dvec3& eye_whole, TerrainDrawResult& result) {
    const terrain::SlotIndex slot = cache_->acquire(selected.chunk, frame_);
    if (slot == terrain::kNoSlot || !slots_[slot].indexed) return;
    const terrain::ChunkEntry& entry = database_->entry(selected.chunk);
    const gl::Program& program = use_variant(gl, entry, input).program;
    gl->Uniform3f(program.uniform(kChunkOffset), static_cast<float>(entry.centre_m[0] - eye_whole.x),
                  static_cast<float>(entry.centre_m[1] - eye_whole.y), static_cast<float>(entry.centre_m[2] - eye_whole.z));
    point_attributes(gl, slot);
    gl::draw_triangles(gl, {static_cast<std::uint32_t>(slot * kSlotIndices), slots_[slot].index_count, entry.vertex_count - 1});
    result.triangles += slots_[slot].index_count / 3;
    ++result.draws;
}

}  // namespace tedavis::draw
