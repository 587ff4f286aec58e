/// Fits a device into a memory: reduces the capacities of a shipped device until a display starts with it.
///
/// Thread  one. Failure  throws UserError where no device fits into the memory, and what the starts throw.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/device_plan/device_draft.hpp"
#include "render_core/base/budget_shortage.hpp"

namespace tedavis::host_sim {

struct GivenUp {
    std::string what;         ///< "drape_pages", "attribute_pages", "off_screen_pictures", "traced_terrain" or "max_chunk_slots"
    std::uint64_t bytes = 0;  ///< bytes that it would need
    std::string sentence;
};

struct DevicePlan {
    effects::DeviceSettings device;
    std::string shipped;  ///< name of the device that it was made from
    std::vector<GivenUp> given_up;
    struct Larger {
        std::string name;
        std::uint64_t bytes = 0;
    };
    std::vector<Larger> larger;  ///< shipped devices that do not fit into the memory, with the bytes that they would need
};

struct StartedDevice {
    std::optional<base::BudgetShortage> shortage;  ///< nothing: it has started
    base::BudgetTable used;                        ///< after a start, the used bytes of each line
};
/// Starts a display on the device.
using DeviceStart = std::function<StartedDevice(const effects::DeviceSettings&)>;

/// Returns the first of the shipped devices, which are in the order from the largest, that fits completely; else the last one
/// with reduced capacities. More memory never gives fewer slots. A display has been started with the result.
[[nodiscard]] DevicePlan plan_device(const std::vector<effects::DeviceSettings>& shipped, const DeviceAsk& ask,
                                     const DeviceNeeds& needs, const DeviceStart& start);

}  // namespace tedavis::host_sim
