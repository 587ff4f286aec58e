/// A pool of expensive objects, such as open files: each is used by one thread at a time and kept for the next one.
///
/// Memory  as many objects as were in use at once. Thread  any. An object that is not given back (its user threw) is lost to the
/// pool.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace tedavis::host_sim {

template <class T>
class IdlePool {
public:
    /// Returns an idle object, else the result of `make()`, a std::unique_ptr<T>. `make` is called outside the lock; its
    /// exceptions are passed on.
    template <class Make>
    [[nodiscard]] std::unique_ptr<T> take(const Make& make) {
        if (std::unique_ptr<T> idle = take_idle()) return idle;
        return make();
    }
    /// `thing` must not be null.
    void give_back(std::unique_ptr<T> thing) {
        const std::lock_guard lock(mutex_);
        idle_.push_back(std::move(thing));
    }

private:
    [[nodiscard]] std::unique_ptr<T> take_idle() {
        const std::lock_guard lock(mutex_);
        if (idle_.empty()) return nullptr;
        std::unique_ptr<T> thing = std::move(idle_.back());
        idle_.pop_back();
        return thing;
    }

    std::mutex mutex_;
    std::vector<std::unique_ptr<T>> idle_;
};

}  // namespace tedavis::host_sim
