// Words that flight code does without: the compiler refuses some only when they are reached, so the sources are read.
#pragma once

#include <string>
#include <vector>

#include "tests/layering/source_file.hpp"

namespace tedavis::tests::layering {

/// Findings of one file: exceptions and run-time types, heap, clocks and files where its folder does without them, marks
/// of unfinished work anywhere, a header without `#pragma once`.
std::vector<std::string> word_findings(const SourceFile& file);

}  // namespace tedavis::tests::layering
