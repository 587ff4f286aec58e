/// Extracts the isosurface of a 3D grid of numbers as triangles with shared vertices.
///
/// Each cell is divided into Kuhn's six tetrahedra (kuhn_cell.hpp), after A. Doi and A. Koide, An efficient method of
/// triangulating equi-valued surfaces by using tetrahedral cells, IEICE Transactions E74 (1991). No case is ambiguous: the
/// surface is an oriented manifold, in which every edge inside the grid belongs to two triangles and every vertex to one fan. A
/// post whose value equals the level is inside; vertices keep a distance of kIsosurfaceMargin from posts, so that no triangle
/// degenerates.
///
/// The work is divided into steps of a number of cells, so that an update can be spread over frames; the result is bit for bit
/// independent of the steps. Cells with a corner that is not finite are left out: the surface is open there, and a vertex
/// between such cells may have more than one fan.
///
/// Memory  two slices of edges, from an arena at start(); output in the caller's spans. Thread  one. Bounded: the cost of a
/// step is proportional to its cells. When the output is full, the surface ends at a whole cell, and the triangles left out are
/// counted.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/span.hpp"
#include "render_core/scene/kuhn_cell.hpp"

namespace tedavis::scene {

/// Largest number of posts along a side: beyond it a float does not resolve the margin.
inline constexpr std::uint32_t kMaxIsosurfaceSide = 2048;
/// Least distance of a vertex from the nearer post, as a share of the edge.
inline constexpr double kIsosurfaceMargin = 1.0 / 2048;

/// A 3D grid of values at integer coordinates, x fastest, then y, then z. Owns nothing. A grid with fewer than two posts along
/// an axis has no cells.
struct VolumeView {
    base::Span<const float> values;  ///< nx * ny * nz; not finite means missing
    std::uint32_t nx = 0, ny = 0, nz = 0;
};

/// A vertex in grid coordinates, 0..n-1 along each axis. In a grid with post spacings (dx, dy, dz), world normals are those of
/// (x/dx, y/dy, z/dz).
struct IsosurfaceVertex {
    glm::vec3 position;
    /// Unit normal towards lower values: the negative gradient from central differences at the posts (one-sided at borders and
    /// beside missing values), interpolated linearly; where that is zero the first triangle's normal, else +z.
    glm::vec3 normal;
};

struct IsosurfaceOutput {
    base::Span<IsosurfaceVertex> vertices;
    base::Span<std::uint32_t> indices;  ///< three per triangle, counter-clockwise seen from lower values
};

struct IsosurfaceCounts {
    std::uint32_t vertices = 0;
    std::uint32_t indices = 0;
    std::uint64_t cells = 0;               ///< visited
    std::uint64_t missing_cells = 0;       ///< visited cells left out because a corner is not finite
    std::uint64_t triangles_left_out = 0;  ///< triangles of visited cells for which there was no room
};

enum class IsosurfaceError : std::uint8_t { none, side_too_long, wrong_number_of_values, level_not_finite, memory_too_small };

/// `full`: there was no room for a cell; further steps only count the triangles left out.
enum class IsosurfaceProgress : std::uint8_t { more, done, full };

class IsosurfaceBuilder {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t nx, std::uint32_t ny);
    /// Allocates memory for grids of at most nx * ny posts per slice; to be called once. Returns false when the arena is too
    /// small.
    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t nx, std::uint32_t ny);

    /// Begins a new surface. Grid, values and output must stay valid and unchanged until it is done.
    [[nodiscard]] IsosurfaceError begin(const VolumeView& grid, float level, const IsosurfaceOutput& output);
    /// Visits at most `max_cells` further cells.
    IsosurfaceProgress step(std::uint64_t max_cells);

    [[nodiscard]] const IsosurfaceCounts& counts() const { return counts_; }
    [[nodiscard]] std::uint64_t cells_left() const { return all_cells_ - counts_.cells; }

private:
    using VertexIndex = std::uint32_t;
    static constexpr VertexIndex kNoVertex = 0xFFFFFFFFu;

    struct Point {
        std::uint32_t x, y, z;
    };
    /// The vertex on an edge, stored at the edge's lower post. An entry is valid when its vertex is not older than `oldest`.
    struct EdgeEntry {
        VertexIndex* index;
        VertexIndex oldest;
    };

    void visit_row(std::uint32_t cells);
    void end_row();
    void forget_row(std::uint32_t y);
    void cut_cell(std::uint32_t inside_bits);
    [[nodiscard]] bool add_triangle(const KuhnEdge (&edges)[3]);
    [[nodiscard]] VertexIndex vertex_on(KuhnEdge edge);
    [[nodiscard]] EdgeEntry entry_of(const Point& post, std::uint32_t direction) const;
    void make_vertex(IsosurfaceVertex& vertex, const Point& post, std::uint32_t direction) const;
    [[nodiscard]] glm::dvec3 gradient(const Point& post) const;
    [[nodiscard]] std::size_t place(const Point& post) const;

    base::Span<VertexIndex> flat_[2];  ///< edges within an even and an odd slice, three per post
    base::Span<VertexIndex> upright_;  ///< edges from the lower to the upper slice, four per post
    VolumeView grid_;
    float level_ = 0;
    IsosurfaceOutput output_;
    IsosurfaceCounts counts_;
    std::uint64_t all_cells_ = 0;
    Point cell_{};                                  ///< next cell, by its lowest post
    VertexIndex slab_begin_ = 0, slab_before_ = 0;  ///< vertices before this layer of cells, and before the one below it
    bool is_full_ = false;
};

}  // namespace tedavis::scene
