#include "render_core/draw/data/solid_batch.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "render_core/base/check.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr float kNormalScale = 127;

std::uint8_t normal_code(float component) {
    return static_cast<std::uint8_t>(std::lround(kNormalScale + kNormalScale * std::clamp(component, -1.0f, 1.0f)));
}

}  // namespace

SolidVertex solid_vertex(const glm::vec3& place_m, const glm::vec3& normal, design::Color color, scene::Uncertainty uncertainty) {
    SolidVertex vertex;
    vertex.place_m = place_m;
    for (int n = 0; n < 3; ++n) vertex.normal[n] = normal_code(normal[n]);
    vertex.uncertainty = uncertainty.code();
    vertex.rgba[0] = color.red;
    vertex.rgba[1] = color.green;
    vertex.rgba[2] = color.blue;
    vertex.rgba[3] = color.alpha;
    return vertex;
}

bool operator==(const SolidLook& a, const SolidLook& b) noexcept {
    return a.opacity == b.opacity && a.ghost == b.ghost && a.halo_px == b.halo_px && a.raised_px == b.raised_px &&
           a.fading == b.fading && a.has_grid == b.has_grid && a.fading_strength == b.fading_strength &&
           a.fading_levels == b.fading_levels && a.growth_per_hour == b.growth_per_hour && a.near_m == b.near_m &&
           a.group == b.group && a.is_mixed == b.is_mixed && a.is_hollow == b.is_hollow && a.is_thing == b.is_thing &&
           a.nearer_m == b.nearer_m && a.is_last == b.is_last;
}

SolidBatch::SolidBatch(base::Span<SolidVertex> vertices, base::Span<std::uint16_t> indices, base::Span<SolidPiece> pieces)
    : vertices_(vertices), indices_(indices), pieces_(pieces) {
    use_.capacity = vertices.size();
}

SolidBatch::SolidBatch(base::Arena& memory, const SolidRoom& room)
    : SolidBatch(memory.allocate_array<SolidVertex>(room.vertices), memory.allocate_array<std::uint16_t>(room.indices),
                 memory.allocate_array<SolidPiece>(room.pieces)) {}

void SolidBatch::clear() {
    vertex_count_ = index_count_ = piece_count_ = 0;
    begins_piece_ = true;
    use_.in_use = 0;
}

void SolidBatch::set_look(const SolidLook& look, std::int64_t data_time_ns) {
    begins_piece_ = begins_piece_ || !(look == look_) || data_time_ns != data_time_ns_;
    look_ = look;
    data_time_ns_ = data_time_ns;
}

bool SolidBatch::has_room(std::size_t vertices, std::size_t indices) const {
    return vertices <= kMaxPieceVertices && vertices <= vertices_left() && indices <= indices_left();
}

bool SolidBatch::goes_on(const glm::dvec3& origin, std::size_t vertices) const {
    // What is mixed with what is behind is put in order mesh by mesh.
    if (begins_piece_ || piece_count_ == 0 || look_.is_mixed) return false;
    const SolidPiece& piece = pieces_[piece_count_ - 1];
    return piece.vertices + vertices <= kMaxPieceVertices && glm::distance(origin, piece.anchor) < kFarthestFromAnchor_m;
}

bool SolidBatch::add(const glm::dvec3& origin, base::Span<const SolidVertex> vertices, base::Span<const std::uint16_t> indices) {
    const bool goes_on_now = goes_on(origin, vertices.size());
    if (!has_room(vertices.size(), indices.size()) || (!goes_on_now && piece_count_ == pieces_.size())) {
        ++use_.refused;
        return false;
    }
    if (!goes_on_now) {
        SolidPiece& begun = pieces_[piece_count_++];
        begun = {};
        begun.anchor = origin;
        begun.top_m = -std::numeric_limits<float>::infinity();
        begun.look = look_;
        begun.data_time_ns = data_time_ns_;
        begun.first_vertex = static_cast<std::uint32_t>(vertex_count_);
        begun.first_index = static_cast<std::uint32_t>(index_count_);
        begins_piece_ = false;
    }
    SolidPiece& piece = pieces_[piece_count_ - 1];
    const glm::vec3 offset(origin - piece.anchor), up(earth::up_at(piece.anchor));
    const auto anchor_height_m = static_cast<float>(earth::from_ecef(piece.anchor).height.m);
    for (const SolidVertex& vertex : vertices) {
        SolidVertex& kept = vertices_[vertex_count_++];
        kept = vertex;
        kept.place_m += offset;
        const float away_m = glm::length(kept.place_m);
        piece.radius_m = std::max(piece.radius_m, away_m);
        // The Earth falls away below a level plane.
        const float sunk_m = away_m * away_m / static_cast<float>(2 * earth::kMeanRadius_m);
        piece.top_m = std::max(piece.top_m, anchor_height_m + glm::dot(kept.place_m, up) + sunk_m);
    }
    for (const std::uint16_t index : indices) {
        TEDAVIS_CHECK(index < vertices.size());
        indices_[index_count_++] = static_cast<std::uint16_t>(piece.vertices + index);
    }
    piece.vertices += static_cast<std::uint32_t>(vertices.size());
    piece.indices += static_cast<std::uint32_t>(indices.size());
    use_.take(vertices.size());
    return true;
}

}  // namespace tedavis::draw
