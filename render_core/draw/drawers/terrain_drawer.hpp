/// Draws the selected terrain chunks in the design's style, with warning colours where they apply.
///
/// Watertight between levels: the vertex shader adds a chunk offset of whole metres to positions on a binary grid; the
/// sum is the correctly rounded one of the same real number in every chunk that shares the vertex.
///
/// Memory    GPU slots, one per payload slot of the store, from the lines terrain_vertices and terrain_indices; pages from
///           terrain_pages and terrain_drape_pages; index staging from the arena. Thread  the GL thread. Failure  start() gives
///           one sentence.
#pragma once

#include "render_core/base/fixed_vector.hpp"
#include "render_core/design/phase_designs.hpp"
#include "render_core/draw/depth_plan.hpp"
#include "render_core/draw/drawers/drape_atlas.hpp"
#include "render_core/draw/drawers/geometry_picture.hpp"
#include "render_core/draw/drawers/ground_map.hpp"
#include "render_core/draw/drawers/page_atlas.hpp"
#include "render_core/draw/drawers/screen_triangle.hpp"
#include "render_core/draw/drawers/terrain_uniforms.hpp"
#include "render_core/draw/drawers/view_effects_pass.hpp"
#include "render_core/draw/terrain_bands.hpp"
#include "render_core/draw/terrain_draw_result.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/buffer.hpp"
#include "render_core/terrain/chunk_indices.hpp"
#include "render_core/terrain/lod_selection.hpp"
#include "render_core/terrain/terrain_store.hpp"

namespace tedavis::draw {

struct TerrainDrawInput {
    terrain::View view;
    double haze_per_m = 0;  ///< 1 / distance at which haze hides 1 - 1/e; 0 for none
    /// Unit vectors towards the lights of the style, ECEF.
    glm::dvec3 light_direction[design::kMaxLights];
    bool warning_colors = false;
    double aircraft_msl_m = 0;   ///< for warning colours
    double bands_lowered_m = 0;  ///< amount by which the limits of the bands are lowered
    bool gear_down = false;
    AlertZoneLook alert;
    HeightSpan heights;  ///< of the whole database, for codes
    AirFrame air;
    ShadowRead shadow;
    DistanceLeft left;                          ///< in alpha, where light shafts or blur round a focus read it
    const scene::FocusRegions* foci = nullptr;  ///< as many as the design has; must stay valid. Null: there are none
    bool blurs_context = true;                  ///< false: brightness replaces blur
};

class TerrainDrawer {
public:
    /// Programs for chunks without attribute pages, with pages, and with pages and a coast. For codes: programs that take sea and
    /// void from the vertices, that draw land alone, and that take the coast from the pages.
    static constexpr std::size_t kPageVariants = 3;

    /// Programs for chunks that are completely in focus, or in frames without foci, and for the others.
    static constexpr std::size_t kFocusVariants = 2;

    /// A design has up to eight styles: with its stated or raised weights, with or without a focus that has a position, and for
    /// chunks that are magnified or not.
    static constexpr std::size_t kMaxStyles = 8 * (design::kMaxPhaseDesigns + 1);

    /// Prepares the designs among which a running display changes; the first is the initial one. Store and index lists must
    /// outlive the drawer.
    [[nodiscard]] base::Error start(gl::Gl& gl, const terrain::TerrainStore& store, terrain::ChunkIndices& indices,
                                    DrawnDesigns designs, effects::DeviceSettings& device, base::Arena& staging);
    /// True where the programs and maps that a design needs exist.
    [[nodiscard]] bool shows(const DrawnDesign& design) const;
    /// Changes to another design, for which shows() must be true.
    void set_design(gl::Gl& gl, const DrawnDesign& design);

