// Names that the field has another word for: the tree says the field's word, and only that.
#pragma once

#include <string>
#include <vector>

#include "tests/layering/source_file.hpp"

namespace tedavis::tests::layering {

/// Findings of one file: identifiers of the table, as whole names, and constants that begin with kMost or kLeast. Comments and
/// strings are not read, nor are words of plain English.
std::vector<std::string> name_findings(const SourceFile& file);

}  // namespace tedavis::tests::layering
