/// A slice of a scene's grid on the GPU, and the colours of its scale, for terrain programs with ground data.
///
/// Memory    GPU, from the budget line scene_ground. Thread  the GL thread. Failure  one sentence.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/design/data_style.hpp"
#include "render_core/gl/program.hpp"
#include "render_core/gl/texture.hpp"
#include "render_core/scene/grid_slice.hpp"
#include "render_core/terrain/lattice.hpp"

namespace tedavis::draw {

/// Maps a chunk to a grid: position in posts of the grid = position in the chunk * scale + offset.
struct GridWindow {
    double scale_i = 0, scale_j = 0, offset_i = 0, offset_j = 0;
};
/// Returns the mapping. Longitudes are taken the shorter way round the Earth from the middle of the grid.
[[nodiscard]] GridWindow grid_window(const terrain::Lattice& lattice, const terrain::ChunkKey& chunk,
                                     const scene::GridShape& grid);

class GroundMap {
public:
    /// Allocates the largest square, of side `max_texture_px` / 2^n, that fits the line besides the colours.
    [[nodiscard]] base::Error start(gl::Gl& gl, base::BudgetLine& line, std::uint32_t max_texture_px);
    [[nodiscard]] bool is_started() const { return map_.valid(); }
    /// Number of posts across and down that fit.
    [[nodiscard]] std::uint32_t side() const { return map_.settings().width_px; }

    /// Uploads a finished slice and the scale of its colours. Returns false, and shows nothing, where it does not fit.
    [[nodiscard]] bool upload(gl::Gl& gl, const scene::GridSlice& slice, const design::GroundData& look);
    /// Uploads only the scale. With a nominal palette classes have the colours of their names; classes without a colour count
    /// as missing.
    void set_look(gl::Gl& gl, const design::GroundData& look);
    void clear() { has_data_ = false; }
    [[nodiscard]] bool has_data() const { return has_data_; }

    /// Binds the two textures to these units.
    void bind(gl::Gl& gl, std::uint32_t map_unit, std::uint32_t color_unit) const;
    void set_frame_uniforms(gl::Gl& gl, const gl::Program& program, std::uint32_t map_unit, std::uint32_t color_unit) const;
    void set_chunk_uniforms(gl::Gl& gl, const gl::Program& program, const terrain::Lattice& lattice,
                            const terrain::ChunkKey& chunk) const;
    void destroy(gl::Gl& gl);

private:
    [[nodiscard]] float level_of(double limit, double reach) const;
    [[nodiscard]] bool is_nominal() const { return look_.scale.palette.is_nominal(); }
    [[nodiscard]] design::Color color_of_class(std::size_t number) const;
    [[nodiscard]] std::size_t limits() const;
    [[nodiscard]] double limit(std::size_t number) const;

    gl::Texture map_, colors_;
    design::GroundData look_;
    scene::GridShape grid_{};
    scene::SliceRange range_;
    bool is_classed_ = false;  ///< values are those of the nearest post
    bool has_data_ = false;
    base::FixedVector<design::ClassName, design::kMaxClasses> class_names_;  ///< of the slice's attribute
};

}  // namespace tedavis::draw
