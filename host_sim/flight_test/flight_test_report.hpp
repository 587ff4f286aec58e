/// Results of flight tests as a table, as JSON and as JUnit XML.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/flight_test/fly_flight_test.hpp"

namespace tedavis::host_sim {

struct FlownTest {
    FlightTest test;
    FlightTestResult result;
    std::string picture;     ///< path of the picture of the first failing instant; empty: none
    std::string record{};    ///< path of the record of that instant, where there is no picture
    std::string left_out{};  ///< why it was not flown: it is for another board, or another script has faults; else empty
    std::string fault{};     ///< why it was not flown to its end, one sentence per line; else empty
    bool is_wrong = false;   ///< the fault is one of the script, or of the input that it names

    /// Whether the test holds; nothing where no expectation was judged, since it was left out or a board's records cannot answer
    /// it.
    [[nodiscard]] std::optional<bool> holds() const {
        if (!fault.empty()) return false;
        return result.is_judged() ? std::optional<bool>(result.holds()) : std::nullopt;
    }
};

/// Number of tests that were judged.
[[nodiscard]] std::size_t judged_tests(const std::vector<FlownTest>& tests);
/// Returns one row per test and, below it, its first failure.
[[nodiscard]] std::string flight_tests_text(const std::vector<FlownTest>& tests);
/// Returns JSON. "holds" is null for a test or expectation that was not judged, and for the whole where none was.
[[nodiscard]] nlohmann::ordered_json flight_tests_json(const std::vector<FlownTest>& tests);
/// Returns JUnit XML with a testsuite per script and a testcase per expectation.
[[nodiscard]] std::string flight_tests_junit(const std::vector<FlownTest>& tests);

}  // namespace tedavis::host_sim
