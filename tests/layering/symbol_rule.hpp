// What the compiled core asks of others: proof that flight code reaches no heap, no exception, no clock and no GL entry point
// except through its ports, whatever its sources look like.
#pragma once

#include <string>
#include <vector>

namespace tedavis::tests::layering {

/// One line of `nm -A -u`: archive:member: U symbol.
struct UndefinedSymbol {
    std::string member;  ///< object file in the archive
    std::string name;    ///< mangled
};

std::vector<UndefinedSymbol> parse_nm(const std::string& output);

/// Findings: "member asks for symbol: why it may not".
std::vector<std::string> symbol_findings(const std::vector<UndefinedSymbol>& symbols);

}  // namespace tedavis::tests::layering
