/// What the core needs to read a database without waiting: reads that are asked for now and fetched later. Implemented in
/// platform/threads; SynchronousReader below reads at once.
///
/// Tickets  0..capacity()-1, chosen by the caller (its slot numbers). A ticket carries one read at a time; its answer stays until
///          the ticket is used again.
/// Memory   none after construction. Thread  one caller. The destination belongs to the reader while the read is pending.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render_core/base/ports/byte_source.hpp"

namespace tedavis::base {

/// idle: the ticket was never used.
enum class ReadState : std::uint8_t { idle, pending, done, failed };

/// More tickets than this are never asked for.
inline constexpr std::uint32_t kMaxReadTickets = 16384;

class AsyncReader {
public:
    virtual ~AsyncReader() = default;
    [[nodiscard]] virtual std::uint32_t capacity() const = 0;
    /// Asks for exactly `count` bytes at `offset`. False, and nothing is asked for, when the queue is full, the ticket is pending
    /// or its number too high. Never waits for the medium.
    [[nodiscard]] virtual bool submit(std::uint32_t ticket, std::uint64_t offset, void* destination, std::size_t count) = 0;
    /// Never waits. `done`: the destination holds the bytes; `failed`: its content is unspecified.
    [[nodiscard]] virtual ReadState poll(std::uint32_t ticket) = 0;
    /// Returns when the ticket is no longer pending.
    [[nodiscard]] virtual ReadState wait(std::uint32_t ticket) = 0;
};

/// Reads on the caller, at submit(). For replay on one thread, for tools and tests.
class SynchronousReader final : public AsyncReader {
public:
    /// The source must outlive the reader. At most kMaxReadTickets.
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
