#include "target/self_test/self_test_report.hpp"

#include <cinttypes>
#include <cmath>
#include <cstdio>

namespace tedavis::target {

void SelfTestReport::add(std::string_view name, bool holds, std::string_view finding) {
    SelfCheck check;
    check.name.append(name);
    check.holds = holds;
    check.finding.append(finding);
    // A full list has counted the refusal itself, and holds() reads that.
    static_cast<void>(checks_.try_push_back(check));
}

void SelfTestReport::add_number(std::string_view name, double found, double expected, double tolerance, std::string_view unit) {
    const bool holds = std::fabs(found - expected) <= tolerance;
    const int unit_length = static_cast<int>(unit.size());
    char text[200];
    if (holds)
        std::snprintf(text, sizeof text, "%.9g %.*s", found, unit_length, unit.data());
    else
        std::snprintf(text, sizeof text, "%.9g %.*s, expected %.9g +- %.3g", found, unit_length, unit.data(), expected,
                      tolerance);
    add(name, holds, text);
}

void SelfTestReport::add_count(std::string_view name, std::uint64_t found, std::uint64_t low, std::uint64_t high) {
    const bool holds = found >= low && found <= high;
    char text[120];
    if (holds)
        std::snprintf(text, sizeof text, "%" PRIu64, found);
    else
        std::snprintf(text, sizeof text, "%" PRIu64 ", expected %" PRIu64 " to %" PRIu64, found, low, high);
    add(name, holds, text);
}

bool SelfTestReport::holds() const {
    for (const SelfCheck& check : checks_)
        if (!check.holds) return false;
    return !checks_.empty() && checks_.refused() == 0;
}

const SelfCheck* SelfTestReport::find(std::string_view name) const {
    for (const SelfCheck& check : checks_)
        if (check.name.view() == name) return &check;
    return nullptr;
}

}  // namespace tedavis::target
