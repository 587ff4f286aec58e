/// Which program has a graphics card's screens (is its DRM master), so that this one cannot have them.
///
/// Thread  one. Memory  none of ours. Failure  what cannot be found out is left empty.
#pragma once

#include <string_view>

#include "render_core/base/error.hpp"
#include "render_core/base/fixed_string.hpp"

namespace tedavis::platform {

/// "Xorg (process 812), weston (process 900)": the programs that have this file open, but for this one and seat managers,
/// which open cards for others. Empty where there is none, or where this user may not see it. `processes` is /proc.
[[nodiscard]] base::FixedString<191> find_card_holders(const char* path, const char* processes = "/proc");

/// The sentence about a card, named "/dev/dri/card0 (virtio_gpu)", that other programs have.
[[nodiscard]] base::Error held_card_error(std::string_view card, std::string_view holders);

/// Whether another program has the card's screens now. Takes them for a moment to find out, where none has.
[[nodiscard]] bool is_card_held(const char* path);

}  // namespace tedavis::platform
