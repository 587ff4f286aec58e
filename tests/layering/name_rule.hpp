// Names and phrases for which the field or plain English has another word: the tree uses only that one.
#pragma once

#include <string>
#include <vector>

#include "tests/layering/source_file.hpp"

namespace tedavis::tests::layering {

/// Findings of one file: identifiers of the table, as whole names, constants that begin with kMost or kLeast, and identifiers
/// that contain "colour" in place of "color". Comments, strings and words of plain English are not read.
std::vector<std::string> name_findings(const SourceFile& file);

/// Findings of one file: phrases that only this project knows, in the comments of a source and anywhere in a page (*.md). Strings
/// are not read: texts of the program are held by tests.
std::vector<std::string> phrase_findings(const SourceFile& file);

}  // namespace tedavis::tests::layering
