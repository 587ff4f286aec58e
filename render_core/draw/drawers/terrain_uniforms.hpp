/// Sets the uniforms of a terrain program: once a frame and range of depths, once a chunk, once a page.
///
/// Thread  the GL thread; the program must be in use.
#pragma once

#include <glm/vec3.hpp>

#include "render_core/draw/depth_plan.hpp"
#include "render_core/draw/drawers/color_table.hpp"
#include "render_core/draw/drawers/drape_atlas.hpp"
#include "render_core/draw/drawers/page_atlas.hpp"
#include "render_core/draw/drawers/terrain_program.hpp"
#include "render_core/draw/texel_size.hpp"
#include "render_core/terrain/lod_selection.hpp"
#include "render_core/terrain/view.hpp"

namespace tedavis::draw {

void set_view_uniforms(gl::Gl& gl, const gl::Program& program, const terrain::View& view, const DepthRange& range);
/// The rays of a view's pixels, for deferred shading.
void set_ray_uniforms(gl::Gl& gl, const gl::Program& program, const terrain::View& view);
/// `haze_per_m`: 1 / distance at which haze hides 1 - 1/e, 0 for none.
void set_color_uniforms(gl::Gl& gl, const gl::Program& program, const design::DesignSettings& design, double haze_per_m);
void set_style_uniforms(gl::Gl& gl, const gl::Program& program, const design::TerrainStyle& style, double focal_px);

/// How wide lines and strokes are on the ground, for so many pixels a unit tangent.
void set_pixel_uniform(gl::Gl& gl, const gl::Program& program, const design::TerrainStyle& style, double focal_px);

/// For programs that write codes.
void set_height_range(gl::Gl& gl, const gl::Program& program, const HeightSpan& span);

struct ChunkUniforms {
    const terrain::SelectedChunk& chunk;
    const terrain::Lattice& lattice;
    const glm::dvec3& eye;               ///< ECEF
    const glm::dvec3* light_directions;  ///< ECEF, one a light of the style
};
void set_chunk_uniforms(gl::Gl& gl, const gl::Program& program, const ChunkUniforms& of, const design::TerrainStyle& style);

/// Where the maps of a chunk lie in the page of `owner`, itself or an ancestor.
void set_page_uniforms(gl::Gl& gl, const gl::Program& program, const terrain::Lattice& lattice, const terrain::ChunkKey& chunk,
                       const terrain::ChunkKey& owner, const PageAtlas& atlas, std::uint32_t slot);

/// Where a chunk lies in the drape page of `owner`, itself or an ancestor.
void set_drape_uniforms(gl::Gl& gl, const gl::Program& program, const terrain::Lattice& lattice, const terrain::ChunkKey& chunk,
                        const terrain::ChunkKey& owner, const DrapeAtlas& atlas, std::uint32_t slot);
/// For a chunk without such a page.
void set_no_drape(gl::Gl& gl, const gl::Program& program, const DrapeAtlas& atlas);

/// Lines of the surface grid from post to post of a lattice, and the angles between these.
struct GridStep {
    double lines_east = 0, lines_south = 0;
    double first_east = 0, first_south = 0;  ///< the lattice's first post, counted in lines
    double east_rad = 0, south_rad = 0;
    double east_m = 0, south_m = 0;  ///< from line to line at the middle latitude of the whole lattice
};
/// Of lines by length the first post lies on two; lines by angle are the Earth's, counted from 0 N 0 E.
[[nodiscard]] GridStep grid_step(const terrain::Lattice& lattice, const design::GridSettings& grid);

}  // namespace tedavis::draw
