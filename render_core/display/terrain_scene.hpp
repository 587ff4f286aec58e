/// The terrain of a display, from the database file to triangles on the surface.
///
///   start(...) · plan(eye, design) each frame, without GL · prepare(gl) · draw(gl, range)
///
/// Memory    the arenas and GPU lines given to start(). Thread  the display's. Failure  start() gives one sentence; a database
///           that fails later leaves coarser terrain and says so in the plan.
#pragma once

#include "render_core/base/ports/async_reader.hpp"
#include "render_core/base/ports/byte_source.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/display/eye.hpp"
#include "render_core/draw/depth_plan.hpp"
#include "render_core/draw/screen_grid.hpp"
#include "render_core/draw/terrain_drawer.hpp"
#include "render_core/draw/traced_terrain.hpp"
#include "render_core/terrain/drawn_sight.hpp"
#include "render_core/terrain/near_ground.hpp"

namespace tedavis::display {

/// Where terrain comes from; without a file there is none.
struct TerrainInput {
    base::ByteSource* file = nullptr;
    base::AsyncReader* reader = nullptr;  ///< of the same file, with reader_tickets() tickets
    terrain::ArrivalMode arrival = terrain::ArrivalMode::exact;
    base::Workers* workers = nullptr;  ///< for terrain that is traced; null: the display's own thread
};

/// By budget line.
struct TerrainMemory {
    base::Arena &index, &records, &payloads, &attributes, &drape, &lod, &staging;
};

/// What becomes of the image drape that a style asks for.
enum class DrapeState : std::uint8_t {
    not_asked_for,
    shown,
    not_in_database,  ///< it was built without an image: the plain colour is drawn
    not_on_device,    ///< which has no room for its pages
};

/// What plan() found; plain data.
struct TerrainPlan {
    terrain::LodResult lod;
    std::uint32_t pending = 0;    ///< chunks wanted and not there yet
    bool has_void = false;        ///< ground without data in view
    bool is_late = false;         ///< the file answers too slowly
    bool is_failing = false;      ///< parts of it cannot be had
    bool is_unmagnified = false;  ///< the view's magnifiers left no room for it, and it is planned without
};

/// The same where the terrain is traced: everything that the database has is drawn, whatever has arrived of its chunks.
[[nodiscard]] TerrainPlan as_traced(TerrainPlan plan);

/// What a sentence of start() says of the database, to stand behind the file's name; empty for a sentence about other things.
[[nodiscard]] std::string_view database_fault(std::string_view sentence);

class TerrainScene final : public terrain::DrawnMeshes {
public:
    [[nodiscard]] static std::uint32_t reader_tickets(const effects::DeviceSettings& device);

    /// For designs that follow one another; the first is drawn first. `traced`: where terrain is traced, if a design wants it.
    [[nodiscard]] base::Error start(gl::Gl& gl, const TerrainInput& input, draw::DrawnDesigns designs,
                                    effects::DeviceSettings& device, const TerrainMemory& memory,
                                    const draw::TracePlace& traced = {});
    [[nodiscard]] bool is_started() const { return started_; }
    /// Whether what start() built shows a design, too.
    [[nodiscard]] bool shows(const draw::DrawnDesign& design) const;
    /// From here on this design, which shows() has said it can.
    void set_design(gl::Gl& gl, const draw::DrawnDesign& design);
    void destroy(gl::Gl& gl);

    [[nodiscard]] DrapeState drape(const design::TerrainStyle& style) const {
        return needs_map(style, design::BakedMap::drape) ? drape_ : DrapeState::not_asked_for;
    }
    /// What becomes of tracing in the planned frame, where the design that is drawn wants it.
    [[nodiscard]] draw::TraceState trace_state() const { return trace_; }
    [[nodiscard]] bool is_traced() const { return trace_ == draw::TraceState::traced; }
    [[nodiscard]] const terrain::TerrainDatabase& database() const { return database_; }
    [[nodiscard]] terrain::HeightAnswer true_height(double latitude_rad, double longitude_rad);

