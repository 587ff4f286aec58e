/// What a test of a hard case measured, for the table of hard cases: tests/hard_cases/registry/run reads it from the test
/// program's report. Call it from the body of the test that the case names in cases.toml.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace tedavis::test_support {

inline void record_hard_case(const char* id, const char* what, double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    testing::Test::RecordProperty(std::string(id) + "_" + what, text);
}

/// The worst value that the test found of what the case bounds, in the unit of the case's threshold.
inline void record_worst(const char* id, double value) { record_hard_case(id, "worst", value); }
/// The same of the naive form, which the case's threshold must refuse.
inline void record_control(const char* id, double value) { record_hard_case(id, "control", value); }

}  // namespace tedavis::test_support
