// A card and the buffers of a driver, as tests play them: time stands still unless the card is waited for.
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "platform/egl_kms/drm_port.hpp"

namespace tedavis::platform {

/// Four buffers, as a driver has them; GL cannot draw into one that the screen holds.
class FakeBuffers final : public BufferQueue {
public:
    /// Stands for GL's swap; false where no buffer is free.
    [[nodiscard]] bool swap() {
        for (std::size_t n = 0; n < buffers.size(); ++n) {
            int* const next = &buffers[++last_ % buffers.size()];
            if (held.count(next) != 0) continue;
            front_ = next;
            return true;
        }
        return false;
    }
    [[nodiscard]] bool lock_front(ScanoutBuffer& buffer) override {
        if (front_ == nullptr || is_broken) return false;
        buffer.token = front_;
        buffer.handles[0] = static_cast<std::uint32_t>(front_ - buffers.data()) + 1;
        held.insert(front_);
        front_ = nullptr;
        return true;
    }
    void release(void* token) override { released_what_was_not_held += held.erase(static_cast<int*>(token)) == 0 ? 1 : 0; }
    void on_end_of_buffer(void (*forget)(void*, void*), void* self) override {
        forget_ = forget;
        self_ = self;
    }
    void end_buffer(std::size_t n) { forget_(self_, &buffers[n]); }

    std::vector<int> buffers = std::vector<int>(4);
    std::set<int*> held;
    int released_what_was_not_held = 0;
    bool is_broken = false;

private:
    int* front_ = nullptr;
    std::size_t last_ = 0;
    void (*forget_)(void*, void*) = nullptr;
    void* self_ = nullptr;
};

/// A screen of 60 Hz. Keeps the rules of the kernel: one flip at a time, only its master may do anything, a framebuffer must be
/// known.
class FakeDrm final : public DrmPort {
public:
    static constexpr std::int64_t kPeriod_ns = 16'666'667;

    [[nodiscard]] bool become_master() override {
        ++tries_to_become_master;
        is_master = !others_have_it;
        return is_master;
    }
    void drop_master() override { is_master = false; }
    [[nodiscard]] bool add_framebuffer(const ScanoutBuffer& buffer, std::uint32_t& id) override {
        if (refuses_framebuffers) return false;
        id = 100 + static_cast<std::uint32_t>(++added);
        known[id] = buffer.handles[0];
        return true;
    }
    void remove_framebuffer(std::uint32_t id) override { broken_rules += known.erase(id) == 0 ? 1 : 0; }
    [[nodiscard]] DrmStatus set_mode(std::uint32_t framebuffer) override {
        ++mode_sets;
        if (!is_master) return DrmStatus::not_master;
        if (refuses_modes) return DrmStatus::failed;
        broken_rules += known.count(framebuffer) == 0 ? 1 : 0;
        on_screen = framebuffer;
        is_lit = true;
        queued = 0;
        return DrmStatus::done;
    }
    [[nodiscard]] DrmStatus queue_flip(std::uint32_t framebuffer) override {
        if (!is_master) return DrmStatus::not_master;
        if (queued != 0 && !loses_events) return DrmStatus::busy;
        if (refuses_flips || !is_lit) return DrmStatus::failed;
        broken_rules += known.count(framebuffer) == 0 ? 1 : 0;
        queued = framebuffer;
        return DrmStatus::done;
    }
    [[nodiscard]] bool wait_flip(base::Duration limit, FlipEvent& event) override {
        longest_wait = std::max(longest_wait, limit);
        if (queued == 0 || flips_hang || loses_events) {
            clock.ns += limit.ns;
            return false;
        }
        if (has_vblank) {
            const std::int64_t next = (clock.ns / kPeriod_ns + 1) * kPeriod_ns;
            if (limit.ns > 0) clock.ns = next;
            event.sequence = static_cast<std::uint32_t>(next / kPeriod_ns);
        }
        event.time = clock;
        on_screen = queued;
        queued = 0;
        return true;
    }
    void turn_off() override { is_lit = false; }
    [[nodiscard]] bool is_connected() override {
        ++looks_at_connector;
        return is_plugged;
    }
    [[nodiscard]] bool is_atomic() const override { return true; }
    [[nodiscard]] TerminalRequest take_terminal_request() override {
        const TerminalRequest request = asked;
        asked = TerminalRequest::none;
        return request;
    }
    bool answer_terminal(TerminalRequest request) override {
        answers += request == TerminalRequest::release ? (is_master ? "!" : "r") : "a";
        return !refuses_answers;
    }
    [[nodiscard]] base::Time now() override { return clock; }

    base::Time clock{1'000'000'000'000};
    std::map<std::uint32_t, std::uint32_t> known;  ///< framebuffer → handle
    std::uint32_t on_screen = 0, queued = 0;
    base::Duration longest_wait;
    TerminalRequest asked = TerminalRequest::none;
    std::string answers;  ///< "!": the terminal was given up before the master was
    int broken_rules = 0, added = 0, mode_sets = 0, looks_at_connector = 0, tries_to_become_master = 0;
    bool is_master = true, others_have_it = false, is_plugged = true, is_lit = false, has_vblank = true;
    bool refuses_framebuffers = false, refuses_modes = false, refuses_flips = false, flips_hang = false, loses_events = false;
    bool refuses_answers = false;  ///< the console had not asked
};

}  // namespace tedavis::platform
