/// Where a batch function puts what its calls give: literals and further calls, in order, and after each call done().
///
/// Calls of one task that one token of the stream gave, one behind the other, are written as one token for all of them. What does
/// not fit the task's most_outputs is a fault of the task: it is left out, and the rewriting ends with a sentence.
#pragma once

#include "render_core/base/span.hpp"
#include "render_core/raytrace/stream/task_network.hpp"

namespace tedavis::raytrace {

/// What the calls of one token gave: words [first, first + words) of the output, among them those calls whose places are listed.
struct WrittenRun {
    std::uint32_t first_word = 0, words = 0;
    std::uint32_t first_call = 0, calls = 0;
};

enum class WriterFault : std::uint8_t { none, too_much, unknown_task, nobody };

class TokenWriter {
public:
    /// As many `call_places` as `words`, at most 65536.
    TokenWriter(const TaskNetwork& network, base::Span<std::uint32_t> words, base::Span<std::uint16_t> call_places)
        : network_(network),
          words_(words.data()),
          call_places_(call_places.data()),
          limit_(static_cast<std::uint32_t>(words.size())),
          stop_(limit_) {}

    // For batch functions.

    void literal(std::uint32_t word) {
        if (end_ >= stop_) return note(WriterFault::too_much);
        words_[end_++] = word;
    }
    void literals(const std::uint32_t* words, std::uint32_t count);
    /// Of literals written before, or of what lies before this call in the stream.
    void call(TaskId task);
    /// The present call gives so many calls, whose arguments are records of 32-bit words, one behind the other.
    void calls(TaskId task, const void* records, std::uint32_t count);
    /// The same for records that the caller writes there, all of them, before it writes anything else; `count` to most_count().
    /// Null, and a fault, where there is no room.
    template <class Record>
    [[nodiscard]] Record* calls_in_place(TaskId task, std::uint32_t count) {
        static_assert(std::is_trivially_copyable_v<Record> && alignof(Record) == alignof(std::uint32_t));
        return reinterpret_cast<Record*>(place_calls(task, count, sizeof(Record)));
    }
    /// Each of the next `count` calls, the present one first, gives one call, and is done.
    void each_calls(TaskId task, const void* records, std::uint32_t count);
    /// All that the present call gives has been written.
    void done() {
        if (++done_ == border_) close_run();
    }
    /// Calls from the present one on that one token of the stream stands for. Where it does not matter in which order they are
    /// answered, what they give may be sorted by task, which makes fewer and longer tokens; then done(count), of no more than
    /// these.
    [[nodiscard]] std::uint32_t together() const { return border_ - done_; }
    void done(std::uint32_t count) {
        if (count > together()) return note(WriterFault::nobody);
        if ((done_ += count) == border_) close_run();
    }

    // For the rewriting.

    /// Before a batch: how many calls each of its tokens stands for, added up, where to note what they gave, and how much each
    /// call may.
    void begin(base::Span<const std::uint32_t> borders, WrittenRun* runs, std::uint32_t most_outputs);
    /// After it. Calls that were not said to be done gave nothing.
    void finish();
    /// Forgets what was written, but no fault.
    void clear();
    [[nodiscard]] WriterFault fault() const { return fault_; }
    [[nodiscard]] const std::uint32_t* words() const { return words_; }
    [[nodiscard]] const std::uint16_t* call_places() const { return call_places_; }

private:
    void note(WriterFault fault) {
        if (fault_ == WriterFault::none) fault_ = fault;
    }
    [[nodiscard]] std::uint32_t* place_calls(TaskId task, std::uint32_t count, std::size_t bytes);
    [[nodiscard]] bool make_pending(TaskId task);
    void write_pending();
    void close_run();

    const TaskNetwork& network_;
    std::uint32_t* words_;
    std::uint16_t* call_places_;
    std::uint32_t limit_;
    std::uint32_t stop_;  ///< for literals: one before the limit while a call is pending
    std::uint32_t end_ = 0, calls_ = 0;
    /// The last call is written when it is known how many follow; literals behind its place move on by one then.
    TaskId pending_task_ = kNoTask;
    std::uint32_t pending_count_ = 0, pending_place_ = 0;
    base::Span<const std::uint32_t> borders_;
    WrittenRun* runs_ = nullptr;
    std::uint32_t most_outputs_ = 0;
    std::uint32_t run_ = 0, done_ = 0, border_ = 0;
    std::uint32_t run_word_ = 0, run_call_ = 0;
    WriterFault fault_ = WriterFault::none;
};

}  // namespace tedavis::raytrace
