/// Port: what --probe reads from the machine. Tests play machines that they do not run on.
#pragma once

#include <string_view>

#include "bus/socketcan/interface_list.hpp"
#include "bus/switches/switch_config.hpp"
#include "platform/egl_kms/screen_inventory.hpp"
#include "platform/egl_kms/seat_offer.hpp"
#include "render_core/base/error.hpp"
#include "target/probe/gpio_inventory.hpp"

namespace tedavis::target {

/// Every function replaces the list that it is given, by facts of this moment.
struct ProbePorts {
    bool has_screens = true;  ///< false: this build shows nothing on a screen
    void (*list_screens)(std::string_view path, platform::ScreenInventory& inventory) = nullptr;
    bool (*is_card_held)(const char* path) = nullptr;  ///< by another program
    base::FixedString<191> (*card_holders)(const char* path) = nullptr;
    platform::SeatOffer (*find_seat)() = nullptr;
    void (*list_interfaces)(bus::InterfaceList& list) = nullptr;
    void (*list_gpio)(GpioInventory& inventory) = nullptr;
};

[[nodiscard]] ProbePorts machine_probe_ports();

/// Says why the lines of a panel cannot be read here; empty where nothing is wrong. Start-up only (allocates).
[[nodiscard]] base::Error explain_panel(const bus::SwitchConfig& panel);

}  // namespace tedavis::target
