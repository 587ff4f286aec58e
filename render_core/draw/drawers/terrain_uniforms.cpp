#include "render_core/draw/drawers/terrain_uniforms.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/draw/drawers/view_projection.hpp"

namespace tedavis::draw {
namespace {

// Strokes on the ground are told apart over so many metres before their coordinates begin again; a power of two, as all sizes
// of strokes are.
constexpr double kGroundPeriod_m = 131072;

void set_vec3(gl::Gl& gl, GLint location, const glm::dvec3& v) {
    gl->Uniform3f(location, static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
}

void set_color(gl::Gl& gl, GLint location, design::Color c) {
    set_vec3(gl, location, {c.red / 255.0, c.green / 255.0, c.blue / 255.0});
}

void set_color_and(gl::Gl& gl, GLint location, design::Color c, double fourth) {
    const auto share = [](std::uint8_t level) { return static_cast<float>(level) / 255.0f; };
    gl->Uniform4f(location, share(c.red), share(c.green), share(c.blue), static_cast<float>(fourth));
}

glm::dvec3 axis_of(const terrain::ChunkEntry& entry, int n) {
    return {entry.axes[3 * n], entry.axes[3 * n + 1], entry.axes[3 * n + 2]};
}

void set_to_local(gl::Gl& gl, GLint location, const glm::dvec3& east, const glm::dvec3& north, const glm::dvec3& up) {
    float columns[9];
    for (int c = 0; c < 3; ++c) {
        columns[3 * c] = static_cast<float>(east[c]);
        columns[3 * c + 1] = static_cast<float>(north[c]);
        columns[3 * c + 2] = static_cast<float>(up[c]);
    }
    gl->UniformMatrix3fv(location, 1, GL_FALSE, columns);
}

std::size_t lights_used(const design::ShadeSettings& shade) {
    return shade.technique == design::TerrainShade::lights ? shade.light_count : 1;
}

void set_light_colors(gl::Gl& gl, const gl::Program& program, const design::ShadeSettings& shade) {
    const std::size_t count = lights_used(shade);
    float values[3 * design::kMaxLights];
    for (std::size_t n = 0; n < count; ++n) {
        const design::Color color = shade.lights[n].color;
        values[3 * n] = static_cast<float>(color.red) / 255.0f;
        values[3 * n + 1] = static_cast<float>(color.green) / 255.0f;
        values[3 * n + 2] = static_cast<float>(color.blue) / 255.0f;
    }
    gl->Uniform3fv(program.uniform(kLightColor), static_cast<GLsizei>(count), values);
    set_color(gl, program.uniform(kAmbientColor), shade.ambient_color);
}

void set_lights(gl::Gl& gl, GLint location, const ChunkUniforms& of, const design::ShadeSettings& shade,
                const glm::dvec3 (&local)[3]) {
    const std::size_t count = lights_used(shade);
    double weights = 0;
    for (std::size_t n = 0; n < count; ++n) weights += shade.lights[n].weight;
    float values[4 * design::kMaxLights];
    for (std::size_t n = 0; n < count; ++n) {
        for (std::size_t a = 0; a < 3; ++a) values[4 * n + a] = static_cast<float>(glm::dot(of.light_directions[n], local[a]));
        values[4 * n + 3] = count > 1 && weights > 0 ? static_cast<float>(shade.lights[n].weight / weights) : 1.0f;
    }
    gl->Uniform4fv(location, static_cast<GLsizei>(count), values);
}

/// Row by row: north-west corner, north side, north-east corner, west side, inside, ...
void set_lift(gl::Gl& gl, const gl::Program& program, const ChunkUniforms& of) {
    const terrain::ChunkLift& lift = of.chunk.lift;
    const float by_place[9] = {lift.corner_m[0], lift.edge_m[0],   lift.corner_m[1], lift.edge_m[3],  lift.own_m,
                               lift.edge_m[1],   lift.corner_m[2], lift.edge_m[2],   lift.corner_m[3]};
    gl->Uniform1fv(program.uniform(kLift), 9, by_place);
}

struct PostStep {
    double east_rad, south_rad;
};
PostStep post_step(const terrain::Lattice& lattice) {
    const std::uint32_t j = lattice.rows() / 2;
    return {lattice.longitude_rad(1) - lattice.longitude_rad(0), lattice.latitude_rad(j - 1) - lattice.latitude_rad(j)};
}

/// Metres a post at the middle latitude of the whole lattice, so that strokes meet at every chunk's border.
GroundSize common_cell(const terrain::Lattice& lattice) {
    const double latitude = lattice.latitude_rad(lattice.rows() / 2);
    const PostStep step = post_step(lattice);
    return {step.east_rad * earth::prime_vertical_radius_m(latitude) * std::cos(latitude),
            step.south_rad * earth::meridian_radius_m(latitude)};
}

void set_strokes(gl::Gl& gl, const gl::Program& program, const ChunkUniforms& of) {
    const GroundSize cell = common_cell(of.lattice);
    const terrain::PostRange posts = of.lattice.posts_of(of.chunk.key);
    gl->Uniform4f(program.uniform(kStrokeWindow), static_cast<float>(cell.east_m), static_cast<float>(cell.north_m),
                  static_cast<float>(std::fmod(posts.i0 * cell.east_m, kGroundPeriod_m)),
                  static_cast<float>(std::fmod(posts.j0 * cell.north_m, kGroundPeriod_m)));
}

/// Lines of a chunk by its posts, from the nearest line before its first one.
void set_grid(gl::Gl& gl, const gl::Program& program, const ChunkUniforms& of, const design::GridSettings& grid) {
    const GridStep step = grid_step(of.lattice, grid);
    const terrain::PostRange posts = of.lattice.posts_of(of.chunk.key);
    const double first_east = step.first_east + posts.i0 * step.lines_east;
    const double first_south = step.first_south + posts.j0 * step.lines_south;
    gl->Uniform4f(program.uniform(kGridWindow), static_cast<float>(step.lines_east), static_cast<float>(step.lines_south),
                  static_cast<float>(first_east - std::floor(first_east)),
                  static_cast<float>(first_south - std::floor(first_south)));
    const std::uint32_t rows = of.lattice.rows();
    const double here = std::cos(of.lattice.latitude_rad((posts.j0 + posts.j1) / 2)),
                 middle = std::cos(of.lattice.latitude_rad(rows / 2));
    const double east_m = grid.is_angular() ? step.east_m * here / middle : step.east_m;
    gl->Uniform2f(program.uniform(kGridSpacing), static_cast<float>(east_m), static_cast<float>(step.south_m));
}

}  // namespace

void set_view_uniforms(gl::Gl& gl, const gl::Program& program, const terrain::View& view, const DepthRange& range) {
    const glm::dvec3 eye_whole = glm::round(view.eye);
    set_matrix(gl, program.uniform(kViewProjection), view_projection(view, range, view.eye - eye_whole));
    if (program.uniform(kEarthCentre) >= 0) set_vec3(gl, program.uniform(kEarthCentre), -eye_whole);
    if (program.uniform(kFlatHeight) >= 0) gl->Uniform1f(program.uniform(kFlatHeight), static_cast<float>(view.flat_msl_m));
}

void set_ray_uniforms(gl::Gl& gl, const gl::Program& program, const terrain::View& view) {
    const double pixel = 1 / view.focal_px;
    const glm::dvec3 axes[4] = {
        view.eye - glm::round(view.eye),
        view.forward - view.half_width_tangent() * view.right + view.half_height_tangent() * view.down,
        pixel * view.right,
        -pixel * view.down,
    };
    float values[12];
    for (int n = 0; n < 4; ++n)
        for (int a = 0; a < 3; ++a) values[3 * n + a] = static_cast<float>(axes[n][a]);
    gl->Uniform3fv(program.uniform(kRayAxes), 4, values);
}

void set_color_uniforms(gl::Gl& gl, const gl::Program& program, const design::DesignSettings& design, double haze_per_m) {
    set_color(gl, program.uniform(kPlainColor), design.terrain.style.plain);
    set_color(gl, program.uniform(kSeaColor), design.terrain.sea);
    set_color(gl, program.uniform(kUnknownColor), design.terrain.unknown);
    set_color(gl, program.uniform(kMissingColor), design.data.missing);
    set_color(gl, program.uniform(kHazeColor), design.sky.haze);
    set_color(gl, program.uniform(kLineColor), design.terrain.style.sketch.line);
    gl->Uniform1f(program.uniform(kHazePerM), static_cast<float>(haze_per_m));
    const design::Palette& palette = design.terrain.palette;
    const double low = palette.stops[0].value, high = palette.stops.back().value;
    gl->Uniform2f(program.uniform(kPaletteRange), static_cast<float>(low),
                  high > low ? static_cast<float>(1.0 / (high - low)) : 0.0f);
}

void set_style_uniforms(gl::Gl& gl, const gl::Program& program, const design::TerrainStyle& style, double focal_px) {
    const design::ShadeSettings& shade = style.shade;
    const design::SketchSettings& sketch = style.sketch;
    const auto number = [](double value) { return static_cast<float>(value); };
    gl->Uniform4f(program.uniform(kLight), number(shade.ambient), number(1 - shade.ambient), number(shade.highlight),
                  number(shade.highlight_exponent));
    if (program.uniform(kLightColor) >= 0) set_light_colors(gl, program, shade);
    gl->Uniform2f(program.uniform(kOcclusion), number(shade.ambient_occlusion), number(shade.openness));
    gl->Uniform4f(program.uniform(kFormLines), number(sketch.ridges), number(sketch.valleys), number(sketch.suggestive_contours),
                  number(sketch.contours));
    gl->Uniform2f(program.uniform(kContour), number(1 / sketch.contour_interval_m), static_cast<float>(sketch.contour_index));
    gl->Uniform2f(program.uniform(kStrokes), number(sketch.hatching), number(sketch.stippling));
    set_pixel_uniform(gl, program, style, focal_px);
    set_color_and(gl, program.uniform(kGridLook), style.grid.line, style.grid.strength);
    set_color_and(gl, program.uniform(kNaturalWoods), style.woods, style.tree_line_m);
    set_color_and(gl, program.uniform(kNaturalRock), style.rock, style.grain);
}

void set_pixel_uniform(gl::Gl& gl, const gl::Program& program, const design::TerrainStyle& style, double focal_px) {
    gl->Uniform2f(program.uniform(kPixel), static_cast<float>(1 / focal_px), static_cast<float>(style.sketch.stroke_spacing_px));
}

void set_height_range(gl::Gl& gl, const gl::Program& program, const HeightSpan& span) {
    const double reach_m = span.highest_m - span.lowest_m;
    gl->Uniform2f(program.uniform(kHeightRange), static_cast<float>(span.lowest_m),
                  reach_m > 0 ? static_cast<float>(1 / reach_m) : 1.0f);
}

void set_chunk_uniforms(gl::Gl& gl, const gl::Program& program, const ChunkUniforms& of, const design::TerrainStyle& style) {
    const terrain::ChunkEntry& entry = *of.chunk.entry;
    const glm::dvec3 eye_whole = glm::round(of.eye);
    set_vec3(gl, program.uniform(kChunkOffset), glm::dvec3(entry.centre_m[0], entry.centre_m[1], entry.centre_m[2]) - eye_whole);
    const glm::dvec3 local[3] = {axis_of(entry, 1), axis_of(entry, 0), -axis_of(entry, 2)};
    set_to_local(gl, program.uniform(kToLocal), local[0], local[1], local[2]);
    if (program.uniform(kLights) >= 0) set_lights(gl, program.uniform(kLights), of, style.shade, local);
    const terrain::PostRange posts = of.lattice.posts_of(of.chunk.key);
    gl->Uniform2f(program.uniform(kPlaceEnd), static_cast<float>(posts.i1 - posts.i0), static_cast<float>(posts.j1 - posts.j0));
    if (program.uniform(kLift) >= 0) set_lift(gl, program, of);
    if (program.uniform(kStrokeWindow) >= 0) set_strokes(gl, program, of);
    if (program.uniform(kGridWindow) >= 0) set_grid(gl, program, of, style.grid);
}

void set_page_uniforms(gl::Gl& gl, const gl::Program& program, const terrain::Lattice& lattice, const terrain::ChunkKey& chunk,
                       const terrain::ChunkKey& owner, const PageAtlas& atlas, std::uint32_t slot) {
    const terrain::PostRange posts = lattice.posts_of(chunk), page = lattice.posts_of(owner);
    const auto texels_per_post = 1.0f / static_cast<float>(1u << (owner.level - 1));
    gl->Uniform4f(program.uniform(kPageWindow), texels_per_post, texels_per_post,
                  static_cast<float>(posts.i0 - page.i0) * texels_per_post,
                  static_cast<float>(posts.j0 - page.j0) * texels_per_post);
    const PageOrigin origin = atlas.origin(slot);
    gl->Uniform4f(program.uniform(kPageOrigin), origin.map_x, origin.map_y, origin.horizon_x, origin.horizon_y);
    gl->Uniform2f(program.uniform(kPageScale), atlas.map_scale(), atlas.horizon_scale());
    const GroundSize texel = texel_size(lattice, owner);
    gl->Uniform2f(program.uniform(kPageTexel), static_cast<float>(texel.east_m), static_cast<float>(texel.north_m));
}

void set_drape_uniforms(gl::Gl& gl, const gl::Program& program, const terrain::Lattice& lattice, const terrain::ChunkKey& chunk,
                        const terrain::ChunkKey& owner, const DrapeAtlas& atlas, std::uint32_t slot) {
    const terrain::PostRange posts = lattice.posts_of(chunk), page = lattice.posts_of(owner);
    constexpr float kTexelsPerPost = terrain::kDrapeSteps / static_cast<float>(terrain::kChunkCells);
    const float texels_per_post = kTexelsPerPost / static_cast<float>(1u << owner.level);
    gl->Uniform3f(program.uniform(kDrapeWindow), texels_per_post, static_cast<float>(posts.i0 - page.i0) * texels_per_post,
                  static_cast<float>(posts.j0 - page.j0) * texels_per_post);
    const DrapeOrigin origin = atlas.origin(slot);
    const GroundSize texel = drape_texel_size(lattice, owner);
    gl->Uniform4f(program.uniform(kDrapeOrigin), origin.x, origin.y, static_cast<float>(texel.east_m / texel.north_m),
                  atlas.scale());
}

void set_no_drape(gl::Gl& gl, const gl::Program& program, const DrapeAtlas& atlas) {
    gl->Uniform3f(program.uniform(kDrapeWindow), 0, 0, 0);
    gl->Uniform4f(program.uniform(kDrapeOrigin), atlas.nowhere().x, atlas.nowhere().y, 1, atlas.scale());
}

GridStep grid_step(const terrain::Lattice& lattice, const design::GridSettings& grid) {
    const GroundSize cell = common_cell(lattice);
    const PostStep step = post_step(lattice);
    if (!grid.is_angular())
        return {cell.east_m / grid.spacing_m,
                cell.north_m / grid.spacing_m,
                0,
                0,
                step.east_rad,
                step.south_rad,
                grid.spacing_m,
                grid.spacing_m};
    const double lines_east = step.east_rad / grid.spacing_rad, lines_south = step.south_rad / grid.spacing_rad;
    const std::uint32_t middle = lattice.rows() / 2;  // the first row may be a pole's, which is nearer
    return {lines_east,
            lines_south,
            lattice.longitude_rad(0) / grid.spacing_rad,
            -lattice.latitude_rad(middle) / grid.spacing_rad - middle * lines_south,
            step.east_rad,
            step.south_rad,
            cell.east_m / lines_east,
            cell.north_m / lines_south};
}

}  // namespace tedavis::draw
