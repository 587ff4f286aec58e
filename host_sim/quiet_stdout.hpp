/// Keeps a library's output out of the command's result: while an object exists, standard output is discarded. For one thread
/// that prints nothing itself meanwhile, since standard output belongs to the whole process.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

namespace tedavis::host_sim {

class QuietStdout {
public:
    QuietStdout() {
        std::fflush(stdout);
        const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (nowhere < 0) return;
        kept_ = dup(STDOUT_FILENO);
        if (kept_ >= 0) (void)dup2(nowhere, STDOUT_FILENO);
        (void)close(nowhere);
    }
    ~QuietStdout() {
        if (kept_ < 0) return;
        std::fflush(stdout);
        (void)dup2(kept_, STDOUT_FILENO);
        (void)close(kept_);
    }
    QuietStdout(const QuietStdout&) = delete;
    QuietStdout& operator=(const QuietStdout&) = delete;

private:
    int kept_ = -1;
};

}  // namespace tedavis::host_sim
