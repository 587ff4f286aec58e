#include "tests/support/programs/virtual_screen.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace tedavis::test_support {
namespace {

/// Xvfb writes the number of the display that it took and a line feed once it serves.
std::string read_line(int descriptor) {
    std::string line;
    char c = '\0';
    while (read(descriptor, &c, 1) == 1 && c != '\n') line += c;
    return line;
}

}  // namespace

VirtualScreen::VirtualScreen() {
    int pipe_ends[2] = {-1, -1};
    if (pipe(pipe_ends) != 0) std::abort();
    server_ = fork();
    if (server_ == 0) {
        dup2(pipe_ends[1], 3);
        const int nothing = open("/dev/null", O_WRONLY);
        dup2(nothing, 2);
        execlp("Xvfb", "Xvfb", "-displayfd", "3", "-screen", "0", "1280x1024x24", "-nolisten", "tcp", nullptr);
        _exit(127);
    }
    close(pipe_ends[1]);
    const std::string number = read_line(pipe_ends[0]);
    close(pipe_ends[0]);
    if (number.empty()) {
        std::fprintf(stderr, "Xvfb does not start; install the package xvfb\n");
        std::abort();
    }
    setenv("DISPLAY", (":" + number).c_str(), 1);
    setenv("SDL_VIDEODRIVER", "x11", 1);
}

VirtualScreen::~VirtualScreen() {
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
    unsetenv("DISPLAY");
    unsetenv("SDL_VIDEODRIVER");
}

}  // namespace tedavis::test_support
