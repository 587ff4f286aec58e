#include "bus/socketcan/raw_can_socket.hpp"

#include <linux/can.h>
#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "bus/socketcan/interface_check.hpp"

namespace tedavis::bus {
namespace {

template <class Value>
bool set_option(int descriptor, int level, int option, const Value& value) {
    return setsockopt(descriptor, level, option, &value, sizeof value) == 0;
}

bool set_filters(int descriptor, const SocketCanSettings& settings) {
    if (settings.filters.empty()) return true;
    std::array<can_filter, 512> filters{};
    for (std::size_t i = 0; i < settings.filters.size(); ++i)
        filters[i] = {settings.filters[i].identifier, settings.filters[i].mask};
    const auto bytes = static_cast<socklen_t>(settings.filters.size() * sizeof(can_filter));
    return setsockopt(descriptor, SOL_CAN_RAW, CAN_RAW_FILTER, filters.data(), bytes) == 0;
}

/// The forced buffer size needs a privilege; without it the system's limit holds, which is no failure.
void set_receive_buffer(int descriptor, int bytes) {
    if (!set_option(descriptor, SOL_SOCKET, SO_RCVBUFFORCE, bytes)) (void)set_option(descriptor, SOL_SOCKET, SO_RCVBUF, bytes);
}

const char* configure(int descriptor, const SocketCanSettings& settings) {
    constexpr can_err_mask_t kAllErrors = CAN_ERR_MASK;
    const int on = 1;
    if (!set_filters(descriptor, settings)) return "the kernel refuses the identifier filters";
    if (!set_option(descriptor, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, kAllErrors)) return "the kernel refuses the error filter";
    if (settings.can_fd && !set_option(descriptor, SOL_CAN_RAW, CAN_RAW_FD_FRAMES, on)) return "the kernel has no CAN FD";
    if (!set_option(descriptor, SOL_SOCKET, SO_TIMESTAMPNS, on)) return "the kernel gives no receive time stamps";
    if (!set_option(descriptor, SOL_SOCKET, SO_RXQ_OVFL, on)) return "the kernel does not count lost frames";
    set_receive_buffer(descriptor, static_cast<int>(settings.receive_buffer_bytes));
    return nullptr;
}

bool bind_to(int descriptor, unsigned interface_index) {
    sockaddr_can address{};
    address.can_family = AF_CAN;
    address.can_ifindex = static_cast<int>(interface_index);
    const void* plain = &address;
    return bind(descriptor, static_cast<const sockaddr*>(plain), sizeof address) == 0;
}

OpenedSocket failure(const SocketCanSettings& settings, const char* what) {
    OpenedSocket result;
    result.reason.append("CAN interface '");
    result.reason.append(settings.interface_name.view());
    result.reason.append("': ");
    result.reason.append(what);
    return result;
}

}  // namespace

bool add_identifier_filters(SocketCanSettings& settings, std::uint16_t identifier) {
    if (settings.filters.capacity() - settings.filters.size() < 2) return false;
    const bool eleven = settings.filters.try_push_back({identifier, CAN_EFF_FLAG | CAN_RTR_FLAG | CAN_SFF_MASK});
    return eleven && settings.filters.try_push_back({identifier | CAN_EFF_FLAG, CAN_EFF_FLAG | CAN_RTR_FLAG | 0xFFFFu});
}

OpenedSocket RawCanSocket::open(const SocketCanSettings& settings) {
    const int descriptor = socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW);
    if (descriptor < 0) {
        const bool absent = errno == EAFNOSUPPORT || errno == EPROTONOSUPPORT;
        return failure(settings, absent ? "this kernel has no CAN; load the modules can and can_raw (modprobe can_raw)"
                                        : "no socket can be opened");
    }
    const unsigned index = if_nametoindex(settings.interface_name.c_str());
    const char* fault =
        index == 0 ? "there is no such interface; check its name with `ip link`" : configure(descriptor, settings);
    if (fault == nullptr && !bind_to(descriptor, index)) fault = "the socket cannot be bound; is it a CAN interface?";
    if (fault == nullptr) return {descriptor, {}};
    close(descriptor);
    return failure(settings, fault);
}

SocketFaultText RawCanSocket::explain(const SocketCanSettings& settings) {
    InterfaceList list;
    list_interfaces(list);
    return interface_fault(list, settings.interface_name.view()).message.view();
}

}  // namespace tedavis::bus
