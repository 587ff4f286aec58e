/// The surface where a grid of numbers in space has a given value, as triangles that share their vertices.
///
/// Traversing tetrahedra over Kuhn's six tetrahedra a cell (kuhn_cell.hpp): A. Doi and A. Koide, An efficient method of
/// triangulating equi-valued surfaces by using tetrahedral cells, IEICE Transactions E74 (1991). No case is ambiguous: every
/// edge inside the grid belongs to two triangles that run along it in opposite directions, every vertex to one fan. A post whose
/// value equals the level is inside; vertices keep kIsosurfaceMargin away from posts, so that no triangle has lost its area.
///
/// The work is cut into steps of so many cells, for updates spread over frames; the result does not depend on the steps, bit for
/// bit. Cells with a corner that is not finite are left out: the surface is open beside them, and where such cells meet at a
/// vertex it may have more than one fan.
///
/// Memory  two slices of edges, from an arena at start(); output in the caller's spans. Thread  one. Bounded: a step costs no
/// more than its cells. A full output ends the surface at a whole cell and counts what is left out.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "render_core/base/memory_budget.hpp"
#include "render_core/base/span.hpp"
#include "render_core/scene/kuhn_cell.hpp"

namespace tedavis::scene {

/// Posts of a side at most: farther out a float no longer holds the margin well.
inline constexpr std::uint32_t kMaxIsosurfaceSide = 2048;
/// The part of an edge between a vertex and the nearer post, at least.
inline constexpr double kIsosurfaceMargin = 1.0 / 2048;

/// Values at whole coordinates, x fastest, then y, then z. Owns nothing. Fewer than two posts along an axis enclose nothing.
struct VolumeView {
    base::Span<const float> values;  ///< nx * ny * nz; not finite means missing
    std::uint32_t nx = 0, ny = 0, nz = 0;
};

/// In the coordinates of the grid, 0..n-1 along each axis. Over a grid whose posts are (dx, dy, dz) apart the normal is that of
/// (x/dx, y/dy, z/dz).
struct IsosurfaceVertex {
    glm::vec3 position;
    /// Unit length, towards lower values: against the gradient by central differences at the posts (one-sided at borders and
    /// beside missing values), linear between them; where that is zero, of the first triangle; else +z.
    glm::vec3 normal;
};

struct IsosurfaceOutput {
    base::Span<IsosurfaceVertex> vertices;
    base::Span<std::uint32_t> indices;  ///< three a triangle, counter-clockwise seen from lower values
};

struct IsosurfaceCounts {
    std::uint32_t vertices = 0;
    std::uint32_t indices = 0;
    std::uint64_t cells = 0;               ///< visited
    std::uint64_t missing_cells = 0;       ///< of them, left out because a corner is not finite
    std::uint64_t triangles_left_out = 0;  ///< of visited cells, for want of room
};

enum class IsosurfaceError : std::uint8_t { none, side_too_long, wrong_number_of_values, level_not_finite, memory_too_small };

/// `full`: a cell found no room. More steps then only count what is left out.
enum class IsosurfaceProgress : std::uint8_t { more, done, full };

class IsosurfaceBuilder {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t nx, std::uint32_t ny);
    /// Once, for grids of at most nx * ny posts a slice. False when the arena cannot hold it.
    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t nx, std::uint32_t ny);

    /// Begins a surface and forgets the one before. Grid and output must stay, and the values unchanged, until it is done.
    [[nodiscard]] IsosurfaceError begin(const VolumeView& grid, float level, const IsosurfaceOutput& output);
    /// Visits the next cells, at most so many.
    IsosurfaceProgress step(std::uint64_t max_cells);

    [[nodiscard]] const IsosurfaceCounts& counts() const { return counts_; }
    [[nodiscard]] std::uint64_t cells_left() const { return all_cells_ - counts_.cells; }

private:
    using VertexIndex = std::uint32_t;
    static constexpr VertexIndex kNoVertex = 0xFFFFFFFFu;

    struct Point {
        std::uint32_t x, y, z;
    };
    /// Edges that cross the surface by their lower post. An entry counts when its vertex is not older than the edges are.
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

    base::Span<VertexIndex> flat_[2];  ///< edges within an even and an odd slice, three a post
    base::Span<VertexIndex> upright_;  ///< edges from the lower to the upper slice, four a post
    VolumeView grid_;
    float level_ = 0;
    IsosurfaceOutput output_;
    IsosurfaceCounts counts_;
    std::uint64_t all_cells_ = 0;
    Point cell_{};                                  ///< the next one, by its lowest post
    VertexIndex slab_begin_ = 0, slab_before_ = 0;  ///< vertices before this layer of cells, and before the one below it
    bool is_full_ = false;
};

}  // namespace tedavis::scene
