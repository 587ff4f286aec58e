#include "platform/egl_kms/terminal_switch.hpp"

#include <fcntl.h>
#include <linux/vt.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <atomic>

namespace tedavis::platform {
namespace {

std::atomic<TerminalRequest> newest_request = TerminalRequest::none;
static_assert(std::atomic<TerminalRequest>::is_always_lock_free, "signal handlers write it");

void on_release(int) { newest_request = TerminalRequest::release; }
void on_acquire(int) { newest_request = TerminalRequest::acquire; }

void handle_signal(int signal, void (*handler)(int), struct sigaction& previous) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, &previous);
}

}  // namespace

bool TerminalSwitch::start(const char* path) {
    const int terminal = ::open(path, O_RDWR | O_CLOEXEC | O_NOCTTY);
    if (terminal < 0) return false;
    vt_mode mode{};
    if (::ioctl(terminal, VT_GETMODE, &mode) != 0) {
        ::close(terminal);
        return false;
    }
    newest_request = TerminalRequest::none;
    handle_signal(release_signal(), &on_release, previous_release_);
    handle_signal(acquire_signal(), &on_acquire, previous_acquire_);
    terminal_ = terminal;
    mode.mode = VT_PROCESS;
    mode.relsig = static_cast<short>(release_signal());
    mode.acqsig = static_cast<short>(acquire_signal());
    if (::ioctl(terminal, VT_SETMODE, &mode) == 0) return true;
    stop();
    return false;
}

void TerminalSwitch::stop() {
    if (terminal_ < 0) return;
    vt_mode mode{};
    mode.mode = VT_AUTO;
    ::ioctl(terminal_, VT_SETMODE, &mode);
    ::close(terminal_);
    terminal_ = -1;
    sigaction(release_signal(), &previous_release_, nullptr);
    sigaction(acquire_signal(), &previous_acquire_, nullptr);
}

TerminalRequest TerminalSwitch::take_request() { return newest_request.exchange(TerminalRequest::none); }

bool TerminalSwitch::answer(TerminalRequest request) {
    return terminal_ >= 0 && ::ioctl(terminal_, VT_RELDISP, request == TerminalRequest::acquire ? VT_ACKACQ : 1) == 0;
}

}  // namespace tedavis::platform
