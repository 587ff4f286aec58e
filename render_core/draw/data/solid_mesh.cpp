#include "render_core/draw/data/solid_mesh.hpp"

#include <glm/geometric.hpp>

namespace tedavis::draw {
namespace {

constexpr std::uint64_t kMeshPadding_bytes = 64;

}  // namespace

std::uint64_t SolidMesh::bytes_needed() {
    return kVertices * sizeof(SolidVertex) + (kIndices + 3 * kCorners) * sizeof(std::uint16_t) + kCorners * sizeof(glm::dvec2) +
           kMeshPadding_bytes;
}

bool SolidMesh::start(base::Arena& arena) {
    vertices_ = arena.allocate_array<SolidVertex>(kVertices);
    indices_ = arena.allocate_array<std::uint16_t>(kIndices);
    corners_ = arena.allocate_array<glm::dvec2>(kCorners);
    corner_indices_ = arena.allocate_array<std::uint16_t>(3 * kCorners);
    return !vertices_.empty() && !indices_.empty() && !corners_.empty() && !corner_indices_.empty();
}

void SolidMesh::begin(const glm::dvec3& origin) {
    origin_ = origin;
    vertex_count_ = index_count_ = 0;
    is_whole_ = true;
}

void SolidMesh::set_color(design::Color color, scene::Uncertainty uncertainty) {
    color_ = color;
    uncertainty_ = uncertainty;
}

std::uint16_t SolidMesh::vertex(const glm::dvec3& place, const glm::dvec3& normal) {
    if (vertex_count_ == vertices_.size()) {
        is_whole_ = false;
        return 0;
    }
    vertices_[vertex_count_] = solid_vertex(glm::vec3(place - origin_), glm::vec3(normal), color_, uncertainty_);
    return static_cast<std::uint16_t>(vertex_count_++);
}

void SolidMesh::triangle(std::uint16_t a, std::uint16_t b, std::uint16_t c) {
    if (index_count_ + 3 > indices_.size()) {
        is_whole_ = false;
        return;
    }
    for (const std::uint16_t corner : {a, b, c}) indices_[index_count_++] = corner;
}

void SolidMesh::quad(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    const glm::dvec3 across = glm::cross(c - a, d - b);
    const double area = glm::length(across);
    if (!(area > 0)) return;
    const glm::dvec3 normal = across / area;
    const std::uint16_t first = vertex(a, normal), second = vertex(b, normal), third = vertex(c, normal),
                        last = vertex(d, normal);
    triangle(first, second, third);
    triangle(first, third, last);
}

bool SolidMesh::add_to(SolidBatch& batch) const {
    return is_whole_ && batch.add(origin_, {vertices_.data(), vertex_count_}, {indices_.data(), index_count_});
}

}  // namespace tedavis::draw
