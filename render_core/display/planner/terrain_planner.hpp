/// Selects the chunks of the terrain that a frame shows, from the database file to the selection; no GL.
///
///   start(...) · plan(camera, design) each frame · seen_from(view) for the painter
///
/// Memory    the arenas given to start(). Thread  the display's. Failure  start() gives one message; a database that fails later
///           leaves coarser terrain and says so in the plan.
#pragma once

#include "render_core/base/ports/async_reader.hpp"
#include "render_core/base/ports/byte_source.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/display/planner/camera.hpp"
#include "render_core/draw/depth_plan.hpp"
#include "render_core/draw/drawn_design.hpp"
#include "render_core/draw/screen_part.hpp"
#include "render_core/draw/trace_state.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/terrain/chunk_indices.hpp"
#include "render_core/terrain/height_ceiling.hpp"
#include "render_core/terrain/line_of_sight.hpp"
#include "render_core/terrain/near_ground.hpp"

namespace tedavis::display {

/// Where terrain comes from; without a file there is none.
struct TerrainInput {
    base::ByteSource* file = nullptr;
    base::AsyncReader* reader = nullptr;  ///< of the same file, with reader_tickets() tickets
    terrain::ArrivalMode arrival = terrain::ArrivalMode::exact;
    base::Workers* workers = nullptr;  ///< for terrain that is traced; null: the display's own thread
};

/// The arenas, by budget line.
struct TerrainMemory {
    base::Arena &index, &records, &payloads, &attributes, &drape, &lod, &staging;
};

/// Whether the image drape that a style requests is shown, or why not.
enum class DrapeState : std::uint8_t {
    not_asked_for,
    shown,
    not_in_database,  ///< it was built without an image: the plain colour is drawn
    not_on_device,    ///< the device has no room for its pages
};

/// What plan() found; plain data.
struct TerrainPlan {
    terrain::LodResult lod;
    bool is_short = false;        ///< budgets leave a greater error than tau
    std::uint32_t pending = 0;    ///< chunks that were requested and have not arrived
    bool has_void = false;        ///< ground without data in view
    bool is_late = false;         ///< the file answers too slowly
    bool is_failing = false;      ///< parts of it cannot be read
    bool is_unmagnified = false;  ///< it is planned without the view's magnifiers, which left no room for it
};

/// Returns the plan of traced terrain: the whole database is drawn, no matter which chunks have arrived. `shades_chunks`: the
/// ground is shaded chunk by chunk, so that the selection must have found room.
[[nodiscard]] TerrainPlan as_traced(TerrainPlan plan, bool shades_chunks);

/// Returns the part of a message of start() that concerns the database, to follow the file's name; empty for other messages.
[[nodiscard]] std::string_view database_fault(std::string_view message);

/// The terrain of one camera, as a painter draws it. The chunks are valid until the next plan().
struct SeenTerrain {
    base::Span<const terrain::SelectedChunk> chunks;
    draw::DepthPlan depth;   ///< the ranges in which they are drawn
    draw::ScreenPart part;   ///< of the screen that all of them lie in; the whole of it where no pass of the design reads it
    bool is_traced = false;  ///< by rays instead of triangles
    const terrain::TerrainDatabase* database = nullptr;  ///< null: there is no terrain
};

class TerrainPlanner final : public terrain::DrawnMeshes {
public:
    [[nodiscard]] static std::uint32_t reader_tickets(const effects::DeviceSettings& device);
    /// Returns the bytes of the budget line lod_scratch for so many slots of chunks.
    [[nodiscard]] static std::uint64_t lod_bytes(std::uint32_t slots);

    /// Starts for the designs that the display changes between; the first is drawn first.
    [[nodiscard]] base::Error start(const TerrainInput& input, draw::DrawnDesigns designs, effects::DeviceSettings& device,
                                    const TerrainMemory& memory);
    [[nodiscard]] bool is_started() const { return started_; }
    /// Takes the abilities of the painter, before the first plan(): whether attribute pages are drawn, and whether it can trace.
    void follow_painter(bool reads_pages, draw::TraceState tracer);
    /// Plans for this design from now on.
    void set_design(const draw::DrawnDesign& design);

    [[nodiscard]] DrapeState drape(const design::TerrainStyle& style) const {
        return needs_map(style, design::BakedMap::drape) ? drape_ : DrapeState::not_asked_for;
    }
    /// Whether the planned frame is traced where its design requests it, or why not.
    [[nodiscard]] draw::TraceState trace_state() const { return trace_; }
    [[nodiscard]] bool is_traced() const { return trace_ == draw::TraceState::traced; }
    /// Has the frame that plan() has planned drawn by triangles, although rays could draw it.
    void draw_triangles() { trace_ = draw::TraceState::not_by_cost; }
    /// Whether traced ground of the design is shaded chunk by chunk.
    [[nodiscard]] bool shades_chunks() const { return shades_chunks_; }
    [[nodiscard]] const terrain::TerrainDatabase& database() const { return database_; }
    [[nodiscard]] terrain::HeightAnswer true_height(double latitude_rad, double longitude_rad);
    [[nodiscard]] terrain::HeightQuery& heights() { return heights_; }
    [[nodiscard]] terrain::HeightCeiling& ceiling() { return ceiling_; }
    [[nodiscard]] const terrain::TerrainStore& store() const { return store_; }
    [[nodiscard]] terrain::ChunkIndices& chunk_indices() { return chunk_indices_; }

