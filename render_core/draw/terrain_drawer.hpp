/// Draws the selected terrain chunks: hypsometric tint, Lambert light, haze, and the warning colours where they hold.
///
/// Watertight between levels: the vertex shader adds a chunk offset of whole metres to positions on a binary grid; the
/// sum is the correctly rounded one of the same real number in every chunk that shares the vertex.
///
/// Memory    GPU slots, one a cache slot, from the lines terrain_vertices and terrain_indices; index staging from the
///           arena. Thread  the GL thread. Failure  start() gives one sentence.
#pragma once

#include "render_core/design/design_settings.hpp"
#include "render_core/draw/terrain_bands.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/buffer.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/texture.hpp"
#include "render_core/terrain/chunk_cache.hpp"
#include "render_core/terrain/chunk_mesh.hpp"
#include "render_core/terrain/lod_selection.hpp"

namespace tedavis::draw {

struct TerrainDrawInput {
    terrain::View view;
    glm::dvec3 light_direction;  ///< ECEF, towards the light
    bool warning_colors = false;
    double aircraft_msl_m = 0;  ///< for warning colours
    bool gear_down = false;
};

struct TerrainDrawResult {
    std::uint32_t triangles = 0;
    std::uint32_t draws = 0;
    std::uint64_t uploaded_bytes = 0;
    bool complete = false;  ///< every selected chunk was drawn
};

class TerrainDrawer {
public:
    static constexpr std::size_t kBandVariants = 3;  ///< programs for no, few and all warning bands

    [[nodiscard]] gl::GlError start(gl::Gl& gl, const terrain::TerrainDatabase& database, terrain::ChunkCache& cache,
                                    const design::DesignSettings& design, effects::DeviceSettings& device, base::Arena& staging);
    /// Palette, light and bands of another design; no new objects.
    void set_design(gl::Gl& gl, const design::DesignSettings& design);

    /// Reads and uploads what is missing. False when a chunk cannot be had: then nothing of the terrain may be drawn.
    [[nodiscard]] bool prepare(gl::Gl& gl, base::Span<const terrain::SelectedChunk> selected, std::uint64_t frame);
    /// Draws what prepare() made ready, into the bound framebuffer with depth test and culling as the caller set them.
    [[nodiscard]] TerrainDrawResult draw(gl::Gl& gl, base::Span<const terrain::SelectedChunk> selected,
                                         const TerrainDrawInput& input);
    void destroy(gl::Gl& gl);
    [[nodiscard]] const terrain::TdbFailure& failure() const { return cache_->failure(); }

private:
    struct GpuSlot {
        std::uint64_t loads = 0;  ///< of the cache slot when it was uploaded
        std::uint32_t index_count = 0;
        std::uint8_t coarser_edges = 0;
        bool indexed = false;
    };
    [[nodiscard]] bool upload(gl::Gl& gl, terrain::SlotIndex slot, const terrain::SelectedChunk& selected);
    struct Variant {
        gl::Program program;
        std::size_t band_color = 0, band_lower = 0, last_place = 0;  ///< uniforms beside the common ones
    };
    [[nodiscard]] gl::GlError build_programs(gl::Gl& gl);
    [[nodiscard]] static base::Result<Variant, gl::GlError> build_variant(gl::Gl& gl, std::size_t bands, bool raster_ends);
    void set_frame_uniforms(gl::Gl& gl, const gl::Program& program, const TerrainDrawInput& input,
                            const glm::dvec3& eye_whole) const;
    [[nodiscard]] const Variant& use_variant(gl::Gl& gl, const terrain::ChunkEntry& entry, const TerrainDrawInput& input) const;
    void draw_chunk(gl::Gl& gl, const terrain::SelectedChunk& selected, const TerrainDrawInput& input,
                    const glm::dvec3& eye_whole, TerrainDrawResult& result);

    const terrain::TerrainDatabase* database_ = nullptr;
    terrain::ChunkCache* cache_ = nullptr;
    design::DesignSettings design_;
    Variant programs_[kBandVariants][2];  ///< by bands; the second is for chunks in which the raster ends
    gl::Buffer vertices_, indices_;
    gl::Texture palette_;
    base::Span<GpuSlot> slots_;
    base::Span<std::uint16_t> index_staging_;
    terrain::ChunkMeshScratch* scratch_ = nullptr;
    std::uint64_t frame_ = 0;
    std::uint64_t uploaded_ = 0;
};

}  // namespace tedavis::draw
