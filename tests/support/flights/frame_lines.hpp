/// The lines of a run's frames.jsonl, read back for comparison.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "host_sim/input_file.hpp"

namespace tedavis::test_support {

[[nodiscard]] inline std::vector<nlohmann::json> frame_lines(const std::string& folder) {
    std::istringstream text(host_sim::read_file(folder + "/frames.jsonl"));
    std::vector<nlohmann::json> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(nlohmann::json::parse(line));
    return lines;
}

/// Hash by time; where a time was drawn more than once, the last one.
[[nodiscard]] inline std::map<double, std::string> hashes_by_time(const std::string& folder) {
    std::map<double, std::string> hashes;
    for (const nlohmann::json& line : frame_lines(folder)) hashes[line.at("time_s")] = line.at("hash");
    return hashes;
}

[[nodiscard]] inline nlohmann::json summary_of(const std::string& folder) {
    return nlohmann::json::parse(host_sim::read_file(folder + "/summary.json"));
}

}  // namespace tedavis::test_support
