/// Calls of a group that are executed together: calls of one task are gathered into one batch, so that SIMD kernels stay full;
/// a token that stands for enough calls to fill the kernel alone is executed in place.
///
/// The output of a call is rewritten again at once, while it is in the cache, a few times at most ("can be optionally repeated
/// several times", thesis 6.2.2.1), if it consists only of few complete calls that do not lengthen the stream. This depends
/// only on the call's output, so rounds are the same for all block sizes.
///
/// Memory  from an arena, at start; one segment per worker.
#pragma once

#include "render_core/raytrace/stream/block_group.hpp"
#include "render_core/raytrace/stream/block_writer.hpp"

namespace tedavis::raytrace {

class Segment {
public:
    [[nodiscard]] static std::uint64_t bytes_needed();
    [[nodiscard]] bool start(base::Arena& arena);

    /// True where there is room for one more call; always for the first.
    [[nodiscard]] bool fits(const CallShape& shape) const {
        return count_ == 0 || (count_ < kMaxItems && words_ + shape.arguments <= kMaxArguments &&
                               outputs_ + shape.most_outputs + shape.left_words <= kOutputsTogether);
    }
    /// Adds a call whose arguments are at `from`. Before it `kept` words of the group are copied, then `skipped` words belong
    /// to the call.
    void add(std::uint32_t call, const CallShape& shape, std::uint32_t kept, std::uint32_t skipped, BlockCursor from);
    /// Runs the tasks. On a fault it records the task.
    void run(const TaskNetwork& network, BlockGroup& group);
    /// Writes kept words and the calls' output in order and clears the segment. `from` is advanced behind them.
    void write(BlockCursor& from, BlockWriter& to);

private:
    static constexpr std::uint32_t kMaxItems = 512;  ///< items that add() accepts
    static constexpr std::uint32_t kMaxParts = 4;    ///< calls in the output of an item that is rewritten again
    static constexpr std::uint32_t kMaxArguments = 2 * kMaxPatternWords;
    static constexpr std::uint32_t kMaxOutputs = kMaxOutputWords;
    static constexpr std::uint32_t kOutputsTogether =
        8192;  ///< words that items executed together may write, in the stream and elsewhere, so that they stay in the cache
    static constexpr std::uint32_t kMaxSteps = 4;

    struct Item {
        std::uint32_t kept = 0, skipped = 0;
        std::uint32_t call = 0;
        std::uint32_t parts = 0;  ///< calls that it may still lead to; 0: finished
        const std::uint32_t* arguments = nullptr;
        WrittenRun given;
    };
    using Order = base::Span<const std::uint16_t>;

    void run_open_items(const TaskNetwork& network, TokenWriter& out, BlockGroup& group);
    void sort_by_task(std::uint32_t tasks, std::uint32_t* ends);
    void run_task(const TaskNetwork& network, Order of_task, TokenWriter& out, RewriteCounts& counts);
    void run_gathered(const Task& task, TaskId id, Order gathered, TokenWriter& out, RewriteCounts& counts);
    [[nodiscard]] bool go_on(const TaskNetwork& network);
    [[nodiscard]] bool goes_on(const TaskNetwork& network, const Item& item) const;

    base::Span<Item> items_, next_items_;
    base::Span<std::uint16_t> order_;
    base::Span<std::uint16_t> gathered_;
    base::Span<std::uint32_t> borders_;
    base::Span<WrittenRun> runs_;
    base::Span<std::uint32_t> copies_;   ///< arguments that span several blocks
    base::Span<std::uint32_t> records_;  ///< arguments of a batch
    base::Span<std::uint32_t> output_;
    base::Span<std::uint16_t> call_places_;
    std::uint32_t count_ = 0, words_ = 0, outputs_ = 0, copied_ = 0;
};

}  // namespace tedavis::raytrace
