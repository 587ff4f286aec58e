#include "platform/egl_kms/drm_card.hpp"

#if defined(TEDAVIS_HAVE_KMS)

#include <drm_fourcc.h>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>
#include <xf86drm.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "platform/clock/monotonic_clock.hpp"
#include "platform/egl_kms/card_holder.hpp"
#include "render_core/base/driver_scope.hpp"

namespace tedavis::platform {
namespace {

DrmStatus status_by_errno(int reason) {
    if (reason == EBUSY) return DrmStatus::busy;
    return reason == EACCES || reason == EPERM ? DrmStatus::not_master : DrmStatus::failed;
}

bool has_capability(int card, std::uint64_t capability) {
    std::uint64_t value = 0;
    return drmGetCap(card, capability, &value) == 0 && value != 0;
}

base::Error seat_error(std::string_view card, SeatAccess access, std::string_view manager) {
    if (access == SeatAccess::no_answer)
        return base::make_error(card, ": the seat manager does not answer; start it again (`systemctl restart seatd`)");
    return base::make_error(card, ": ", manager, " does not give this program the screen: another terminal or program has it; ",
                            "switch to the terminal that was shown when the display started, or end the other program");
}

constexpr std::int64_t kNanosecondsPerMillisecond = 1'000'000;

}  // namespace

DrmCard::~DrmCard() {
    const base::DriverScope driver;
    if (black_ != 0) drmModeRmFB(card_, black_);
    if (black_handle_ != 0) drmModeDestroyDumbBuffer(card_, black_handle_);
    if (before_ != nullptr) drmModeFreeCrtc(before_);
    terminal_.stop();
    atomic_.close();
    if (card_ >= 0 && !seat_.is_open()) ::close(card_);
    seat_.close();
}

base::Error DrmCard::open(const ScreenCard& card, const ScreenChoice& choice, std::unique_ptr<SeatPort> seat,
                          const SeatLimits& limits) {
    const base::DriverScope driver;
    name_ = card_text(card);
    path_ = card.path;
    if (base::Error error = open_file(card.path.c_str(), std::move(seat), limits)) return error;
    connector_ = card.connectors[choice.connector].id;
    crtc_ = choice.crtc_id;
    is_held_ = !become_master();
    if (is_held_) return held_error();
    if (!find_mode(choice)) return base::make_error(name_.view(), ": the screen has changed during the start; start again");
    before_ = drmModeGetCrtc(card_, crtc_);
    is_atomic_ = atomic_.open(card_, connector_, crtc_, choice.crtc_index, mode_);
    if (is_atomic_ && has_capability(card_, DRM_CAP_ADDFB2_MODIFIERS)) modifiers_ = atomic_.modifiers();
    if (!seat_.is_open()) terminal_.start();
    return {};
}

/// A manager that gives no seat, or not this file, is none.
base::Error DrmCard::open_file(const char* path, std::unique_ptr<SeatPort> seat, const SeatLimits& limits) {
    const SeatAccess access = seat_.open(std::move(seat), path, limits);
    is_held_ = access == SeatAccess::not_enabled || access == SeatAccess::no_answer;
    if (is_held_) return seat_error(name_.view(), access, seat_.manager());
    card_ = access == SeatAccess::open ? seat_.descriptor() : ::open(path, O_RDWR | O_CLOEXEC | O_NONBLOCK);
    if (card_ >= 0) return {};
    return base::make_error(name_.view(), ": cannot be opened any more (", std::strerror(errno), "); start again");
}

base::Error DrmCard::held_error() const {
    if (seat_.is_open() && !seat_.is_enabled()) return seat_error(name_.view(), SeatAccess::not_enabled, seat_.manager());
    return held_card_error(name_.view(), find_card_holders(path_.c_str()).view());
}

bool DrmCard::find_mode(const ScreenChoice& choice) {
    drmModeConnector* const connector = drmModeGetConnectorCurrent(card_, connector_);
    if (connector == nullptr) return false;
    const bool found = choice.mode.index < connector->count_modes &&
                       connector->modes[choice.mode.index].hdisplay == choice.mode.width_px &&
                       connector->modes[choice.mode.index].vdisplay == choice.mode.height_px;
    if (found) mode_ = connector->modes[choice.mode.index];
    drmModeFreeConnector(connector);
    return found;
}

base::Error DrmCard::show_black() {
    const base::DriverScope driver;
    if (!make_black())
        return base::make_error(name_.view(), ": gives no buffer for the screen (", std::strerror(errno),
                                "); free the card's memory or use a smaller mode");
    const DrmStatus status = set_mode(black_);
    return status == DrmStatus::done ? base::Error{} : refused_mode(status);
}

/// The screen may be taken away during the start, which is no wrong setting. What the manager has said of it is read first.
base::Error DrmCard::refused_mode(DrmStatus status) {
    const int reason = errno;
    is_held_ = status == DrmStatus::not_master;
    if (is_held_ && seat_.is_open()) (void)seat_.take_request();
    if (is_held_) return held_error();
    return base::make_error(name_.view(), ": refuses the mode ", mode_.name, " (", std::strerror(reason),
                            "); use another mode of [screen], or a connector that shares no CRTC with another screen");
}

/// The kernel hands out such a buffer zeroed.
bool DrmCard::make_black() {
    std::uint32_t stride = 0;
    std::uint64_t bytes = 0;
    if (drmModeCreateDumbBuffer(card_, mode_.hdisplay, mode_.vdisplay, 32, 0, &black_handle_, &stride, &bytes) != 0) return false;
    const std::uint32_t handles[4] = {black_handle_}, strides[4] = {stride}, offsets[4] = {};
    return drmModeAddFB2(card_, mode_.hdisplay, mode_.vdisplay, DRM_FORMAT_XRGB8888, handles, strides, offsets, &black_, 0) == 0;
}

void DrmCard::restore() {
    const base::DriverScope driver;
    if (before_ == nullptr || drmIsMaster(card_) == 0) return;
    const bool was_on = before_->mode_valid != 0 && before_->buffer_id != 0;
    if (was_on && drmModeSetCrtc(card_, crtc_, before_->buffer_id, before_->x, before_->y, &connector_, 1, &before_->mode) == 0)
        return;
    turn_off();
}

bool DrmCard::become_master() {
    const base::DriverScope driver;
    if (is_managed() && !seat_.is_enabled()) return false;
    is_given_up_ = false;
    if (drmSetMaster(card_) == 0) return true;
    // Who opened the card first is its master; older kernels let only root say so again.
    return errno == EACCES && drmIsMaster(card_) != 0;
}

void DrmCard::drop_master() {
    const base::DriverScope driver;
    // A manager has done so already, unless this program became the master again before it read the request.
    if (!is_managed() || drmIsMaster(card_) != 0) drmDropMaster(card_);
    is_given_up_ = !is_managed();
}

bool DrmCard::add_framebuffer(const ScanoutBuffer& buffer, std::uint32_t& id) {
    const base::DriverScope driver;
    std::uint64_t modifiers[4] = {};
    for (std::uint32_t n = 0; n < buffer.planes && n < 4; ++n) modifiers[n] = buffer.modifier;
    if (buffer.has_modifier &&
        drmModeAddFB2WithModifiers(card_, buffer.width_px, buffer.height_px, buffer.format, buffer.handles, buffer.strides,
                                   buffer.offsets, modifiers, &id, DRM_MODE_FB_MODIFIERS) == 0)
        return true;
    // Without modifiers the kernel takes the buffer for a linear one.
    if (buffer.has_modifier && buffer.modifier != DRM_FORMAT_MOD_LINEAR) return false;
    return drmModeAddFB2(card_, buffer.width_px, buffer.height_px, buffer.format, buffer.handles, buffer.strides, buffer.offsets,
                         &id, 0) == 0;
}

void DrmCard::remove_framebuffer(std::uint32_t id) {
    const base::DriverScope driver;
    drmModeRmFB(card_, id);
}

DrmStatus DrmCard::set_mode(std::uint32_t framebuffer) {
    const base::DriverScope driver;
    if (is_atomic_ && atomic_.set_mode(framebuffer)) return DrmStatus::done;
    if (is_atomic_ && status_by_errno(errno) == DrmStatus::not_master) return DrmStatus::not_master;
    if (!set_mode_without_atomic(framebuffer)) return status_by_errno(errno);
    is_atomic_ = false;
    return DrmStatus::done;
}

bool DrmCard::set_mode_without_atomic(std::uint32_t framebuffer) {
    return drmModeSetCrtc(card_, crtc_, framebuffer, 0, 0, &connector_, 1, &mode_) == 0;
}

/// Some drivers refuse commits of what the older call does.
DrmStatus DrmCard::queue_flip(std::uint32_t framebuffer) {
    const base::DriverScope driver;
    // The event of a flip that is queued already keeps its number where the next one is refused.
    const std::uint32_t next = cookie_ + 1;
    if (is_atomic_ && atomic_.flip(framebuffer, next)) {
        cookie_ = next;
        return DrmStatus::done;
    }
    if (is_atomic_ && status_by_errno(errno) != DrmStatus::failed) return status_by_errno(errno);
    if (!queue_flip_without_atomic(framebuffer, next)) return status_by_errno(errno);
    cookie_ = next;
    is_atomic_ = false;
    return DrmStatus::done;
}

bool DrmCard::queue_flip_without_atomic(std::uint32_t framebuffer, std::uint32_t cookie) {
    return drmModePageFlip(card_, crtc_, framebuffer, DRM_MODE_PAGE_FLIP_EVENT,
                           reinterpret_cast<void*>(std::uintptr_t{cookie})) == 0;
}

bool DrmCard::wait_flip(base::Duration limit, FlipEvent& event) {
    const base::DriverScope driver;
    const base::Time end = now() + limit;
    for (;;) {
        const std::int64_t left_ms = (end - now()).ns / kNanosecondsPerMillisecond;
        pollfd ready{card_, POLLIN, 0};
        const int count = ::poll(&ready, 1, left_ms > 0 ? static_cast<int>(left_ms) : 0);
        if (count > 0 && (ready.revents & POLLIN) != 0 && read_events(event)) return true;
        const bool is_broken = count > 0 && (ready.revents & POLLIN) == 0;
        if (left_ms <= 0 || is_broken) return false;
    }
}

/// True where the flip that was queued last is among them.
bool DrmCard::read_events(FlipEvent& event) {
    alignas(drm_event_vblank) unsigned char bytes[1024];
    const ssize_t size = ::read(card_, bytes, sizeof bytes);
    bool found = false;
    drm_event header{};
    for (ssize_t at = 0; at + static_cast<ssize_t>(sizeof header) <= size; at += static_cast<ssize_t>(header.length)) {
        std::memcpy(&header, bytes + at, sizeof header);
        if (header.length < sizeof header) break;
        drm_event_vblank flip{};
        if (header.type != DRM_EVENT_FLIP_COMPLETE || at + static_cast<ssize_t>(sizeof flip) > size) continue;
        std::memcpy(&flip, bytes + at, sizeof flip);
        if (static_cast<std::uint32_t>(flip.user_data) != cookie_) continue;
        event.sequence = flip.sequence;
        event.time = {std::int64_t{flip.tv_sec} * 1'000'000'000 + std::int64_t{flip.tv_usec} * 1000};
        found = true;
    }
    return found;
}

void DrmCard::turn_off() {
    const base::DriverScope driver;
    if (is_atomic_ && atomic_.turn_off()) return;
    drmModeSetCrtc(card_, crtc_, 0, 0, 0, nullptr, 0, nullptr);
}

bool DrmCard::is_connected() {
    const base::DriverScope driver;
    drmModeConnector* const connector = drmModeGetConnectorCurrent(card_, connector_);
    if (connector == nullptr) return false;
    // A connector whose state is not known may well have a screen.
    const bool connected = connector->connection != DRM_MODE_DISCONNECTED;
    drmModeFreeConnector(connector);
    return connected;
}

TerminalRequest DrmCard::take_terminal_request() {
    if (!seat_.is_open()) return terminal_.take_request();
    const base::DriverScope driver;
    if (manager_end_ != ManagerEnd::none) return take_request_without_manager();
    const TerminalRequest request = seat_.take_request();
    if (request != TerminalRequest::lost) return request;
    manager_end_ = ManagerEnd::left_the_card;
    const TerminalRequest next = take_request_without_manager();
    if (next != TerminalRequest::lost) terminal_.start();
    return next;
}

/// As long as the card is still ours, pictures come without the manager, too. The kernel lets only the process that opened the
/// card, or root, give its screens up, so that a program without that right has to end for another terminal.
TerminalRequest DrmCard::take_request_without_manager() {
    if ((drmIsMaster(card_) != 0) != is_given_up_) return terminal_.take_request();
    manager_end_ = is_given_up_ ? ManagerEnd::kept_the_card : ManagerEnd::took_the_card;
    return TerminalRequest::lost;
}

base::Time DrmCard::now() { return monotonic_now(); }

}  // namespace tedavis::platform

#endif
