/// Why something of the machine is not to be had: one sentence, what and what to do.
#pragma once

#include <string_view>

#include "render_core/base/fixed_string.hpp"

namespace tedavis::platform {

struct PlatformError {
    base::FixedString<383> sentence;
};

/// The parts joined; a part that does not fit is cut.
[[nodiscard]] inline PlatformError make_platform_error(std::string_view a, std::string_view b = {}, std::string_view c = {},
                                                       std::string_view d = {}) {
    PlatformError error;
    for (std::string_view part : {a, b, c, d}) error.sentence.append(part);
    return error;
}

}  // namespace tedavis::platform
