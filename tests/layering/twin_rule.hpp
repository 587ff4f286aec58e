// Every source has a test of its own name.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace tedavis::tests::layering {

/// Findings over all paths of the tree: sources X/name.cpp without tests/X/test_name.cpp. Roots named main.cpp are
/// proven by the commands that they run; twin_rule.cpp names other exemptions with their reasons.
std::vector<std::string> twin_findings(const std::set<std::string>& paths);

/// The test that belongs to a source.
std::string twin_of(const std::string& source_path);

}  // namespace tedavis::tests::layering
