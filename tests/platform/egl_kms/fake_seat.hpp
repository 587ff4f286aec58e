// A seat manager, as tests play it: what it says comes with the next dispatch(), as libseat hands it on.
#pragma once

#include <fcntl.h>
#include <poll.h>
#include <semaphore.h>

#include <cerrno>
#include <deque>
#include <memory>
#include <string>

#include "platform/egl_kms/seat_port.hpp"

namespace tedavis::platform {

struct FakeManager {
    FakeManager() {
        sem_init(&may_answer, 0, 0);
        sem_init(&has_closed, 0, 0);
    }
    [[nodiscard]] std::unique_ptr<SeatPort> port();

    enum class Says { enable, disable };
    std::deque<Says> says = {Says::enable};
    std::string calls;  ///< in their order, separated by spaces
    const char* device = "/dev/null";
    int device_fault = 0;  ///< errno; 0: it opens the device
    const char* name = "seatd";
    bool gives_seat = true, is_gone = false, disables_while_it_opens = false;
    bool stands_still = false, stands_still_at_close = false;  ///< until `may_answer`
    int longest_wait_ms = 0, descriptor = -1;
    SeatListener* listener = nullptr;
    sem_t may_answer{}, has_closed{};  ///< of a manager that stands still
};

class FakeSeat final : public SeatPort {
public:
    explicit FakeSeat(FakeManager& manager) : manager_(manager) {}
    [[nodiscard]] bool open(SeatListener& listener) override {
        manager_.calls += "open ";
        manager_.listener = &listener;
        if (manager_.stands_still) sem_wait(&manager_.may_answer);
        return manager_.gives_seat;
    }
    [[nodiscard]] int open_device(const char* path, int& descriptor) override {
        manager_.calls += std::string("device:") + path + " ";
        errno = manager_.device_fault;
        if (manager_.device_fault != 0) return -1;
        manager_.descriptor = descriptor = ::open(manager_.device, O_RDWR | O_CLOEXEC);
        if (manager_.disables_while_it_opens) manager_.listener->on_disable();
        return 7;
    }
    void close_device(int device) override { manager_.calls += "close:" + std::to_string(device) + " "; }
    [[nodiscard]] bool disable() override {
        manager_.calls += "disable ";
        return !manager_.is_gone;
    }
    [[nodiscard]] bool dispatch(int wait_ms) override {
        manager_.longest_wait_ms = wait_ms > manager_.longest_wait_ms ? wait_ms : manager_.longest_wait_ms;
        if (manager_.is_gone) return false;
        if (manager_.says.empty()) ::poll(nullptr, 0, wait_ms < 5 ? wait_ms : 5);
        while (!manager_.says.empty()) {
            const bool enables = manager_.says.front() == FakeManager::Says::enable;
            manager_.says.pop_front();
            enables ? manager_.listener->on_enable() : manager_.listener->on_disable();
        }
        return true;
    }
    void close() override {
        manager_.calls += "close ";
        if (manager_.stands_still_at_close) sem_wait(&manager_.may_answer);
        sem_post(&manager_.has_closed);
    }
    [[nodiscard]] base::FixedString<31> manager() const override { return manager_.name; }

private:
    FakeManager& manager_;
};

inline std::unique_ptr<SeatPort> FakeManager::port() { return std::make_unique<FakeSeat>(*this); }

}  // namespace tedavis::platform
