#include "platform/egl_kms/scanout.hpp"

namespace tedavis::platform {

Scanout::Scanout(DrmPort& drm, BufferQueue& buffers, ScreenReport& report, std::uint32_t refresh_mhz)
    : drm_(drm), buffers_(buffers), report_(report), clock_(refresh_mhz) {
    buffers_.on_end_of_buffer([](void* self, void* token) { static_cast<Scanout*>(self)->forget(token); }, this);
}

bool Scanout::show() {
    const base::Time now = drm_.now();
    if (!has_begun_) confirm(now);
    has_begun_ = true;
    serve_terminal();
    check_screen(now);
    collect({});
    // While all that was queued has come, time goes into drawing: a slow frame is no standstill.
    if (pending_ == nullptr && !has_missed_ && !report_.is_stuck) confirmed_at_ = now;
    judge_standstill(now);
    report_.waited = {};
    report_.shown_at.reset();  // what was collected was the frame before
    ScanoutBuffer front;
    if (!buffers_.lock_front(front)) return false;
    show(front, now);
    report_.paced_by = clock_.paced_by();
    report_.is_atomic = drm_.is_atomic();
    return !is_lost_ && drm_.now() - confirmed_at_ < kGiveUpAfter;
}

void Scanout::confirm(base::Time now) {
    confirmed_at_ = now;
    has_missed_ = false;
    report_.is_stuck = false;
}

/// Once for each standstill the mode is set anew.
void Scanout::judge_standstill(base::Time now) {
    if (report_.is_stuck || now - confirmed_at_ < kStuckAfter) return;
    report_.is_stuck = true;
    needs_mode_ = true;
}

void Scanout::show(const ScanoutBuffer& front, base::Time now) {
    if (!is_visible()) {
        confirm(now);
        buffers_.release(front.token);
        ++report_.hidden_frames;
        return;
    }
    const std::uint32_t framebuffer = framebuffer_of(front);
    if (framebuffer == 0) return miss(front);
    if (needs_mode_) return set_mode(front, framebuffer, now);
    // A driver that lost a flip's event takes the next flip all the same.
    if (pending_ != nullptr && now - queued_at_ < kScreenCheckInterval) return miss(front);
    flip(front, framebuffer, now);
}

void Scanout::serve_terminal() {
    const TerminalRequest request = drm_.take_terminal_request();
    if (request == TerminalRequest::release) {
        drm_.drop_master();
        is_released_ = drm_.answer_terminal(request);
        if (!is_released_ && drm_.become_master()) return;  // the console did not ask
        if (report_.is_master) lose_master();
    } else if (request == TerminalRequest::acquire) {
        (void)drm_.answer_terminal(request);
        is_released_ = false;
        needs_mode_ = true;  // the other program's mode may be left, also where the release before was answered by itself
        report_.is_master = report_.is_master || drm_.become_master();
        has_failed_ = false;
    } else if (request == TerminalRequest::lost) {
        is_lost_ = true;
    }
}

void Scanout::lose_master() {
    report_.is_master = false;
    needs_mode_ = true;
    ++report_.taken_away;
}

void Scanout::check_screen(base::Time now) {
    if (has_checked_ && now - checked_at_ < kScreenCheckInterval) return;
    has_checked_ = true;
    checked_at_ = now;
    if (!report_.is_master && !is_released_) report_.is_master = drm_.become_master();
    check_connector();
}

void Scanout::check_connector() {
    const bool is_connected = drm_.is_connected();
    if (report_.is_plugged && !is_connected) {
        ++report_.unplugged;
        if (report_.is_master) drm_.turn_off();
        needs_mode_ = true;
    }
    if (!report_.is_plugged && is_connected) has_failed_ = false;
    report_.is_plugged = is_connected;
}

/// Takes over the flip that is pending, if it was done within `limit`.
void Scanout::collect(base::Duration limit) {
    FlipEvent event;
    if (pending_ == nullptr || !drm_.wait_flip(limit, event)) return;
    ++report_.flips;
    report_.shown_at = event.time;
    confirm(drm_.now());
    if (clock_.flipped(event)) ++report_.late_flips;
    if (shown_ != nullptr) buffers_.release(shown_);
    shown_ = pending_;
    pending_ = nullptr;
}

void Scanout::set_mode(const ScanoutBuffer& front, std::uint32_t framebuffer, base::Time now) {
    if (has_failed_ && now - failed_at_ < kScreenCheckInterval) return miss(front);
    const DrmStatus status = drm_.set_mode(framebuffer);
    report_.waited = drm_.now() - now;
    has_failed_ = status != DrmStatus::done;
    failed_at_ = now;
    if (status == DrmStatus::not_master) lose_master();
    if (has_failed_) return miss(front);
    if (pending_ != nullptr) buffers_.release(pending_);
    if (shown_ != nullptr) buffers_.release(shown_);
    pending_ = nullptr;
    shown_ = front.token;
    needs_mode_ = false;
    if (!report_.is_stuck) confirm(drm_.now());  // a standstill ends with a flip
    ++report_.flips;
    report_.shown_at = drm_.now();
}

void Scanout::flip(const ScanoutBuffer& front, std::uint32_t framebuffer, base::Time now) {
    const DrmStatus status = drm_.queue_flip(framebuffer);
    if (status == DrmStatus::not_master) lose_master();
    if (status == DrmStatus::failed) needs_mode_ = true;
    if (status != DrmStatus::done) return miss(front);
    if (pending_ != nullptr) {  // its event was lost, but the card took the next one
        confirm(now);
        if (shown_ != nullptr) buffers_.release(shown_);
        shown_ = pending_;
    }
    pending_ = front.token;
    queued_at_ = now;
    const base::Time begun = drm_.now();
    clock_.queued(begun);
    collect(kFlipLimit);
    report_.waited = drm_.now() - begun;
    if (pending_ != nullptr) ++report_.missed_flips;
}

void Scanout::miss(const ScanoutBuffer& front) {
    buffers_.release(front.token);
    has_missed_ = true;
    ++report_.missed_flips;
}

std::uint32_t Scanout::framebuffer_of(const ScanoutBuffer& buffer) {
    for (const Framebuffer& known : framebuffers_)
        if (known.token == buffer.token) return known.id;
    Framebuffer added{buffer.token, 0};
    if (!drm_.add_framebuffer(buffer, added.id)) return 0;
    if (framebuffers_.full())
        for (const Framebuffer& known : framebuffers_)
            if (known.token != shown_ && known.token != pending_) {
                forget(known.token);
                break;
            }
    if (framebuffers_.try_push_back(added)) return added.id;
    drm_.remove_framebuffer(added.id);
    return 0;
}

void Scanout::forget(void* token) {
    for (Framebuffer& known : framebuffers_) {
        if (known.token != token) continue;
        drm_.remove_framebuffer(known.id);
        known = framebuffers_.back();
        framebuffers_.pop_back();
        return;
    }
}

void Scanout::stop() { collect(kFlipLimit); }

void Scanout::let_go() {
    while (!framebuffers_.empty()) forget(framebuffers_.back().token);
    if (pending_ != nullptr) buffers_.release(pending_);
    if (shown_ != nullptr) buffers_.release(shown_);
    pending_ = shown_ = nullptr;
}

}  // namespace tedavis::platform
