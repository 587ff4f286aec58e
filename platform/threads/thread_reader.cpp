#include "platform/threads/thread_reader.hpp"

#include <pthread.h>

#include <new>

namespace tedavis::platform {
namespace {

using base::ReadState;

/// pthread rather than std::thread: its failures are codes, not exceptions.
class ThreadReader final : public base::AsyncReader {
public:
    ThreadReader(base::ByteSource& source, void (*on_thread_start)()) : source_(source), on_thread_start_(on_thread_start) {}
    ~ThreadReader() override { stop(); }
    ThreadReader(const ThreadReader&) = delete;
    ThreadReader& operator=(const ThreadReader&) = delete;

    [[nodiscard]] bool start(std::uint32_t tickets, std::uint32_t queue) {
        states_.reset(new (std::nothrow) ReadState[tickets]());
        ring_.reset(new (std::nothrow) Read[queue]());
        if (states_ == nullptr || ring_ == nullptr) return false;
        tickets_ = tickets;
        queue_ = queue;
        running_ = pthread_create(&thread_, nullptr, &ThreadReader::thread_main, this) == 0;
        return running_;
    }

    std::uint32_t capacity() const override { return tickets_; }

    bool submit(std::uint32_t ticket, std::uint64_t offset, void* destination, std::size_t count) override {
        if (ticket >= tickets_) return false;
        pthread_mutex_lock(&mutex_);
        const bool accepted = waiting_ < queue_ && states_[ticket] != ReadState::pending;
        if (accepted) {
            states_[ticket] = ReadState::pending;
            ring_[(first_ + waiting_) % queue_] = {ticket, offset, destination, count};
            ++waiting_;
            pthread_cond_signal(&work_);
        }
        pthread_mutex_unlock(&mutex_);
        return accepted;
    }

    ReadState poll(std::uint32_t ticket) override {
        if (ticket >= tickets_) return ReadState::idle;
        pthread_mutex_lock(&mutex_);
        const ReadState state = states_[ticket];
        pthread_mutex_unlock(&mutex_);
        return state;
    }

    ReadState wait(std::uint32_t ticket) override {
        if (ticket >= tickets_) return ReadState::idle;
        pthread_mutex_lock(&mutex_);
        while (states_[ticket] == ReadState::pending) pthread_cond_wait(&done_, &mutex_);
        const ReadState state = states_[ticket];
        pthread_mutex_unlock(&mutex_);
        return state;
    }

private:
    struct Read {
        std::uint32_t ticket;
        std::uint64_t offset;
        void* destination;
        std::size_t count;
    };

    static void* thread_main(void* self) {
        static_cast<ThreadReader*>(self)->serve();
        return nullptr;
    }

    void serve() {
        if (on_thread_start_ != nullptr) on_thread_start_();
        pthread_mutex_lock(&mutex_);
        while (true) {
            while (!stopping_ && waiting_ == 0) pthread_cond_wait(&work_, &mutex_);
            if (stopping_) break;
            const Read read = ring_[first_];
            first_ = (first_ + 1) % queue_;
            --waiting_;
            pthread_mutex_unlock(&mutex_);
            const bool good = source_.read(read.offset, read.destination, read.count);
            pthread_mutex_lock(&mutex_);
            states_[read.ticket] = good ? ReadState::done : ReadState::failed;
            pthread_cond_signal(&done_);
        }
        pthread_mutex_unlock(&mutex_);
    }

    void stop() {
        if (!running_) return;
        pthread_mutex_lock(&mutex_);
        stopping_ = true;
        pthread_cond_signal(&work_);
        pthread_mutex_unlock(&mutex_);
        pthread_join(thread_, nullptr);
    }

    base::ByteSource& source_;
    pthread_mutex_t mutex_ = PTHREAD_MUTEX_INITIALIZER;
    pthread_cond_t work_ = PTHREAD_COND_INITIALIZER;
    pthread_cond_t done_ = PTHREAD_COND_INITIALIZER;
    pthread_t thread_{};
    std::unique_ptr<ReadState[]> states_;
    std::unique_ptr<Read[]> ring_;
    std::uint32_t tickets_ = 0, queue_ = 0, first_ = 0, waiting_ = 0;
    bool running_ = false, stopping_ = false;
    void (*on_thread_start_)();
};

}  // namespace

base::Result<std::unique_ptr<base::AsyncReader>, base::Error> make_thread_reader(base::ByteSource& source,
                                                                                 const ThreadReaderSettings& settings) {
    if (settings.tickets < 1 || settings.tickets > base::kMaxReadTickets || settings.queue < 1 ||
        settings.queue > settings.tickets)
        return base::fail(base::make_error("a reader has 1 to 16384 tickets and a queue of 1 to as many; give such numbers"));
    std::unique_ptr<ThreadReader> reader(new (std::nothrow) ThreadReader(source, settings.on_thread_start));
    if (reader == nullptr || !reader->start(settings.tickets, settings.queue))
        return base::fail(base::make_error("the machine gives no thread or memory for reading terrain; end other programs"));
    return std::unique_ptr<base::AsyncReader>(std::move(reader));
}

}  // namespace tedavis::platform
