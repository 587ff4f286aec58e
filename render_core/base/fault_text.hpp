/// Sentences about files, put together where the fault is found and completed with a name where the name is known.
///
/// Pure functions; any thread; nothing allocates.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/fixed_string.hpp"

namespace tedavis::base {

using FaultText = FixedString<191>;

/// "is damaged (offset 40); get a whole copy", to be put behind the file's name. What does not fit is cut.
[[nodiscard]] FaultText fault_text(std::string_view what, std::uint64_t offset, std::string_view remedy) noexcept;

/// What a sentence says behind `start`; empty where it does not begin so.
[[nodiscard]] std::string_view text_behind(std::string_view start, std::string_view sentence) noexcept;

}  // namespace tedavis::base
