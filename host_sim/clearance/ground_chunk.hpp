/// An exact chunk of the true surface in memory, with bounding boxes of its cells, for the search of nearest points.
///
/// Places are in the chunk's own frame: metres north, east and down of its centre. They are those of the database's vertices,
/// some centimetres from the surface at most (tdb_format.hpp); cells are flat triangles between them.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <vector>

#include "host_sim/clearance/triangle_place.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::host_sim {

struct GroundBox {
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};

    void include(const glm::dvec3& place);
    [[nodiscard]] double distance_m(const glm::dvec3& from) const;
    /// Horizontal part of the distance.
    [[nodiscard]] double level_distance_m(const glm::dvec3& from) const;
    /// False only if no part of the box lies in the region.
    [[nodiscard]] bool may_reach(const Region& region) const;
};

class GroundChunk {
public:
    static constexpr std::uint32_t kBlockCells = 4;

    /// Reads the chunk of an entry without children. Null where it is damaged.
    [[nodiscard]] static std::unique_ptr<GroundChunk> read(const terrain::TerrainDatabase& database,
                                                           const terrain::ChunkEntry& entry);

    /// North, east and down, ECEF.
    [[nodiscard]] const glm::dmat3& axes() const { return axes_; }
    [[nodiscard]] const glm::dvec3& centre() const { return centre_; }

    /// Sets `nearest` (relative to the eye) and `distance_m` if the chunk has a nearer point in the region than `distance_m`;
    /// returns whether it has. The eye and the region are in the chunk's frame, the region relative to the eye. Cells with a void
    /// corner have no surface.
    [[nodiscard]] bool find_nearer(const glm::dvec3& eye, const Region& region, double& distance_m, glm::dvec3& nearest) const;
    /// Whether cells with a void corner may lie within a horizontal distance.
    [[nodiscard]] bool has_void_within(const glm::dvec3& eye, double distance_m) const;

private:
    struct Block {
        GroundBox box;
        std::uint32_t column = 0, row = 0;  ///< its first post
        bool has_void = false;
    };
    void add_blocks();
    [[nodiscard]] std::size_t post(std::uint32_t column, std::uint32_t row) const { return std::size_t{row} * columns_ + column; }
    [[nodiscard]] bool find_in_cell(std::uint32_t column, std::uint32_t row, const glm::dvec3& eye, const Region& region,
                                    double& distance_m, glm::dvec3& nearest) const;

    std::uint32_t columns_ = 0, rows_ = 0;
    glm::dvec3 centre_{};
    glm::dmat3 axes_{1};
    std::vector<glm::dvec3> posts_;
    std::vector<bool> is_void_;
    std::vector<Block> blocks_;
};

}  // namespace tedavis::host_sim
