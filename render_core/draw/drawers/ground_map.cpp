#include "render_core/draw/drawers/ground_map.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/base/units.hpp"
#include "render_core/draw/drawers/terrain_program.hpp"
#include "render_core/earth/geodetic.hpp"

namespace tedavis::draw {
namespace {

constexpr std::uint32_t kColors = 1024, kColorRows = 2;
constexpr std::uint32_t kSmallestSide = 16;
constexpr std::size_t kBreaks = design::kMaxClasses - 1;  // in the shader
constexpr double kBeyond = 1e9;                           // of any value 0..1

void put(std::uint8_t* texel, design::Color c) {
    texel[0] = c.red;
    texel[1] = c.green;
    texel[2] = c.blue;
    texel[3] = c.alpha;
}

}  // namespace

GridWindow grid_window(const terrain::Lattice& lattice, const terrain::ChunkKey& chunk, const scene::GridShape& grid) {
    const terrain::PostRange posts = lattice.posts_of(chunk);
    const double step_lon = earth::angle_difference(lattice.longitude_rad(1), lattice.longitude_rad(0));
    // Rows at the poles stand closer than the others; the middle of the lattice has the step of all.
    const std::uint32_t j = lattice.rows() / 2;
    const double step_lat = lattice.latitude_rad(j - 1) - lattice.latitude_rad(j);
    const double middle_rad = grid.west_rad + 0.5 * grid.step_lon_rad * (grid.columns - 1.0);
    const double from_middle = earth::angle_difference(lattice.longitude_rad(posts.i0), earth::wrap_longitude(middle_rad));
    GridWindow window;
    window.scale_i = step_lon / grid.step_lon_rad;
    window.scale_j = step_lat / grid.step_lat_rad;
    window.offset_i = 0.5 * (grid.columns - 1.0) + from_middle / grid.step_lon_rad;
    window.offset_j = (grid.north_rad - lattice.latitude_rad(posts.j0)) / grid.step_lat_rad;
    return window;
}

base::Error GroundMap::start(gl::Gl& gl, base::BudgetLine& line, std::uint32_t max_texture_px) {
    const std::uint64_t color_bytes = std::uint64_t{kColors} * kColorRows * 4;
    std::uint32_t side = max_texture_px;
    while (side >= kSmallestSide && std::uint64_t{side} * side * 4 + color_bytes > line.bytes) side /= 2;
    if (side < kSmallestSide)
        return base::shortage_error(line, kSmallestSide * kSmallestSide * 4 + color_bytes, "data on the ground");
    auto colors = gl::make_texture(gl, line, {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, kColors, kColorRows});
    if (!colors.ok()) return colors.error();
    colors_ = static_cast<gl::Texture&&>(colors.value());
    auto map = gl::make_texture(gl, line, {gl::TextureFormat::rgba8, gl::TextureFilter::nearest, side, side});
    if (!map.ok()) return map.error();
    map_ = static_cast<gl::Texture&&>(map.value());
    return {};
}

bool GroundMap::upload(gl::Gl& gl, const scene::GridSlice& slice, const design::GroundData& look) {
    has_data_ = false;
    if (!slice.has_texels() || slice.columns() > side() || slice.rows() > side()) return false;
    if (!map_.upload(gl, {0, 0, slice.columns(), slice.rows()}, slice.texels().data())) return false;
    grid_ = slice.layer()->entry->grid;
    range_ = slice.range();
    is_classed_ = slice.attribute()->entry->scale != scene::AttributeScale::quantitative;
    has_data_ = true;
    class_names_.clear();
    for (std::uint32_t n = 0; n < slice.attribute()->entry->class_count; ++n)
        static_cast<void>(class_names_.try_push_back(design::ClassName(slice.attribute()->class_name(n))));
    set_look(gl, look);
    return true;
}

void GroundMap::set_look(gl::Gl& gl, const design::GroundData& look) {
    look_ = look;
    const design::Palette& palette = look.scale.palette;
    const double low = palette.stops[0].value, high = palette.stops.back().value;
    std::uint8_t texels[kColors * kColorRows * 4];
    for (std::uint32_t n = 0; n < kColors; ++n) {
        put(texels + 4 * n, design::color_of_value(palette, low + (high - low) * n / (kColors - 1)));
        put(texels + 4 * (kColors + n), color_of_class(std::min<std::size_t>(n, limits())));
    }
    TEDAVIS_CHECK(colors_.upload(gl, {0, 0, kColors, kColorRows}, texels));
}

void GroundMap::bind(gl::Gl& gl, std::uint32_t map_unit, std::uint32_t color_unit) const {
    map_.bind(gl, map_unit);
    colors_.bind(gl, color_unit);
}

design::Color GroundMap::color_of_class(std::size_t number) const {
    if (!is_nominal()) return design::color_of_class(look_.scale, number);
    return number < class_names_.size() ? design::color_of_name(look_.scale.palette, class_names_[number].view())
                                        : design::Color{0, 0, 0, 0};
}

/// Between classes: of kinds one less than there are names.
std::size_t GroundMap::limits() const {
    if (!is_nominal()) return look_.scale.breaks.size();
    return class_names_.empty() ? 0 : class_names_.size() - 1;
}

double GroundMap::limit(std::size_t number) const {
    return is_nominal() ? static_cast<double>(number) + 0.5 : look_.scale.breaks[number];
}

/// A limit as the shader compares values with it, 0..1 over the map's range.
float GroundMap::level_of(double limit, double reach) const {
    const double above = limit - range_.lowest;
    const double level = reach > 0 ? above / reach : above > 0 ? kBeyond : -kBeyond;
    return static_cast<float>(std::fmin(std::fmax(level, -kBeyond), kBeyond));
}

void GroundMap::set_frame_uniforms(gl::Gl& gl, const gl::Program& program, std::uint32_t map_unit,
                                   std::uint32_t color_unit) const {
    const auto number = [](double value) { return static_cast<float>(value); };
    gl->Uniform1i(program.uniform(kDataMap), static_cast<GLint>(map_unit));
    gl->Uniform1i(program.uniform(kDataColors), static_cast<GLint>(color_unit));
    gl->Uniform4f(program.uniform(kDataSize), 1.0f / static_cast<float>(side()), 1.0f / static_cast<float>(side()),
                  number(grid_.columns - 1.0), number(grid_.rows - 1.0));
    const design::Palette& palette = look_.scale.palette;
    const bool has_stops = !palette.stops.empty();
    const double low = has_stops ? palette.stops[0].value : 0, high = has_stops ? palette.stops.back().value : 0;
    const double span = high > low ? high - low : 1, reach = range_.highest - range_.lowest;
    gl->Uniform4f(program.uniform(kDataScale), number(reach / span), number((range_.lowest - low) / span),
                  is_nominal() || limits() > 0 ? 1.0f : 0.0f, is_classed_ ? 1.0f : 0.0f);
    float breaks[kBreaks];
    for (std::size_t n = 0; n < kBreaks; ++n) {
        breaks[n] = n < limits() ? level_of(limit(n), reach) : number(kBeyond);
    }
    gl->Uniform1fv(program.uniform(kDataBreaks), static_cast<GLsizei>(kBreaks), breaks);
    gl->Uniform4f(program.uniform(kDataLook), number(look_.opacity), number(look_.uncertainty.strength),
                  static_cast<float>(look_.uncertainty.levels), has_data_ && look_.opacity > 0 ? 1.0f : 0.0f);
    gl->Uniform1f(program.uniform(kDataLowest), level_of(look_.shown_from, reach));
    const design::GroundOverlay& overlay = look_.overlay;
    gl->Uniform4f(program.uniform(kDataOverlay), number(overlay.strength), static_cast<float>(overlay.levels),
                  number(overlay.threshold), number(overlay.mesh_m));
    gl->Uniform3f(program.uniform(kDataOverlayColor), number(overlay.color.red / 255.0), number(overlay.color.green / 255.0),
                  number(overlay.color.blue / 255.0));
}

void GroundMap::set_chunk_uniforms(gl::Gl& gl, const gl::Program& program, const terrain::Lattice& lattice,
                                   const terrain::ChunkKey& chunk) const {
    const GridWindow window = has_data_ ? grid_window(lattice, chunk, grid_) : GridWindow{};
    gl->Uniform4f(program.uniform(kDataWindow), static_cast<float>(window.scale_i), static_cast<float>(window.scale_j),
                  static_cast<float>(window.offset_i), static_cast<float>(window.offset_j));
}

void GroundMap::destroy(gl::Gl& gl) {
    map_.destroy(gl);
    colors_.destroy(gl);
}

}  // namespace tedavis::draw