    /// Selects the chunks of this frame from those that have arrived, and requests those that the view needs. `tau_factor`:
    /// factor of the error that the design allows.
    [[nodiscard]] TerrainPlan plan(const Camera& camera, const design::DesignSettings& design, double tau_factor = 1);
    /// Raises the worst error to that of the selected chunks in another view, if it is greater there; to be called after plan().
    void widen_error(const terrain::View& view, const design::DesignSettings& design, terrain::LodResult& lod);
    /// Replaces plan() in a frame without terrain: which chunks have arrived later depends on such frames, too.
    void rest();

    /// Replaces plan() in a frame that shows no terrain because the own ship is outside of the database: requests what the view
    /// needs, so that it has arrived when the own ship comes over the terrain.
    void approach(const Camera& camera, const design::DesignSettings& design, double tau_factor);

    /// Returns what plan() selected, for a painter; empty before start().
    [[nodiscard]] SeenTerrain seen_from(const terrain::View& view) const;
    /// Returns the depth of the farthest point that is drawn; 0 where nothing is drawn.
    [[nodiscard]] double farthest_depth_m(const terrain::View& view) const;
    /// Returns a distance from the eye beyond which there is no ground in the picture.
    [[nodiscard]] double farthest_m(const terrain::View& view) const;
    /// Returns a distance from the eye within which there is no ground in the picture.
    [[nodiscard]] double nearest_m(const terrain::View& view) const;

    /// Returns the drawn surface at a place, for what stands on the ground; to be called after plan().
    [[nodiscard]] terrain::DrawnPoint drawn_point(double latitude_rad, double longitude_rad);
    /// Returns lines of sight over the surface of this frame; to be called after plan(). The view must stay valid.
    [[nodiscard]] terrain::LineOfSight sight(const terrain::View& view) { return {database_.lattice(), selected(), *this, view}; }
    [[nodiscard]] base::Span<const terrain::ChunkVertex> vertices(const terrain::SelectedChunk& chunk) override;
    [[nodiscard]] base::Span<const std::uint16_t> stored_indices(const terrain::SelectedChunk& chunk) override;
    [[nodiscard]] base::Span<const std::uint16_t> drawn_indices(const terrain::SelectedChunk& chunk) override;
    [[nodiscard]] base::Span<const terrain::SelectedChunk> selected() const { return {selected_.data(), chunks_}; }

private:
    [[nodiscard]] draw::DepthPlan depth_plan(const terrain::View& view) const;
    [[nodiscard]] draw::ScreenPart drawn_part(const terrain::View& view) const;
    [[nodiscard]] terrain::View over_ground(terrain::View view);
    [[nodiscard]] bool can_magnify(const terrain::View& view, const terrain::LodSettings& lod);
    [[nodiscard]] terrain::LodResult ask_for(const terrain::View& view, const terrain::LodSettings& lod);
    [[nodiscard]] terrain::LodResult select_drawn(const terrain::View& view, terrain::LodSettings lod);
    [[nodiscard]] std::uint32_t submitted_triangles(const terrain::View& view) const;
    [[nodiscard]] std::uint32_t parts_in_view() const;
    void decide_drape();
    [[nodiscard]] terrain::LodSettings lod_settings(const design::DesignSettings& design, const Camera& camera,
                                                    double tau_factor) const;
    void follow_view(const terrain::View& view);
    [[nodiscard]] base::Error start_store(const TerrainInput& input, const TerrainMemory& memory);
    [[nodiscard]] base::Error store_error(const TerrainMemory& memory, const terrain::StoreSettings& settings) const;
    [[nodiscard]] base::Error start_selection(const TerrainMemory& memory);

    effects::DeviceSettings* device_ = nullptr;
    terrain::TerrainDatabase database_;
    terrain::TerrainStore store_;
    terrain::HeightQuery heights_;
    terrain::HeightCeiling ceiling_;
    terrain::LodSelector selector_;
    terrain::ChunkIndices chunk_indices_;
    draw::TraceState tracer_ = draw::TraceState::not_asked_for;        ///< of the painter
    draw::TraceState design_trace_ = draw::TraceState::not_asked_for;  ///< of the design that is drawn
    draw::TraceState trace_ = draw::TraceState::not_asked_for;         ///< of it from the planned eye
    base::Span<terrain::SelectedChunk> selected_;
    base::Span<terrain::WantedChunk> wanted_;
    DrapeState drape_ = DrapeState::not_asked_for;
    bool shades_chunks_ = false;
    bool goes_off_screen_ = false;  ///< the design that is drawn: a pass reads the part of the screen
    terrain::DrapeDetail drape_detail_;
    std::uint32_t chunks_ = 0;
    bool started_ = false;
};

}  // namespace tedavis::display