    /// Chooses the chunks of this frame from what is there, and asks for what the view needs. `tau_factor`: of the error
    /// that the design allows.
    [[nodiscard]] TerrainPlan plan(const Eye& eye, const design::DesignSettings& design, double tau_factor = 1);
    /// After plan(): of the chosen chunks seen from elsewhere, too, where that makes the worst error greater.
    void widen_error(const terrain::View& view, const design::DesignSettings& design, terrain::LodResult& lod);
    /// The slice of the scene that colours the ground; null for none. After start(). False where the device has no room for it.
    [[nodiscard]] bool set_ground_data(gl::Gl& gl, const scene::GridSlice* slice) { return drawer_.set_ground_data(gl, slice); }
    /// Posts across and down that such a slice may have; 0 where the design did not ask for any.
    [[nodiscard]] std::uint32_t ground_side() const { return drawer_.ground_side(); }
    /// Instead of plan() in a frame without terrain: what has arrived later follows from such frames as well.
    void rest();
    /// Uploads what is new. False when nothing of the terrain may be drawn.
    [[nodiscard]] bool prepare(gl::Gl& gl, const draw::TerrainDrawInput& input);
    /// Not where it is traced.
    void draw(gl::Gl& gl, const draw::TerrainDrawInput& input, const draw::DepthRange& range, draw::TerrainDrawResult& result);
    /// Where it is traced: its codes, into a picture.
    void draw_traced(gl::Gl& gl, const draw::TerrainDrawInput& input, const gl::Texture& picture);
    /// The depths of what was drawn; colours are nothing.
    void draw_depths(gl::Gl& gl, const draw::TerrainDrawInput& input, const draw::DepthRange& range,
                     draw::TerrainDrawResult& result);

    /// Depth of the farthest point that is drawn; 0 when nothing is.
    [[nodiscard]] double farthest_depth_m(const terrain::View& view) const;
    /// The ranges in which the selected chunks are drawn.
    [[nodiscard]] draw::DepthPlan depth_plan(const terrain::View& view) const;
    /// No ground in the picture is farther from the eye.
    [[nodiscard]] double farthest_m(const terrain::View& view) const;
    /// Nor is any nearer.
    [[nodiscard]] double nearest_m(const terrain::View& view) const;

    /// The part of the screen that everything drawn lies in, bounded along the picture's vertical.
    [[nodiscard]] draw::ScreenPart drawn_part(const terrain::View& view) const;

    /// The drawn surface at a place, for what stands on the ground; after prepare().
    [[nodiscard]] terrain::DrawnPoint drawn_point(double latitude_rad, double longitude_rad);
    /// Over the surface of this frame; after plan(). The view must stay.
    [[nodiscard]] terrain::DrawnSight sight(const terrain::View& view) { return {database_.lattice(), selected(), *this, view}; }
    [[nodiscard]] base::Span<const terrain::ChunkVertex> vertices(const terrain::SelectedChunk& chunk) override;
    [[nodiscard]] base::Span<const std::uint16_t> stored_indices(const terrain::SelectedChunk& chunk) override;
    [[nodiscard]] base::Span<const std::uint16_t> drawn_indices(const terrain::SelectedChunk& chunk) override;
    [[nodiscard]] base::Span<const terrain::SelectedChunk> selected() const { return {selected_.data(), chunks_}; }

private:
    [[nodiscard]] terrain::View over_ground(terrain::View view);
    [[nodiscard]] bool can_magnify(const terrain::View& view, const terrain::LodSettings& lod);
    [[nodiscard]] terrain::LodResult select_drawn(const terrain::View& view, terrain::LodSettings lod);
    [[nodiscard]] std::uint32_t submitted_triangles(const terrain::View& view) const;
    [[nodiscard]] std::uint32_t parts_in_view() const;
    void decide_drape();
    [[nodiscard]] terrain::LodSettings lod_settings(const design::DesignSettings& design, const Eye& eye,
                                                    double tau_factor) const;
    [[nodiscard]] base::Error start_tracing(gl::Gl& gl, draw::DrawnDesigns designs, draw::TracePlace place);
    void follow_trace(const draw::DrawnDesign& design);
    void follow_trace(const terrain::View& view);
    [[nodiscard]] draw::TerrainDrawInput no_farther(draw::TerrainDrawInput input) const;
    [[nodiscard]] base::Error start_store(const TerrainInput& input, const TerrainMemory& memory);
    [[nodiscard]] base::Error start_selection(base::Arena& lod);

    effects::DeviceSettings* device_ = nullptr;
    terrain::TerrainDatabase database_;
    terrain::TerrainStore store_;
    terrain::HeightQuery heights_;
    terrain::LodSelector selector_;
    draw::TerrainDrawer drawer_;
    draw::TracedTerrain traced_;
    draw::TraceState design_trace_ = draw::TraceState::not_asked_for;  ///< of the design that is drawn
    draw::TraceState trace_ = draw::TraceState::not_asked_for;         ///< of it from the planned eye
    design::DesignSettings design_;                                    ///< that is drawn, where it is traced
    base::Span<terrain::SelectedChunk> selected_;
    base::Span<terrain::WantedChunk> wanted_;
    DrapeState drape_ = DrapeState::not_asked_for;
    terrain::DrapeDetail drape_detail_;
    std::uint32_t chunks_ = 0;
    bool started_ = false;
};

}  // namespace tedavis::display
