/// Parts of pages of the source tree that are written from the code, each between two marks:
///   <!-- NAME: written from the code -->
///   <!-- end of NAME -->
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tedavis::test_support {

/// "| a | b |" with a line's end.
[[nodiscard]] std::string page_row(const std::vector<std::string_view>& cells);
/// The head of a table with the line below it.
[[nodiscard]] std::string page_head(const std::vector<std::string_view>& cells);

/// What is between the marks; stops the test program where the page does not have them.
[[nodiscard]] std::string page_part(const std::string& page, const std::string& name);

/// Fails where the page's part is not `part`. With TEDAVIS_NEW_PAGES=1 in the environment the part is written instead.
void expect_page_part(const std::string& path_from_root, const std::string& name, const std::string& part);

}  // namespace tedavis::test_support
