/// A device as a shipped one, with budgets for another picture and other room. Pure; any thread.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "host_sim/device_plan/device_needs.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::host_sim {

/// What the user asks for.
struct DeviceAsk {
    std::string name;  ///< of the device, at most 31 letters
    PictureSize size;
    double rate_hz = 30;
    std::uint64_t memory_bytes = 0;  ///< of processor and GPU together
    std::string memory_text;         ///< as the user wrote it
};

/// What a device has room for; a plan gives up of it what its memory does not hold.
struct DeviceRoom {
    std::uint32_t slots = 0, attribute_pages = 0, drape_pages = 0;
    bool has_pictures = true;  ///< off screen
    bool is_traced = false;
};

/// Bytes by budget line, which a start has asked for.
using LineBytes = std::map<std::string, std::uint64_t, std::less<>>;

/// Of one shipped device: what is known of the starts of what is made of it.
struct DraftSource {
    effects::DeviceSettings shipped;
    LineBytes raised;                            ///< lines take so much at least
    std::map<bool, std::uint64_t> target_bytes;  ///< render_targets, by has_pictures; what is not there is not known
};

/// Before they are measured.
inline constexpr std::uint64_t kUnknownTargetBytes = std::uint64_t{1} << 30;

/// All that the needs ask for, with as many slots as the shipped device has for its pixels.
[[nodiscard]] DeviceRoom whole_room(const DraftSource& source, const DeviceAsk& ask, const DeviceNeeds& needs);
/// The fewest slots that a plan goes down to: roots, and some in view and beside it.
[[nodiscard]] std::uint32_t fewest_slots(const DeviceNeeds& needs);
[[nodiscard]] effects::DeviceSettings draft_device(const DraftSource& source, const DeviceAsk& ask, const DeviceNeeds& needs,
                                                   const DeviceRoom& room);
/// Of processor and GPU together.
[[nodiscard]] std::uint64_t total_bytes(const effects::DeviceSettings& device);

}  // namespace tedavis::host_sim
