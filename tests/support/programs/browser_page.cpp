#include "tests/support/programs/browser_page.hpp"

#include <filesystem>

#include "tests/support/programs/running_program.hpp"

namespace tedavis::test_support {
namespace {

constexpr const char* kBrowser = "/usr/bin/chromium";

}  // namespace

bool has_browser() { return std::filesystem::exists(kBrowser); }

BrowserPage open_in_browser(const TemporaryFolder& place, const std::string& html, int width) {
    const std::string page = place.write("page.html", html);
    const ProgramResult result =
        run_program({kBrowser, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
                     "--disable-extensions", "--disable-background-networking", "--user-data-dir=" + place.file("profile"),
                     "--enable-logging=stderr", "--window-size=" + std::to_string(width) + ",900", "--virtual-time-budget=4000",
                     "--dump-dom", "file://" + page});
    BrowserPage seen;
    if (result.code != 0 || result.out.empty()) {
        seen.failure = "code " + std::to_string(result.code) + ": " + result.err.substr(0, 2000);
        return seen;
    }
    seen.document = result.out;
    std::istringstream lines(result.err);
    for (std::string line; std::getline(lines, line);)
        if (line.find(":CONSOLE:") != std::string::npos) seen.console.push_back(line);
    return seen;
}

}  // namespace tedavis::test_support
