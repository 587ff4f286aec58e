/// A file in memory that fails when told to, and a reader over it whose answers come when told to.
#pragma once

#include <cstring>
#include <deque>
#include <vector>

#include "render_core/base/ports/async_reader.hpp"

namespace tedavis::test_support {

class FlakyBytes;

class HandReader final : public base::AsyncReader {
public:
    explicit HandReader(base::ByteSource& source) : source_(source), states_(base::kMaxReadTickets, base::ReadState::idle) {}
    [[nodiscard]] std::uint32_t capacity() const override { return base::kMaxReadTickets; }
    [[nodiscard]] bool submit(std::uint32_t ticket, std::uint64_t offset, void* destination, std::size_t count) override {
        if (is_full || states_[ticket] == base::ReadState::pending) return false;
        states_[ticket] = base::ReadState::pending;
        queue_.push_back({ticket, offset, destination, count});
        if (at_once) arrive(1);
        return true;
    }
    [[nodiscard]] base::ReadState poll(std::uint32_t ticket) override { return states_[ticket]; }
    [[nodiscard]] base::ReadState wait(std::uint32_t ticket) override {
        while (states_[ticket] == base::ReadState::pending) arrive(1);
        return states_[ticket];
    }
    /// Lets the oldest reads happen.
    void arrive(std::size_t count) {
        for (; count > 0 && !queue_.empty(); --count) {
            const Read read = queue_.front();
            queue_.pop_front();
            const bool good = source_.read(read.offset, read.destination, read.count);
            states_[read.ticket] = good ? base::ReadState::done : base::ReadState::failed;
        }
    }
    [[nodiscard]] std::size_t waiting() const { return queue_.size(); }
    bool at_once = false, is_full = false;

private:
    struct Read {
        std::uint32_t ticket;
        std::uint64_t offset;
        void* destination;
        std::size_t count;
    };
    base::ByteSource& source_;
    std::vector<base::ReadState> states_;
    std::deque<Read> queue_;
};

class FlakyBytes final : public base::ByteSource {
public:
    explicit FlakyBytes(std::vector<std::uint8_t> bytes) : content(std::move(bytes)) {}
    [[nodiscard]] std::uint64_t size() const override { return content.size(); }
    [[nodiscard]] bool read(std::uint64_t offset, void* destination, std::size_t count) override {
        ++reads;
        if (fails || offset > content.size() || count > content.size() - offset) return false;
        std::memcpy(destination, content.data() + offset, count);
        return true;
    }
    std::vector<std::uint8_t> content;
    bool fails = false;
    int reads = 0;
    HandReader reader{*this};
};

}  // namespace tedavis::test_support
