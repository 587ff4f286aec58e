#include "host_sim/flight_test/flight_test_report.hpp"

#include <algorithm>
#include <cstdio>

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

std::string with_seconds(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f s", seconds);
    return text;
}

std::string words_of_failure(const ExpectationResult& failure) {
    return "at " + with_seconds(failure.failed_s) + " " + failure.key + ": expected " + failure.expected + ", found " +
           failure.found + (failure.reason.empty() ? "" : " (" + failure.reason + ")");
}

std::string padded(const std::string& text, std::size_t width) {
    return text + std::string(width > text.size() ? width - text.size() : 0, ' ');
}

/// Of one that must be reached.
std::string words_of_window(const Expectation& expectation) {
    if (expectation.kind != WindowKind::within) return {};
    return "; it was to be reached from " + with_seconds(expectation.from_s) + " to " + with_seconds(expectation.to_s);
}

std::string place_of_expectation(const Expectation& expectation) {
    return expectation.file + ":" + std::to_string(expectation.line);
}

std::string escaped(const std::string& text) {
    std::string xml;
    for (const char c : text) {
        if (c == '&')
            xml += "&amp;";
        else if (c == '<')
            xml += "&lt;";
        else if (c == '>')
            xml += "&gt;";
        else if (c == '"')
            xml += "&quot;";
        else
            xml += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return xml;
}

Json expectation_json(const Expectation& expectation, const ExpectationResult& result) {
    Json json = {{"name", expectation.name}, {"file", expectation.file}, {"line", expectation.line}, {"holds", result.holds}};
    json["reached_s"] = result.reached_s ? Json(*result.reached_s) : Json(nullptr);
    if (result.holds) return json;
    json["failed_s"] = result.failed_s;
    json["key"] = result.key;
    json["expected"] = result.expected;
    json["found"] = result.found;
    json["reason"] = result.reason;
    return json;
}

std::string junit_case(const FlownTest& one, std::size_t n) {
    const Expectation& expectation = one.test.expectations[n];
    const ExpectationResult& result = one.result.expectations[n];
    std::string xml = "    <testcase classname=\"" + escaped(one.test.path) + "\" name=\"" + escaped(expectation.name) +
                      "\" file=\"" + escaped(expectation.file) + "\" line=\"" + std::to_string(expectation.line) + "\"";
    if (result.holds) return xml + "/>\n";
    const std::string words = escaped(words_of_failure(result) + words_of_window(expectation));
    return xml + ">\n      <failure message=\"" + words + "\">" + escaped(place_of_expectation(expectation)) + ": " + words +
           "</failure>\n    </testcase>\n";
}

}  // namespace

std::string flight_tests_text(const std::vector<FlownTest>& tests) {
    std::size_t width = 6, held = 0, all = 0;
    for (const FlownTest& one : tests) width = std::max(width, one.test.path.size());
    std::string text = padded("script", width) + "  expectations  held  failed\n";
    for (const FlownTest& one : tests) {
        const std::size_t count = one.result.expectations.size(), kept = one.result.held();
        char counts[64];
        std::snprintf(counts, sizeof counts, "  %12zu  %4zu  %6zu\n", count, kept, count - kept);
        text += padded(one.test.path, width) + counts;
        held += kept;
        all += count;
        for (std::size_t n = 0; n < count; ++n)
            if (const ExpectationResult& result = one.result.expectations[n]; !result.holds)
                text += "  " + place_of_expectation(one.test.expectations[n]) + ": " + words_of_failure(result) +
                        words_of_window(one.test.expectations[n]) + "\n";
        if (!one.picture.empty()) text += "  " + one.picture + " shows it\n";
    }
    return text + std::to_string(held) + " of " + std::to_string(all) + " expectations hold\n";
}

Json flight_tests_json(const std::vector<FlownTest>& tests) {
    Json json = {{"holds", true}, {"tests", Json::array()}};
    for (const FlownTest& one : tests) {
        Json expectations = Json::array();
        for (std::size_t n = 0; n < one.result.expectations.size(); ++n)
            expectations.push_back(expectation_json(one.test.expectations[n], one.result.expectations[n]));
        Json told = {
            {"script", one.test.path}, {"title", one.test.title}, {"holds", one.result.holds()}, {"frames", one.result.frames}};
        told["picture"] = one.picture.empty() ? Json(nullptr) : Json(one.picture);
        told["expectations"] = std::move(expectations);
        json["tests"].push_back(std::move(told));
        if (!one.result.holds()) json["holds"] = false;
    }
    return json;
}

std::string flight_tests_junit(const std::vector<FlownTest>& tests) {
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (const FlownTest& one : tests) {
        const std::size_t count = one.result.expectations.size();
        xml += "  <testsuite name=\"" + escaped(one.test.title) + "\" tests=\"" + std::to_string(count) + "\" failures=\"" +
               std::to_string(count - one.result.held()) + "\" errors=\"0\">\n";
        for (std::size_t n = 0; n < count; ++n) xml += junit_case(one, n);
        xml += "  </testsuite>\n";
    }
    return xml + "</testsuites>\n";
}

}  // namespace tedavis::host_sim
