#include "render_core/draw/data/isosurface_solids.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/solid_look.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/scene/data_time.hpp"

namespace tedavis::draw {
namespace {

constexpr std::uint64_t kSurfacePadding_bytes = 256;
constexpr std::size_t kIndicesAVertex = 6, kShareOfRoom = 2;
constexpr std::uint32_t kMinAcross = 4;  // posts that are looked at along an axis, where there are as many
constexpr std::uint64_t kAllCells = ~std::uint64_t{0};
constexpr std::uint32_t kSlotBits = 13;
static_assert(SolidMesh::kVertices <= 1u << kSlotBits);
constexpr std::uint32_t kMeshVertices = SolidMesh::kVertices - 3, kMeshIndices = SolidMesh::kIndices - 3;
constexpr float kOuterOpacity = 0.5f;  // of the element's, where there are many levels
constexpr float kHalfLine_px = 1;
constexpr double kLineShade = 0.65;  // of black in the surface's colour
constexpr double kLineLift = 0.5;    // away from the surface, of the way to the side
constexpr std::uint32_t kLineVertices = 4, kLineIndices = 12, kMaxLinesATriangle = 64;

using Levels = base::FixedVector<double, design::kMaxElementLevels>;
/// Those that the design names first.
Levels levels_at(const design::DataElement& element) {
    Levels kept;
    const double most = std::ceil(element.detail * static_cast<double>(element.levels.size()));
    for (std::size_t n = 0; n < element.levels.size() && (n == 0 || static_cast<double>(n) < most); ++n)
        static_cast<void>(kept.try_push_back(element.levels[n]));
    return kept;
}

const scene::Attribute* attribute_of(const ElementInput& input) {
    if (input.element.by_color.is_used()) return input.layer.find(input.element.by_color.attribute.view());
    return input.layer.attributes.empty() ? nullptr : &input.layer.attributes[0];
}

std::int64_t time_of(const ElementInput& input) {
    const base::Span<const std::int64_t>& times = input.layer.times_ns;
    if (times.empty()) return input.layer.entry->data_time_ns;
    if (!input.has_date) return times[0];
    return scene::start_of_data_step(input.time_ns);
}

std::size_t level_below(const base::Span<const float>& levels_m, double level) {
    return std::min(static_cast<std::size_t>(level), levels_m.size() - 2);
}

/// From a level to the next one.
double climb_at(const base::Span<const float>& levels_m, double level) {
    const std::size_t below = level_below(levels_m, level);
    return static_cast<double>(levels_m[below + 1]) - static_cast<double>(levels_m[below]);
}

double height_at(const base::Span<const float>& levels_m, double level) {
    const std::size_t below = level_below(levels_m, level);
    return static_cast<double>(levels_m[below]) + (level - static_cast<double>(below)) * climb_at(levels_m, level);
}

Levels ascending(Levels levels) {
    for (std::size_t n = 1; n < levels.size(); ++n)
        for (std::size_t k = n; k > 0 && levels[k] < levels[k - 1]; --k) std::swap(levels[k], levels[k - 1]);
    return levels;
}

}  // namespace

bool shows_isosurfaces(const scene::Layer& layer) {
    const scene::GridShape& grid = layer.entry->grid;
    return layer.entry->shape == scene::LayerShape::grid && layer.levels_m.size() > 1 && grid.columns > 1 && grid.rows > 1;
}

bool isosurfaces_move(const scene::Layer& layer) { return layer.times_ns.size() > 1; }

IsosurfaceRoom IsosurfaceRoom::beside(std::uint32_t batch_vertices) {
    constexpr std::uint32_t kMaxVertices = 262144, kMaxPosts = 128 * 128 * 128;
    constexpr std::uint32_t kMinPosts = kMaxMovingPosts, kMinSlice = 24 * 24, kSmallBatch = 65536;
    IsosurfaceRoom room;
    room.vertices = std::min(batch_vertices / 8, kMaxVertices);
    room.posts = std::clamp(batch_vertices < kSmallBatch ? batch_vertices : 2 * batch_vertices, kMinPosts, kMaxPosts);
    room.posts_of_slice = std::clamp(room.posts / 64, kMinSlice, 128u * 128);
    return room;
}

std::uint64_t IsosurfaceSolids::bytes_needed(const IsosurfaceRoom& room) {
    constexpr std::uint64_t kVertex = sizeof(scene::IsosurfaceVertex) + (kIndicesAVertex + 1) * sizeof(std::uint32_t);
    return room.posts * sizeof(float) + room.vertices * kVertex + scene::IsosurfaceBuilder::bytes_needed(room.posts_of_slice, 1) +
           kSurfacePadding_bytes;
}

bool IsosurfaceSolids::start(base::Arena& arena, const IsosurfaceRoom& room) {
    slice_posts_ = room.posts_of_slice;
    values_ = arena.allocate_array<float>(room.posts);
    vertices_ = arena.allocate_array<scene::IsosurfaceVertex>(room.vertices);
    indices_ = arena.allocate_array<std::uint32_t>(kIndicesAVertex * room.vertices);
    slots_ = arena.allocate_array<std::uint32_t>(room.vertices);
    // A slice may have any sides; the builder takes a product that is as large.
    const auto side = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(slice_posts_)));
    slice_posts_ = side * side;
    return !values_.empty() && !vertices_.empty() && !indices_.empty() && !slots_.empty() && builder_.start(arena, side, side);
}

