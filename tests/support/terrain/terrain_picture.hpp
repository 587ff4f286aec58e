/// Pictures of terrain alone, from any view: what is no terrain has a colour that no terrain has.
#pragma once

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "render_core/display/preroll.hpp"
#include "tests/support/display/drawn_pixels.hpp"
#include "tests/support/flights/placed_aircraft.hpp"

namespace tedavis::test_support {

/// All that is no terrain is pure blue, ground without data too; terrain and sea have none of it. Nothing else is shown.
inline design::DesignSettings garish_design(double tau_px = 1, bool conservative_up = false) {
    design::DesignSettings design = shipped_design("default");
    design.terrain.tau_px = tau_px;
    design.terrain.conservative_up = conservative_up;
    design.terrain.style.sketch.silhouettes = 0;
    const design::Color blue{0, 0, 255}, ground{200, 60, 0};
    design.sky.zenith = design.sky.horizon = design.sky.ground = design.sky.ground_horizon = design.sky.haze = blue;
    design.sky.haze_distance_m = 0;
    for (design::ColorStop& stop : design.terrain.palette.stops) stop.color = ground;
    design.terrain.sea = ground;
    design.terrain.unknown = blue;  // of the ground beyond the database as well
    design.warning_colors = false;
    design.data.elements.clear();
    design.effects.antialiasing = design::Antialiasing::off;  // it mixes colors across edges
    return design;
}

class TerrainPicture {
public:
    /// With everything arrived, or with what is there when `settled` is false.
    TerrainPicture(HeadlessDisplay& headless, const terrain::View& view, const earth::Geodetic& ship, bool settled = true)
        : view_(view),
          width_(static_cast<int>(headless.surface().width())),
          height_(static_cast<int>(headless.surface().height())) {
        EXPECT_TRUE(view.width == headless.surface().width() && view.height == headless.surface().height());
        display::Display& display = headless.display();
        const flight::AircraftState state = aircraft_at(ship);
        display.planner().set_free_view(view);
        if (settled) display::settle(display, {state, {}, host_sim::kPosedTime});
        display.plan({state, {}, host_sim::kPosedTime});
        rgba_ = drawn_pixels(headless);
        record_ = display.record();
    }

    [[nodiscard]] const terrain::View& view() const { return view_; }
    [[nodiscard]] const display::FrameRecord& record() const { return record_; }
    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    /// RGBA; row 0 at the top.
    [[nodiscard]] const std::uint8_t* pixel(int column, int row) const {
        return rgba_.data() + (static_cast<std::size_t>(height_ - 1 - row) * static_cast<std::size_t>(width_) +
                               static_cast<std::size_t>(column)) *
                                  4;
    }
    [[nodiscard]] bool is_background(int column, int row) const { return pixel(column, row)[0] == 0; }
    [[nodiscard]] int background() const {
        int count = 0;
        for (int row = 0; row < height_; ++row)
            for (int column = 0; column < width_; ++column) count += is_background(column, row) ? 1 : 0;
        return count;
    }
    /// Row of the uppermost pixel of terrain.
    [[nodiscard]] std::optional<int> skyline(int column) const {
        for (int row = 0; row < height_; ++row)
            if (!is_background(column, row)) return row;
        return std::nullopt;
    }
    /// Background pixels that no way over background leads from to the picture's edge: seen through holes in the terrain.
    [[nodiscard]] int enclosed_background() const {
        const auto place = [this](int column, int row) { return static_cast<std::size_t>(row * width_ + column); };
        std::vector<char> reached(static_cast<std::size_t>(width_ * height_), 0);
        std::vector<std::pair<int, int>> open;
        const auto reach = [&](int column, int row) {
            if (column < 0 || row < 0 || column >= width_ || row >= height_) return;
            if (reached[place(column, row)] != 0 || !is_background(column, row)) return;
            reached[place(column, row)] = 1;
            open.emplace_back(column, row);
        };
        for (int column = 0; column < width_; ++column) reach(column, 0), reach(column, height_ - 1);
        for (int row = 0; row < height_; ++row) reach(0, row), reach(width_ - 1, row);
        int outside = 0;
        for (; !open.empty(); ++outside) {
            const auto [column, row] = open.back();
            open.pop_back();
            for (int b = -1; b <= 1; ++b)
                for (int a = -1; a <= 1; ++a) reach(column + a, row + b);
        }
        return background() - outside;
    }

private:
    terrain::View view_;
    int width_, height_;
    std::vector<std::uint8_t> rgba_;
    display::FrameRecord record_;
};

/// A view over the same field for pictures of another size.
[[nodiscard]] inline terrain::View resized(terrain::View view, std::uint32_t width, std::uint32_t height) {
    view.focal_px *= double{1} * width / view.width;
    view.width = width;
    view.height = height;
    return view;
}

}  // namespace tedavis::test_support
