#include "host_sim/interrupt.hpp"

#include <signal.h>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

volatile sig_atomic_t g_requested = 0;
int g_guards = 0;
struct sigaction g_previous_interrupt;
struct sigaction g_previous_terminate;

void on_signal(int) { g_requested = 1; }

}  // namespace

InterruptGuard::InterruptGuard() {
    if (g_guards++ > 0) return;
    g_requested = 0;
    struct sigaction action {};
    action.sa_handler = on_signal;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);  // the next one ends the program
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, &g_previous_interrupt);
    sigaction(SIGTERM, &action, &g_previous_terminate);
}

InterruptGuard::~InterruptGuard() {
    if (--g_guards > 0) return;
    sigaction(SIGINT, &g_previous_interrupt, nullptr);
    sigaction(SIGTERM, &g_previous_terminate, nullptr);
    g_requested = 0;
}

bool InterruptGuard::requested() const { return g_requested != 0; }

void require_uninterrupted(const std::string& output) {
    if (g_requested != 0) throw Interrupted("interrupted; nothing was written to " + output);
}

}  // namespace tedavis::host_sim
