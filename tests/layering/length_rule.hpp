// How long sources and functions of the product may be: short enough to be read at once.
#pragma once

#include <string>
#include <vector>

#include "tests/layering/source_file.hpp"

namespace tedavis::tests::layering {

inline constexpr int kMaxFileLines = 400, kMaxFunctionLines = 60;

/// Findings of one source or shader: more lines than kMaxFileLines, and functions (and other blocks behind parentheses) of more
/// lines than kMaxFunctionLines, head and closing brace included. Tables, types and namespaces may be longer. The layout of
/// clang-format is presupposed: a block ends with the first line that begins with a brace in the column of its head.
std::vector<std::string> length_findings(const SourceFile& file);

}  // namespace tedavis::tests::layering
