#include "host_sim/terrain_builder/chunk_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using namespace terrain;

constexpr double kPlaceRounding_m = 1e-8;       // of places in space, computed in doubles
constexpr double kHalfUlp = 0x1p-24;            // of heights above the ellipsoid, which are floats
constexpr double kUndulationRounding_m = 5e-6;  // its grid holds floats below 128 m

/// The box's axes as the file states them.
std::array<glm::dvec3, 3> axes_of(const ChunkEntry& entry) {
    std::array<glm::dvec3, 3> axes;
    for (std::size_t a = 0; a < 3; ++a) axes[a] = {entry.axes[3 * a], entry.axes[3 * a + 1], entry.axes[3 * a + 2]};
    return axes;
}

/// Positions that are not exact in a float would part chunks that share them.
float exactly(double value) {
    const auto single = static_cast<float>(value);
    if (double{single} != value)
        throw UserError("terrain build: a vertex lies farther from its chunk's centre than planned; report this raster");
    return single;
}

float stored_above(double value) { return std::nextafter(static_cast<float>(value), std::numeric_limits<float>::max()); }

}  // namespace

ChunkAssembly::ChunkAssembly(const BuildPlan& plan, const ChunkKey& key) : plan_(plan), posts_(plan.lattice.posts_of(key)) {
    draft_.entry.level = static_cast<std::uint8_t>(key.level);
    draft_.entry.i = key.i;
    draft_.entry.j = key.j;
    draft_.entry.le90_m = plan.header.le90_m;
    for (std::uint32_t level = 0; level < plan.levels(); ++level) quantum_m_.push_back(plan.quantum_m(level));
}

void ChunkAssembly::reserve(std::size_t vertices) {
    places_.reserve(vertices);
    draft_.vertices.reserve(vertices);
    draft_.roundings.reserve(vertices);
}

void ChunkAssembly::add_border(const BorderPost& post, const LatticeWindow& window, const PostPlaces& places) {
    add(post.i, post.j, post.top_level, post.stays, window, places);
    ++draft_.entry.border_count;
}

void ChunkAssembly::add_inner(std::uint32_t i, std::uint32_t j, const LatticeWindow& window, const PostPlaces& places) {
    add(i, j, draft_.entry.level, false, window, places);
}

void ChunkAssembly::add(std::uint32_t i, std::uint32_t j, std::uint32_t quantum_level, bool stays, const LatticeWindow& window,
                        const PostPlaces& places) {
    const std::size_t n = window.at(i, j);
    const double q = quantum_m_[quantum_level];
    const glm::dvec3 exact = places.at(i, j, window.surface_m[n]);
    glm::dvec3 place = exact;
    for (int a = 0; a < 3; ++a) place[a] = std::round(place[a] / q) * q;
    places_.push_back(place);
    const glm::dvec3 moved = place - exact, up = places.up(i, j);
    const double moved_up_m = glm::dot(moved, up);
    const double height_rounding_m = std::abs(double{window.surface_m[n]}) * kHalfUlp + kUndulationRounding_m;
    draft_.roundings.push_back(
        {std::abs(moved_up_m) + height_rounding_m + kPlaceRounding_m, glm::length(moved - up * moved_up_m) + kPlaceRounding_m});
    draft_.rounding_m = std::max(draft_.rounding_m, 0.5 * std::sqrt(3.0) * q);
    ChunkVertex v{};
    v.height_m = window.height_m[n];
    const glm::dvec3 normal = places.normal(window, i, j);
    for (int a = 0; a < 3; ++a) v.normal[a] = static_cast<std::int8_t>(std::lround(normal[a] * 127));
    v.kind = static_cast<std::uint8_t>(static_cast<unsigned>(window.post_class[n]) | (stays ? 4u : 0u));
    v.i = static_cast<std::uint16_t>(i - posts_.i0);
    v.j = static_cast<std::uint16_t>(j - posts_.j0);
    draft_.vertices.push_back(v);
}

void ChunkAssembly::place_box() {
    ChunkEntry& entry = draft_.entry;
    const double latitude = 0.5 * (plan_.lattice.latitude_rad(posts_.j0) + plan_.lattice.latitude_rad(posts_.j1));
    const glm::dmat3 frame = earth::north_east_down(latitude, plan_.lattice.longitude_rad((posts_.i0 + posts_.i1) / 2));
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) entry.axes[3 * a + b] = static_cast<float>(frame[a][b]);
    const std::array<glm::dvec3, 3> axes = axes_of(entry);
    const glm::dvec3 origin = places_.front();
    glm::dvec3 least(0), most(0);
    for (const glm::dvec3& place : places_)
        for (int a = 0; a < 3; ++a) {
            const double along = glm::dot(place - origin, axes[static_cast<std::size_t>(a)]);
            least[a] = std::min(least[a], along);
            most[a] = std::max(most[a], along);
        }
    glm::dvec3 centre = origin;
    for (int a = 0; a < 3; ++a) centre += axes[static_cast<std::size_t>(a)] * (0.5 * (least[a] + most[a]));
    for (int a = 0; a < 3; ++a) {
        entry.centre_m[a] = std::round(centre[a]);
        const double shift = std::sqrt(3.0);  // rounding moves the centre by less, along whatever axis
        entry.half_extent_m[a] = stored_above((0.5 * (most[a] - least[a]) + shift) * (1 + 1e-6));
    }
}

ChunkDraft ChunkAssembly::finish() {
    place_box();
    const glm::dvec3 centre(draft_.entry.centre_m[0], draft_.entry.centre_m[1], draft_.entry.centre_m[2]);
    for (std::size_t n = 0; n < places_.size(); ++n) {
        const glm::dvec3 local = places_[n] - centre;
        ChunkVertex& v = draft_.vertices[n];
        v.x = exactly(local.x);
        v.y = exactly(local.y);
        v.z = exactly(local.z);
    }
    draft_.entry.vertex_count = static_cast<std::uint16_t>(draft_.vertices.size());
    return std::move(draft_);
}

void grow_box(ChunkEntry& entry, double margin_m) {
    for (float& half : entry.half_extent_m) half = stored_above(half + margin_m);
}

}  // namespace tedavis::host_sim
