/// What somebody types at a terminal, for a question that Ctrl-C and SIGTERM end.
///
/// std::cin does not do: its reads begin anew after a signal, so that an interrupted question would wait for a line.
#pragma once

#include <array>
#include <streambuf>

namespace tedavis::host_sim {

/// The buffer of a stream. Where an InterruptGuard is requested, before or while it waits, the input ends as at the end of a
/// file.
class AnswerInput : public std::streambuf {
public:
    /// `file`: a descriptor that is open for reading and stays so; it is not closed.
    explicit AnswerInput(int file) : file_(file) {}

protected:
    int_type underflow() override;

private:
    int file_;
    std::array<char, 256> read_{};
};

}  // namespace tedavis::host_sim
