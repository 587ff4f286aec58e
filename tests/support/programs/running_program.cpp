#include "tests/support/programs/running_program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>

namespace tedavis::test_support {
namespace {

/// The reading end of what a program writes; the writing end is given to it.
struct Channel {
    int reader = -1, writer = -1;

    explicit Channel(bool terminal) {
        int ends[2] = {-1, -1};
        const bool open = terminal ? openpty(&ends[0], &ends[1], nullptr, nullptr, nullptr) == 0 : pipe(ends) == 0;
        if (!open) throw std::runtime_error("no pipe or terminal to be had");
        reader = ends[0];
        writer = ends[1];
    }
    ~Channel() {
        close_end(reader);
        close_end(writer);
    }
    Channel(const Channel&) = delete;
    Channel& operator=(const Channel&) = delete;

    static void close_end(int& end) {
        if (end >= 0) close(end);
        end = -1;
    }
    /// False at the end. A terminal whose other side is gone answers with an error.
    bool read_some(std::string& text) {
        char piece[4096];
        const ssize_t count = read(reader, piece, sizeof piece);
        if (count <= 0) {
            close_end(reader);
            return false;
        }
        text.append(piece, static_cast<std::size_t>(count));
        return true;
    }
};

[[noreturn]] void become(const std::vector<std::string>& words, const ProgramSetting& setting, const Channel& out,
                         const Channel& err) {
    dup2(out.writer, STDOUT_FILENO);
    dup2(err.writer, STDERR_FILENO);
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    signal(SIGINT, SIG_DFL);
    if (setting.largest_file > 0) {
        signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{setting.largest_file, setting.largest_file};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    execv(arguments[0], arguments.data());
    _exit(127);
}

/// Both streams until both end, with the signal and the time limit on the way.
void follow(pid_t child, Channel& out, Channel& err, const ProgramSetting& setting, ProgramResult& result) {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(setting.limit_s));
    bool sent = !setting.signal_when;
    while (out.reader >= 0 || err.reader >= 0) {
        pollfd waits[2] = {{out.reader, POLLIN, 0}, {err.reader, POLLIN, 0}};
        poll(waits, 2, 10);
        if (waits[0].revents != 0) out.read_some(result.out);
        if (waits[1].revents != 0) err.read_some(result.err);
        if (!sent && setting.signal_when()) {
            kill(child, setting.signal);
            sent = true;
        }
        if (!result.hung && Clock::now() > end) {
            result.hung = true;
            kill(child, SIGKILL);
        }
    }
}

}  // namespace

ProgramResult run_program(const std::vector<std::string>& words, const ProgramSetting& setting) {
    Channel out(false), err(setting.terminal);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process to be had");
    if (child == 0) become(words, setting, out, err);
    Channel::close_end(out.writer);
    Channel::close_end(err.writer);
    ProgramResult result;
    follow(child, out, err, setting, result);
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFEXITED(status)) result.code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
    return result;
}

}  // namespace tedavis::test_support
