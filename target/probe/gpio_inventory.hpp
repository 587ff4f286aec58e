/// The GPIO chips of this machine with their lines, as plain lists of fixed capacity, read from the kernel without a library.
///
/// Thread  any. Memory  the list is large: keep it on the heap, at start-up only. Failure  what cannot be read says so in the
/// list.
#pragma once

#include <cstdint>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"

namespace tedavis::target {

/// Its number on the chip is its place in the list.
struct GpioLine {
    base::FixedString<31> name;      ///< empty: the chip gives it none
    base::FixedString<31> consumer;  ///< who uses it, as that one says; may be empty
    bool is_used = false;
};

struct GpioChip {
    base::FixedString<31> name;   ///< "gpiochip0"
    base::FixedString<31> label;  ///< empty where the chip may not be opened
    base::FixedString<31> group;  ///< that the file belongs to, where this user may not open it; empty: not known
    bool may_open = false;
    std::uint32_t line_count = 0;
    base::FixedVector<GpioLine, 256> lines;  ///< the first ones
};

struct GpioInventory {
    base::FixedVector<GpioChip, 24> chips;
};

/// Every chip of `folder`, in the order of their numbers.
void list_gpio(GpioInventory& inventory, const char* folder = "/dev");

}  // namespace tedavis::target
