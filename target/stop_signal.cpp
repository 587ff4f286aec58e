#include "target/stop_signal.hpp"

namespace tedavis::target {
namespace {

volatile sig_atomic_t requested_flag = 0;

void on_signal(int) { requested_flag = 1; }

}  // namespace

StopSignal::StopSignal() {
    requested_flag = 0;
    struct sigaction action {};
    action.sa_handler = &on_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, &previous_interrupt_);
    sigaction(SIGTERM, &action, &previous_terminate_);
}

StopSignal::~StopSignal() {
    sigaction(SIGINT, &previous_interrupt_, nullptr);
    sigaction(SIGTERM, &previous_terminate_, nullptr);
}

bool StopSignal::requested() const { return requested_flag != 0; }

}  // namespace tedavis::target
