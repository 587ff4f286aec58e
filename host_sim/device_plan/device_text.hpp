/// A device as a file, and a plan as JSON. Pure; any thread.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host_sim/device_plan/device_plan.hpp"

namespace tedavis::host_sim {

/// A device file (configs/devices) that reads back as the same device, without costs. `comment`: its first lines, without marks.
[[nodiscard]] std::string device_text(const effects::DeviceSettings& device, const std::string& comment);

/// All of a plan; `memory_bytes`: what it was to fit.
[[nodiscard]] nlohmann::ordered_json plan_json(const DevicePlan& plan, std::uint64_t memory_bytes);
/// The same in some lines for the user.
[[nodiscard]] std::string plan_text(const DevicePlan& plan, std::uint64_t memory_bytes);

}  // namespace tedavis::host_sim
