/// The share of its detail that each region of the screen keeps: a grid of factors, from the top left corner.
///
/// Plain data; pure.
#pragma once

#include <array>
#include <cstddef>

namespace tedavis::scene {

struct DetailRegions {
    static constexpr std::size_t kAcross = 8, kDown = 6;
    std::array<float, kAcross* kDown> factor = whole();  ///< 0..1, row by row

    /// Returns the factor at a point of the screen, 0..1 from the left and from the top; outside it that of the nearest region.
    [[nodiscard]] double at(double across, double down) const noexcept {
        return static_cast<double>(factor[index(down, kDown) * kAcross + index(across, kAcross)]);
    }
    [[nodiscard]] bool is_whole() const noexcept { return factor == whole(); }

private:
    [[nodiscard]] static constexpr std::array<float, kAcross * kDown> whole() {
        std::array<float, kAcross * kDown> all{};
        for (float& one : all) one = 1;
        return all;
    }
    [[nodiscard]] static std::size_t index(double share, std::size_t count) noexcept {
        if (!(share > 0)) return 0;
        const auto number = static_cast<std::size_t>(share * static_cast<double>(count));
        return number < count ? number : count - 1;
    }
};

}  // namespace tedavis::scene
