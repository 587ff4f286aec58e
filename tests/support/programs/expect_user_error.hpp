/// Asks that a call refuses its input with a sentence that holds certain words.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "host_sim/user_error.hpp"

namespace tedavis::test_support {

template <class Call>
void expect_user_error(Call call, const std::string& words) {
    try {
        call();
    } catch (const host_sim::UserError& error) {
        EXPECT_THAT(error.what(), ::testing::HasSubstr(words));
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "one sentence on one line";
        return;
    }
    FAIL() << "no UserError that says: " << words;
}

}  // namespace tedavis::test_support
