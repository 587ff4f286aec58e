#include "render_core/scene/isosurface.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace tedavis::scene {
namespace {

constexpr std::size_t kFlatEdges = 3, kUprightEdges = 4;  // a post
constexpr std::uint32_t kUpwards = 4;                     // the bit of directions and corners
constexpr int kMissingShift = 8;

bool is_finite(float value) { return std::abs(value) <= std::numeric_limits<float>::max(); }

std::uint64_t posts_of_slice(std::uint32_t nx, std::uint32_t ny) { return std::uint64_t{nx} * ny; }

/// Change a post along one axis; one-sided where there is no finite value on the other side.
double slope(const float* value, std::size_t stride, std::uint32_t position, std::uint32_t posts) {
    double before = *value, after = before;
    int steps = 0;
    if (position > 0 && is_finite(*(value - stride))) {
        before = *(value - stride);
        ++steps;
    }
    if (position + 1 < posts && is_finite(*(value + stride))) {
        after = *(value + stride);
        ++steps;
    }
    return steps == 0 ? 0 : (after - before) / steps;
}

glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::dvec3 across = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    const double length = glm::length(across);
    return length > 0 ? glm::vec3(across / length) : glm::vec3(0, 0, 1);
}

/// The four posts of a cell with the lower x, in two sets of bits: inside, and missing shifted up.
struct Columns {
    const float* row[4];  ///< (y, z), (y + 1, z), (y, z + 1), (y + 1, z + 1)
    float level;

    [[nodiscard]] std::uint32_t bits(std::size_t x) const {
        std::uint32_t made = 0;
        for (std::uint32_t n = 0; n < 4; ++n) {
            const float value = row[n][x];
            made |= (value >= level ? 1u : 0u) << (2 * n);
            made |= (is_finite(value) ? 0u : 1u) << (2 * n + kMissingShift);
        }
        return made;
    }
};

}  // namespace

std::uint64_t IsosurfaceBuilder::bytes_needed(std::uint32_t nx, std::uint32_t ny) {
    return posts_of_slice(nx, ny) * (2 * kFlatEdges + kUprightEdges) * sizeof(VertexIndex) + alignof(VertexIndex);
}

bool IsosurfaceBuilder::start(base::Arena& arena, std::uint32_t nx, std::uint32_t ny) {
    if (nx > kMaxIsosurfaceSide || ny > kMaxIsosurfaceSide) return false;
    const auto posts = static_cast<std::size_t>(posts_of_slice(nx, ny));
    for (base::Span<VertexIndex>& slice : flat_) slice = arena.allocate_array<VertexIndex>(posts * kFlatEdges);
    upright_ = arena.allocate_array<VertexIndex>(posts * kUprightEdges);
    return flat_[0].size() == posts * kFlatEdges && flat_[1].size() == posts * kFlatEdges &&
           upright_.size() == posts * kUprightEdges;
}

IsosurfaceError IsosurfaceBuilder::begin(const VolumeView& grid, float level, const IsosurfaceOutput& output) {
    all_cells_ = 0;
    counts_ = {};
    cell_ = {};
    slab_begin_ = slab_before_ = 0;
    is_full_ = false;
    if (std::max({grid.nx, grid.ny, grid.nz}) > kMaxIsosurfaceSide) return IsosurfaceError::side_too_long;
    if (posts_of_slice(grid.nx, grid.ny) * grid.nz != grid.values.size()) return IsosurfaceError::wrong_number_of_values;
    if (!is_finite(level)) return IsosurfaceError::level_not_finite;
    if (posts_of_slice(grid.nx, grid.ny) * kUprightEdges > upright_.size()) return IsosurfaceError::memory_too_small;
    grid_ = grid;
    level_ = level;
    output_ = output;
    if (grid.nx > 1 && grid.ny > 1 && grid.nz > 1) all_cells_ = posts_of_slice(grid.nx - 1, grid.ny - 1) * (grid.nz - 1);
    return IsosurfaceError::none;
}

IsosurfaceProgress IsosurfaceBuilder::step(std::uint64_t max_cells) {
    while (max_cells > 0 && cells_left() > 0) {
        const std::uint32_t row_left = grid_.nx - 1 - cell_.x;
        const auto cells = static_cast<std::uint32_t>(std::min<std::uint64_t>(row_left, max_cells));
        visit_row(cells);
        max_cells -= cells;
        counts_.cells += cells;
        if (cells == row_left) end_row();
    }
    if (is_full_) return IsosurfaceProgress::full;
    return cells_left() > 0 ? IsosurfaceProgress::more : IsosurfaceProgress::done;
}

void IsosurfaceBuilder::visit_row(std::uint32_t cells) {
    // Entries of a surface before this one would pass for this one's.
    if (cell_.z == 0 && cell_.x == 0) {
        if (cell_.y == 0) forget_row(0);
        forget_row(cell_.y + 1);
    }
    const float* low = grid_.values.data() + place({0, cell_.y, cell_.z});
    const float* high = low + posts_of_slice(grid_.nx, grid_.ny);
    const Columns columns{{low, low + grid_.nx, high, high + grid_.nx}, level_};
    const std::uint32_t end = cell_.x + cells;
    std::uint32_t left = columns.bits(cell_.x);
    for (; cell_.x < end; ++cell_.x) {
        const std::uint32_t right = columns.bits(cell_.x + 1), cell = left | right << 1;
        left = right;
        if (cell == 0 || cell == 0xFF) continue;
        if (cell > 0xFF)
            ++counts_.missing_cells;
        else
            cut_cell(cell);
    }
}

