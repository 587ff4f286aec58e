/// Reads the user's answer at a terminal to a question that Ctrl-C and SIGTERM end.
///
/// std::cin is not suitable: its reads are restarted after a signal, so that an interrupted question would wait for a line.
#pragma once

#include <array>
#include <streambuf>

namespace tedavis::host_sim {

/// The buffer of a stream. Where an InterruptGuard is requested, before or while it waits, the input ends as at the end of a
/// file.
class AnswerInput : public std::streambuf {
public:
    /// `file` is a descriptor that must be open for reading while this object exists; it is not closed.
    explicit AnswerInput(int file) : file_(file) {}

protected:
    int_type underflow() override;

private:
    int file_;
    std::array<char, 256> read_{};
};

}  // namespace tedavis::host_sim
