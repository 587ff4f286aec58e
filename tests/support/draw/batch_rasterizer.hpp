/// Draws a quad batch without GL, by the formula in quad_batch.hpp: what tests look at when they ask for pixels.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render_core/draw/quad_batch.hpp"

namespace tedavis::test_support {

struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  ///< top row first

    Picture(int w, int h, design::Color background);
    [[nodiscard]] design::Color at(int x, int y) const;
    /// Binary PPM, to look at.
    void save(const std::string& path) const;
};

void rasterize(const draw::QuadBatch& batch, Picture& picture);

}  // namespace tedavis::test_support
