/// `tedavis device plan`: writes a device file whose budgets fit into a given memory.
#pragma once

#include <optional>
#include <string>

#include "host_sim/console.hpp"
#include "host_sim/options/picture_options.hpp"
#include "render_core/effects/device_capability.hpp"

namespace tedavis::host_sim {

struct DevicePlanOptions {
    std::string output;  ///< the device file (.toml)
    std::string memory;  ///< "64M": bytes of processor and GPU together, or a number with K, M or G of 1024
    double rate_hz = 30;
    std::optional<effects::Lane> lane;  ///< nothing: that of the largest shipped device that fits into the memory
    PictureOptions picture;             ///< size, design, terrain and scene
};

/// "64M" in bytes. Throws UserError.
[[nodiscard]] std::uint64_t memory_from(const std::string& text);

/// Writes the file only after a display was started with it. Returns the exit code; throws UserError and Interrupted.
[[nodiscard]] int run_device_plan(const DevicePlanOptions& options, Console& console);

}  // namespace tedavis::host_sim