IsosurfaceSolids::Sampling IsosurfaceSolids::sampling_of(const scene::GridShape& grid, std::uint32_t step) {
    Sampling sampling;
    const std::uint32_t all[3] = {grid.columns, grid.rows, grid.levels};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        sampling.step[axis] = std::min(step, std::max(1u, (all[axis] - 1) / (kMinAcross - 1)));
        sampling.posts[axis] = (all[axis] - 1) / sampling.step[axis] + 1;
    }
    return sampling;
}

ElementCount IsosurfaceSolids::add(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input) {
    const scene::GridShape& grid = input.layer.entry->grid;
    ElementCount count;
    count.hidden = grid.columns * grid.rows * grid.levels;
    const scene::Attribute* const attribute = attribute_of(input);
    if (attribute == nullptr || input.element.levels.empty()) return count;
    const scene::GridField field(input.layer, *attribute);
    time_ns_ = time_of(input);
    has_uncertainty_ = attribute->entry->uncertainty_kind != scene::UncertaintyKind::none;
    const std::uint64_t most =
        isosurfaces_move(input.layer) ? std::min<std::uint64_t>(kMaxMovingPosts, values_.size()) : values_.size();
    const auto finest = static_cast<std::uint32_t>(std::lround(1 + 3 * (1 - input.element.detail)));
    for (std::uint32_t step = finest; step <= kMaxIsosurfaceSteps; ++step) {
        const Sampling sampling = sampling_of(grid, step);
        if (sampling.all() > most || sampling.posts[0] * sampling.posts[1] > slice_posts_) continue;
        const std::uint32_t known = sample(field, sampling);
        if (!build(batch, mesh, input, field, sampling)) continue;
        const auto looked_at = static_cast<std::uint32_t>(sampling.all());
        count.drawn = known;
        count.aggregated = count.hidden - looked_at;
        count.hidden = looked_at - known;
        return count;
    }
    return count;
}

std::uint32_t IsosurfaceSolids::sample(const scene::GridField& field, const Sampling& sampling) {
    const scene::AxisPlace time = field.time_at(time_ns_);
    const base::Duration age = field.age(time_ns_);
    std::uint32_t known = 0;
    std::size_t n = 0;
    for (std::uint32_t z = 0; z < sampling.posts[2]; ++z) {
        const std::uint32_t level = z * sampling.step[2];
        const scene::AxisPlace at{level, level, 0, true};
        for (std::uint32_t y = 0; y < sampling.posts[1]; ++y)
            for (std::uint32_t x = 0; x < sampling.posts[0]; ++x, ++n) {
                const scene::FieldValue value = field.at_post(x * sampling.step[0], y * sampling.step[1], at, time, age);
                const bool is_known = value.state != scene::ValueState::missing;
                values_[n] = is_known ? static_cast<float>(value.value) : std::numeric_limits<float>::quiet_NaN();
                known += is_known ? 1 : 0;
            }
    }
    return known;
}

/// False where room is wanting; nothing is added then, because all levels are tried before the first is.
bool IsosurfaceSolids::build(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, const scene::GridField& field,
                             const Sampling& sampling) {
    const Levels levels = ascending(levels_at(input.element));
    const std::size_t room = std::min({vertices_.size(), batch.vertices_left() / (kShareOfRoom * levels.size()),
                                       batch.indices_left() / (kShareOfRoom * kIndicesAVertex * levels.size())});
    for (const double level : levels)
        if (!make(sampling, static_cast<float>(level), room)) return false;
    for (std::size_t n = 0; n < levels.size(); ++n) {
        // A single one has just been made.
        if (levels.size() > 1) static_cast<void>(make(sampling, static_cast<float>(levels[n]), room));
        const float inwards = static_cast<float>(n + 1) / static_cast<float>(levels.size());
        SolidLook look = look_of(input);
        look.opacity *= kOuterOpacity + (1 - kOuterOpacity) * inwards;
        look.is_mixed = look.is_mixed || look.opacity < 1;
        batch.set_look(look, time_ns_);
        const design::ColorEncoding& encoding = input.element.by_color;
        color_ = encoding.is_used() ? design::scale_color(encoding.scale, levels[n]) : input.element.color;
        add_surface(batch, mesh, input, field, sampling);
        add_lines(batch, mesh, input, sampling);
    }
    return true;
}

