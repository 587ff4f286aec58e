#include "host_sim/answer_input.hpp"

#include <poll.h>
#include <unistd.h>

#include "host_sim/interrupt.hpp"

namespace tedavis::host_sim {
namespace {

constexpr int kUntilAskedAgain_ms = 100;  // another thread may have taken the signal, which does not end this one's wait

}  // namespace

AnswerInput::int_type AnswerInput::underflow() {
    const InterruptGuard interrupt;
    pollfd input{file_, POLLIN, 0};
    do {
        if (interrupt.requested()) return traits_type::eof();
    } while (poll(&input, 1, kUntilAskedAgain_ms) <= 0);
    const ssize_t bytes = read(file_, read_.data(), read_.size());
    if (bytes <= 0) return traits_type::eof();
    setg(read_.data(), read_.data(), read_.data() + bytes);
    return traits_type::to_int_type(read_.front());
}

}  // namespace tedavis::host_sim
