#include "host_sim/flight_test/input_logs.hpp"

#include <cmath>
#include <cstdio>

#include "host_sim/atomic_file.hpp"
#include "host_sim/flight_test/step_log.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kMilliseconds = 1000;  // a second has, to which a better window is said

std::string words_of_end(double end_s) {
    char words[96];
    std::snprintf(words, sizeof words, "this [[expect]] lies beyond the end of the input, which lasts %.1f s", end_s);
    return std::string(words) + "; say an earlier time";
}

/// The first frame that an expectation can hold in, as its judge looks at it, s.
double first_frame_s(const Expectation& expectation, double rate_hz) {
    const bool is_after = expectation.kind == WindowKind::within;
    const double from_s = expectation.from_s + (is_after ? kSameTime_s : -kSameTime_s);
    return (is_after ? std::floor(from_s * rate_hz) + 1 : std::ceil(from_s * rate_hz)) / rate_hz;
}

/// What is wrong with a time in which the device has no frame; empty where it has one.
std::string fault_of_window(const Expectation& expectation, double rate_hz, double end_s) {
    const double frame_s = first_frame_s(expectation, rate_hz);
    char words[192];
    if (frame_s > end_s + kSameTime_s) {
        std::snprintf(words, sizeof words, "the input, which lasts %.3f s, ends before the frame that this [[expect]] asks for",
                      end_s);
        return std::string(words) + "; say an earlier time";
    }
    if (expectation.kind == WindowKind::at || frame_s <= expectation.to_s + kSameTime_s) return {};
    const bool is_after = expectation.kind == WindowKind::within;
    const double least_s = frame_s - (is_after ? expectation.from_s : 0);
    std::snprintf(words, sizeof words, "no frame lies %s %g s%s %g s: the device shows %g a second; say %s = %g or more",
                  is_after ? "within" : "from", is_after ? expectation.to_s - expectation.from_s : expectation.from_s,
                  is_after ? " after" : " to", is_after ? expectation.from_s : expectation.to_s, rate_hz,
                  is_after ? "within_s" : "to_s", std::ceil(least_s * kMilliseconds - kSameTime_s) / kMilliseconds);
    return words;
}

}  // namespace

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

void require_within_input(const FlightTest& test, double end_s, const FrameTimes& times) {
    std::string sentences;
    for (const Expectation& one : test.expectations) {
        const std::string sentence = one.to_s > end_s
                                         ? words_of_end(end_s)
                                         : (times.rate_hz ? fault_of_window(one, *times.rate_hz, end_s) : std::string());
        if (!sentence.empty())
            sentences += (sentences.empty() ? "" : "\n") + one.file + ":" + std::to_string(one.line) + ": " + sentence;
    }
    if (!sentences.empty()) throw UserError(sentences);
}

}  // namespace tedavis::host_sim
