/// A screen in memory (Xvfb) for tests of the window, so that they need no desk.
#pragma once

#include <sys/types.h>

#include <string>

namespace tedavis::test_support {

class VirtualScreen {
public:
    /// Starts Xvfb on a free display and points DISPLAY at it; stops the test program when Xvfb is missing.
    VirtualScreen();
    ~VirtualScreen();
    VirtualScreen(const VirtualScreen&) = delete;
    VirtualScreen& operator=(const VirtualScreen&) = delete;

private:
    pid_t server_ = -1;
};

}  // namespace tedavis::test_support
