/// The program's own command line, inside the test's process.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "host_sim/commands/command_line.hpp"

namespace tedavis::test_support {

struct ProgramOutcome {
    int code = 0;
    std::string results, notes;
};

/// `words`: without the program's name.
inline ProgramOutcome run_words(std::vector<std::string> words) {
    words.insert(words.begin(), "tedavis");
    std::vector<const char*> arguments;
    for (const std::string& word : words) arguments.push_back(word.c_str());
    std::ostringstream results, notes;
    const int code = host_sim::run_command_line(static_cast<int>(arguments.size()), arguments.data(), results, notes, false);
    return {code, results.str(), notes.str()};
}

/// One sentence that says where, and exit code 2.
inline void expect_refusal(const ProgramOutcome& outcome, const std::string& where) {
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.results, "");
    EXPECT_THAT(outcome.notes, ::testing::HasSubstr(where));
    EXPECT_EQ(outcome.notes.find('\n'), outcome.notes.size() - 1) << outcome.notes;
    EXPECT_THAT(outcome.notes, ::testing::Not(::testing::HasSubstr("please report")));
}

}  // namespace tedavis::test_support
