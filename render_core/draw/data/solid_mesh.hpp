/// A mesh under construction, which is then added to a SolidBatch as a whole.
///
/// Memory  from an arena, once. Thread  one. Failure  a full mesh refuses; is_whole() tells, and add_to() then adds nothing.
#pragma once

#include <glm/vec2.hpp>

#include "render_core/base/memory_budget.hpp"
#include "render_core/draw/data/solid_batch.hpp"

namespace tedavis::draw {

class SolidMesh {
public:
    static constexpr std::uint32_t kVertices = 4096, kIndices = 3 * kVertices, kCorners = 1024;

    [[nodiscard]] static std::uint64_t bytes_needed();
    [[nodiscard]] bool start(base::Arena& arena);

    /// Clears the mesh; positions are stored relative to `origin` (ECEF).
    void begin(const glm::dvec3& origin);
    [[nodiscard]] const glm::dvec3& origin() const { return origin_; }

    /// Sets colour and uncertainty of the next vertices.
    void set_color(design::Color color, scene::Uncertainty uncertainty = scene::Uncertainty::from_code(0));
    /// `place` in ECEF; a normal of length 0 is not shaded. Returns its number.
    std::uint16_t vertex(const glm::dvec3& place, const glm::dvec3& normal);
    /// Adds a triangle of vertex numbers, counter-clockwise seen from outside.
    void triangle(std::uint16_t a, std::uint16_t b, std::uint16_t c);
    /// Adds a flat quad with the normal of its corners, counter-clockwise seen from outside; one without area is left out.
    void quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

    [[nodiscard]] bool is_whole() const { return is_whole_; }
    [[nodiscard]] std::uint32_t vertex_count() const { return vertex_count_; }
    /// Adds the mesh to the batch. Returns false, and adds nothing, when it is not whole or the batch has no room.
    bool add_to(SolidBatch& batch) const;

    /// Scratch memory for polygons.
    [[nodiscard]] base::Span<glm::dvec2> corners() const { return corners_; }
    [[nodiscard]] base::Span<std::uint16_t> corner_indices() const { return corner_indices_; }

private:
    base::Span<SolidVertex> vertices_;
    base::Span<std::uint16_t> indices_;
    base::Span<glm::dvec2> corners_;
    base::Span<std::uint16_t> corner_indices_;
    glm::dvec3 origin_{0};
    design::Color color_;
    scene::Uncertainty uncertainty_;
    std::uint32_t vertex_count_ = 0, index_count_ = 0;
    bool is_whole_ = true;
};

}  // namespace tedavis::draw
