#include "host_sim/replay/picture_writer.hpp"

#include <utility>

namespace tedavis::host_sim {

PictureWriter::~PictureWriter() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ends_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void PictureWriter::add(const std::string& path, const RgbaView& view) {
    Waiting next{path, upright(view)};
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() < kMaxWaiting || failure_ != nullptr; });
    throw_failure();
    waiting_.push_back(std::move(next));
    changed_.notify_all();
}

void PictureWriter::finish() {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.empty(); });
    throw_failure();
}

void PictureWriter::throw_failure() {
    if (failure_ != nullptr) std::rethrow_exception(failure_);
}

void PictureWriter::run() {
    std::unique_lock<std::mutex> lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
        if (waiting_.empty()) return;
        write_first(lock);
    }
}

/// Unlocked while it writes: a deque's first element stays in its place when others are added.
void PictureWriter::write_first(std::unique_lock<std::mutex>& lock) {
    const Waiting& first = waiting_.front();
    const bool is_wanted = failure_ == nullptr;
    lock.unlock();
    std::exception_ptr failure;
    try {
        if (is_wanted) write_png(first.path, view_of(first.picture));
    } catch (...) {
        failure = std::current_exception();
    }
    lock.lock();
    if (failure_ == nullptr) failure_ = failure;
    waiting_.pop_front();
    changed_.notify_all();
}

}  // namespace tedavis::host_sim
