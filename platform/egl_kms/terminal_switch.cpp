#include "platform/egl_kms/terminal_switch.hpp"

#include <fcntl.h>
#include <linux/vt.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace tedavis::platform {
namespace {

volatile sig_atomic_t newest_request = 0;

void on_release(int) { newest_request = static_cast<int>(TerminalRequest::release); }
void on_acquire(int) { newest_request = static_cast<int>(TerminalRequest::acquire); }

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
    newest_request = 0;
    handle_signal(SIGUSR1, &on_release, previous_release_);
    handle_signal(SIGUSR2, &on_acquire, previous_acquire_);
    terminal_ = terminal;
    mode.mode = VT_PROCESS;
    mode.relsig = SIGUSR1;
    mode.acqsig = SIGUSR2;
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
    sigaction(SIGUSR1, &previous_release_, nullptr);
    sigaction(SIGUSR2, &previous_acquire_, nullptr);
}

TerminalRequest TerminalSwitch::take_request() {
    const auto request = static_cast<TerminalRequest>(newest_request);
    newest_request = 0;
    return request;
}

void TerminalSwitch::answer(TerminalRequest request) {
    if (terminal_ >= 0) ::ioctl(terminal_, VT_RELDISP, request == TerminalRequest::acquire ? VT_ACKACQ : 1);
}

}  // namespace tedavis::platform