    /// Sets a finished slice of the field that colours the ground; null: none. Returns false where it does not fit.
    [[nodiscard]] bool set_ground_data(gl::Gl& gl, const scene::GridSlice* slice);
    /// Number of posts across and down that fit; 0 where the design does not request data on the ground. Valid after start().
    [[nodiscard]] std::uint32_t ground_side() const { return ground_.is_started() ? ground_.side() : 0; }

    /// Uploads available chunks that are missing on the GPU. Returns false when a chunk contradicts its format; the terrain
    /// must then not be drawn.
    [[nodiscard]] bool prepare(gl::Gl& gl, base::Span<const terrain::SelectedChunk> selected, const TerrainDrawInput& input);
    /// Draws the prepared chunks that reach into the range of depths into the bound framebuffer, with the caller's depth test
    /// and culling.
    void draw(gl::Gl& gl, base::Span<const terrain::SelectedChunk> selected, const TerrainDrawInput& input,
              const DepthRange& range, TerrainDrawResult& result);
    /// Draws ray-traced ground, for a design with deferred shading: shades each pixel of the geometry picture `words` once, with
    /// the program, uniforms and pages of its chunk. `selected` must be prepared, and the depth of the bound framebuffer must
    /// hold the chunk numbers (GeometryPicture::leave_numbers()). Leaves depth test and scissor test off.
    void shade(gl::Gl& gl, base::Span<const terrain::SelectedChunk> selected, const TerrainDrawInput& input,
               const gl::Texture& words);
    /// True where the style, or a coast in the database, needs attribute pages; valid after start().
    [[nodiscard]] bool reads_pages() const;
    void destroy(gl::Gl& gl);

private:
    enum PageVariant : std::size_t { kWithoutPages, kWithPages, kWithCoast };
    enum FocusVariant : std::size_t { kInFocus, kAcrossFoci };
    static constexpr std::uint32_t kFocusRow = 1;  ///< below the palette, where a design has foci

    using ProgramTable = gl::Program[kFocusVariants][kBandVariants][kPageVariants];

