/// Several faults of one file, which are reported together: one sentence each, printed as one line each.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

class UserErrors : public UserError {
public:
    /// `sentences` has at least one entry. what() has a line for each.
    explicit UserErrors(std::vector<std::string> sentences) : UserError(lines_of(sentences)), sentences_(std::move(sentences)) {}

    [[nodiscard]] const std::vector<std::string>& sentences() const { return sentences_; }

private:
    static std::string lines_of(const std::vector<std::string>& sentences) {
        std::string lines;
        for (const std::string& sentence : sentences) lines += (lines.empty() ? "" : "\n") + sentence;
        return lines;
    }

    std::vector<std::string> sentences_;
};

}  // namespace tedavis::host_sim