bool IsosurfaceSolids::make(const Sampling& sampling, float level, std::size_t room) {
    const scene::VolumeView volume{
        {values_.data(), static_cast<std::size_t>(sampling.all())}, sampling.posts[0], sampling.posts[1], sampling.posts[2]};
    const scene::IsosurfaceOutput output{{vertices_.data(), room}, {indices_.data(), kIndicesAVertex * room}};
    return builder_.begin(volume, level, output) == scene::IsosurfaceError::none &&
           builder_.step(kAllCells) == scene::IsosurfaceProgress::done;
}

/// In meshes of as many triangles as one of them holds; a vertex is put into each mesh that needs it.
void IsosurfaceSolids::add_surface(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, const scene::GridField& field,
                                   const Sampling& sampling) {
    const scene::IsosurfaceCounts& made = builder_.counts();
    std::fill_n(slots_.data(), made.vertices, 0u);
    std::uint32_t number = 0, indices = kMeshIndices + 1;
    for (std::uint32_t n = 0; n < made.indices; n += 3, indices += 3) {
        if (indices > kMeshIndices || mesh.vertex_count() > kMeshVertices) {
            if (number > 0) mesh.add_to(batch);
            mesh.begin(placed_in(input, sampling, vertices_[indices_[n]]).place);
            ++number;
            indices = 0;
        }
        std::uint16_t corner[3];
        for (std::uint32_t k = 0; k < 3; ++k) {
            std::uint32_t& slot = slots_[indices_[n + k]];
            if (slot >> kSlotBits != number)
                slot = number << kSlotBits | add_vertex(mesh, input, field, sampling, vertices_[indices_[n + k]]);
            corner[k] = static_cast<std::uint16_t>(slot & ((1u << kSlotBits) - 1));
        }
        mesh.triangle(corner[0], corner[2], corner[1]);  // rows go south: seen from above the grid is mirrored
    }
    if (number > 0) mesh.add_to(batch);
}

IsosurfaceSolids::GridPlace IsosurfaceSolids::placed_in(const ElementInput& input, const Sampling& sampling,
                                                        const scene::IsosurfaceVertex& vertex) const {
    const scene::GridShape& grid = input.layer.entry->grid;
    const double column = static_cast<double>(vertex.position.x) * sampling.step[0],
                 row = static_cast<double>(vertex.position.y) * sampling.step[1];
    const double level = static_cast<double>(vertex.position.z) * sampling.step[2];
    GridPlace at;
    at.latitude_rad = grid.north_rad - row * grid.step_lat_rad;
    at.longitude_rad = grid.west_rad + column * grid.step_lon_rad;
    at.height_m = height_at(input.layer.levels_m, level);
    at.climb_m = climb_at(input.layer.levels_m, level);
    at.place = placed(input, at.latitude_rad, at.longitude_rad, at.height_m).place;
    return at;
}

/// Unit length, in ECEF.
glm::dvec3 IsosurfaceSolids::normal_in(const ElementInput& input, const Sampling& sampling, const GridPlace& at,
                                       const glm::vec3& normal) {
    const scene::GridShape& grid = input.layer.entry->grid;
    const LocalAxes axes = local_axes(at.latitude_rad, at.longitude_rad);
    const double post_east_m =
        sampling.step[0] * grid.step_lon_rad * std::cos(at.latitude_rad) * earth::prime_vertical_radius_m(at.latitude_rad);
    const double post_north_m = sampling.step[1] * grid.step_lat_rad * earth::meridian_radius_m(at.latitude_rad);
    const glm::dvec3 slope(normal);
    const glm::dvec3 across = slope.x / post_east_m * axes.east - slope.y / post_north_m * axes.north +
                              slope.z / (sampling.step[2] * at.climb_m) * axes.up;
    const double length = glm::length(across);
    return length > 0 ? across / length : axes.up;
}