void IsosurfaceBuilder::end_row() {
    cell_.x = 0;
    if (++cell_.y < grid_.ny - 1) return;
    cell_.y = 0;
    ++cell_.z;
    slab_before_ = slab_begin_;
    slab_begin_ = counts_.vertices;
}

void IsosurfaceBuilder::forget_row(std::uint32_t y) {
    const std::size_t first = place({0, y, 0});
    for (const base::Span<VertexIndex>& slice : flat_)
        std::fill_n(slice.data() + first * kFlatEdges, grid_.nx * kFlatEdges, kNoVertex);
    std::fill_n(upright_.data() + first * kUprightEdges, grid_.nx * kUprightEdges, kNoVertex);
}

void IsosurfaceBuilder::cut_cell(std::uint32_t inside_bits) {
    const KuhnCase& found = kKuhnCases[inside_bits];
    const IsosurfaceCounts before = counts_;
    for (std::uint32_t n = 0; n < found.triangles && !is_full_; ++n) is_full_ = !add_triangle(found.edge[n]);
    if (!is_full_) return;
    counts_ = before;
    counts_.triangles_left_out += found.triangles;
}

bool IsosurfaceBuilder::add_triangle(const KuhnEdge (&edges)[3]) {
    if (output_.indices.size() - counts_.indices < 3) return false;
    VertexIndex* index = output_.indices.data() + counts_.indices;
    for (int n = 0; n < 3; ++n) {
        index[n] = vertex_on(edges[n]);
        if (index[n] == kNoVertex) return false;
    }
    IsosurfaceVertex* vertex = output_.vertices.data();
    for (int n = 0; n < 3; ++n) {
        glm::vec3& normal = vertex[index[n]].normal;
        if (normal == glm::vec3(0))
            normal = face_normal(vertex[index[0]].position, vertex[index[1]].position, vertex[index[2]].position);
    }
    counts_.indices += 3;
    return true;
}

IsosurfaceBuilder::VertexIndex IsosurfaceBuilder::vertex_on(KuhnEdge edge) {
    const Point post{cell_.x + (edge.corner & 1u), cell_.y + (edge.corner >> 1 & 1u), cell_.z + (edge.corner >> 2 & 1u)};
    const EdgeEntry entry = entry_of(post, edge.direction);
    // Both sides wrap: what is older, and what was taken back, is out of the range.
    if (*entry.index - entry.oldest < counts_.vertices - entry.oldest) return *entry.index;
    if (counts_.vertices == std::min<std::size_t>(output_.vertices.size(), kNoVertex)) return kNoVertex;
    make_vertex(output_.vertices.data()[counts_.vertices], post, edge.direction);
    *entry.index = counts_.vertices;
    return counts_.vertices++;
}

IsosurfaceBuilder::EdgeEntry IsosurfaceBuilder::entry_of(const Point& post, std::uint32_t direction) const {
    const std::size_t in_slice = place({post.x, post.y, 0});
    if (direction >= kUpwards) return {upright_.data() + in_slice * kUprightEdges + (direction - kUpwards), slab_begin_};
    return {flat_[post.z & 1].data() + in_slice * kFlatEdges + (direction - 1), post.z == cell_.z ? slab_before_ : slab_begin_};
}

void IsosurfaceBuilder::make_vertex(IsosurfaceVertex& vertex, const Point& post, std::uint32_t direction) const {
    const Point step{direction & 1u, direction >> 1 & 1u, direction >> 2 & 1u};
    const Point far{post.x + step.x, post.y + step.y, post.z + step.z};
    const double near_value = grid_.values.data()[place(post)], far_value = grid_.values.data()[place(far)];
    const double t = std::clamp((level_ - near_value) / (far_value - near_value), kIsosurfaceMargin, 1 - kIsosurfaceMargin);
    vertex.position = glm::vec3(glm::dvec3(post.x, post.y, post.z) + t * glm::dvec3(step.x, step.y, step.z));
    const glm::dvec3 uphill = (1 - t) * gradient(post) + t * gradient(far);
    const double steepness = glm::length(uphill);
    vertex.normal = steepness > 0 ? glm::vec3(-uphill / steepness) : glm::vec3(0);
}

glm::dvec3 IsosurfaceBuilder::gradient(const Point& post) const {
    const float* value = grid_.values.data() + place(post);
    const std::size_t row = grid_.nx, slice = row * grid_.ny;
    return {slope(value, 1, post.x, grid_.nx), slope(value, row, post.y, grid_.ny), slope(value, slice, post.z, grid_.nz)};
}

std::size_t IsosurfaceBuilder::place(const Point& post) const {
    return (std::size_t{post.z} * grid_.ny + post.y) * grid_.nx + post.x;
}

}  // namespace tedavis::scene
