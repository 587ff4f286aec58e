#include "host_sim/accuracy/accuracy_report.hpp"

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

#include "host_sim/version.hpp"

namespace tedavis::host_sim {
namespace {

std::string processor_name() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.rfind("model name", 0) != 0) continue;
        const std::size_t colon = line.find(": ");
        if (colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown";
}

double load_of_a_minute() {
    double load[1] = {0};
    return getloadavg(load, 1) == 1 ? load[0] : 0;
}

std::string utc_now() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text;
}

}  // namespace

MeasuringConditions conditions_now(const std::string& command, const std::string& terrain, bool is_quick) {
    MeasuringConditions now;
    now.version = version();
    now.compiler = __VERSION__;
    now.command = command;
    now.date = utc_now();
    now.processor = processor_name();
    now.processors = std::thread::hardware_concurrency();
    now.load = load_of_a_minute();
    now.terrain = terrain;
    now.is_quick = is_quick;
    return now;
}

bool are_comparable(const MeasuringConditions& a, const MeasuringConditions& b) {
    return a.version == b.version && a.compiler == b.compiler && a.processor == b.processor && a.processors == b.processors &&
           a.terrain == b.terrain && a.is_quick == b.is_quick;
}

}  // namespace tedavis::host_sim
