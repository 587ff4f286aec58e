#include "platform/threads/thread_workers.hpp"

#include <pthread.h>
#include <sched.h>

#include <atomic>
#include <new>

#include "render_core/base/float_environment.hpp"

namespace tedavis::platform {
namespace {

/// pthread rather than std::thread: its failures are codes, not exceptions.
class ThreadWorkers final : public base::Workers {
public:
    explicit ThreadWorkers(void (*on_thread_start)()) : on_thread_start_(on_thread_start) {}
    ~ThreadWorkers() override { stop(); }
    ThreadWorkers(const ThreadWorkers&) = delete;
    ThreadWorkers& operator=(const ThreadWorkers&) = delete;

    [[nodiscard]] bool start(std::uint32_t concurrency) {
        for (; thread_count_ + 1 < concurrency; ++thread_count_)
            if (pthread_create(&threads_[thread_count_], nullptr, &ThreadWorkers::thread_main, this) != 0) return false;
        return true;
    }

    std::uint32_t concurrency() const override { return thread_count_ + 1; }

    void parallel_for(std::uint32_t count, Task task, void* context) override {
        if (thread_count_ == 0 || count < 2) {
            for (std::uint32_t i = 0; i < count; ++i) task(context, i);
            return;
        }
        pthread_mutex_lock(&mutex_);
        task_ = task;
        context_ = context;
        count_ = count;
        next_.store(0, std::memory_order_relaxed);
        busy_ = thread_count_;
        ++round_;
        pthread_cond_broadcast(&work_);
        pthread_mutex_unlock(&mutex_);
        take_tasks();
        pthread_mutex_lock(&mutex_);
        while (busy_ > 0) pthread_cond_wait(&done_, &mutex_);
        pthread_mutex_unlock(&mutex_);
    }

private:
    static void* thread_main(void* self) {
        static_cast<ThreadWorkers*>(self)->serve();
        return nullptr;
    }

    void serve() {
        base::set_float_environment();
        if (on_thread_start_ != nullptr) on_thread_start_();
        std::uint64_t served = 0;
        pthread_mutex_lock(&mutex_);
        while (true) {
            while (!stopping_ && round_ == served) pthread_cond_wait(&work_, &mutex_);
            if (stopping_) break;
            served = round_;
            pthread_mutex_unlock(&mutex_);
            take_tasks();
            pthread_mutex_lock(&mutex_);
            if (--busy_ == 0) pthread_cond_signal(&done_);
        }
        pthread_mutex_unlock(&mutex_);
    }

    void take_tasks() {
        for (std::uint32_t i = next_.fetch_add(1); i < count_; i = next_.fetch_add(1)) task_(context_, i);
    }

    void stop() {
        pthread_mutex_lock(&mutex_);
        stopping_ = true;
        pthread_cond_broadcast(&work_);
        pthread_mutex_unlock(&mutex_);
        for (std::uint32_t i = 0; i < thread_count_; ++i) pthread_join(threads_[i], nullptr);
    }

    pthread_mutex_t mutex_ = PTHREAD_MUTEX_INITIALIZER;
    pthread_cond_t work_ = PTHREAD_COND_INITIALIZER;
    pthread_cond_t done_ = PTHREAD_COND_INITIALIZER;
    pthread_t threads_[kMaxWorkers] = {};
    std::uint32_t thread_count_ = 0;
    std::uint32_t busy_ = 0;
    std::uint64_t round_ = 0;
    bool stopping_ = false;
    Task task_ = nullptr;
    void* context_ = nullptr;
    std::uint32_t count_ = 0;
    std::atomic<std::uint32_t> next_{0};
    void (*on_thread_start_)();
};

}  // namespace

std::uint32_t usable_processors() noexcept {
    cpu_set_t set;
    CPU_ZERO(&set);
    if (sched_getaffinity(0, sizeof set, &set) != 0) return 1;
    const int count = CPU_COUNT(&set);
    if (count < 1) return 1;
    return static_cast<std::uint32_t>(count) < kMaxWorkers ? static_cast<std::uint32_t>(count) : kMaxWorkers;
}

base::Result<std::unique_ptr<base::Workers>, base::Error> make_thread_workers(const ThreadWorkersSettings& settings) {
    if (settings.concurrency < 1 || settings.concurrency > kMaxWorkers)
        return base::fail(base::make_error("the number of workers must be 1 to 64; give such a number"));
    std::unique_ptr<ThreadWorkers> workers(new (std::nothrow) ThreadWorkers(settings.on_thread_start));
    if (workers == nullptr || !workers->start(settings.concurrency))
        return base::fail(base::make_error("the machine gives no more threads; ask for fewer workers"));
    return std::unique_ptr<base::Workers>(std::move(workers));
}

}  // namespace tedavis::platform
