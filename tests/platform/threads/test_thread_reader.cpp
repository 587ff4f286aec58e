// What the thread must do as an AsyncReader stands in tests/contracts; here is what only it does.
#include "platform/threads/thread_reader.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <condition_variable>
#include <mutex>

namespace tedavis::platform::test_thread_reader {
namespace {

using base::ReadState;

/// A medium that holds every read until it is let go.
struct Gate final : base::ByteSource {
    std::uint64_t size() const override { return 1000; }
    bool read(std::uint64_t, void*, std::size_t) override {
        std::unique_lock<std::mutex> lock(mutex);
        ++begun;
        changed.notify_all();
        changed.wait(lock, [this] { return open; });
        return true;
    }
    void wait_until_begun(int reads) {
        std::unique_lock<std::mutex> lock(mutex);
        changed.wait(lock, [&] { return begun >= reads; });
    }
    void let_go() {
        const std::lock_guard<std::mutex> lock(mutex);
        open = true;
        changed.notify_all();
    }
    std::mutex mutex;
    std::condition_variable changed;
    int begun = 0;
    bool open = false;
};

TEST(ThreadReader, SubmittingAndPollingDoNotWaitForTheMedium) {
    Gate gate;
    auto reader = make_thread_reader(gate, {8, 4, nullptr});
    ASSERT_TRUE(reader.ok());
    base::AsyncReader& reads = *reader.value();
    char bytes[8];
    ASSERT_TRUE(reads.submit(0, 0, bytes, 1));
    gate.wait_until_begun(1);
    for (std::uint32_t ticket = 1; ticket <= 4; ++ticket) EXPECT_TRUE(reads.submit(ticket, 0, bytes + ticket, 1));
    EXPECT_FALSE(reads.submit(5, 0, bytes + 5, 1)) << "the queue is full";
    EXPECT_FALSE(reads.submit(0, 0, bytes, 1)) << "the ticket is pending";
    EXPECT_EQ(reads.poll(0), ReadState::pending);
    EXPECT_EQ(reads.poll(4), ReadState::pending);
    EXPECT_EQ(reads.poll(5), ReadState::idle) << "what was refused was not asked for";
    gate.let_go();
    for (std::uint32_t ticket = 0; ticket <= 4; ++ticket) EXPECT_EQ(reads.wait(ticket), ReadState::done);
    EXPECT_TRUE(reads.submit(5, 0, bytes + 5, 1));
    EXPECT_EQ(reads.wait(5), ReadState::done);
}

TEST(ThreadReader, DestructionDropsWhatHasNotBegun) {
    Gate gate;
    char bytes[8];
    {
        auto reader = make_thread_reader(gate, {8, 8, nullptr});
        ASSERT_TRUE(reader.ok());
        for (std::uint32_t ticket = 0; ticket < 8; ++ticket) ASSERT_TRUE(reader.value()->submit(ticket, 0, bytes + ticket, 1));
        gate.wait_until_begun(1);
        gate.let_go();
    }
    EXPECT_GE(gate.begun, 1);
}

TEST(ThreadReader, CallsTheHookInItsThread) {
    static std::atomic<int> started{0};
    started = 0;
    Gate gate;
    gate.open = true;
    auto reader = make_thread_reader(gate, {1, 1, [] { ++started; }});
    ASSERT_TRUE(reader.ok());
    char byte;
    ASSERT_TRUE(reader.value()->submit(0, 0, &byte, 1));
    EXPECT_EQ(reader.value()->wait(0), ReadState::done);
    EXPECT_EQ(started, 1);
}

TEST(ThreadReader, RefusesImpossibleNumbers) {
    Gate gate;
    EXPECT_FALSE(make_thread_reader(gate, {0, 0, nullptr}).ok());
    EXPECT_FALSE(make_thread_reader(gate, {4, 5, nullptr}).ok());
    EXPECT_FALSE(make_thread_reader(gate, {4, 0, nullptr}).ok());
    EXPECT_FALSE(make_thread_reader(gate, {base::kMaxReadTickets + 1, 1, nullptr}).ok());
}

}  // namespace
}  // namespace tedavis::platform::test_thread_reader
