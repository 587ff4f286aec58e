/// What prevents the lines of a switch panel from being read, in one sentence with the remedy. The start and --probe say the
/// same.
///
/// Pure. Thread  any. Memory  none.
#pragma once

#include "bus/switches/switch_config.hpp"
#include "render_core/base/error.hpp"
#include "target/probe/gpio_inventory.hpp"

namespace tedavis::target {

/// Empty where the chip has the line and nobody uses it.
[[nodiscard]] base::Error switch_line_fault(const GpioInventory& inventory, const bus::SwitchLine& line);
/// That of the first line that has one; empty where all serve.
[[nodiscard]] base::Error panel_fault(const GpioInventory& inventory, const bus::SwitchConfig& panel);

/// Returns "panel (gpiochip0)"; without a label the name alone.
[[nodiscard]] base::FixedString<95> chip_text(const GpioChip& chip);
/// Returns "0 GROUND, 1 TAKEOFF (used by tedavis)"; what does not fit is "...".
[[nodiscard]] base::FixedString<511> lines_text(const GpioChip& chip);

}  // namespace tedavis::target
