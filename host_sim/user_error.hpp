/// A fault in what the user gave: one sentence that says what, where and what to do. Ends the command with exit code 2.
#pragma once

#include <stdexcept>
#include <string>

namespace tedavis::host_sim {

class UserError : public std::runtime_error {
public:
    explicit UserError(const std::string& sentence) : std::runtime_error(sentence) {}
};

}  // namespace tedavis::host_sim
