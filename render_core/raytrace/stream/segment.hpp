/// Calls of a group whose kernels run together: those of one task are gathered into one batch, so that SIMD kernels stay full; a
/// token that stands for enough calls to fill the kernel by itself is handed on where it lies.
///
/// Memory  an arena's, at start; one for each worker.
#pragma once

#include "render_core/raytrace/stream/block_group.hpp"
#include "render_core/raytrace/stream/block_writer.hpp"

namespace tedavis::raytrace {

class Segment {
public:
    [[nodiscard]] static std::uint64_t bytes_needed();
    [[nodiscard]] bool start(base::Arena& arena);

    /// Whether there is room for one more; there is for the first.
    [[nodiscard]] bool fits(const CallShape& shape) const {
        return count_ == 0 || (count_ < kMostItems && words_ + shape.arguments <= kMostArguments &&
                               outputs_ + shape.most_outputs <= kMostOutputs);
    }
    /// A call whose arguments lie at `from`. Before it `kept` words of the group stay as they are, then `skipped` go with the
    /// call.
    void add(std::uint32_t call, const CallShape& shape, std::uint32_t kept, std::uint32_t skipped, BlockCursor from);
    /// Runs the tasks. On a fault says whose.
    void run(const TaskNetwork& network, BlockGroup& group);
    /// What is kept and what the calls gave, in order; then the segment is empty. `from` goes on behind them.
    void write(BlockCursor& from, BlockWriter& to);

private:
    static constexpr std::uint32_t kMostItems = 512;
    static constexpr std::uint32_t kMostArguments = 2 * kMostPatternWords;
    static constexpr std::uint32_t kMostOutputs = kMostOutputWords;

    struct Item {
        std::uint32_t call = 0, kept = 0, skipped = 0;
        const std::uint32_t* arguments = nullptr;
        WrittenRun given;
    };

    void sort_by_task(std::uint32_t (&ends)[kMostTasks]);
    void run_task(const TaskNetwork& network, base::Span<const std::uint16_t> of_task, TokenWriter& out, RewriteCounts& counts);
    void run_gathered(const Task& task, TaskId id, base::Span<const std::uint16_t> gathered, TokenWriter& out,
                      RewriteCounts& counts);

    base::Span<Item> items_;
    base::Span<std::uint16_t> order_;
    base::Span<std::uint16_t> gathered_;
    base::Span<std::uint32_t> borders_;
    base::Span<WrittenRun> runs_;
    base::Span<std::uint32_t> copies_;   ///< arguments that lie in several blocks
    base::Span<std::uint32_t> records_;  ///< arguments of a batch
    base::Span<std::uint32_t> output_;
    base::Span<std::uint16_t> call_places_;
    std::uint32_t count_ = 0, words_ = 0, outputs_ = 0, copied_ = 0;
};

}  // namespace tedavis::raytrace
