#include "bus/socketcan/interface_check.hpp"

namespace tedavis::bus {
namespace {

constexpr std::string_view kNoCan = "this kernel has no CAN; load the modules can and can_raw (modprobe can_raw)";

using LinkText = base::FixedString<255>;

LinkText can_interfaces_text(const InterfaceList& list) {
    LinkText text;
    for (const NetInterface& link : list.interfaces) {
        if (!link.is_can) continue;
        if (!text.empty()) text.append(", ");
        text.append(link.name.view());
    }
    if (text.empty()) text.append("none");
    return text;
}

const NetInterface* find_link(const InterfaceList& list, std::string_view name) {
    for (const NetInterface& link : list.interfaces)
        if (link.name.view() == name) return &link;
    return nullptr;
}

base::Error link_error(std::string_view name, std::initializer_list<std::string_view> what) {
    base::Error error = base::make_error("CAN interface '", name, "': ");
    error.message.append(base::make_error(what).message.view());
    return error;
}

bool is_controller(const NetInterface& link) { return link.kind.view() == "can"; }

/// A serial adapter (slcan) lists its rates and refuses restart-ms.
std::string_view switched_on(const NetInterface& link) { return link.has_listed_rates ? " up" : " up type can restart-ms 100"; }

base::Error down_error(const NetInterface& link) {
    const std::string_view name = link.name.view();
    if (!is_controller(link)) return link_error(name, {"is down; switch it on: ip link set ", name, " up"});
    if (link.bit_rate_hz != 0) return link_error(name, {"is down; switch it on: ip link set ", name, switched_on(link)});
    return link_error(
        name, {"is down and has no bit rate; set the rate of the bus, for example: ip link set ", name,
               " up type can bitrate 1000000 restart-ms 100",
               link.has_listed_rates ? "; a serial adapter that got its rate already (slcand -s8) needs only: ip link set " : "",
               link.has_listed_rates ? name : "", link.has_listed_rates ? " up" : ""});
}

base::Error bus_off_error(const NetInterface& link) {
    const std::string_view name = link.name.view();
    if (link.restart_ms != 0)
        return link_error(name, {"is bus-off and tries again every ", base::digits(link.restart_ms).view(),
                                 " ms; check wiring, termination, and that all nodes have the bit rate ",
                                 base::digits(link.bit_rate_hz).view()});
    return link_error(name, {"is bus-off and stays so (restart-ms 0); check wiring and bit rate, then: ip link set ", name,
                             " down; ip link set ", name, switched_on(link)});
}

const char* to_text(ControllerState state) {
    switch (state) {
        case ControllerState::active: return "error-active";
        case ControllerState::warning: return "error-warning";
        case ControllerState::passive: return "error-passive";
        case ControllerState::bus_off: return "bus-off";
        case ControllerState::stopped: return "stopped";
        case ControllerState::sleeping: return "sleeping";
        case ControllerState::unknown: break;
    }
    return "state not known";
}

}  // namespace

base::Error interface_fault(const InterfaceList& list, std::string_view name) {
    if (!list.has_can) return link_error(name, {kNoCan});
    if (!list.is_read) return {};
    const NetInterface* const link = find_link(list, name);
    if (link == nullptr)
        return link_error(name, {"there is no such interface; CAN interfaces here: ", can_interfaces_text(list).view(),
                                 "; correct 'interface' of [can], or load the driver"});
    if (!link->is_can)
        return link_error(name, {"is no CAN interface; CAN interfaces here: ", can_interfaces_text(list).view(),
                                 "; correct 'interface' of [can]"});
    if (!link->is_up) return down_error(*link);
    if (link->state == ControllerState::bus_off) return bus_off_error(*link);
    if (link->state == ControllerState::passive)
        return link_error(name, {"is error-passive: its frames find no acknowledgement or arrive damaged; check wiring, "
                                 "termination, and that all nodes have the bit rate ",
                                 base::digits(link->bit_rate_hz).view()});
    return {};
}

base::FixedString<127> interface_text(const NetInterface& link) {
    base::FixedString<127> text(link.kind.empty() ? std::string_view("no kind named") : link.kind.view());
    text.append(link.is_up ? ", up" : ", down");
    if (!is_controller(link)) return text;
    text.append(", ");
    if (link.bit_rate_hz == 0) {
        text.append("no bit rate known");
    } else {
        text.append(base::digits(link.bit_rate_hz).view());
        text.append(" bit/s");
    }
    text.append(", ");
    text.append(to_text(link.state));
    text.append(link.restart_ms == 0 ? ", bus-off lasts (restart-ms 0)" : ", restart after ");
    if (link.restart_ms == 0) return text;
    text.append(base::digits(link.restart_ms).view());
    text.append(" ms");
    return text;
}

}  // namespace tedavis::bus
