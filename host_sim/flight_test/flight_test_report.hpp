/// What flight tests found, as a table, JSON and JUnit XML.
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
    std::string left_out{};  ///< why it was not flown: it is one of another board, or another script is wrong; else empty
    std::string fault{};     ///< why it was not flown to its end, a sentence a line; else empty

    /// Nothing where none of it was judged: it was left out, or a board cannot answer what it asks for.
    [[nodiscard]] std::optional<bool> holds() const {
        if (!fault.empty()) return false;
        return result.is_judged() ? std::optional<bool>(result.holds()) : std::nullopt;
    }
};

/// How many of them were judged.
[[nodiscard]] std::size_t judged_tests(const std::vector<FlownTest>& tests);
/// A row a test, and below it the first failure.
[[nodiscard]] std::string flight_tests_text(const std::vector<FlownTest>& tests);
/// "holds" is null of a test or expectation that was not judged, and of all together where none was.
[[nodiscard]] nlohmann::ordered_json flight_tests_json(const std::vector<FlownTest>& tests);
/// A testsuite a script, a testcase an expectation.
[[nodiscard]] std::string flight_tests_junit(const std::vector<FlownTest>& tests);

}  // namespace tedavis::host_sim
