/// Ground of any size that is nowhere stored: hills between lattice points 64 posts apart, and every post a little off them.
/// Whole numbers all the way, so that any part of it is the same wherever it is asked for.
#pragma once

#include <algorithm>

#include "render_core/raytrace/paged/chunk_heights.hpp"
#include "tests/support/terrain/fractal_heights.hpp"

namespace tedavis::test_support {

class GeneratedChunks final : public raytrace::ChunkHeights<std::int16_t> {
public:
    GeneratedChunks(std::uint32_t columns, std::uint32_t rows) : columns_(columns), rows_(rows) {}
    [[nodiscard]] std::uint32_t columns() const override { return columns_; }
    [[nodiscard]] std::uint32_t rows() const override { return rows_; }

    [[nodiscard]] static std::int16_t height(std::uint32_t i, std::uint32_t j) {
        const std::int32_t u = static_cast<std::int32_t>(i % kHill), v = static_cast<std::int32_t>(j % kHill), side = kHill;
        const std::int32_t north = hill(i / kHill, j / kHill) * (side - u) + hill(i / kHill + 1, j / kHill) * u;
        const std::int32_t south = hill(i / kHill, j / kHill + 1) * (side - u) + hill(i / kHill + 1, j / kHill + 1) * u;
        const auto rough = static_cast<std::int32_t>(mixed_bits(i ^ mixed_bits(j)) % (2 * kRough + 1)) - kRough;
        return static_cast<std::int16_t>((north * (side - v) + south * v) / (side * side) + rough);
    }
    /// From the hills at the corners of the chunk's hill cell, without a look at its posts.
    [[nodiscard]] bool read_bounds(base::Span<std::int16_t> lowest, base::Span<std::int16_t> highest) override {
        for (std::uint32_t chunk = 0; chunk < lowest.size(); ++chunk) {
            const std::uint32_t i = chunk % chunk_columns() * kCells / kHill, j = chunk / chunk_columns() * kCells / kHill;
            const std::int32_t corners[] = {hill(i, j), hill(i + 1, j), hill(i, j + 1), hill(i + 1, j + 1)};
            lowest[chunk] = static_cast<std::int16_t>(*std::min_element(corners, corners + 4) - kRough);
            highest[chunk] = static_cast<std::int16_t>(*std::max_element(corners, corners + 4) + kRough);
        }
        return true;
    }
    [[nodiscard]] bool load(std::uint32_t column, std::uint32_t row, std::uint32_t, base::Span<std::int16_t> posts) override {
        for (std::uint32_t n = 0; n < posts.size(); ++n) {
            const std::uint32_t i = column * kCells + n % kPosts, j = row * kCells + n / kPosts;
            posts[n] = i < columns_ && j < rows_ ? height(i, j) : raytrace::HeightGrid<std::int16_t>::kVoid;
        }
        return true;
    }
    static constexpr std::int32_t kHighest = 8000;

private:
    static constexpr std::uint32_t kHill = 64;
    static constexpr std::int32_t kRough = 60;
    /// Lower hills everywhere, and a high one here and there.
    static std::int32_t hill(std::uint32_t i, std::uint32_t j) {
        const std::uint32_t bits = mixed_bits(i ^ mixed_bits(j ^ 0x51ed270bu));
        return static_cast<std::int32_t>(bits % (bits % 16 == 0 ? kHighest - 100 : 1500));
    }

    std::uint32_t columns_, rows_;
};

}  // namespace tedavis::test_support
