/// What flight tests found, as a table, JSON and JUnit XML.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "host_sim/flight_test/fly_flight_test.hpp"

namespace tedavis::host_sim {

struct FlownTest {
    FlightTest test;
    FlightTestResult result;
    std::string picture;  ///< path of the picture of the first failing instant; empty: none
};

/// A row a test, and below it the first failure.
[[nodiscard]] std::string flight_tests_text(const std::vector<FlownTest>& tests);
[[nodiscard]] nlohmann::ordered_json flight_tests_json(const std::vector<FlownTest>& tests);
/// A testsuite a script, a testcase an expectation.
[[nodiscard]] std::string flight_tests_junit(const std::vector<FlownTest>& tests);

}  // namespace tedavis::host_sim
