#include "render_core/draw/data/tube_skin.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"

namespace tedavis::draw {
namespace {

constexpr std::uint32_t kSides = scene::kDefaultTubeSides;
constexpr std::uint32_t kEndIndices = 3 * (kSides - 2), kWallIndices = 6 * kSides;
constexpr std::uint32_t kBlockRings = kTubeBlockRings + 1;
constexpr std::uint32_t kBlockVertices = kBlockRings * TubeSkin::kRingVertices + 2 * TubeSkin::kEndVertices;
constexpr std::uint32_t kBlockIndices = kTubeBlockRings * kWallIndices + 2 * kEndIndices;
constexpr std::uint64_t kSkinPadding_bytes = 64;
constexpr double kMarkerRadii = 2;  // of the tube that it stands for
static_assert(kBlockVertices <= SolidMesh::kVertices && kBlockRings * kTubeHullSides <= SolidMesh::kVertices);
static_assert(6 * kTubeHullSides * kBlockRings <= SolidMesh::kIndices);

/// How far an ellipse reaches in a direction with this part of it upwards.
double reach_m(const TubeMargin& margin, double upwards) {
    if (!(margin.horizontal_m > 0) || !(margin.vertical_m > 0)) return 0;
    const double across = (1 - upwards * upwards) / (margin.horizontal_m * margin.horizontal_m);
    return 1 / std::sqrt(across + upwards * upwards / (margin.vertical_m * margin.vertical_m));
}

/// A round hull: a ring of vertices for each ring of the tube.
class Hull {
public:
    Hull(SolidMesh& mesh, const TubeBlock& block, std::uint32_t sides, base::Span<const TubeMargin> margins,
         base::Span<const RingColors> colors)
        : mesh_(mesh), block_(block), sides_(sides), margins_(margins), colors_(colors) {}

    void build() {
        const std::size_t count = block_.rings.size();
        for (std::size_t n = 0; n < count; ++n) {
            const double facing = n == 0 && block_.begins ? -1 : n + 1 == count && block_.ends ? 1 : 0;
            add_ring(n, facing);
            if (n > 0) add_walls(n);
        }
        for (std::uint32_t corner = 1; corner + 1 < sides_; ++corner) {
            if (block_.begins) mesh_.triangle(number(0, 0), number(0, corner + 1), number(0, corner));
            if (block_.ends) mesh_.triangle(number(count - 1, 0), number(count - 1, corner), number(count - 1, corner + 1));
        }
    }

private:
    [[nodiscard]] std::uint16_t number(std::size_t ring, std::uint32_t corner) const {
        return static_cast<std::uint16_t>(ring * sides_ + corner % sides_);
    }
    void add_ring(std::size_t n, double facing) {
        const scene::TubeRing& ring = block_.rings[n];
        mesh_.set_color(colors_[n].even.color, colors_[n].even.uncertainty);
        const glm::dvec3 binormal = ring.frame.binormal(), up = glm::normalize(ring.centre);
        for (std::uint32_t corner = 0; corner < sides_; ++corner) {
            const double turn = base::kPi * (2.0 * corner - 1) / sides_;
            const glm::dvec3 outwards = std::cos(turn) * ring.frame.normal + std::sin(turn) * binormal;
            const double margin_m = margins_.empty() ? 0 : reach_m(margins_[n], glm::dot(outwards, up));
            const double end_m = facing == 0 || margins_.empty() ? 0 : margins_[n].horizontal_m;
            static_cast<void>(mesh_.vertex(
                ring.centre + (static_cast<double>(ring.radius_m) + margin_m) * outwards + facing * end_m * ring.frame.tangent,
                glm::normalize(outwards + facing * ring.frame.tangent)));
        }
    }
    void add_walls(std::size_t n) {
        for (std::uint32_t corner = 0; corner < sides_; ++corner) {
            mesh_.triangle(number(n - 1, corner), number(n - 1, corner + 1), number(n, corner + 1));
            mesh_.triangle(number(n - 1, corner), number(n, corner + 1), number(n, corner));
        }
    }