    /// One kind of style: designs that differ only in palettes, lights, strengths and bands share it.
    struct Style {
        design::TerrainStyle style;  ///< of the first such design, for same_programs()
        TerrainVariant variant;      ///< without bands and pages
        ProgramTable programs;
        ProgramTable shading;  ///< for shade(); only where a design has deferred shading
    };
    struct GpuSlot {
        std::uint32_t generation = 0;  ///< of the store's slot when it was uploaded
        std::uint32_t index_count = 0;
        std::uint8_t coarser_edges = 0;
        bool indexed = false;
    };
    struct PageSlot {
        std::uint32_t generation = 0;
        double azimuth_rad = -1;  ///< of the light that its horizon was mixed for
    };
    /// The page from which a chunk takes its maps; kNoSlot: none has been loaded.
    struct PageChoice {
        terrain::SlotIndex slot = terrain::kNoSlot;
        terrain::ChunkKey owner;
    };
    [[nodiscard]] base::Error start_memory(gl::Gl& gl, effects::DeviceSettings& device, base::Arena& staging);
    [[nodiscard]] base::Error start_palette(gl::Gl& gl, effects::DeviceSettings& device, bool with_foci);
    [[nodiscard]] base::Error start_pages(gl::Gl& gl, DrawnDesigns designs, effects::DeviceSettings& device,
                                          base::Arena& staging);
    [[nodiscard]] base::Error start_drape(gl::Gl& gl, effects::DeviceSettings& device, base::Arena& staging);
    [[nodiscard]] base::Error start_ground(gl::Gl& gl, DrawnDesigns designs, effects::DeviceSettings& device);
    [[nodiscard]] TerrainVariant variant_of(const DrawnDesign& design, bool is_magnified) const;
    /// Returns the index of a design's style; styles_.size() where there is none.
    [[nodiscard]] std::size_t style_of(const DrawnDesign& design, bool is_magnified) const;
    [[nodiscard]] base::Error add_style(gl::Gl& gl, const DrawnDesign& design, bool is_magnified);
    [[nodiscard]] base::Error build_programs(gl::Gl& gl, Style& style, bool deferred);
    [[nodiscard]] static bool has_shading(const Style& style, const DrawnDesign& design) {
        return !design.is_deferred || style.shading[kInFocus][0][kWithoutPages].valid();
    }
    void use_looks(gl::Gl& gl, const TerrainDrawInput& input, const DepthRange& range, bool deferred);
    void set_uniforms_of_programs(gl::Gl& gl, const ProgramTable& programs, const TerrainDrawInput& input,
                                  const DepthRange& range) const;
    [[nodiscard]] const Style& style() const { return styles_[style_]; }
    [[nodiscard]] bool magnifies(const TerrainDrawInput& input) const {
        return !input.view.magnifiers.empty() && magnified_style_ < styles_.size();
    }
    [[nodiscard]] bool has_ground_data() const { return style().variant.ground_data; }
    [[nodiscard]] bool is_coded() const { return style().variant.output == TerrainOutput::code; }
    void upload_palette(gl::Gl& gl);
    [[nodiscard]] bool upload_chunk(gl::Gl& gl, const terrain::SelectedChunk& chunk);
    [[nodiscard]] bool upload_page(gl::Gl& gl, const terrain::SelectedChunk& chunk, const TerrainDrawInput& input);
    [[nodiscard]] PageChoice page_of(const terrain::ChunkKey& key) const;
    [[nodiscard]] static bool is_coast(const terrain::ChunkEntry& entry);
    [[nodiscard]] bool database_has_coast() const;
    [[nodiscard]] PageChoice drape_of(const terrain::SelectedChunk& chunk, const terrain::View& view) const;
    [[nodiscard]] bool upload_drape(gl::Gl& gl, const terrain::SelectedChunk& chunk, const terrain::View& view);
    void set_frame_uniforms(gl::Gl& gl, const gl::Program& program, const TerrainDrawInput& input, const DepthRange& range) const;
    [[nodiscard]] std::size_t page_variant(const terrain::ChunkEntry& entry, bool baked) const;
    [[nodiscard]] const gl::Program& use_program(gl::Gl& gl, const ProgramTable& programs, const terrain::ChunkEntry& entry,
                                                 std::size_t pages, const TerrainDrawInput& input, bool in_focus) const;
    [[nodiscard]] const gl::Program& use_look(gl::Gl& gl, const ProgramTable& programs, const terrain::SelectedChunk& chunk,
                                              const TerrainDrawInput& input) const;
    void draw_mesh(gl::Gl& gl, const terrain::SelectedChunk& chunk, TerrainDrawResult& result) const;
    void draw_parts(gl::Gl& gl, const gl::Program& program, const terrain::SelectedChunk& chunk, const TerrainDrawInput& input,
                    TerrainDrawResult& result) const;
    void draw_chunk(gl::Gl& gl, const terrain::SelectedChunk& chunk, const TerrainDrawInput& input, TerrainDrawResult& result);

    const terrain::TerrainStore* store_ = nullptr;
    terrain::ChunkIndices* chunk_indices_ = nullptr;
    design::DesignSettings design_;
    base::FixedVector<Style, kMaxStyles> styles_;
    std::size_t style_ = 0, magnified_style_ = 0;  ///< of design_
    bool needs_maps_ = false;
    gl::Buffer vertices_, indices_;
    ScreenTriangle screen_;  ///< where shading is deferred
    gl::Texture palette_;    ///< not valid where all designs write codes: ColorTable holds the colours
    PageAtlas atlas_;
    DrapeAtlas drape_;
    GroundMap ground_;
    GroundFocus focus_;
    base::Span<GpuSlot> slots_;
    base::Span<PageSlot> page_slots_;
    base::Span<std::uint32_t> drape_generations_;  ///< by slot: the generation that was uploaded
};

}  // namespace tedavis::draw
