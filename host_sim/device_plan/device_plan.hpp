/// Fits a device to a memory: takes a shipped device, and gives up what the memory does not hold, until a start proves it.
///
/// Thread  one. Failure  UserError where the memory holds no device, and what the starts throw.
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
    std::uint64_t bytes = 0;  ///< that it would take
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
    std::vector<Larger> larger;  ///< shipped devices that the memory does not hold, with what they would take
};

struct StartedDevice {
    std::optional<base::BudgetShortage> shortage;  ///< nothing: it has started
    base::BudgetTable used;                        ///< then what was taken of each line
};
/// Starts a display on the device.
using DeviceStart = std::function<StartedDevice(const effects::DeviceSettings&)>;

/// Of the shipped devices, largest first, the first that the memory holds whole; else what it holds of the last. More memory
/// never gives fewer slots. What is returned has been started.
[[nodiscard]] DevicePlan plan_device(const std::vector<effects::DeviceSettings>& shipped, const DeviceAsk& ask,
                                     const DeviceNeeds& needs, const DeviceStart& start);

}  // namespace tedavis::host_sim
