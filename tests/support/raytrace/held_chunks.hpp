/// Chunks cut out of a grid in memory, for tests of the paged tracer; and its pictures.
#pragma once

#include <algorithm>
#include <atomic>
#include <vector>

#include "render_core/raytrace/paged/paged_tracer.hpp"
#include "tests/support/raytrace/traced_view.hpp"

namespace tedavis::test_support {

template <class Height>
class HeldChunks final : public raytrace::ChunkHeights<Height> {
public:
    using Grid = raytrace::HeightGrid<Height>;
    using raytrace::ChunkHeights<Height>::kCells;
    using raytrace::ChunkHeights<Height>::kPosts;

    explicit HeldChunks(const Grid& grid) : grid_(grid) {}
    [[nodiscard]] std::uint32_t columns() const override { return grid_.columns; }
    [[nodiscard]] std::uint32_t rows() const override { return grid_.rows; }
    [[nodiscard]] bool read_bounds(base::Span<Height> lowest, base::Span<Height> highest) override {
        std::vector<Height> posts(kPosts * kPosts);
        for (std::uint32_t n = 0; n < lowest.size(); ++n) {
            cut(n % this->chunk_columns(), n / this->chunk_columns(), posts);
            lowest[n] = std::numeric_limits<Height>::max();
            highest[n] = std::numeric_limits<Height>::lowest();
            for (const Height post : posts) {
                if (post == Grid::kVoid) continue;
                lowest[n] = std::min(lowest[n], post);
                highest[n] = std::max(highest[n], post);
            }
            if (lowest[n] > highest[n]) continue;
            lowest[n] = static_cast<Height>(lowest[n] - slack);
            highest[n] = static_cast<Height>(highest[n] + slack);
        }
        return !is_unreadable;
    }
    [[nodiscard]] bool load(std::uint32_t column, std::uint32_t row, std::uint32_t, base::Span<Height> posts) override {
        ++loads;
        cut(column, row, posts);
        return row * this->chunk_columns() + column != damaged;
    }

    Height slack = 0;  ///< bounds are wider than heights by it
    std::uint32_t damaged = 0xFFFFFFFFu;
    bool is_unreadable = false;
    std::atomic<std::uint32_t> loads{0};

private:
    void cut(std::uint32_t column, std::uint32_t row, base::Span<Height> posts) const {
        for (std::uint32_t y = 0; y < kPosts; ++y)
            for (std::uint32_t x = 0; x < kPosts; ++x) {
                const std::uint32_t i = column * kCells + x, j = row * kCells + y;
                posts[y * kPosts + x] = i < grid_.columns && j < grid_.rows ? grid_.at(i, j) : Grid::kVoid;
            }
    }

    Grid grid_;
};

/// A paged tracer with its memory.
template <class Height>
struct StartedPages {
    StartedPages(raytrace::ChunkHeights<Height>& heights, const raytrace::PagedSettings& settings)
        : memory(raytrace::PagedTracer<Height>::bytes_needed(heights.columns(), heights.rows(), settings) / 8 + 1) {
        base::Arena arena(memory.data(), memory.size() * 8);
        started = tracer.start(heights, settings, arena);
    }
    StartedPages(const StartedPages&) = delete;
    StartedPages& operator=(const StartedPages&) = delete;

    TracedPicture trace(const raytrace::GridCamera& camera, std::uint32_t width, std::uint32_t height, std::uint32_t cells,
                        raytrace::CellSurface surface, const raytrace::PacketKernel<Height>& kernel, base::Workers& workers,
                        bool from_below = true) {
        std::vector<raytrace::Hit> hits(std::size_t{width} * height);
        work = tracer.trace(raytrace::PagedRays::of(camera, width, height), surface, from_below, kernel, workers, hits);
        TracedPicture all(width, height);
        for (std::size_t n = 0; n < hits.size(); ++n) {
            all.t[n] = hits[n].t;
            all.side[n] = hits[n].side;
            all.cell[n] =
                hits[n].side == raytrace::HitSide::none ? -1 : static_cast<std::int32_t>(hits[n].row * cells + hits[n].column);
        }
        return all;
    }

    std::vector<std::uint64_t> memory;
    raytrace::PagedTracer<Height> tracer;
    typename raytrace::PagedTracer<Height>::Started started;
    raytrace::PagedWork work;
};

}  // namespace tedavis::test_support
