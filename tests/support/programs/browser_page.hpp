/// Opens a page in headless Chromium: what its document is after its scripts ran, and what the console said.
///
/// Needs no network, no display and no user's profile; runs as root. Time is virtual: nothing depends on how fast the machine is.
#pragma once

#include <string>
#include <vector>

#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::test_support {

struct BrowserPage {
    std::string document;              ///< as HTML; empty where the browser failed
    std::vector<std::string> console;  ///< messages of the page, faults of its scripts among them
    std::string failure;               ///< what the browser said where it failed
};

[[nodiscard]] bool has_browser();
/// Writes the page into the folder first. `width`: of the window, in pixels.
[[nodiscard]] BrowserPage open_in_browser(const TemporaryFolder& place, const std::string& html, int width);

}  // namespace tedavis::test_support
