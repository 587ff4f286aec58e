/// Runs tasks in parallel and processes their results one after the other, in the order of the tasks, so that the outcome does
/// not depend on the number of threads.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <map>
#include <mutex>
#include <utility>

#include "render_core/base/ports/workers.hpp"

namespace tedavis::host_sim {

/// `work(index)` runs on any thread and returns a Result; `commit(index, Result&&)` is called for one index at a time, ascending.
/// The exception of the lowest index that fails is thrown again after every running task has ended.
template <class Work, class Commit>
class OrderedTasks {
public:
    using Result = std::invoke_result_t<Work&, std::uint32_t>;

    OrderedTasks(Work& work, Commit& commit, std::uint32_t first, std::uint32_t concurrency)
        : work_(work), commit_(commit), first_(first), next_(first), most_waiting_(concurrency) {}

    static void run_one(void* context, std::uint32_t n) { static_cast<OrderedTasks*>(context)->run(n); }
    void finish() {
        if (error_) std::rethrow_exception(error_);
    }

private:
    void run(std::uint32_t n) {
        const std::uint32_t index = first_ + n;
        try {
            {
                std::unique_lock lock(mutex_);
                room_.wait(lock, [&] { return failed_ || index <= next_ + most_waiting_; });
                if (failed_) return;
            }
            Result result = work_(index);
            take(index, std::move(result));
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!failed_ || index < failed_index_) {
                error_ = std::current_exception();
                failed_index_ = index;
            }
            failed_ = true;
            room_.notify_all();
        }
    }

    void take(std::uint32_t index, Result&& result) {
        const std::lock_guard lock(mutex_);
        waiting_.emplace(index, std::move(result));
        while (!failed_ && !waiting_.empty() && waiting_.begin()->first == next_) {
            Result first = std::move(waiting_.begin()->second);
            waiting_.erase(waiting_.begin());
            commit_(next_, std::move(first));
            ++next_;
        }
        room_.notify_all();
    }

    Work& work_;
    Commit& commit_;
    const std::uint32_t first_;
    std::uint32_t next_;
    const std::uint32_t most_waiting_;
    std::mutex mutex_;
    std::condition_variable room_;
    std::map<std::uint32_t, Result> waiting_;
    bool failed_ = false;
    std::uint32_t failed_index_ = 0;
    std::exception_ptr error_;
};

/// Runs the tasks first..end-1. At most as many results wait for their turn as there are workers.
template <class Work, class Commit>
void run_in_order(base::Workers& workers, std::uint32_t first, std::uint32_t end, Work work, Commit commit) {
    OrderedTasks<Work, Commit> tasks(work, commit, first, workers.concurrency());
    if (first < end) workers.parallel_for(end - first, &OrderedTasks<Work, Commit>::run_one, &tasks);
    tasks.finish();
}

}  // namespace tedavis::host_sim
