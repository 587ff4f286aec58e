/// Sets the uniforms of a terrain program: per frame and range of depths, per chunk, and per page.
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
/// Sets the rays of the view's pixels, for deferred shading.
void set_ray_uniforms(gl::Gl& gl, const gl::Program& program, const terrain::View& view);
/// `haze_per_m`: 1 / distance at which haze hides 1 - 1/e, 0 for none.
void set_color_uniforms(gl::Gl& gl, const gl::Program& program, const design::DesignSettings& design, double haze_per_m);
void set_style_uniforms(gl::Gl& gl, const gl::Program& program, const design::TerrainStyle& style, double focal_px);

/// Sets the pixel size, from which lines and strokes get their widths on the ground; `focal_px` is the focal length in pixels.
void set_pixel_uniform(gl::Gl& gl, const gl::Program& program, const design::TerrainStyle& style, double focal_px);

/// Sets the span of heights, for programs that write codes.
void set_height_range(gl::Gl& gl, const gl::Program& program, const HeightSpan& span);

struct ChunkUniforms {
    const terrain::SelectedChunk& chunk;
    const terrain::Lattice& lattice;
    const glm::dvec3& eye;               ///< ECEF
    const glm::dvec3* light_directions;  ///< unit vectors, ECEF; one per light of the style
};
void set_chunk_uniforms(gl::Gl& gl, const gl::Program& program, const ChunkUniforms& of, const design::TerrainStyle& style);

/// Sets where the maps of a chunk lie in the page of `owner`, which is the chunk or an ancestor.
void set_page_uniforms(gl::Gl& gl, const gl::Program& program, const terrain::Lattice& lattice, const terrain::ChunkKey& chunk,
                       const terrain::ChunkKey& owner, const PageAtlas& atlas, std::uint32_t slot);

/// Sets where a chunk lies in the drape page of `owner`, which is the chunk or an ancestor.
void set_drape_uniforms(gl::Gl& gl, const gl::Program& program, const terrain::Lattice& lattice, const terrain::ChunkKey& chunk,
                        const terrain::ChunkKey& owner, const DrapeAtlas& atlas, std::uint32_t slot);
/// The same for a chunk without a drape page, which is drawn with the transparent texel.
void set_no_drape(gl::Gl& gl, const gl::Program& program, const DrapeAtlas& atlas);

/// The surface grid over a lattice.
struct GridStep {
    double lines_east = 0, lines_south = 0;  ///< number of lines from post to post
    double first_east = 0, first_south = 0;  ///< position of the lattice's first post, in lines
    double east_rad = 0, south_rad = 0;      ///< angles from post to post
    double east_m = 0, south_m = 0;          ///< distance of lines at the middle latitude of the whole lattice
};
/// Lines with a spacing in metres are counted from the lattice's first post, lines with an angular spacing from 0 N 0 E.
[[nodiscard]] GridStep grid_step(const terrain::Lattice& lattice, const design::GridSettings& grid);

}  // namespace tedavis::draw
