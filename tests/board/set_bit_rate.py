#!/usr/bin/env python3
"""Sets the bit rate of a CAN controller and takes it up, as `ip link set IF type can bitrate RATE` does, where iproute2 is missing.

    set_bit_rate.py INTERFACE BITS_PER_SECOND

Needs the right to change network devices. Exit 0, or 1 with the kernel's reason. Standard library only.
"""
import os
import socket
import struct
import sys

# <linux/rtnetlink.h>, <linux/if_link.h>, <linux/can/netlink.h>
RTM_NEWLINK, NLMSG_ERROR, NLM_F_REQUEST, NLM_F_ACK = 16, 2, 1, 4
IFLA_LINKINFO, IFLA_INFO_KIND, IFLA_INFO_DATA, IFLA_CAN_BITTIMING = 18, 1, 2, 1
IFF_UP = 1


def attribute(kind, data):
    return struct.pack("=HH", 4 + len(data), kind) + data + bytes(-len(data) % 4)


def change_link(index, flags, attributes):
    """Changes an interface; raises OSError with the kernel's reason."""
    body = struct.pack("=BxHiII", socket.AF_UNSPEC, 0, index, flags, IFF_UP) + attributes
    header = struct.pack("=IHHII", 16 + len(body), RTM_NEWLINK, NLM_F_REQUEST | NLM_F_ACK, 1, 0)
    with socket.socket(socket.AF_NETLINK, socket.SOCK_RAW, socket.NETLINK_ROUTE) as kernel:
        kernel.settimeout(10)
        kernel.send(header + body)
        answer = kernel.recv(65536)
    kind, error = struct.unpack_from("=H", answer, 4)[0], struct.unpack_from("=i", answer, 16)[0]
    if kind != NLMSG_ERROR or error != 0:
        raise OSError(-error, os.strerror(-error))


def main():
    name, rate = sys.argv[1], int(sys.argv[2])
    timing = struct.pack("=8I", rate, 0, 0, 0, 0, 0, 0, 0)  # the kernel computes the rest
    info = attribute(IFLA_INFO_KIND, b"can") + attribute(IFLA_INFO_DATA, attribute(IFLA_CAN_BITTIMING, timing))
    try:
        index = socket.if_nametoindex(name)
        change_link(index, 0, attribute(IFLA_LINKINFO, info))
        change_link(index, IFF_UP, b"")
    except OSError as error:
        print(f"set_bit_rate: {name}: {error.strerror}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
