#include "host_sim/flight_test/flight_test_report.hpp"

#include <algorithm>
#include <cstdio>

#include "host_sim/flight_test/input_logs.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNotJudged = "not judged on a board";
constexpr const char* kUnfinished = "was not flown to its end, and has not passed: ";
constexpr const char* kWrong = "is wrong: ";

std::string words_of_failure(const ExpectationResult& failure) {
    return "at " + frame_time_text(failure.failed_s) + " " + failure.key + ": expected " + failure.expected + ", found " +
           failure.found + (failure.reason.empty() ? "" : " (" + failure.reason + ")");
}

std::string padded(const std::string& text, std::size_t width) {
    return text + std::string(width > text.size() ? width - text.size() : 0, ' ');
}

/// Of one that must be reached, and was not.
std::string words_of_window(const Expectation& expectation, const ExpectationResult& failure) {
    if (expectation.kind != WindowKind::within || failure.key == "after_s") return {};
    return "; it was to be reached from " + frame_time_text(expectation.from_s) + " to " + frame_time_text(expectation.to_s);
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
    Json json = {{"name", expectation.name}, {"file", expectation.file}, {"line", expectation.line}};
    json["holds"] = result.is_judged ? Json(result.holds) : Json(nullptr);
    json["judged"] = result.is_judged;
    json["not_judged"] = result.not_judged;
    json["reached_s"] = result.reached_s ? Json(*result.reached_s) : Json(nullptr);
    if (result.holds || !result.is_judged) return json;
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
    if (!result.is_judged) return xml + ">\n      <skipped message=\"" + std::string(kNotJudged) + "\"/>\n    </testcase>\n";
    const std::string words = escaped(words_of_failure(result) + words_of_window(expectation, result));
    return xml + ">\n      <failure message=\"" + words + "\">" + escaped(place_of_expectation(expectation)) + ": " + words +
           "</failure>\n    </testcase>\n";
}

/// "1 script is wrong", "2 scripts are wrong".
std::string counted_scripts(std::size_t count, const char* of_one, const char* of_more) {
    return std::to_string(count) + (count == 1 ? std::string(" script ") + of_one : std::string(" scripts ") + of_more);
}

/// Why it was not flown to its end.
std::string words_of_fault(const FlownTest& one) {
    if (one.fault == kTestInterrupted) return one.fault;
    return (one.is_wrong ? kWrong : kUnfinished) + one.fault;
}

/// Which of the failures the picture or the record shows.
std::string words_of_shown(const FlownTest& one) {
    const std::string& file = one.picture.empty() ? one.record : one.picture;
    if (file.empty()) return {};
    return "  " + file + " shows " + frame_time_text(one.result.shown_s) + " (" +
           place_of_expectation(one.test.expectations[one.result.shown]) + ")\n";
}

/// Of a script that was not flown, or not to its end.
std::string junit_unflown(const FlownTest& one) {
    const bool is_out = one.fault.empty();
    const std::string count = is_out ? "failures=\"0\" errors=\"0\" skipped=\"1\"" : "failures=\"0\" errors=\"1\"";
    return "  <testsuite name=\"" + escaped(one.test.title) + "\" tests=\"1\" " + count + ">\n    <testcase classname=\"" +
           escaped(one.test.path) + "\" name=\"" + escaped(one.test.title) + "\">\n      <" + (is_out ? "skipped" : "error") +
           " message=\"" + escaped(is_out ? one.left_out : words_of_fault(one)) + "\"/>\n    </testcase>\n  </testsuite>\n";
}

std::string failures_text(const FlownTest& one) {
    std::string text;
    for (std::size_t n = 0; n < one.result.expectations.size(); ++n)
        if (const ExpectationResult& result = one.result.expectations[n]; result.is_judged && !result.holds)
            text += "  " + place_of_expectation(one.test.expectations[n]) + ": " + words_of_failure(result) +
                    words_of_window(one.test.expectations[n], result) + "\n";
    if (const std::size_t count = one.result.not_judged(); count > 0)
        text += "  " + std::to_string(count) + (count == 1 ? " condition is " : " conditions are ") + kNotJudged + "\n";
    return text + words_of_shown(one);
}

