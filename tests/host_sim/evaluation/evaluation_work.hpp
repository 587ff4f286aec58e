/// What an evaluation works with, in a test: a number of threads, and when it is stopped.
#pragma once

#include <atomic>
#include <limits>
#include <sstream>

#include "host_sim/evaluation/evaluation_work.hpp"
#include "platform/threads/thread_workers.hpp"

namespace tedavis::test_support {

class TestWork {
public:
    /// Stopped once it was asked more than `most_questions` times, one a picture.
    explicit TestWork(std::uint32_t threads = 1, int most_questions = std::numeric_limits<int>::max())
        : workers_(std::move(platform::make_thread_workers({threads, nullptr}).value())), left_(most_questions) {}

    [[nodiscard]] host_sim::EvaluationWork work() {
        return {*workers_, console_, [this] { return --left_ < 0; }, {}};
    }

private:
    std::unique_ptr<base::Workers> workers_;
    std::ostringstream results_, notes_;
    host_sim::Console console_{results_, notes_, false, false};
    std::atomic<int> left_;
};

}  // namespace tedavis::test_support
