/// Derives a device from a shipped one, with budgets for another picture size and other capacities. Pure; any thread.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "host_sim/device_plan/device_needs.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::host_sim {

/// The user's request.
struct DeviceAsk {
    std::string name;  ///< of the device, at most 31 letters
    PictureSize size;
    double rate_hz = 30;
    std::uint64_t memory_bytes = 0;  ///< of processor and GPU together
    std::string memory_text;         ///< as the user wrote it
};

/// The capacities of a device, which a plan reduces until they fit into the memory.
struct DeviceRoom {
    std::uint32_t slots = 0, attribute_pages = 0, drape_pages = 0;
    bool has_pictures = true;  ///< room for off-screen pictures
    bool is_traced = false;
};

/// Bytes by budget line that a start of the display requested.
using LineBytes = std::map<std::string, std::uint64_t, std::less<>>;

/// A shipped device, and what starts of devices derived from it have shown.
struct DraftSource {
    effects::DeviceSettings shipped;
    LineBytes raised;                            ///< least bytes of each line
    std::map<bool, std::uint64_t> target_bytes;  ///< bytes of render_targets by has_pictures; a missing entry is not known
};

/// Value of target_bytes before it is measured.
inline constexpr std::uint64_t kUnknownTargetBytes = std::uint64_t{1} << 30;

/// Returns the room for all needs, with as many slots per pixel as the shipped device.
[[nodiscard]] DeviceRoom whole_room(const DraftSource& source, const DeviceAsk& ask, const DeviceNeeds& needs);
/// The least number of slots of a plan: for the roots, and some in view and beside it.
[[nodiscard]] std::uint32_t fewest_slots(const DeviceNeeds& needs);
[[nodiscard]] effects::DeviceSettings draft_device(const DraftSource& source, const DeviceAsk& ask, const DeviceNeeds& needs,
                                                   const DeviceRoom& room);
/// Budgeted bytes of processor and GPU together.
[[nodiscard]] std::uint64_t total_bytes(const effects::DeviceSettings& device);

}  // namespace tedavis::host_sim
