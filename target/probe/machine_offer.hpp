/// `tedavis-display --probe` without a board file: what this machine has for a board file to name.
///
/// Entries: card, connector, gl, can_interface, gpio_chip; one each, or one that says that there is none. Nothing of this is a
/// fault, so that every entry holds.
///
/// Thread  one; makes and releases a headless surface. Memory  start-up only.
#pragma once

#include <cstdio>

#include "target/probe/probe_ports.hpp"
#include "target/self_test/self_test_report.hpp"

namespace tedavis::target {

void list_offer(const ProbePorts& ports, SelfTestReport& report);

/// Cards with their connectors and modes.
void add_screens(const platform::ScreenInventory& inventory, SelfTestReport& report);
void add_can_interfaces(const bus::InterfaceList& list, SelfTestReport& report);
void add_gpio_chips(const GpioInventory& inventory, SelfTestReport& report);
/// The driver of headless EGL in each lane.
void add_gl(SelfTestReport& report);

/// Prints one line an entry, or the JSON line of --probe.
void print_offer(const SelfTestReport& report, bool json, std::FILE* out);

}  // namespace tedavis::target
