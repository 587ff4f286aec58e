/// Elements of a small scene, built over a ground that is known, and what their solids enclose.
#pragma once

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <map>
#include <utility>
#include <vector>

#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/solid_batch.hpp"
#include "render_core/draw/data/solid_mesh.hpp"
#include "tests/support/scene/loaded_scene.hpp"

namespace tedavis::test_support {

/// Level, but for nothing where `is_known` is false.
class LevelGround final : public scene::Ground {
public:
    double height_m(double, double) override { return is_known ? height : std::numeric_limits<double>::quiet_NaN(); }
    double undulation_m(double, double) override { return undulation; }

    double height = 600, undulation = 50;
    bool is_known = true;
};

/// A batch with room of its own, and a mesh for builders.
class SolidRoomOfTest {
public:
    explicit SolidRoomOfTest(std::size_t vertices = 65536, std::size_t pieces = 64)
        : vertices_(vertices), indices_(3 * vertices), pieces_(pieces), block_(draw::SolidMesh::bytes_needed()) {
        batch = draw::SolidBatch({vertices_.data(), vertices}, {indices_.data(), indices_.size()}, {pieces_.data(), pieces});
        base::Arena arena(block_.data(), block_.size());
        EXPECT_TRUE(mesh.start(arena));
    }

    draw::SolidBatch batch;
    draw::SolidMesh mesh;

private:
    std::vector<draw::SolidVertex> vertices_;
    std::vector<std::uint16_t> indices_;
    std::vector<draw::SolidPiece> pieces_;
    std::vector<unsigned char> block_;
};

/// The layer of a draft as builders get it. Settings may be changed before it is built.
class ElementOfTest {
public:
    explicit ElementOfTest(const host_sim::LayerDraft& draft) : scene_(draft) {
        element.layer = std::string_view(draft.name);
        element.color = {200, 40, 20, 255};
    }
    [[nodiscard]] draw::ElementInput input() {
        return {element, 3, scene_.layer(), ground, {255, 0, 255, 255}, time_ns, has_date};
    }

    design::DataElement element;
    LevelGround ground;
    std::int64_t time_ns = 0;
    bool has_date = false;

private:
    LoadedScene scene_;
};

/// Of a piece, by the divergence theorem: positive when its triangles face outwards.
[[nodiscard]] inline double volume_m3(const draw::SolidBatch& batch, const draw::SolidPiece& piece) {
    double six_times = 0;
    const auto place = [&](std::uint32_t n) {
        return glm::dvec3(batch.vertices()[piece.first_vertex + batch.indices()[piece.first_index + n]].place_m);
    };
    for (std::uint32_t n = 0; n + 2 < piece.indices; n += 3)
        six_times += glm::dot(place(n), glm::cross(place(n + 1), place(n + 2)));
    return six_times / 6;
}

/// Edges of a piece, by the places of their ends, that are not run through once each way.
[[nodiscard]] inline std::size_t open_edges(const draw::SolidBatch& batch, const draw::SolidPiece& piece) {
    using Place = std::array<float, 3>;
    std::map<std::pair<Place, Place>, int> runs;
    const auto place = [&](std::uint32_t n) {
        const glm::vec3& at = batch.vertices()[piece.first_vertex + batch.indices()[piece.first_index + n]].place_m;
        return Place{at.x, at.y, at.z};
    };
    for (std::uint32_t n = 0; n + 2 < piece.indices; n += 3)
        for (std::uint32_t side = 0; side < 3; ++side) {
            const Place from = place(n + side), to = place(n + (side + 1) % 3);
            from < to ? ++runs[{from, to}] : --runs[{to, from}];
        }
    std::size_t open = 0;
    for (const auto& edge : runs) open += edge.second != 0 ? 1 : 0;
    return open;
}

}  // namespace tedavis::test_support
