/// A group of commands, and what words of a command line set in it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "host_sim/commands/command_groups.hpp"

namespace tedavis::test_support {

template <void (*add_group)(CLI::App&, host_sim::CommandLine&)>
struct ParsedCommands : ::testing::Test {
    ParsedCommands() { add_group(app, line); }
    /// Throws CLI::ParseError.
    void parse(std::vector<std::string> words) {
        std::reverse(words.begin(), words.end());  // as CLI11 takes them
        app.parse(std::move(words));
    }
    CLI::App app;
    host_sim::CommandLine line;
};

}  // namespace tedavis::test_support
