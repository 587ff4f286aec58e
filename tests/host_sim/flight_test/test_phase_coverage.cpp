// What the shipped flight tests cover, as the tables of configs/flight_tests/README.md.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <set>

#include "host_sim/commands/verify.hpp"
#include "host_sim/flight_test/read_conditions.hpp"
#include "host_sim/flight_test/read_flight_test.hpp"
#include "tests/support/files/generated_page.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::host_sim::test_phase_coverage {
namespace {

using test_support::page_head;
using test_support::page_row;
using Scripts = std::set<std::string>;

constexpr const char* kPage = "configs/flight_tests/README.md";
const std::array<std::string, 3> kSources = {"switch", "can", "motion"};
const std::vector<std::string> kScenarios = {"ground", "takeoff", "cruise", "approach", "go_around", "unknown"};

/// Transitions that no rule of the motion makes (render_core/flight/motion_phase_detector.cpp), and what it passes instead.
const std::map<std::pair<std::string, std::string>, const char*> kNotByMotion = {
    {{"ground", "cruise"}, "passes take-off"},     {{"ground", "approach"}, "passes take-off"},
    {{"ground", "go_around"}, "passes take-off"},  {{"takeoff", "go_around"}, "passes approach"},
    {{"cruise", "ground"}, "passes unknown"},      {{"cruise", "takeoff"}, "passes approach or unknown"},
    {{"cruise", "go_around"}, "passes approach"},  {{"go_around", "takeoff"}, "passes unknown"},
    {{"unknown", "go_around"}, "passes approach"},
};

struct Statement {
    double time_s = 0;
    std::string phase, source;
};

std::string scenario_of(const std::string& phase) { return phase.substr(0, phase.find('.')); }

std::string expected_of(const Expectation& expectation, const char* key) {
    for (const FrameCondition& condition : expectation.conditions)
        if (condition.key == key) return condition.expected;
    return {};
}

struct Coverage {
    std::map<std::pair<std::string, std::string>, Scripts> phases;                               ///< phase, source
    std::map<std::pair<std::pair<std::string, std::string>, std::string>, Scripts> transitions;  ///< of scenarios, source
    std::vector<std::pair<std::string, std::string>> titles;

    void add(const FlightTest& test) {
        const std::string name = std::filesystem::path(test.path).stem().string();
        titles.emplace_back(name, test.title);
        std::vector<Statement> statements;
        for (const Expectation& one : test.expectations) {
            const Statement stated{one.from_s, expected_of(one, "phase"), expected_of(one, "phase_source")};
            if (stated.phase.empty() || stated.source.empty()) continue;
            phases[{stated.phase, stated.source}].insert(name);
            if (stated.source != "held") statements.push_back(stated);
        }
        std::stable_sort(statements.begin(), statements.end(),
                         [](const Statement& a, const Statement& b) { return a.time_s < b.time_s; });
        for (std::size_t n = 1; n < statements.size(); ++n) add_transition(statements[n - 1], statements[n], name);
    }

    /// One that a source causes: it stated the phase before, or no source did; or it falls silent.
    void add_transition(const Statement& from, const Statement& to, const std::string& name) {
        const bool falls_silent = to.phase == "unknown" && to.source == "none";
        const std::string source = falls_silent ? from.source : to.source;
        if (!falls_silent && from.source != to.source && from.phase != "unknown") return;
        transitions[{{scenario_of(from.phase), scenario_of(to.phase)}, source}].insert(name);
    }
};

const Coverage& shipped_coverage() {
    static const Coverage kCoverage = [] {
        Coverage coverage;
        for (const std::string& path : scripts_of_folder(test_support::source_dir() + "/configs/flight_tests")) {
            ScriptFaults faults;
            coverage.add(read_flight_test(path, {}, faults));
            EXPECT_THAT(faults.sentences(), ::testing::IsEmpty());
        }
        return coverage;
    }();
    return kCoverage;
}

std::string listed(const Scripts& scripts) {
    constexpr std::size_t kShown = 2;
    std::string text;
    std::size_t n = 0;
    for (const std::string& name : scripts)
        if (n++ < kShown) text += (text.empty() ? "" : ", ") + name;
    return scripts.size() > kShown ? text + " and " + std::to_string(scripts.size() - kShown) + " more" : text;
}

std::string phase_cell(const std::string& phase, const std::string& source) {
    const bool has_sub_phases = phase == "takeoff" || phase == "approach" || phase == "go_around";
    if (source == "motion" && has_sub_phases) return "by its sub-phases";
    if (source == "switch" && phase == "go_around") return "no shipped panel has it";
    if (phase == "unknown" && source != "motion") return "states nothing: the transitions below";
    const auto found = shipped_coverage().phases.find({phase, source});
    return found == shipped_coverage().phases.end() ? "" : listed(found->second);
}

std::string transition_cell(const std::string& from, const std::string& to, const std::string& source) {
    const auto found = shipped_coverage().transitions.find({{from, to}, source});
    const auto reason = kNotByMotion.find({from, to});
    const bool is_covered = found != shipped_coverage().transitions.end();
    if (source != "motion" || reason == kNotByMotion.end()) return is_covered ? listed(found->second) : "";
    EXPECT_FALSE(is_covered) << from << " to " << to << ": " << (is_covered ? listed(found->second) : "");
    return std::string("not by motion: ") + reason->second;
}

/// "" for an empty cell is a failure.
std::string checked(const std::string& cell, const std::string& where) {
    EXPECT_FALSE(cell.empty()) << where << " is covered by no shipped flight test";
    return cell;
}

TEST(PhaseCoverage, EveryPhaseBySource) {
    std::string part = page_head({"phase", "switch", "message", "motion"});
    for (const std::string& phase : phase_names()) {
        std::vector<std::string> cells{"`" + phase + "`"};
        for (const std::string& source : kSources) cells.push_back(checked(phase_cell(phase, source), phase + " by " + source));
        part += page_row({cells.begin(), cells.end()});
    }
    test_support::expect_page_part(kPage, "phases", part);
}

TEST(PhaseCoverage, EveryTransitionBySource) {
    std::string part = page_head({"from", "to", "switch", "message", "motion"});
    for (const std::string& from : kScenarios)
        for (const std::string& to : kScenarios) {
            if (from == to) continue;
            std::vector<std::string> cells{from, to};
            for (const std::string& source : kSources)
                cells.push_back(checked(transition_cell(from, to, source), from + " to " + to + " by " + source));
            part += page_row({cells.begin(), cells.end()});
        }
    test_support::expect_page_part(kPage, "transitions", part);
}

TEST(PhaseCoverage, EveryScriptHasATitle) {
    std::string part = page_head({"script", "tests"});
    for (const auto& [name, title] : shipped_coverage().titles) {
        EXPECT_NE(name, title) << "say a title";
        part += page_row({"`" + name + "`", title});
    }
    test_support::expect_page_part(kPage, "scripts", part);
}

}  // namespace
}  // namespace tedavis::host_sim::test_phase_coverage
