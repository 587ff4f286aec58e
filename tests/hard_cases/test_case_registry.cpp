// The registry of hard cases (registry/cases.toml) is whole as far as that can be told without running it: every case has its
// parts, and the tests that it names exist. registry/run tells the rest.
#define TOML_EXCEPTIONS 0  // as everywhere in this program
#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tests/support/files/device_files.hpp"
#include "tests/support/files/paths.hpp"

namespace tedavis::test_case_registry {
namespace {

constexpr std::size_t kNumericsCases = 48;  ///< A01 to A48 were collected before the first of them had a test

std::vector<toml::table> cases() {
    const toml::parse_result file = toml::parse(test_support::source_file("tests/hard_cases/registry/cases.toml"));
    std::vector<toml::table> all;
    EXPECT_TRUE(file) << "cases.toml is not valid";
    if (!file) return all;
    for (const toml::node& one : *file.table()["case"].as_array()) all.push_back(*one.as_table());
    return all;
}

std::string text_of(const toml::table& one, const char* key) { return one[key].value_or(std::string()); }

std::vector<std::string> tests_of(const toml::table& one) {
    std::vector<std::string> names;
    if (const toml::array* const tests = one["tests"].as_array())
        for (const toml::node& test : *tests) names.push_back(test.value_or(std::string()));
    if (const std::string control = text_of(one, "control_test"); !control.empty()) names.push_back(control);
    return names;
}

/// "Suite.Test" of every TEST, TEST_F and TEST_P below tests; of the latter as sources spell it.
std::set<std::string> known_tests() {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test_support::source_dir() + "/tests")) {
        if (entry.path().extension() != ".cpp") continue;
        const std::string path = std::filesystem::relative(entry.path(), test_support::source_dir()).string();
        const std::string text = test_support::source_file(path);
        for (std::size_t at = text.find("\nTEST"); at != std::string::npos; at = text.find("\nTEST", at + 1)) {
            const std::size_t open = text.find('(', at), comma = text.find(',', open), close = text.find(')', comma);
            const std::size_t name = text.find_first_not_of(" \n", comma + 1);
            names.insert(text.substr(open + 1, comma - open - 1) + "." + text.substr(name, close - name));
        }
    }
    return names;
}

/// "Instance/Suite.Test/Parameter" as the source spells it.
std::string in_source(std::string test) {
    const std::size_t dot = test.find('.');
    const std::size_t instance = test.rfind('/', dot), parameter = test.find('/', dot);
    if (parameter != std::string::npos) test.erase(parameter);
    return instance == std::string::npos ? test : test.substr(instance + 1);
}

TEST(CaseRegistry, NumbersItsCasesFromOneOn) {
    std::size_t number = 0;
    for (const toml::table& one : cases()) {
        char id[8];
        std::snprintf(id, sizeof id, "A%02zu", ++number);
        EXPECT_EQ(text_of(one, "id"), id);
    }
    EXPECT_GE(number, kNumericsCases);
}

TEST(CaseRegistry, EveryCaseHasItsParts) {
    for (const toml::table& one : cases())
        for (const char* const part : {"title", "wrong", "technique", "threshold", "first_oracle", "second_oracle", "where"})
            EXPECT_FALSE(text_of(one, part).empty()) << text_of(one, "id") << " has no " << part;
}

/// A case without a test or a negative control says so; registry/run finds values that no test recorded.
TEST(CaseRegistry, WhatACaseLacksIsSaid) {
    for (const toml::table& one : cases()) {
        const bool is_whole = one["tests"].as_array() != nullptr && !one["tests"].as_array()->empty() &&
                              !text_of(one, "control").empty() && !text_of(one, "control_test").empty();
        EXPECT_TRUE(is_whole || !text_of(one, "lacks").empty()) << text_of(one, "id");
    }
}

TEST(CaseRegistry, TestsThatItNamesExist) {
    const std::set<std::string> known = known_tests();
    ASSERT_GT(known.size(), 1000u) << "control: tests are found at all";
    for (const toml::table& one : cases())
        for (const std::string& test : tests_of(one)) {
            const std::size_t name = test.find(": ");
            ASSERT_NE(name, std::string::npos) << test << ": write it as \"program: Suite.Test\"";
            EXPECT_TRUE(known.count(in_source(test.substr(name + 2))) != 0) << text_of(one, "id") << ": " << test;
        }
}

TEST(CaseRegistry, ThePageHasARowForEachCase) {
    const std::string page = test_support::source_file("tests/hard_cases/README.md");
    for (const toml::table& one : cases())
        EXPECT_NE(page.find("\n| " + text_of(one, "id") + " " + text_of(one, "title") + " |"), std::string::npos)
            << text_of(one, "id") << ": tests/hard_cases/registry/run --table writes the table";
}

}  // namespace
}  // namespace tedavis::test_case_registry
