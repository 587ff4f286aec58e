/// Lists the graphics cards of this machine with their screens.
///
/// Thread  one. Memory  allocates inside libdrm only (start-up). Failure  what cannot be read says so in the list.
#pragma once

#include <string_view>

#include "platform/egl_kms/screen_inventory.hpp"

namespace tedavis::platform {

/// False where libdrm was missing at the build: every list is empty then.
[[nodiscard]] bool can_list_screens();

/// With a `path` the list holds this card alone, else every card of `folder`, in the order of their numbers. Each screen is asked
/// for its modes anew, which may take a tenth of a second a screen.
void list_screens(std::string_view path, ScreenInventory& inventory, const char* folder = "/dev/dri");

}  // namespace tedavis::platform
