#include "host_sim/accuracy/accuracy_report.hpp"

#include <cstdlib>
#include <fstream>
#include <thread>

#include "host_sim/calendar_time.hpp"
#include "host_sim/replay/index_key.hpp"
#include "host_sim/version.hpp"

namespace tedavis::host_sim {
namespace {

constexpr const char* kCompilerName =
#if defined(__clang__)
    "";  // its version says it
#else
    "GCC ";
#endif

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

}  // namespace

MeasuringConditions conditions_now(const std::string& command, const std::string& renderer, const MeasuredInputs& inputs) {
    MeasuringConditions now;
    static_cast<MeasuredInputs&>(now) = inputs;
    now.version = version();
    now.commit = commit();
    now.renderer = renderer;
    now.program = program_identity();
    now.compiler = std::string(kCompilerName) + __VERSION__;
    now.command = command;
    now.date = utc_now();
    now.processor = processor_name();
    now.processors = std::thread::hardware_concurrency();
    now.load = load_of_a_minute();
    return now;
}

bool have_same_inputs(const MeasuredInputs& a, const MeasuredInputs& b) {
    return a.terrain_identity == b.terrain_identity && a.flight_identity == b.flight_identity && a.size == b.size &&
           a.device == b.device && a.design == b.design && a.is_quick == b.is_quick;
}

bool are_of_one_kind(const MeasuringConditions& a, const MeasuringConditions& b) {
    return a.program == b.program && a.processor == b.processor && a.processors == b.processors && a.renderer == b.renderer &&
           a.display_identity == b.display_identity && have_same_inputs(a, b);
}

}  // namespace tedavis::host_sim
