#include "render_core/draw/terrain_drawer.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include "render_core/draw/shader_texts.hpp"
#include "render_core/gl/draw_triangles.hpp"

namespace tedavis::draw {
namespace {

using terrain::ChunkVertex;

constexpr std::uint32_t kPaletteTexels = 256;
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
    kLastPlace,
    kBandColor,
    kBandLower
};
constexpr const char* kUniforms[] = {"chunk_offset", "view_projection", "light_direction", "light",
                                     "haze_per_m",   "palette",         "palette_range",   "sea_color",
                                     "haze_color",   "last_place",      "band_color",      "band_lower"};
constexpr std::size_t kPlainUniforms = 10;

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
    auto palette = gl::make_texture(gl, *palette_line, {gl::TextureFormat::rgba8, gl::TextureFilter::linear, kPaletteTexels, 1});
    if (!palette.ok()) return palette.error();
    palette_ = static_cast<gl::Texture&&>(palette.value());

    const base::Span<const gl::AttributeBinding> attributes(kAttributes);
    auto plain = gl::build_program(gl, {"terrain", shader_text(k_terrain_vert), shader_text(k_terrain_frag), attributes,
                                        base::Span<const char* const>(kUniforms, kPlainUniforms)});
    if (!plain.ok()) return plain.error();
    plain_ = static_cast<gl::Program&&>(plain.value());
    base::FixedString<kMaxShaderText> fragment("#define WARNING_BANDS 1\n");
    fragment.append(shader_text(k_terrain_frag));
    auto banded = gl::build_program(gl, {"terrain with warning colours", shader_text(k_terrain_vert), fragment.view(), attributes,
                                         base::Span<const char* const>(kUniforms)});
    if (!banded.ok()) return banded.error();
    banded_ = static_cast<gl::Program&&>(banded.value());
    set_design(gl, design);
    return {};
}

void TerrainDrawer::destroy(gl::Gl& gl) {
    plain_.destroy(gl);
    banded_.destroy(gl);
    palette_.destroy(gl);
    indices_.destroy(gl);
    vertices_.destroy(gl);
}

void TerrainDrawer::set_design(gl::Gl& gl, const design::DesignSettings& design) {
    design_ = design;
    const design::HeightPalette& stops = design.terrain.palette;
    const double low = stops[0].height_m, high = stops.back().height_m;
    std::uint8_t texels[kPaletteTexels * 4];
    for (std::uint32_t n = 0; n < kPaletteTexels; ++n) {
        const design::Color c = design::color_of_height(stops, low + (high - low) * n / (kPaletteTexels - 1));
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
    const gl::Program& program = input.warning_colors ? banded_ : plain_;
    program.use(gl);
    const glm::dvec3 eye_whole = glm::round(input.view.eye);
    const glm::dmat4 matrix = view_projection(input.view, input.view.eye - eye_whole);
    float values[16];
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) values[4 * c + r] = static_cast<float>(matrix[c][r]);
    gl->UniformMatrix4fv(program.uniform(kViewProjection), 1, GL_FALSE, values);
    set_frame_uniforms(gl, program, input);
    palette_.bind(gl, 0);
    vertices_.bind(gl);
    indices_.bind(gl);
    for (GLuint attribute = kPosition; attribute <= kPlace; ++attribute) gl->EnableVertexAttribArray(attribute);
    for (const terrain::SelectedChunk& chunk : selected) draw_chunk(gl, program, chunk, eye_whole, result);
    for (GLuint attribute = kPosition; attribute <= kPlace; ++attribute) gl->DisableVertexAttribArray(attribute);
    result.complete = result.draws == selected.size();
    return result;
}

void TerrainDrawer::set_frame_uniforms(gl::Gl& gl, const gl::Program& program, const TerrainDrawInput& input) const {
    const glm::vec3 light(input.light_direction);
    gl->Uniform3f(program.uniform(kLightDirection), light.x, light.y, light.z);
    const auto ambient = static_cast<float>(design_.terrain.light.ambient);
    gl->Uniform2f(program.uniform(kLight), ambient, 1.0f - ambient);
    const double haze_m = design_.sky.haze_distance_m;
    gl->Uniform1f(program.uniform(kHaze), haze_m > 0 ? static_cast<float>(1.0 / haze_m) : 0.0f);
    gl->Uniform1i(program.uniform(kPalette), 0);
    const double low = design_.terrain.palette[0].height_m, high = design_.terrain.palette.back().height_m;
    gl->Uniform2f(program.uniform(kPaletteRange), static_cast<float>(low),
                  high > low ? static_cast<float>(1.0 / (high - low)) : 0.0f);
    set_color(gl, program.uniform(kSeaColor), design_.terrain.sea);
    set_color(gl, program.uniform(kHazeColor), design_.sky.haze);
    if (input.warning_colors) set_bands(gl, program, input);
}

/// Design bands stand from the highest down; the shader wants them from the lowest up.
void TerrainDrawer::set_bands(gl::Gl& gl, const gl::Program& program, const TerrainDrawInput& input) const {
    float colors[design::kMaxWarningBands * 4] = {};
    float lower[design::kMaxWarningBands];
    for (float& limit : lower) limit = 1e9f;
    const std::size_t count = design_.warning_bands.size();
    for (std::size_t n = 0; n < count; ++n) {
        const design::WarningBand& band = design_.warning_bands[count - 1 - n];
        colors[4 * n] = static_cast<float>(band.color.red) / 255.0f;
        colors[4 * n + 1] = static_cast<float>(band.color.green) / 255.0f;
        colors[4 * n + 2] = static_cast<float>(band.color.blue) / 255.0f;
        colors[4 * n + 3] = static_cast<float>(band.strength);
        lower[n] = static_cast<float>(input.aircraft_msl_m + (input.gear_down ? band.lower_gear_down_m : band.lower_m));
    }
    gl->Uniform4fv(program.uniform(kBandColor), static_cast<GLsizei>(design::kMaxWarningBands), colors);
    gl->Uniform1fv(program.uniform(kBandLower), static_cast<GLsizei>(design::kMaxWarningBands), lower);
}

void TerrainDrawer::draw_chunk(gl::Gl& gl, const gl::Program& program, const terrain::SelectedChunk& selected,
                               const glm::dvec3& eye_whole, TerrainDrawResult& result) {
    const terrain::SlotIndex slot = cache_->acquire(selected.chunk, frame_);
    if (slot == terrain::kNoSlot || !slots_[slot].indexed) return;
    const terrain::ChunkEntry& entry = database_->entry(selected.chunk);
    const std::int64_t side = std::int64_t{terrain::kChunkCells} << entry.level;
    const auto beyond = [&](std::uint32_t posts, std::uint32_t at) { return static_cast<float>(posts - 1 - at * side); };
    gl->Uniform3f(program.uniform(kChunkOffset), static_cast<float>(entry.centre_m[0] - eye_whole.x),
                  static_cast<float>(entry.centre_m[1] - eye_whole.y), static_cast<float>(entry.centre_m[2] - eye_whole.z));
    gl->Uniform2f(program.uniform(kLastPlace), beyond(database_->header().columns, entry.i),
                  beyond(database_->header().rows, entry.j));
    point_attributes(gl, slot);
    gl::draw_triangles(gl, {static_cast<std::uint32_t>(slot * kSlotIndices), slots_[slot].index_count, entry.vertex_count - 1});
    result.triangles += slots_[slot].index_count / 3;
    ++result.draws;
}

}  // namespace tedavis::draw
