/// The reason for a failure: one message that says what is wrong, where, and what to do. An empty message means success.
///
/// Memory: inside the object, no heap; text beyond the capacity is cut off. May be used on any thread.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "render_core/base/fixed_string.hpp"

namespace tedavis::base {

struct Error {
    FixedString<1535> message;  ///< a shader compiler's message may be long

    /// True where there is an error.
    [[nodiscard]] explicit operator bool() const { return !message.empty(); }
};

/// Joins the parts into one message.
[[nodiscard]] Error make_error(std::initializer_list<std::string_view> parts);
template <class... Parts>
[[nodiscard]] Error make_error(const Parts&... parts) {
    return make_error({std::string_view(parts)...});
}

/// Formats a number in decimal digits, for messages.
[[nodiscard]] FixedString<20> digits(std::uint64_t value);

}  // namespace tedavis::base