std::string row_text(const FlownTest& one, std::size_t width) {
    if (!one.left_out.empty()) return padded(one.test.path, width) + "  left out: it " + one.left_out + "\n";
    if (one.fault == kTestInterrupted) return padded(one.test.path, width) + "  interrupted\n";
    if (!one.fault.empty()) return padded(one.test.path, width) + "  " + words_of_fault(one) + "\n";
    char counts[64];
    std::snprintf(counts, sizeof counts, "  %12zu  %4zu  %6zu\n", one.result.expectations.size(), one.result.held(),
                  one.result.failed());
    return padded(one.test.path, width) + counts + failures_text(one);
}

}  // namespace

std::size_t judged_tests(const std::vector<FlownTest>& tests) {
    return static_cast<std::size_t>(std::count_if(
        tests.begin(), tests.end(), [](const FlownTest& one) { return one.fault.empty() && one.result.is_judged(); }));
}

std::string flight_tests_text(const std::vector<FlownTest>& tests) {
    std::size_t width = 6, held = 0, all = 0, not_judged = 0, left_out = 0, wrong = 0, unfinished = 0;
    for (const FlownTest& one : tests) width = std::max(width, one.test.path.size());
    std::string text = padded("script", width) + "  expectations  held  failed\n";
    for (const FlownTest& one : tests) {
        text += row_text(one, width);
        held += one.result.held();
        all += one.result.expectations.size();
        not_judged += one.result.not_judged();
        left_out += one.left_out.empty() ? 0 : 1;
        wrong += one.is_wrong ? 1 : 0;
        unfinished += one.fault.empty() || one.is_wrong ? 0 : 1;
    }
    text += std::to_string(held) + " of " + std::to_string(all) + " expectations hold";
    if (const std::size_t judged = judged_tests(tests); judged < tests.size())
        text += ", " + std::to_string(judged) + " of " + counted_scripts(tests.size(), "is judged", "are judged");
    if (not_judged > 0) text += ", " + std::to_string(not_judged) + " conditions are " + kNotJudged;
    if (left_out > 0) text += ", " + counted_scripts(left_out, "is left out", "are left out");
    if (wrong > 0) text += ", " + counted_scripts(wrong, "is wrong", "are wrong");
    if (unfinished > 0) text += ", " + counted_scripts(unfinished, "was not flown to its end", "were not flown to their end");
    return text + "\n";
}

Json flight_tests_json(const std::vector<FlownTest>& tests) {
    Json json = {{"holds", nullptr}, {"tests", Json::array()}};
    const auto text_or_null = [](const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); };
    for (const FlownTest& one : tests) {
        Json expectations = Json::array();
        for (std::size_t n = 0; n < one.result.expectations.size(); ++n)
            expectations.push_back(expectation_json(one.test.expectations[n], one.result.expectations[n]));
        Json told = {{"script", one.test.path}, {"title", one.test.title}, {"frames", one.result.frames}};
        const std::optional<bool> holds = one.holds();
        told["holds"] = holds ? Json(*holds) : Json(nullptr);
        told["not_judged"] = one.result.not_judged();
        told["left_out"] = text_or_null(one.left_out);
        told["fault"] = text_or_null(one.fault);
        told["picture"] = text_or_null(one.picture);
        told["expectations"] = std::move(expectations);
        json["tests"].push_back(std::move(told));
        if (holds) json["holds"] = *holds && json["holds"] != false;
    }
    return json;
}

std::string flight_tests_junit(const std::vector<FlownTest>& tests) {
    std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (const FlownTest& one : tests) {
        if (!one.left_out.empty() || !one.fault.empty()) {
            xml += junit_unflown(one);
            continue;
        }
        const std::size_t count = one.result.expectations.size();
        xml += "  <testsuite name=\"" + escaped(one.test.title) + "\" tests=\"" + std::to_string(count) + "\" failures=\"" +
               std::to_string(one.result.failed()) + "\" errors=\"0\">\n";
        for (std::size_t n = 0; n < count; ++n) xml += junit_case(one, n);
        xml += "  </testsuite>\n";
    }
    return xml + "</testsuites>\n";
}

}  // namespace tedavis::host_sim
