#include "target/probe/probe_ports.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace tedavis::target::test_probe_ports {
namespace {

TEST(ProbePorts, AskThisMachine) {
    const ProbePorts ports = machine_probe_ports();
    const auto screens = std::make_unique<platform::ScreenInventory>();
    ports.list_screens("/nowhere/card0", *screens);
    if (ports.has_screens) {
        ASSERT_EQ(screens->cards.size(), 1u);
        EXPECT_EQ(screens->cards[0].access, platform::CardAccess::missing);
    }
    EXPECT_TRUE(ports.card_holders("/nowhere/card0").empty());
    EXPECT_FALSE(ports.is_card_held("/nowhere/card0"));
    const platform::SeatOffer seat = ports.find_seat();
    EXPECT_TRUE(!seat.is_there || !seat.text.empty());
    bus::InterfaceList list;
    ports.list_interfaces(list);
    EXPECT_TRUE(list.is_read);
    const auto gpio = std::make_unique<GpioInventory>();
    ports.list_gpio(*gpio);
}

TEST(ProbePorts, APanelThatIsNotHereIsExplained) {
    bus::SwitchConfig panel;
    EXPECT_FALSE(explain_panel(panel)) << "a panel without lines lacks none";
    bus::SwitchLine line;
    line.chip = "no such panel";
    line.name = "GROUND";
    ASSERT_TRUE(panel.lines.try_push_back(line));
    EXPECT_EQ(explain_panel(panel).message.view().substr(0, 35), "switch line 'no such panel.GROUND':");
}

}  // namespace
}  // namespace tedavis::target::test_probe_ports
