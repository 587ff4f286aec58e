/// Error messages about files: composed where the fault is found, and completed with the file's name where that is known.
///
/// Pure functions; any thread; nothing allocates.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/fixed_string.hpp"

namespace tedavis::base {

using FaultText = FixedString<191>;

/// Returns "is damaged (offset 40); get a whole copy", to be appended to the file's name. Text that does not fit is cut.
[[nodiscard]] FaultText fault_text(std::string_view what, std::uint64_t offset, std::string_view remedy) noexcept;

/// Returns the part of a message after `start`, or an empty text where the message does not begin with it.
[[nodiscard]] std::string_view text_behind(std::string_view start, std::string_view message) noexcept;

}  // namespace tedavis::base
