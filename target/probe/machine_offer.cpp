#include "target/probe/machine_offer.hpp"

#include <memory>
#include <new>

#include "bus/socketcan/interface_check.hpp"
#include "platform/egl_kms/screen_choice.hpp"
#include "platform/surface_factory.hpp"
#include "target/probe/switch_faults.hpp"
#include "target/self_test.hpp"

namespace tedavis::target {
namespace {

void add_entry(std::string_view name, std::initializer_list<std::string_view> parts, SelfTestReport& report) {
    report.add(name, true, base::make_error(parts).message.view());
}

void add_card(const platform::ScreenCard& card, SelfTestReport& report) {
    const bool serves = card.access == platform::CardAccess::open;
    if (!serves) return add_entry("card", {platform::card_error(card).message.view()}, report);
    add_entry("card",
              {platform::card_text(card).view(), ": ", base::digits(card.connectors.size()).view(),
               card.connectors.size() == 1 ? " connector" : " connectors"},
              report);
    for (const platform::ScreenConnector& connector : card.connectors) {
        if (!connector.is_connected)
            add_entry("connector", {connector.name.view(), " of ", card.path.view(), ": not connected"}, report);
        else
            add_entry("connector",
                      {connector.name.view(), " of ", card.path.view(), ": ", platform::modes_text(connector).view()}, report);
    }
}

base::FixedString<383> gl_text(base::Surface& surface) {
    constexpr unsigned kRenderer = 0x1F01, kVersion = 0x1F02;  // GL_RENDERER, GL_VERSION
    using GetString = const unsigned char* (*)(unsigned);
    base::FixedString<383> text;
    const auto get_string = reinterpret_cast<GetString>(surface.proc_address("glGetString"));
    if (get_string == nullptr) return "a driver without glGetString";
    for (const unsigned name : {kRenderer, kVersion}) {
        const auto* const value = reinterpret_cast<const char*>(get_string(name));
        if (!text.empty()) text.append(", ");
        text.append(value != nullptr ? value : "no name");
    }
    return text;
}

void add_gl_lane(const char* lane_name, platform::ContextLane lane, SelfTestReport& report) {
    constexpr std::uint32_t kSidePx = 64;
    auto surface = platform::make_surface("egl", {kSidePx, kSidePx, lane});
    if (!surface.ok()) return add_entry("gl", {lane_name, ": ", surface.error().message.view()}, report);
    if (!surface.value()->make_current()) return add_entry("gl", {lane_name, ": the surface cannot be made current"}, report);
    add_entry("gl", {lane_name, ", off-screen: ", gl_text(*surface.value()).view()}, report);
    surface.value()->release_current();
}

}  // namespace

void add_screens(const platform::ScreenInventory& inventory, SelfTestReport& report) {
    for (const platform::ScreenCard& card : inventory.cards) add_card(card, report);
    if (inventory.cards.empty()) add_entry("card", {"none that the kernel drives (nothing in /dev/dri)"}, report);
}

void add_can_interfaces(const bus::InterfaceList& list, SelfTestReport& report) {
    bool has_any = false;
    for (const bus::NetInterface& link : list.interfaces) {
        if (!link.is_can) continue;
        has_any = true;
        const base::Error fault = bus::interface_fault(list, link.name.view());
        add_entry("can_interface",
                  {link.name.view(), ": ", bus::interface_text(link).view(), fault ? "; " : "", fault.message.view()}, report);
    }
    if (!list.has_can)
        add_entry("can_interface", {"none: this kernel has no CAN; load the modules can and can_raw (modprobe can_raw)"}, report);
    else if (!has_any)
        add_entry("can_interface",
                  {list.is_read ? "none; load its driver, or for a trial: ip link add vcan0 up type vcan"
                                : "the kernel does not list its interfaces"},
                  report);
}

void add_gpio_chips(const GpioInventory& inventory, SelfTestReport& report) {
    for (const GpioChip& chip : inventory.chips) {
        if (chip.may_open)
            add_entry("gpio_chip", {chip_text(chip).view(), ": ", lines_text(chip).view()}, report);
        else
            add_entry("gpio_chip",
                      {"/dev/", chip.name.view(), ": may not be opened; it belongs to the group ", chip.group.view()}, report);
    }
    if (inventory.chips.empty()) add_entry("gpio_chip", {"none (nothing in /dev/gpiochip*)"}, report);
}

void add_gl(SelfTestReport& report) {
    add_gl_lane("es3", platform::ContextLane::es3, report);
    add_gl_lane("es2", platform::ContextLane::es2, report);
}

void list_offer(const ProbePorts& ports, SelfTestReport& report) {
    const std::unique_ptr<platform::ScreenInventory> screens(new (std::nothrow) platform::ScreenInventory());
    const std::unique_ptr<GpioInventory> gpio(new (std::nothrow) GpioInventory());
    if (screens == nullptr || gpio == nullptr) return add_entry("memory", {"none for the lists; free some"}, report);
    ports.list_screens({}, *screens);
    if (ports.has_screens)
        add_screens(*screens, report);
    else
        add_entry("card", {"this build shows nothing on a screen"}, report);
    add_gl(report);
    bus::InterfaceList interfaces;
    ports.list_interfaces(interfaces);
    add_can_interfaces(interfaces, report);
    ports.list_gpio(*gpio);
    add_gpio_chips(*gpio, report);
}

void print_offer(const SelfTestReport& report, bool json, std::FILE* out) {
    if (json) return print_checks(report, "probe", json, out);
    for (const SelfCheck& check : report.checks()) std::fprintf(out, "%-16s %s\n", check.name.c_str(), check.finding.c_str());
}

}  // namespace tedavis::target
