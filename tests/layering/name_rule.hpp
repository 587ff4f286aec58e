// Names for which the field has another word or spelling: the tree uses only that one.
#pragma once

#include <string>
#include <vector>

#include "tests/layering/source_file.hpp"

namespace tedavis::tests::layering {

/// Findings of one file: identifiers of the table, as whole names, constants that begin with kMost or kLeast, and identifiers
/// that contain "colour" in place of "color". Comments, strings and words of plain English are not read.
std::vector<std::string> name_findings(const SourceFile& file);

}  // namespace tedavis::tests::layering
