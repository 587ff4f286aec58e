#include "target/probe/switch_faults.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/target/probe/fake_machine.hpp"

namespace tedavis::target::test_switch_faults {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

bus::SwitchLine line(const char* chip, const char* name, std::int32_t offset = -1) {
    bus::SwitchLine made;
    made.chip = chip;
    made.name = name;
    made.offset = offset;
    return made;
}

struct SwitchFaults : testing::Test {
    void SetUp() override {
        machine.add_chip("gpiochip0", "pinctrl", {"", "LED"}).lines[1].is_used = true;
        machine.gpio->chips[0].lines[1].consumer = "led0";
        machine.add_chip("gpiochip1", "panel", {"GROUND", "TAKEOFF", "CRUISE"});
    }
    std::string fault(const bus::SwitchLine& of) const { return switch_line_fault(*machine.gpio, of).message.c_str(); }
    FakeMachine machine;
};

TEST_F(SwitchFaults, ALineThatIsThereAndFreeServes) {
    EXPECT_EQ(fault(line("panel", "TAKEOFF")), "");
    EXPECT_EQ(fault(line("gpiochip1", "TAKEOFF")), "") << "by the chip's name";
    EXPECT_EQ(fault(line("pinctrl", "own name", 0)), "") << "by its number";
}

TEST_F(SwitchFaults, AMissingChipIsToldWithThoseThatAreThere) {
    EXPECT_EQ(
        fault(line("panle", "GROUND")),
        "switch line 'panle.GROUND': no GPIO chip has this label or name; chips here: pinctrl (gpiochip0), panel (gpiochip1); "
        "correct 'chip'");
    machine.gpio->chips.clear();
    EXPECT_EQ(fault(line("panel", "GROUND")),
              "switch line 'panel.GROUND': this machine has no GPIO chip (nothing in /dev/gpiochip*); load the chip's driver");
}

TEST_F(SwitchFaults, AMissingLineIsToldWithThoseThatAreThere) {
    EXPECT_EQ(
        fault(line("panel", "APPROACH")),
        "switch line 'panel.APPROACH': the chip panel (gpiochip1) has no line of this name; its lines: 0 GROUND, 1 TAKEOFF, 2 "
        "CRUISE; correct 'name', or give its 'offset'");
    EXPECT_EQ(
        fault(line("panel", "mine", 3)),
        "switch line 'panel.mine': the chip panel (gpiochip1) has 3 lines, numbered from 0, and none with this offset; correct "
        "'offset'");
    EXPECT_EQ(fault(line("panel", "mine", 2)), "");
}

TEST_F(SwitchFaults, ABusyLineIsToldWithItsUser) {
    EXPECT_EQ(fault(line("pinctrl", "LED")),
              "switch line 'pinctrl.LED': is used by led0; end that, or correct the line in the switch file");
    machine.gpio->chips[0].lines[1].consumer.clear();
    EXPECT_THAT(fault(line("pinctrl", "LED")), HasSubstr("is used by a program or driver without a name"));
    machine.gpio->chips[0].lines[1].consumer = "tedavis";
    EXPECT_THAT(fault(line("pinctrl", "LED")), HasSubstr("another tedavis-display uses it"));
}

/// A chip that may not be opened has no label, so it may be the one that is meant.
TEST_F(SwitchFaults, AChipThatMayNotBeOpenedIsToldWithItsGroup) {
    GpioChip& chip = machine.gpio->chips[1];
    chip = GpioChip();
    chip.name = "gpiochip1";
    chip.group = "dialout";
    for (const char* wanted : {"panel", "gpiochip1"})
        EXPECT_THAT(
            fault(line(wanted, "GROUND")),
            HasSubstr("/dev/gpiochip1 may not be opened; it belongs to the group dialout: add the user (usermod -aG dialout "
                      "USER)"));
    EXPECT_EQ(fault(line("pinctrl", "x", 0)), "") << "a chip that serves is not in doubt";
}

TEST_F(SwitchFaults, OfAChipWithMoreLinesThanAreReadNothingIsClaimed) {
    machine.gpio->chips[1].line_count = 900;
    EXPECT_EQ(fault(line("panel", "LATE")), "");
    EXPECT_EQ(fault(line("panel", "mine", 800)), "");
    EXPECT_THAT(fault(line("panel", "mine", 900)), HasSubstr("has 900 lines"));
}

TEST_F(SwitchFaults, TheFirstFaultOfAPanelStandsForIt) {
    bus::SwitchConfig panel;
    ASSERT_TRUE(panel.lines.try_push_back(line("panel", "GROUND")));
    EXPECT_FALSE(panel_fault(*machine.gpio, panel));
    ASSERT_TRUE(panel.lines.try_push_back(line("panel", "LOST")));
    ASSERT_TRUE(panel.lines.try_push_back(line("other", "GROUND")));
    EXPECT_THAT(std::string(panel_fault(*machine.gpio, panel).message.view()), StartsWith("switch line 'panel.LOST': "));
}

TEST_F(SwitchFaults, LongListsEndWithDots) {
    GpioChip chip;
    chip.name = "gpiochip2";
    chip.may_open = true;
    for (int n = 0; n < 256; ++n) ASSERT_TRUE(chip.lines.try_push_back({"A_LINE_WITH_A_LONG_NAME", {}, false}));
    const std::string text(lines_text(chip).view());
    EXPECT_EQ(text.substr(text.size() - 5), ", ...");
    EXPECT_THAT(text, StartsWith("0 A_LINE_WITH_A_LONG_NAME, 1 A_LINE"));
    EXPECT_EQ(chip_text(chip).view(), "gpiochip2");
}

}  // namespace
}  // namespace tedavis::target::test_switch_faults
