#include "target/probe/probe_board.hpp"

#include <memory>
#include <new>

#include "bus/socketcan/interface_check.hpp"
#include "platform/egl_kms/card_holder.hpp"
#include "platform/egl_kms/screen_choice.hpp"
#include "target/board_display.hpp"
#include "target/probe/machine_offer.hpp"
#include "target/probe/switch_faults.hpp"
#include "target/self_test/board_checks.hpp"

namespace tedavis::target {
namespace {

constexpr std::string_view kNoMemory = "no memory for the list of what is here; free some";

/// The fault of the screen that was chosen; empty where it is free.
base::Error held_fault(const platform::ScreenCard& card, const ProbePorts& ports) {
    if (!ports.is_card_held(card.path.c_str())) return {};
    return platform::held_card_error(platform::card_text(card).view(), ports.card_holders(card.path.c_str()).view());
}

/// What is wrong, without the name of the line.
std::string_view behind_the_name(const base::Error& fault) {
    const std::string_view text = fault.message.view();
    const std::size_t end = text.find("': ");
    return end == std::string_view::npos ? text : text.substr(end);
}

/// Whether a line before the n-th has the same fault: a chip that is missing is told once.
bool is_of_a_line_before(const GpioInventory& inventory, const bus::SwitchConfig& panel, std::size_t n) {
    const base::Error fault = switch_line_fault(inventory, panel.lines[n]);
    for (std::size_t before = 0; before < n; ++before) {
        const base::Error other = switch_line_fault(inventory, panel.lines[before]);
        if (other && behind_the_name(other) == behind_the_name(fault)) return true;
    }
    return false;
}

base::Error chosen_screen_text(const platform::ScreenInventory& inventory, const platform::ScreenChoice& choice) {
    const platform::ScreenCard& card = inventory.cards[choice.card];
    const platform::ScreenMode& mode = choice.mode;
    return base::make_error(card.connectors[choice.connector].name.view(), " of ", platform::card_text(card).view(), ", ",
                            platform::mode_text(mode.width_px, mode.height_px, mode.refresh_mhz).view());
}

/// Without a manager the program opens the card itself, which is no fault.
base::Error seat_text(const platform::SeatOffer& offer) {
    if (offer.text.empty()) return base::make_error("no seat manager; the program opens the card itself");
    return base::make_error(
        offer.text.view(), offer.is_there ? " would open the card" : "; the program opens the card itself as long as this is so");
}

}  // namespace

bool probe_screen(const BoardSettings& settings, const ProbePorts& ports, SelfTestReport& report) {
    if (!ports.has_screens) {
        report.add("screen", false,
                   "this build shows nothing on a screen; install libgbm-dev and libdrm-dev and build again, or use backend = "
                   "\"egl\"");
        return false;
    }
    const std::unique_ptr<platform::ScreenInventory> inventory(new (std::nothrow) platform::ScreenInventory());
    if (inventory == nullptr) {
        report.add("screen", false, kNoMemory);
        return false;
    }
    ports.list_screens(settings.screen.path.view(), *inventory);
    const auto choice = platform::choose_screen(*inventory, settings.screen, settings.width_px, settings.height_px);
    base::Error error = choice.ok() ? held_fault(inventory->cards[choice.value().card], ports) : choice.error().error;
    if (error) error.message = base::make_error("[surface]: ", error.message.view()).message;
    const bool holds = !error;
    report.add("screen", holds, (holds ? chosen_screen_text(*inventory, choice.value()) : error).message.view());
    report.add("seat", true, seat_text(ports.find_seat()).message.view());
    add_screens(*inventory, report);
    return holds;
}

void probe_can(const BoardSettings& settings, const ProbePorts& ports, SelfTestReport& report) {
    bus::InterfaceList list;
    ports.list_interfaces(list);
    const std::string_view name = settings.can.interface_name.view();
    if (!list.is_read)
        return report.add("can", false, "the kernel does not list its interfaces; run --probe with access to netlink sockets");
    const base::Error fault = bus::interface_fault(list, name);
    if (fault) return report.add("can", false, fault.message.view());
    for (const bus::NetInterface& link : list.interfaces)
        if (link.name.view() == name)
            report.add("can", true, base::make_error(name, ": ", bus::interface_text(link).view()).message.view());
}

void probe_switches(const BoardSettings& settings, const ProbePorts& ports, SelfTestReport& report) {
    const std::unique_ptr<GpioInventory> inventory(new (std::nothrow) GpioInventory());
    if (inventory == nullptr) return report.add("switches", false, kNoMemory);
    ports.list_gpio(*inventory);
    std::uint64_t faults = 0;
    for (std::size_t n = 0; n < settings.switches.lines.size(); ++n) {
        const base::Error fault = switch_line_fault(*inventory, settings.switches.lines[n]);
        if (!fault) continue;
        ++faults;
        if (!is_of_a_line_before(*inventory, settings.switches, n)) report.add("switches", false, fault.message.view());
    }
    const base::FixedString<20> lines = base::digits(settings.switches.lines.size());
    if (faults == 0)
        return report.add("switches", true, base::make_error(lines.view(), " lines, all there and free").message.view());
    const auto serving = base::digits(settings.switches.lines.size() - faults);
    report.add("switches", false, base::make_error(serving.view(), " of ", lines.view(), " lines serve").message.view());
}

void probe_board(const BoardSettings& settings, const ProbePorts& ports, SelfTestReport& report) {
    const bool has_screen = !is_on_screen(settings) || probe_screen(settings, ports, report);
    probe_can(settings, ports, report);
    if (settings.has_switches) probe_switches(settings, ports, report);
    check_board(settings, report, {BoardReading::headers, !has_screen});
}

}  // namespace tedavis::target