std::uint16_t IsosurfaceSolids::add_vertex(SolidMesh& mesh, const ElementInput& input, const scene::GridField& field,
                                           const Sampling& sampling, const scene::IsosurfaceVertex& vertex) {
    const GridPlace at = placed_in(input, sampling, vertex);
    mesh.set_color(color_, has_uncertainty_ ? field.at(at.latitude_rad, at.longitude_rad, at.height_m, time_ns_).uncertainty
                                            : scene::Uncertainty::from_code(0));
    return mesh.vertex(at.place, normal_in(input, sampling, at, vertex.normal));
}

bool has_isosurface_lines(const design::DataElement& element) {
    constexpr double kMinDetail = 0.5;
    return element.detail >= kMinDetail && !element.grid;
}

/// Where the surface last made goes through whole multiples of kIsosurfaceLines_m; all of its lines or, where these have no room,
/// none.
void IsosurfaceSolids::add_lines(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input, const Sampling& sampling) {
    if (!has_isosurface_lines(input.element)) return;
    const std::uint32_t end = builder_.counts().indices;
    std::size_t lines = 0;
    for (std::uint32_t n = 0; n < end; n += 3) visit_lines(input, sampling, n, [&](const LinePiece&) { ++lines; });
    if (lines > std::min(batch.vertices_left() / kLineVertices, batch.indices_left() / kLineIndices) / kShareOfRoom) return;
    SolidLook look;
    look.group = input.group;
    look.halo_px = kHalfLine_px;
    batch.set_look(look, time_ns_);
    bool has_begun = false;
    for (std::uint32_t n = 0; n < end; n += 3)
        visit_lines(input, sampling, n, [&](const LinePiece& piece) {
            const GridPlace from = placed_in(input, sampling, piece.ends[0]), to = placed_in(input, sampling, piece.ends[1]);
            if (has_begun && mesh.vertex_count() + kLineVertices > SolidMesh::kVertices) {
                mesh.add_to(batch);
                has_begun = false;
            }
            if (!has_begun) mesh.begin(from.place);
            has_begun = true;
            add_line(mesh, from.place, to.place, normal_in(input, sampling, from, piece.ends[0].normal));
        });
    if (has_begun) mesh.add_to(batch);
}

/// Of the triangle whose first index this is.
template <class Visitor>
void IsosurfaceSolids::visit_lines(const ElementInput& input, const Sampling& sampling, std::uint32_t first,
                                   Visitor visitor) const {
    const scene::IsosurfaceVertex* corners[3]{};
    double lines[3]{};  // their heights
    for (std::uint32_t k = 0; k < 3; ++k) {
        corners[k] = &vertices_[indices_[first + k]];
        lines[k] =
            height_at(input.layer.levels_m, static_cast<double>(corners[k]->position.z) * sampling.step[2]) / kIsosurfaceLines_m;
    }
    const double highest = std::max({lines[0], lines[1], lines[2]});
    double line = std::ceil(std::min({lines[0], lines[1], lines[2]}));
    for (std::uint32_t n = 0; n < kMaxLinesATriangle && line < highest; ++n, line += 1) {
        LinePiece piece;
        std::size_t ends = 0;
        for (std::size_t k = 0; k < 3 && ends < 2; ++k) {
            const std::size_t next = (k + 1) % 3;
            if ((lines[k] < line) == (lines[next] < line)) continue;
            const auto share = static_cast<float>((line - lines[k]) / (lines[next] - lines[k]));
            piece.ends[ends].position = glm::mix(corners[k]->position, corners[next]->position, share);
            piece.ends[ends++].normal = glm::mix(corners[k]->normal, corners[next]->normal, share);
        }
        if (ends == 2) visitor(piece);
    }
}

/// Without width: it gets that on the screen, to both sides and seen from both.
void IsosurfaceSolids::add_line(SolidMesh& mesh, const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& normal) const {
    const glm::dvec3 across = glm::cross(to - from, normal);
    const double length = glm::length(across);
    if (!(length > 0)) return;
    const glm::dvec3 side = across / length, lift = kLineLift * normal;
    mesh.set_color(design::blended(color_, {0, 0, 0}, kLineShade));
    const glm::dvec3 right = glm::normalize(lift + side), left = glm::normalize(lift - side);
    const std::uint16_t a = mesh.vertex(from, right), b = mesh.vertex(from, left), c = mesh.vertex(to, left),
                        d = mesh.vertex(to, right);
    mesh.triangle(a, b, c);
    mesh.triangle(a, c, d);
    mesh.triangle(c, b, a);
    mesh.triangle(d, c, a);
}

}  // namespace tedavis::draw