    SolidMesh& mesh_;
    const TubeBlock& block_;
    std::uint32_t sides_;
    base::Span<const TubeMargin> margins_;
    base::Span<const RingColors> colors_;
};

}  // namespace

std::uint64_t TubeSkin::bytes_needed() {
    return kBlockVertices * sizeof(scene::TubeVertex) + kBlockIndices * sizeof(std::uint16_t) + kSkinPadding_bytes;
}

bool TubeSkin::start(base::Arena& arena) {
    vertices_ = arena.allocate_array<scene::TubeVertex>(kBlockVertices);
    indices_ = arena.allocate_array<std::uint16_t>(kBlockIndices);
    return !vertices_.empty() && !indices_.empty();
}

bool TubeSkin::add_sides(SolidBatch& batch, SolidMesh& mesh, const TubeBlock& block, base::Span<const RingColors> colors) {
    const glm::dvec3 origin = block.rings[0].centre;
    scene::TubeChunk chunk;
    const scene::TubeMeshCounts made = scene::mesh_tube(block.rings, kSides, origin, {vertices_, indices_, {&chunk, 1}});
    mesh.begin(origin);
    // The mesh is an end, the rings in turn, an end; ends within a piece are left out.
    const std::uint32_t first = block.begins ? 0 : kEndVertices, end = made.vertices - (block.ends ? 0 : kEndVertices);
    const auto last_ring = static_cast<std::uint32_t>(block.rings.size() - 1);
    for (std::uint32_t n = first; n < end; ++n) {
        const std::uint32_t ring = n < kEndVertices ? 0 : std::min((n - kEndVertices) / kRingVertices, last_ring);
        const bool is_odd = vertices_[n].side != scene::kTubeEndSide && vertices_[n].side % 2 == 1;
        const TubeColor& shown = is_odd ? colors[ring].odd : colors[ring].even;
        mesh.set_color(shown.color, shown.uncertainty);
        static_cast<void>(mesh.vertex(origin + glm::dvec3(vertices_[n].position), glm::dvec3(vertices_[n].normal)));
    }
    const auto from = [&](std::uint32_t n) { return static_cast<std::uint16_t>(indices_[n] - first); };
    const std::uint32_t last = made.indices - (block.ends ? 0 : kEndIndices);
    for (std::uint32_t n = block.begins ? 0 : kEndIndices; n < last; n += 3) mesh.triangle(from(n), from(n + 1), from(n + 2));
    return made.rings == block.rings.size() && mesh.add_to(batch);
}

bool add_tube_hull(SolidBatch& batch, SolidMesh& mesh, const TubeBlock& block, std::uint32_t sides,
                   base::Span<const TubeMargin> margins, base::Span<const RingColors> colors) {
    mesh.begin(block.rings[0].centre);
    Hull(mesh, block, sides, margins, colors).build();
    return mesh.add_to(batch);
}

bool add_tube_marker(SolidBatch& batch, SolidMesh& mesh, const scene::TubeRing& ring, const TubeColor& color) {
    const glm::dvec3 up = glm::normalize(ring.centre);
    const scene::TubeFrame frame{up, scene::normal_towards({0, 0, 1}, up)};
    const double radius_m = kMarkerRadii * static_cast<double>(ring.radius_m);
    const glm::dvec3 round[4] = {frame.normal, frame.binormal(), -frame.normal, -frame.binormal()};
    mesh.begin(ring.centre);
    mesh.set_color(color.color, color.uncertainty);
    for (std::size_t n = 0; n < 4; ++n)
        for (const double side : {1.0, -1.0}) {
            const glm::dvec3 a = round[n], b = round[(n + 1) % 4], tip = side * up;
            const glm::dvec3 normal = glm::normalize(a + b + tip);
            const auto add = [&](const glm::dvec3& direction) { return mesh.vertex(ring.centre + radius_m * direction, normal); };
            const std::uint16_t first = add(side > 0 ? a : b), second = add(side > 0 ? b : a), third = add(tip);
            mesh.triangle(first, second, third);
        }
    return mesh.add_to(batch);
}

}  // namespace tedavis::draw
