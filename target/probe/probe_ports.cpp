#include "target/probe/probe_ports.hpp"

#include <memory>
#include <new>

#include "platform/egl_kms/card_holder.hpp"
#include "platform/egl_kms/drm_inventory.hpp"
#include "target/probe/switch_faults.hpp"

namespace tedavis::target {

ProbePorts machine_probe_ports() {
    ProbePorts ports;
    ports.has_screens = platform::can_list_screens();
    ports.list_screens = [](std::string_view path, platform::ScreenInventory& inventory) {
        platform::list_screens(path, inventory);
    };
    ports.is_card_held = &platform::is_card_held;
    ports.card_holders = [](const char* path) { return platform::find_card_holders(path); };
    ports.find_seat = [] { return platform::find_seat(); };
    ports.list_interfaces = &bus::list_interfaces;
    ports.list_gpio = [](GpioInventory& inventory) { list_gpio(inventory); };
    return ports;
}

base::Error explain_panel(const bus::SwitchConfig& panel) {
    const std::unique_ptr<GpioInventory> inventory(new (std::nothrow) GpioInventory());
    if (inventory == nullptr) return {};
    list_gpio(*inventory);
    return panel_fault(*inventory, panel);
}

}  // namespace tedavis::target
