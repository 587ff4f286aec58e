/// Why a GL object could not be made: one sentence, what and what to do.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/fixed_string.hpp"

namespace tedavis::gl {

struct GlError {
    base::FixedString<1023> sentence;  ///< a compiler's message may be long
};

/// The parts joined; a part that does not fit is cut.
[[nodiscard]] GlError make_error(std::string_view a, std::string_view b = {}, std::string_view c = {}, std::string_view d = {});
/// Decimal digits.
[[nodiscard]] base::FixedString<20> digits(std::uint64_t value);

}  // namespace tedavis::gl
