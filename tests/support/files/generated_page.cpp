#include "tests/support/files/generated_page.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "tests/support/files/device_files.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::test_support {
namespace {

struct Extent {
    std::size_t begin, end;
};

Extent extent_of_part(const std::string& page, const std::string& name) {
    const std::string head = "<!-- " + name + ": written from the code -->\n", foot = "<!-- end of " + name + " -->";
    const std::size_t begin = page.find(head), end = page.find(foot);
    if (begin == std::string::npos || end == std::string::npos || end < begin) {
        std::cerr << "the page has no part " << name << '\n';
        std::abort();
    }
    return {begin + head.size(), end};
}

}  // namespace

std::string page_row(const std::vector<std::string_view>& cells) {
    std::string row = "|";
    for (const std::string_view cell : cells) row += (cell.empty() ? " " : " " + std::string(cell) + " ") + "|";
    return row + '\n';
}

std::string page_head(const std::vector<std::string_view>& cells) {
    std::string line = "|";
    for (std::size_t n = 0; n < cells.size(); ++n) line += "---|";
    return page_row(cells) + line + '\n';
}

std::string page_part(const std::string& page, const std::string& name) {
    const Extent part = extent_of_part(page, name);
    return page.substr(part.begin, part.end - part.begin);
}

void expect_page_part(const std::string& path_from_root, const std::string& name, const std::string& part) {
    std::string page = source_file(path_from_root);
    if (std::getenv("TEDAVIS_NEW_PAGES") != nullptr) {
        const Extent old = extent_of_part(page, name);
        page.replace(old.begin, old.end - old.begin, part);
        std::ofstream(source_dir() + "/" + path_from_root) << page;
    }
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    EXPECT_EQ(page_part(page, name), part) << path_from_root << " is not as the code: TEDAVIS_NEW_PAGES=1 build/host/bin/"
                                           << std::filesystem::read_symlink("/proc/self/exe").filename().string()
                                           << " --gtest_filter=" << test.test_suite_name() << '.' << test.name() << " writes it";
}

}  // namespace tedavis::test_support
