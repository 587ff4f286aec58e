// The elements of a report that a reader can check, each computed from accuracy.json alone and looked for on the page. Numbers
// are those of the list of elements in host_sim/accuracy/README.md; 22 (files and schema) and 23 (one file without network) are
// tested beside this.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <functional>

#include "host_sim/accuracy/accuracy_json.hpp"
#include "host_sim/accuracy/accuracy_page.hpp"
#include "host_sim/reports/base64.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "tests/host_sim/accuracy/whole_report.hpp"

namespace tedavis::host_sim::test_report_elements {
namespace {

using Json = nlohmann::ordered_json;
using Texts = std::vector<std::string>;

template <class... Values>
std::string printed(const char* format, Values... values) {
    char text[200];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::string text(const Json& json) { return json.get<std::string>(); }
double number(const Json& json) { return json.get<double>(); }
std::string three(const Json& json) { return printed("%.3g", number(json)); }
std::string cell(const std::string& content) { return "<td class='n'>" + content + "</td>"; }

const Json& knob_named(const Json& report, const char* name) {
    for (const Json& knob : report.at("knobs"))
        if (knob.at("name") == name) return knob;
    throw std::runtime_error(name);
}

/// An element: what it is, and the texts that the page must have, by accuracy.json.
struct ReportElement {
    int number;
    const char* name;
    std::function<Texts(const Json&)> texts;
};

Texts of_levels(const Json& knob, const std::function<std::string(const Json&)>& one) {
    Texts all;
    for (const Json& level : knob.at("levels")) all.push_back(one(level));
    return all;
}

std::string law(const char* what, const Json& fit) {
    return printed("%s ~ amount^%.2f (R2 %.3f; every point within a factor of %.2f of it). ", what, number(fit.at("exponent")),
                   number(fit.at("r2")), number(fit.at("worst_residual")));
}

/// What is proven of a level, or else its greatest error.
double trusted(const Json& level) {
    const double measured = number(level.at("error").at("max"));
    return level.at("proven").is_null() ? measured : std::max(measured, number(level.at("proven")));
}

/// What 95 of 100 frames keep to, with the margin that was measured.
double needed_ms(const Json& knob, const Json& level) {
    return number(level.at("kept_ms")) * (1 + number(knob.at("noise"))) * number(knob.at("dearest"));
}

/// The most accurate level of the frame's settings whose slow frames keep to a time.
const Json* best_within(const Json& knob, double budget_ms) {
    const Json* best = nullptr;
    for (const Json& level : knob.at("levels"))
        if (needed_ms(knob, level) <= budget_ms && (best == nullptr || trusted(level) < trusted(*best))) best = &level;
    return best;
}

/// The quickest level whose trusted error keeps to a target.
const Json* quickest_for(const Json& knob, double error) {
    const Json* best = nullptr;
    for (const Json& level : knob.at("levels"))
        if (trusted(level) <= error && (best == nullptr || level.at("ms").at("median") < best->at("ms").at("median")))
            best = &level;
    return best;
}

bool is_beaten(const Json& knob, const Json& level) {
    for (const Json& other : knob.at("levels")) {
        const Json &a = other.at("error"), &b = level.at("error");
        if (a.at("mean") > b.at("mean") || a.at("max") > b.at("max")) continue;
        const bool is_better = a.at("mean") < b.at("mean") || a.at("max") < b.at("max");
        const double mine = number(level.at("ms").at("median")), theirs = number(other.at("ms").at("median"));
        if (is_better ? theirs <= mine : theirs * (1 + number(knob.at("noise"))) < mine) return true;
    }
    return false;
}

/// What lies on the page where, and on which side of what: a marked row for each beaten level, a plain one for the others.
Texts front_rows(const Json& knob) {
    return of_levels(knob, [&](const Json& level) {
        return std::string(is_beaten(knob, level) ? "<tr class='dominated'>" : "<tr>") + "<th>" + text(level.at("name")) +
               "</th>";
    });
}

const std::vector<ReportElement>& elements() {
    static const std::vector<ReportElement> kElements = {
        {1, "header",
         [](const Json& json) {
             const Json& on = json.at("conditions");
             return Texts{text(on.at("processor")),
                          text(on.at("renderer")),
                          printed("load %.1f", number(on.at("load"))),
                          "commit " + text(on.at("commit")),
                          text(on.at("compiler")),
                          "fixed seeds",
                          text(on.at("command"))};
         }},
        {2, "a minute's summary",
         [](const Json& json) {
             const Json& knob = knob_named(json, "frame_settings");
             const Json& best = *best_within(knob, 1000.0 / 60);
             const Json& answer = json.at("answers").at(2);
             const double margin = 100 * number(answer.at("margin"));
             return Texts{"The best settings for 60 frames/s (16.7 ms) are " + text(best.at("name")),
                          printed("took at most %.3g ms; with a margin of %.0f %%", number(best.at("kept_ms")), margin),
                          printed(") that is %.3g ms, so at least %.0f of 100", number(answer.at("needed_ms")),
                                  100 * number(answer.at("expected_share"))),
                          printed("<b>%.1f ms</b>", needed_ms(knob, best)),
                          printed("<b>%.1f ms</b>", number(best.at("sample_ms").at("median"))),
                          printed("<b>%.2g ", trusted(best))};
         }},
        {3, "reference, its own bound, second oracle",
         [](const Json& json) {
             const Json& knob = knob_named(json, "made");
             const Json& reference = knob.at("reference");
             return Texts{"Reference: " + text(reference.at("what")), "itself within " + three(reference.at("bound")),
                          text(reference.at("reason")), "Second oracle: " + text(knob.at("second_oracle"))};
         }},
        {4, "noise floor",
         [](const Json& json) {
             return Texts{printed("medians that differ by less than %.1f %% are not ranked",
                                  100 * number(knob_named(json, "made").at("noise")))};
         }},
        {5, "work-precision curve with p5 to p95",
         [](const Json& json) {
             Texts all = of_levels(knob_named(json, "made"), [](const Json& level) {
                 const Json& ms = level.at("ms");
                 return printed("%.3f - %.3f", number(ms.at("p5")), number(ms.at("p95")));
             });
             all.push_back("<title>A made-up knob: error over time</title>");
             return all;
         }},
        {6, "fitted laws",
         [](const Json& json) {
             const Json& knob = knob_named(json, "made");
             return Texts{escaped_html(law("Error", knob.at("error_law"))), escaped_html(law("Time", knob.at("time_law")))};
         }},
        {7, "distribution",
         [](const Json& json) {
             return of_levels(knob_named(json, "made"), [](const Json& level) {
                 const Json& error = level.at("error");
                 return cell(three(error.at("mean"))) + "<td class='n aside'>" + three(error.at("p95")) +
                        "</td><td class='n aside'>" + three(error.at("p99")) + "</td>" + cell(three(error.at("max")));
             });
         }},
        {8, "requested, proven, measured",
         [](const Json& json) {
             Texts all;
             for (const Json& line : json.at("flights").at(0).at("lines"))
                 all.push_back(printed("<th>%g px</th>", number(line.at("asked_px"))) + cell(three(line.at("proven_px"))) +
                               cell(three(line.at("measured_px"))) +
                               cell(printed("%.0f %%", 100 * number(line.at("tightness").at("median")))) +
                               cell(printed("%.0f %%", 100 * number(line.at("tightness").at("max")))));
             return all;
         }},
        {9, "front across settings", [](const Json& json) { return front_rows(knob_named(json, "frame_settings")); }},
        {10, "what the next level costs",
         [](const Json& json) {
             const Json& levels = knob_named(json, "made").at("levels");
             Texts all;
             for (std::size_t n = 1; n < levels.size(); ++n) {
                 const Json &from = levels.at(n - 1), &to = levels.at(n);
                 all.push_back("<td>" + text(from.at("name")) + "</td><td>" + text(to.at("name")) + "</td>" +
                               cell(printed("x %.3g", number(to.at("error").at("mean")) / number(from.at("error").at("mean")))) +
                               cell(printed("x %.3g", number(to.at("ms").at("median")) / number(from.at("ms").at("median")))));
             }
             return all;
         }},
        {11, "queries by budget and by error",
         [](const Json& json) {
             const Json& knob = knob_named(json, "frame_settings");
             const Json &best = *best_within(knob, 12), &quickest = *quickest_for(knob, 0.5);
             const auto of_level = [&](const Json& level) {
                 return "<td>" + text(level.at("name")) + "</td>" + cell(three(trusted(level))) + "<td class='n aside'>" +
                        three(level.at("error").at("max")) + "</td>" +
                        cell(printed("%.2f", number(level.at("sample_ms").at("median")))) +
                        printed("<td class='n aside'>%.2f</td>", needed_ms(knob, level));
             };
             return Texts{"<th>12 ms</th><td class='n aside'>12.0</td>" + of_level(best),
                          "<td>" + text(best.at("options")) + "</td></tr>", "<th>0.5 m</th>" + of_level(quickest),
                          "<td>" + text(quickest.at("options")) + "</td></tr>"};
         }},
        {12, "memory, traffic, build time",
         [](const Json& json) {
             const Json& levels = knob_named(json, "made").at("levels");
             return Texts{printed("%.1f kB", number(levels.at(1).at("bytes")) / 1000),
                          printed("%.1f kB", number(levels.at(0).at("uploaded_bytes")) / 1000), "build ms"};
         }},
        {13, "pictures from cheap to exact",
         [](const Json& json) {
             const Json& pictures = knob_named(json, "made").at("pictures");
             return Texts{"left: " + text(pictures.at("cheap_level")) + "; right: " + text(pictures.at("exact_level")),
                          "type='range'", base64(test_support::made_pictures().cheap.png),
                          base64(test_support::made_pictures().exact.png)};
         }},
        {14, "maps of colour, perceived and own error",
         [](const Json& json) {
             const Json& pictures = knob_named(json, "made").at("pictures");
             const Json &color = pictures.at("ciede2000"), &flip = pictures.at("flip");
             return Texts{printed("CIEDE2000: mean %.3g, at most %.3g", number(color.at("mean")), number(color.at("max"))),
                          printed("FLIP: mean %.3g, at most %.3g", number(flip.at("mean")), number(flip.at("max"))),
                          printed("Error, yellow is %.3g: ", number(pictures.at("metric_max"))) + text(pictures.at("metric"))};
         }},
        {15, "worst pixel",
         [](const Json& json) {
             const Json& pictures = knob_named(json, "made").at("pictures");
             return Texts{"pixel " + std::to_string(pictures.at("pixel").at(0).get<int>()) + ", ", text(pictures.at("place")),
                          "Again: " + text(pictures.at("command")), base64(test_support::made_pictures().cheap_crop.png)};
         }},
        {16, "error along the flight",
         [](const Json& json) {
             const Json* worst = nullptr;
             for (const Json& moment : json.at("flights").at(0).at("moments"))
                 if (worst == nullptr || moment.at("measured_px") > worst->at("measured_px")) worst = &moment;
             if (worst == nullptr) return Texts{"no moment was measured"};
             return Texts{printed("The greatest measured error, %.3g px, is at %.0f s", number(worst->at("measured_px")),
                                  number(worst->at("time_s"))),
                          "--pose " + text(worst->at("pose"))};
         }},
        {17, "what the governor may choose",
         [](const Json& json) {
             Texts all{printed("a deadline of %g ms", number(json.at("governor").at("deadline_ms")))};
             for (const Json& level : json.at("governor").at("levels"))
                 all.push_back(cell(printed("%.3f", number(level.at("ms")))) + cell(three(level.at("error_px"))) +
                               cell(three(level.at("error_color"))) + cell(std::to_string(level.at("frames").get<int>())));
             return all;
         }},
        {18, "columns by machine",
         [](const Json& json) {
             const Json& compared = json.at("comparisons").at(0);
             return Texts{"ms: " + text(compared.at("processor")) + ", " + text(compared.at("date")), "another machine",
                          cell(printed("%.3f", number(compared.at("levels").at(0).at("earlier_ms"))))};
         }},
        {19, "negative control",
         [](const Json& json) {
             const Json& control = json.at("negative_control");
             return Texts{"is wrong by " + three(control.at("wrong").at("mean")) + " m in the mean and " +
                          three(control.at("wrong").at("max"))};
         }},
        {20, "omissions",
         [](const Json& json) { return Texts{text(json.at("not_measured").at(0)) + ". The same command goes on"}; }},
        {21, "comparison with an earlier report",
         [](const Json& json) {
             const Json& level = json.at("comparisons").at(0).at("levels").at(0);
             const Json& ranks = json.at("comparisons").at(0).at("ranks");
             return Texts{cell(three(level.at("earlier_error"))) + "<td>less accurate</td>",
                          printed("tau %.3f", number(ranks.at("kendall_tau")))};
         }},
        {24, "effects that the scene did not call for",
         [](const Json& json) {
             const Json& use = json.at("uncalled_effects").at("effects").at(0);
             return Texts{"<th>" + text(use.at("name")) + "</th>" + cell(std::to_string(use.at("asked").get<int>())) +
                              cell(std::to_string(use.at("run").get<int>())),
                          cell(std::to_string(use.at("largest_difference").get<int>()) + " of 255")};
         }},
    };
    return kElements;
}

/// Numbers of the elements of which a text is not on the page.
std::vector<int> missing(const std::string& page, const Json& json) {
    std::vector<int> numbers;
    for (const ReportElement& element : elements())
        for (const std::string& expected : element.texts(json))
            if (page.find(expected) == std::string::npos && page.find(escaped_html(expected)) == std::string::npos) {
                numbers.push_back(element.number);
                break;
            }
    return numbers;
}

/// Everywhere: the last digit is another one; texts without a digit lose their end.
void spoil(std::string& page, const std::string& shown) {
    std::string wrong = shown;
    const std::size_t digit = wrong.find_last_of("0123456789");
    if (digit == std::string::npos)
        wrong.pop_back();
    else
        wrong[digit] = wrong[digit] == '9' ? '0' : static_cast<char>(wrong[digit] + 1);
    for (std::size_t at = page.find(shown); at != std::string::npos; at = page.find(shown, at + wrong.size()))
        page.replace(at, shown.size(), wrong);
}

TEST(ReportElements, AreOnThePageAsTheFileHasThem) {
    const AccuracyReport report = test_support::whole_report();
    EXPECT_THAT(missing(accuracy_page(report), accuracy_json(report)), ::testing::IsEmpty());
}

TEST(ReportElements, AWrongNumberOfEachIsFound) {
    const AccuracyReport report = test_support::whole_report();
    const Json json = accuracy_json(report);
    const std::string page = accuracy_page(report);
    for (const ReportElement& element : elements()) {
        std::string spoiled = page;
        for (const std::string& shown : element.texts(json)) {
            spoil(spoiled, shown);
            spoil(spoiled, escaped_html(shown));
        }
        EXPECT_THAT(missing(spoiled, json), ::testing::Contains(element.number)) << element.name;
    }
}

TEST(ReportElements, FollowTheFileAndNotThePage) {
    const AccuracyReport report = test_support::whole_report();
    AccuracyReport other = report;
    for (MeasuredLevel& level : other.knobs[0].levels) level.error.mean *= 1.5;
    EXPECT_THAT(missing(accuracy_page(report), accuracy_json(other)), ::testing::Contains(7));
}

}  // namespace
}  // namespace tedavis::host_sim::test_report_elements
