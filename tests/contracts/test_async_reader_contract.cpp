// What every AsyncReader must do, read at once and by a thread, from sound, slow and failing media.
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "platform/threads/thread_reader.hpp"

namespace tedavis::platform::test_async_reader_contract {
namespace {

using base::ReadState;

constexpr std::size_t kSize = 40'000;
constexpr std::uint32_t kTickets = 50;

std::uint8_t byte_at(std::uint64_t offset) { return static_cast<std::uint8_t>(offset * offset >> 5); }

/// Fails where it is told to; takes its time where it is told to.
struct Medium final : base::ByteSource {
    std::uint64_t size() const override { return kSize; }
    bool read(std::uint64_t offset, void* destination, std::size_t count) override {
        ++reads;
        if (is_slow) std::this_thread::sleep_for(std::chrono::microseconds(300));
        if (count > kSize || offset > kSize - count || offset >= fails_from) return false;
        for (std::size_t n = 0; n < count; ++n) static_cast<std::uint8_t*>(destination)[n] = byte_at(offset + n);
        return true;
    }
    std::uint64_t fails_from = kSize;
    bool is_slow = false;
    std::atomic<int> reads{0};
};

class AsyncReaderContract : public testing::TestWithParam<bool> {
protected:
    AsyncReaderContract() {
        if (!GetParam()) {
            reader_ = std::make_unique<base::SynchronousReader>(medium_, kTickets);
            return;
        }
        auto made = make_thread_reader(medium_, {kTickets, kTickets, nullptr});
        EXPECT_TRUE(made.ok());
        reader_ = std::move(made.value());
    }
    bool ask(std::uint32_t ticket, std::uint64_t offset, std::size_t count) {
        parts_[ticket].assign(count, 0);
        return reader_->submit(ticket, offset, parts_[ticket].data(), count);
    }
    bool is_right(std::uint32_t ticket, std::uint64_t offset) const {
        for (std::size_t n = 0; n < parts_[ticket].size(); ++n)
            if (parts_[ticket][n] != byte_at(offset + n)) return false;
        return true;
    }
    Medium medium_;
    std::vector<std::uint8_t> parts_[kTickets];
    std::unique_ptr<base::AsyncReader> reader_;
};

TEST_P(AsyncReaderContract, SaysHowManyTicketsItHas) {
    EXPECT_EQ(reader_->capacity(), kTickets);
    EXPECT_EQ(reader_->poll(3), ReadState::idle);
    EXPECT_EQ(reader_->wait(3), ReadState::idle) << "nothing to wait for";
    EXPECT_FALSE(ask(0, 0, 1) && reader_->submit(kTickets, 0, parts_[0].data(), 1)) << "no such ticket";
    EXPECT_EQ(reader_->poll(kTickets), ReadState::idle);
    EXPECT_EQ(reader_->wait(0), ReadState::done);
}

TEST_P(AsyncReaderContract, EveryTicketBringsItsOwnBytes) {
    for (const bool is_slow : {false, true}) {
        medium_.is_slow = is_slow;
        for (std::uint32_t ticket = 0; ticket < kTickets; ++ticket) ASSERT_TRUE(ask(ticket, ticket * 700u, 137 + ticket));
        for (std::uint32_t n = 0; n < kTickets; ++n) {
            const std::uint32_t ticket = (n * 31) % kTickets;
            ASSERT_EQ(reader_->wait(ticket), ReadState::done);
            EXPECT_TRUE(is_right(ticket, ticket * 700u)) << ticket;
            EXPECT_EQ(reader_->poll(ticket), ReadState::done) << "the answer stays";
        }
    }
}

TEST_P(AsyncReaderContract, TicketsServeAgainAndAgain) {
    for (std::uint32_t round = 0; round < 400; ++round) {
        const std::uint32_t ticket = round % 3;
        ASSERT_NE(reader_->wait(ticket), ReadState::failed);
        ASSERT_TRUE(ask(ticket, round, 64));
        if (round % 5 == 0) {
            EXPECT_EQ(reader_->wait(ticket), ReadState::done);
            EXPECT_TRUE(is_right(ticket, round));
        }
    }
    for (std::uint32_t ticket = 0; ticket < 3; ++ticket) EXPECT_EQ(reader_->wait(ticket), ReadState::done);
    EXPECT_EQ(medium_.reads, 400);
}

TEST_P(AsyncReaderContract, FailuresAreSaidTicketByTicketAndPass) {
    medium_.fails_from = 10'000;
    ASSERT_TRUE(ask(0, 100, 50) && ask(1, 12'000, 50) && ask(2, kSize - 1, 2) && ask(3, 200, 50));
    EXPECT_EQ(reader_->wait(0), ReadState::done);
    EXPECT_EQ(reader_->wait(1), ReadState::failed);
    EXPECT_EQ(reader_->wait(2), ReadState::failed);
    EXPECT_EQ(reader_->wait(3), ReadState::done);
    EXPECT_TRUE(is_right(3, 200));
    medium_.fails_from = kSize;
    ASSERT_TRUE(ask(1, 12'000, 50));
    EXPECT_EQ(reader_->wait(1), ReadState::done);
    EXPECT_TRUE(is_right(1, 12'000));
}

TEST_P(AsyncReaderContract, PollingAloneComesToAnEnd) {
    medium_.is_slow = true;
    for (std::uint32_t ticket = 0; ticket < 10; ++ticket) ASSERT_TRUE(ask(ticket, ticket, 10));
    for (std::uint32_t ticket = 0; ticket < 10; ++ticket) {
        while (reader_->poll(ticket) == ReadState::pending) std::this_thread::yield();
        EXPECT_EQ(reader_->poll(ticket), ReadState::done);
        EXPECT_TRUE(is_right(ticket, ticket));
    }
}

INSTANTIATE_TEST_SUITE_P(Readers, AsyncReaderContract, testing::Bool(),
                         [](const auto& reader) { return std::string(reader.param ? "thread" : "synchronous"); });

}  // namespace
}  // namespace tedavis::platform::test_async_reader_contract
