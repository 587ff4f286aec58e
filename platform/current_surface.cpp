#include "platform/current_surface.hpp"

namespace tedavis::platform {
namespace {

thread_local const base::Surface* current = nullptr;

}  // namespace

bool claim_current(const base::Surface* surface) noexcept {
    if (current != nullptr && current != surface) return false;
    current = surface;
    return true;
}

void drop_current(const base::Surface* surface) noexcept {
    if (current == surface) current = nullptr;
}

bool is_current(const base::Surface* surface) noexcept { return current == surface; }

bool any_current() noexcept { return current != nullptr; }

}  // namespace tedavis::platform
