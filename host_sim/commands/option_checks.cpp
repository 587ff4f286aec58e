#include "host_sim/commands/option_checks.hpp"

#include <cmath>
#include <cstdlib>
#include <string>

namespace tedavis::host_sim {

CLI::Validator above_zero() {
    return {[](std::string& text) {
                const double value = std::strtod(text.c_str(), nullptr);
                return value > 0 && std::isfinite(value) ? std::string() : text + " is no number above zero";
            },
            "above 0"};
}

CLI::Validator from_zero() {
    return {[](std::string& text) {
                return std::strtod(text.c_str(), nullptr) >= 0 ? std::string() : text + " is no number from 0 on";
            },
            "from 0"};
}

}  // namespace tedavis::host_sim
