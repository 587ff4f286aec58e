#include "host_sim/flight_test/input_logs.hpp"

#include <cstdio>

#include "host_sim/atomic_file.hpp"
#include "host_sim/flight_test/step_log.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

PlayerFiles test_input_files(const FlightTest& test, const std::string& folder) {
    PlayerFiles files;
    files.bus = test.picture.bus;
    files.switch_config = test.switch_config;
    files.aircraft = test.picture.aircraft;
    files.log = test.log;
    files.switches = test.switch_log;
    if (!test.has_steps) return files;
    files.log = folder + "/steps.log";
    AtomicFile log(files.log);
    write_step_log(test, log.stream(), files.log);
    log.commit();
    const std::string edges = step_switch_log(test);
    if (edges.empty()) return files;
    files.switches = folder + "/steps.switches";
    write_file_atomically(files.switches, edges);
    return files;
}

void require_within_input(const FlightTest& test, double end_s) {
    std::string sentences;
    for (const Expectation& one : test.expectations) {
        if (one.to_s <= end_s) continue;
        char words[96];
        std::snprintf(words, sizeof words, ": this [[expect]] lies beyond the end of the input, which lasts %.1f s", end_s);
        sentences +=
            (sentences.empty() ? "" : "\n") + one.file + ":" + std::to_string(one.line) + words + "; say an earlier time";
    }
    if (!sentences.empty()) throw UserError(sentences);
}

}  // namespace tedavis::host_sim
