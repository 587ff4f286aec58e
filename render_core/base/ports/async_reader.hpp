/// Port: asynchronous reads of a database, submitted now and fetched later. Implemented in platform/threads; SynchronousReader
/// below reads at once.
///
/// Tickets  0..capacity()-1, chosen by the caller (its slot numbers). A ticket has one read at a time; its result stays until
///          the ticket is used again.
/// Memory   none after construction. Thread  one caller. The reader owns the destination while the read is pending.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render_core/base/ports/byte_source.hpp"

namespace tedavis::base {

/// idle: the ticket was never used.
enum class ReadState : std::uint8_t { idle, pending, done, failed };

/// Upper limit of the number of tickets.
inline constexpr std::uint32_t kMaxReadTickets = 16384;

class AsyncReader {
public:
    virtual ~AsyncReader() = default;
    [[nodiscard]] virtual std::uint32_t capacity() const = 0;
    /// Submits a read of exactly `count` bytes at `offset`. Returns false, and submits nothing, when the queue is full, the
    /// ticket is pending or its number is too high. Never waits for the medium.
    [[nodiscard]] virtual bool submit(std::uint32_t ticket, std::uint64_t offset, void* destination, std::size_t count) = 0;
    /// Returns the state of the ticket without waiting. `done`: the destination holds the bytes; `failed`: its content is
    /// unspecified.
    [[nodiscard]] virtual ReadState poll(std::uint32_t ticket) = 0;
    /// Waits until the ticket is no longer pending.
    [[nodiscard]] virtual ReadState wait(std::uint32_t ticket) = 0;
};

/// Reads on the caller's thread, in submit(). For replays on one thread, tools and tests.
class SynchronousReader final : public AsyncReader {
public:
    /// The source must outlive the reader. `tickets` is at most kMaxReadTickets.
    SynchronousReader(ByteSource& source, std::uint32_t tickets)
        : source_(source), tickets_(tickets < kMaxReadTickets ? tickets : kMaxReadTickets) {}

    [[nodiscard]] std::uint32_t capacity() const override { return tickets_; }
    [[nodiscard]] bool submit(std::uint32_t ticket, std::uint64_t offset, void* destination, std::size_t count) override {
        if (ticket >= tickets_) return false;
        states_[ticket] = source_.read(offset, destination, count) ? ReadState::done : ReadState::failed;
        return true;
    }
    [[nodiscard]] ReadState poll(std::uint32_t ticket) override { return ticket < tickets_ ? states_[ticket] : ReadState::idle; }
    [[nodiscard]] ReadState wait(std::uint32_t ticket) override { return poll(ticket); }

private:
    ByteSource& source_;
    std::uint32_t tickets_;
    ReadState states_[kMaxReadTickets]{};
};

}  // namespace tedavis::base
