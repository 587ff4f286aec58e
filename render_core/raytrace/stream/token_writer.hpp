/// Receives the output of a batch function: literals and further calls, in order, and done() after each call.
///
/// Consecutive calls of one task that result from one token are written as one token. Output beyond the task's most_outputs is
/// a fault of the task: it is dropped, and the rewriting ends with one sentence.
#pragma once

#include "render_core/base/span.hpp"
#include "render_core/raytrace/stream/task_network.hpp"

namespace tedavis::raytrace {

/// The output of one token: words [first, first + words), with the positions of the calls among them.
struct WrittenRun {
    std::uint32_t first_word = 0, words = 0;
    std::uint32_t first_call = 0, calls = 0;
};

enum class WriterFault : std::uint8_t { none, too_much, unknown_task, nobody };

class TokenWriter {
public:
    /// `call_places` has the size of `words`, at most 65536.
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
    /// Writes a call; its arguments are literals written before, or words before this call in the stream.
    void call(TaskId task);
    /// Writes `count` calls for the current call; their arguments are consecutive records of 32-bit words.
    void calls(TaskId task, const void* records, std::uint32_t count);
    /// The same for records that the caller then writes in place, completely, before any other output; `count` is at most
    /// most_count(). Returns null, and records a fault, where there is no room.
    template <class Record>
    [[nodiscard]] Record* calls_in_place(TaskId task, std::uint32_t count) {
        static_assert(std::is_trivially_copyable_v<Record> && alignof(Record) == alignof(std::uint32_t));
        return reinterpret_cast<Record*>(place_calls(task, count, sizeof(Record)));
    }
    /// Writes one call for each of the next `count` calls, beginning with the current one, which are then done.
    void each_calls(TaskId task, const void* records, std::uint32_t count);
    /// Ends the output of the current call.
    void done() {
        if (++done_ == border_) close_run();
    }
    /// Number of calls, from the current one on, of the same token of the stream. Where their order does not matter, their
    /// output may be sorted by task, which gives fewer and longer tokens; then call done(count) with at most this number.
    [[nodiscard]] std::uint32_t together() const { return border_ - done_; }
    void done(std::uint32_t count) {
        if (count > together()) return note(WriterFault::nobody);
        if ((done_ += count) == border_) close_run();
    }

    // For the rewriting.

    /// Begins a batch. `borders` are the cumulative numbers of calls of its tokens, `runs` receives their outputs, and
    /// `most_outputs` is the limit per call.
    void begin(base::Span<const std::uint32_t> borders, WrittenRun* runs, std::uint32_t most_outputs);
    /// Ends a batch. Calls without done() have no output.
    void finish();
    /// Clears the output, but not faults.
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
    /// The last call is written when the number of following equal calls is known; literals behind it are then moved by one.
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
