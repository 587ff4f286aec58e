#include "bus/socketcan/interface_list.hpp"

#include <linux/can.h>
#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace tedavis::bus {
namespace {

using Bytes = base::Span<const unsigned char>;

constexpr unsigned short kArpTypeCan = 280;  // ARPHRD_CAN of <linux/if_arp.h>, which does not go together with <net/if.h>

constexpr std::size_t aligned(std::size_t bytes) { return (bytes + 3) & ~std::size_t{3}; }

template <class Value>
bool take_front(Bytes bytes, Value& value) {
    if (bytes.size() < sizeof value) return false;
    std::memcpy(&value, bytes.data(), sizeof value);
    return true;
}

Bytes behind(Bytes bytes, std::size_t count) {
    return count < bytes.size() ? Bytes(bytes.data() + count, bytes.size() - count) : Bytes();
}

/// Calls `take(type, payload)` for each attribute that lies inside.
template <class Take>
void each_attribute(Bytes bytes, Take take) {
    rtattr head{};
    while (take_front(bytes, head) && head.rta_len >= sizeof head && head.rta_len <= bytes.size()) {
        take(head.rta_type & NLA_TYPE_MASK, Bytes(bytes.data() + sizeof head, head.rta_len - sizeof head));
        bytes = behind(bytes, aligned(head.rta_len));
    }
}

base::FixedString<15> link_text(Bytes bytes) {
    std::size_t length = 0;
    while (length < bytes.size() && bytes[length] != 0) ++length;
    return std::string_view(reinterpret_cast<const char*>(bytes.data()), length);
}

ControllerState state_of(std::uint32_t kernel_state) {
    switch (kernel_state) {
        case CAN_STATE_ERROR_ACTIVE: return ControllerState::active;
        case CAN_STATE_ERROR_WARNING: return ControllerState::warning;
        case CAN_STATE_ERROR_PASSIVE: return ControllerState::passive;
        case CAN_STATE_BUS_OFF: return ControllerState::bus_off;
        case CAN_STATE_STOPPED: return ControllerState::stopped;
        case CAN_STATE_SLEEPING: return ControllerState::sleeping;
        default: return ControllerState::unknown;
    }
}

void take_controller(Bytes data, NetInterface& into) {
    constexpr std::uint32_t kUnknownRate = UINT32_MAX;  // a serial adapter that was told no rate
    each_attribute(data, [&into](int type, Bytes payload) {
        can_bittiming timing{};
        std::uint32_t number = 0;
        if (type == IFLA_CAN_BITTIMING && take_front(payload, timing) && timing.bitrate != kUnknownRate)
            into.bit_rate_hz = timing.bitrate;
        if (type == IFLA_CAN_BITRATE_CONST) into.has_listed_rates = true;
        if (type == IFLA_CAN_STATE && take_front(payload, number)) into.state = state_of(number);
        if (type == IFLA_CAN_RESTART_MS && take_front(payload, number)) into.restart_ms = number;
    });
}

/// The kernel writes the kind before the data; data of another kind are not a controller's.
void take_link_info(Bytes info, NetInterface& into) {
    each_attribute(info, [&into](int type, Bytes payload) {
        if (type == IFLA_INFO_KIND) into.kind = link_text(payload);
        if (type == IFLA_INFO_DATA && into.kind.view() == "can") take_controller(payload, into);
    });
}

void add_link(Bytes message, InterfaceList& list) {
    ifinfomsg head{};
    if (!take_front(message, head)) return;
    NetInterface link;
    link.is_can = head.ifi_type == kArpTypeCan;
    link.is_up = (head.ifi_flags & IFF_UP) != 0;
    link.has_carrier = (head.ifi_flags & IFF_RUNNING) != 0;
    each_attribute(behind(message, aligned(sizeof head)), [&link](int type, Bytes payload) {
        if (type == IFLA_IFNAME) link.name = link_text(payload);
        if (type == IFLA_LINKINFO) take_link_info(payload, link);
    });
    if (!link.name.empty()) static_cast<void>(list.interfaces.try_push_back(link));
}

bool ask_for_links(int descriptor) {
    struct {
        nlmsghdr head;
        ifinfomsg link;
    } request{};
    request.head.nlmsg_len = sizeof request;
    request.head.nlmsg_type = RTM_GETLINK;
    request.head.nlmsg_flags = NLM_F_REQUEST | NLM_F_DUMP;
    request.link.ifi_family = AF_UNSPEC;
    return ::send(descriptor, &request, sizeof request, 0) == static_cast<ssize_t>(sizeof request);
}

bool read_links(int descriptor, InterfaceList& list) {
    alignas(nlmsghdr) unsigned char bytes[32768];  // the kernel fills at most this much at a time
    for (;;) {
        const ssize_t size = ::recv(descriptor, bytes, sizeof bytes, 0);
        if (size <= 0) return false;
        const LinkMessages read = add_links({bytes, static_cast<std::size_t>(size)}, list);
        if (read != LinkMessages::go_on) return read == LinkMessages::ended;
    }
}

/// Asking for one loads the modules, where the system lets it.
bool has_can_sockets() {
    const int descriptor = ::socket(PF_CAN, SOCK_RAW | SOCK_CLOEXEC, CAN_RAW);
    if (descriptor < 0) return errno != EAFNOSUPPORT && errno != EPROTONOSUPPORT;
    ::close(descriptor);
    return true;
}

}  // namespace

LinkMessages add_links(base::Span<const unsigned char> answer, InterfaceList& list) {
    while (!answer.empty()) {
        nlmsghdr head{};
        if (!take_front(answer, head) || head.nlmsg_len < sizeof head || head.nlmsg_len > answer.size())
            return LinkMessages::damaged;
        if (head.nlmsg_type == NLMSG_DONE) return LinkMessages::ended;
        if (head.nlmsg_type == NLMSG_ERROR) return LinkMessages::damaged;
        if (head.nlmsg_type == RTM_NEWLINK) add_link({answer.data() + sizeof head, head.nlmsg_len - sizeof head}, list);
        answer = behind(answer, aligned(head.nlmsg_len));
    }
    return LinkMessages::go_on;
}

void list_interfaces(InterfaceList& list) {
    list = InterfaceList();
    list.has_can = has_can_sockets();
    const int descriptor = ::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE);
    if (descriptor < 0) return;
    const timeval limit{0, 20'000};  // the kernel answers at once; a frame may be waiting
    if (::setsockopt(descriptor, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit) == 0 && ask_for_links(descriptor))
        list.is_read = read_links(descriptor, list);
    ::close(descriptor);
}

}  // namespace tedavis::bus
