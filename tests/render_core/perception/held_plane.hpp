/// A plane with values of its own.
#pragma once

#include <vector>

#include "render_core/perception/plane.hpp"
#include "tests/support/perception/itti_reference.hpp"
#include "tests/support/perception/synthetic_picture.hpp"

namespace tedavis::test_support {

struct HeldPlane {
    HeldPlane(int width, int height, float filled = 0) : values(perception::pixels_of(width, height), filled) {
        plane = {values.data(), width, height};
    }
    HeldPlane(const HeldPlane&) = delete;
    HeldPlane& operator=(const HeldPlane&) = delete;
    HeldPlane(HeldPlane&& other) noexcept : values(std::move(other.values)), plane(other.plane) { plane.values = values.data(); }
    HeldPlane& operator=(HeldPlane&&) = delete;

    [[nodiscard]] Field field() const {
        Field copy(plane.width, plane.height);
        copy.values.assign(values.begin(), values.end());
        return copy;
    }
    std::vector<float> values;
    perception::Plane plane;
};

/// Numbers 0..1 by chance.
inline HeldPlane noise_plane(int width, int height, std::uint32_t seed) {
    HeldPlane held(width, height);
    for (std::size_t n = 0; n < held.values.size(); ++n)
        held.values[n] = static_cast<float>(scrambled(static_cast<std::uint32_t>(n), 7, seed) % 10007) / 10007;
    return held;
}

}  // namespace tedavis::test_support
