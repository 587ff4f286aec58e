/// A sheet for billboards of a test, and an eye that looks north over the ground of built_element.hpp.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/billboard_sheet.hpp"
#include "render_core/earth/wgs84.hpp"
#include "tests/support/display/free_view.hpp"
#include "tests/support/draw/built_element.hpp"

namespace tedavis::test_support {

class BillboardRoom {
public:
    static constexpr double kEyeLatitude_deg = 46.8, kEyeLongitude_deg = 9.8, kEyeHeight_m = 1000;

    explicit BillboardRoom(std::size_t vertices = 16'384, double heading_deg = 0)
        : vertices_(2 * vertices), indices_(3 * vertices), block_(1u << 16) {
        const std::size_t indices = 3 * vertices / 2;
        batch = draw::QuadBatch({vertices_.data(), vertices}, {indices_.data(), indices});
        links = draw::QuadBatch({vertices_.data() + vertices, vertices}, {indices_.data() + indices, indices});
        base::Arena arena(block_.data(), block_.size());
        EXPECT_TRUE(sheet.start(arena));
        const double latitude = base::radians(kEyeLatitude_deg), longitude = base::radians(kEyeLongitude_deg);
        view = free_view(earth::to_ecef({latitude, longitude, {kEyeHeight_m}}),
                         earth::body_axes(latitude, longitude, base::radians(heading_deg), 0, 0), 800, 600, 1);
        begin();
    }
    void begin(const draw::QuadBatch* symbology = nullptr) { sheet.begin({batch, links, view, 16, nullptr, symbology}); }

    /// So many metres ahead of the eye and right of it.
    [[nodiscard]] static scene::ScenePoint point(double ahead_m, double right_m, float height_m) {
        const double latitude = base::radians(kEyeLatitude_deg);
        scene::ScenePoint result = {latitude + ahead_m / earth::meridian_radius_m(latitude), base::radians(kEyeLongitude_deg),
                                    height_m, 0, scene::kNoTime};
        result.longitude_rad += right_m / (earth::prime_vertical_radius_m(latitude) * std::cos(latitude));
        return result;
    }
    /// Links and stems, then signs.
    [[nodiscard]] std::vector<draw::QuadVertex> drawn() const {
        std::vector<draw::QuadVertex> all;
        for (const draw::QuadVertex& vertex : links.vertices()) all.push_back(vertex);
        for (const draw::QuadVertex& vertex : batch.vertices()) all.push_back(vertex);
        return all;
    }
    /// Of the vertices that hold, x and y of the least and the greatest.
    template <class Holds>
    [[nodiscard]] draw::Rect bounds(const Holds& holds) const {
        float left = 1e9f, right = -1e9f, top = 1e9f, bottom = -1e9f;
        for (const draw::QuadVertex& vertex : drawn()) {
            if (!holds(vertex)) continue;
            left = std::min(left, vertex.x), right = std::max(right, vertex.x);
            top = std::min(top, vertex.y), bottom = std::max(bottom, vertex.y);
        }
        return {left, top, right - left, bottom - top};
    }
    [[nodiscard]] draw::Rect bounds() const {
        return bounds([](const draw::QuadVertex&) { return true; });
    }
    /// Glyphs carry a negative extent (quad_batch.hpp).
    [[nodiscard]] std::size_t glyph_vertices() const {
        std::size_t count = 0;
        for (const draw::QuadVertex& vertex : batch.vertices()) count += vertex.extent_x < 0 ? 1 : 0;
        return count;
    }

    draw::QuadBatch batch, links;  ///< of signs, and of what leads to them
    draw::BillboardSheet sheet;
    terrain::View view;

private:
    std::vector<draw::QuadVertex> vertices_;
    std::vector<std::uint16_t> indices_;
    std::vector<unsigned char> block_;
};

}  // namespace tedavis::test_support
