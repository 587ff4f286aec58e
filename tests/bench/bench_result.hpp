/// What every benchmark prints: a table, or with `--json` a list of objects. One line a value, with its target.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

namespace tedavis::bench {

struct BenchResult {
    std::string name;  ///< plain text without quotation marks and backslashes
    double value;
    const char* unit;
    double target;
    bool holds;       ///< the value keeps to the target, and what was measured was right
    double baseline;  ///< what the value is to be compared with, measured in the same run where a bench does not say otherwise
};

inline void print_table(const std::vector<BenchResult>& results) {
    std::printf("%-50s %14s %-10s %12s %6s %12s\n", "name", "value", "unit", "target", "holds", "baseline");
    for (const BenchResult& result : results)
        std::printf("%-50s %14.4g %-10s %12.4g %6s %12.4g\n", result.name.c_str(), result.value, result.unit, result.target,
                    result.holds ? "yes" : "no", result.baseline);
}

inline void print_json(const std::vector<BenchResult>& results) {
    const char* before = "[";
    for (const BenchResult& result : results) {
        std::printf("%s\n  {\"name\": \"%s\", \"value\": %.9g, \"unit\": \"%s\", \"target\": %.9g, \"holds\": %s, ", before,
                    result.name.c_str(), result.value, result.unit, result.target, result.holds ? "true" : "false");
        std::printf("\"baseline\": %.9g}", result.baseline);
        before = ",";
    }
    std::printf("\n]\n");
}

/// The exit code of a benchmark: 0 when every target holds, 1 when one does not.
inline int report(const std::vector<BenchResult>& results, bool json) {
    json ? print_json(results) : print_table(results);
    return std::all_of(results.begin(), results.end(), [](const BenchResult& result) { return result.holds; }) ? 0 : 1;
}

}  // namespace tedavis::bench
