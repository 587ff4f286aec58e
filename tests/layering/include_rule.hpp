// Who may include whom, as CONTRIBUTING.md describes it: for own headers the table of dependencies that CMake writes, for system
// headers the table in include_rule.cpp.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "tests/layering/source_file.hpp"

namespace tedavis::tests::layering {

/// Returns the findings of one file: includes of a folder that its own does not depend on, of a folder that no CMakeLists.txt
/// declares, of a system header that its folder may not include, of a header that no table has, and includes whose path does not
/// start at the root. `known_paths` are all files of the tree; includes of generated files are judged by their folder alone.
std::vector<std::string> include_findings(const SourceFile& file, const std::set<std::string>& known_paths);

/// Returns the folders below `root` in the order of the table; their paths are relative to `root`.
std::vector<std::string> folders_below(const std::string& root);

/// Findings of what makes a header stand alone: a source whose header includes another one before it, so that the compiler
/// does not see the header by itself, and a header that may be read twice. Headers without a source of their name are
/// compiled alone by the build.
std::vector<std::string> own_header_findings(const SourceFile& file, const std::set<std::string>& known_paths);

}  // namespace tedavis::tests::layering
