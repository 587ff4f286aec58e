#include "host_sim/reports/run_findings.hpp"

#include "host_sim/reports/line_chart.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

void append(Findings& findings, const Findings& more) { findings.insert(findings.end(), more.begin(), more.end()); }

nlohmann::ordered_json findings_json(const Findings& findings) {
    auto json = nlohmann::ordered_json::array();
    for (const Finding& finding : findings)
        json.push_back({{"name", finding.name}, {"text", finding.text}, {"count", finding.count}});
    return json;
}

void print_warnings(const Findings& findings, Console& console) {
    for (const Finding& finding : findings) console.note("warning: " + finding.text);
}

int exit_code_of(const Findings& findings, bool is_strict) { return is_strict && !findings.empty() ? kCheckFailedExitCode : 0; }

std::string counted(std::uint64_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string part_of(std::uint64_t count, std::uint64_t all) {
    return (count == all ? "all " : std::to_string(count) + " of ") + std::to_string(all);
}

std::string age_words(double seconds) {
    constexpr double kMinute_s = 60, kHour_s = 3600, kDay_s = 86400;
    if (seconds < 2 * kHour_s) return decimal(seconds / kMinute_s, 0) + " min";
    return seconds < 2 * kDay_s ? decimal(seconds / kHour_s, 1) + " h" : decimal(seconds / kDay_s, 0) + " d";
}

}  // namespace tedavis::host_sim
