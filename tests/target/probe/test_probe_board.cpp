#include "target/probe/probe_board.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/scene/scene_drafts.hpp"
#include "tests/target/fake_board.hpp"
#include "tests/target/probe/fake_machine.hpp"

namespace tedavis::target::test_probe_board {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// The fake board on a made-up machine that has all that it asks for.
struct ProbeBoard : testing::Test {
    void SetUp() override {
        machine.add_controller("can9");
        machine.add_card();
        machine.add_chip("gpiochip0", "panel", {"GROUND", "TAKEOFF"});
    }
    void ask_for_screen() {
        settings.surface = "kms";
        settings.width_px = 640;
        settings.height_px = 480;
    }
    void ask_for_switches() {
        settings.has_switches = true;
        for (const char* name : {"GROUND", "TAKEOFF"}) {
            bus::SwitchLine line;
            line.chip = "panel";
            line.name = name;
            ASSERT_TRUE(settings.switches.lines.try_push_back(line));
        }
    }
    /// Of each check that does not hold "name: finding\n".
    static std::string faults(const SelfTestReport& report) {
        std::string all;
        for (const SelfCheck& check : report.checks())
            if (!check.holds) all += std::string(check.name.view()) + ": " + std::string(check.finding.view()) + "\n";
        return all;
    }
    std::string screen_fault() {
        SelfTestReport report;
        const bool serves = probe_screen(settings, FakeMachine::ports(), report);
        EXPECT_EQ(serves, faults(report).empty());
        return faults(report);
    }
    SelfTestReport probed() {
        SelfTestReport report;
        probe_board(settings, FakeMachine::ports(), report);
        return report;
    }
    BoardSettings settings = board_settings();
    FakeMachine machine;
};

TEST_F(ProbeBoard, ABoardThatHasAllItAsksForIsTold) {
    ask_for_switches();
    const SelfTestReport report = probed();
    EXPECT_EQ(faults(report), "");
    EXPECT_EQ(report.find("can")->finding.view(), "can9: can, up, 500000 bit/s, error-active, restart after 100 ms");
    EXPECT_EQ(report.find("switches")->finding.view(), "2 lines, all there and free");
    EXPECT_THAT(std::string(report.find("board_terrain")->finding.view()), HasSubstr("--self-test reads all"));
    EXPECT_THAT(std::string(report.find("board_display")->finding.view()), StartsWith("640 x 480, "));
    EXPECT_EQ(report.find("screen"), nullptr) << "the board draws off-screen";
}

TEST_F(ProbeBoard, EveryFaultOfAMachineIsTold) {
    ask_for_switches();
    machine.interfaces.interfaces[0].is_up = false;
    machine.gpio->chips[0].lines[0].is_used = true;
    machine.gpio->chips[0].lines[1].name = "OTHER";
    settings.terrain = "/nowhere/area.tdb";
    const std::string all = faults(probed());
    EXPECT_THAT(all, HasSubstr("can: CAN interface 'can9': is down"));
    EXPECT_THAT(all, HasSubstr("switches: switch line 'panel.GROUND': is used by"));
    EXPECT_THAT(all, HasSubstr("switches: switch line 'panel.TAKEOFF': the chip panel"));
    EXPECT_THAT(all, HasSubstr("board_terrain: /nowhere/area.tdb: cannot be read"));
    EXPECT_THAT(all, HasSubstr("switches: 0 of 2 lines serve\n"));
    EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 5);
}

TEST_F(ProbeBoard, AChipThatIsMissingIsToldOnce) {
    ask_for_switches();
    machine.gpio->chips.clear();
    SelfTestReport report;
    probe_switches(settings, FakeMachine::ports(), report);
    const std::string all = faults(report);
    EXPECT_THAT(all, StartsWith("switches: switch line 'panel.GROUND': this machine has no GPIO chip"));
    EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 2) << all;
}

TEST_F(ProbeBoard, EveryFaultOfTheScreenIsToldInTheWordsOfTheStart) {
    ask_for_screen();
    EXPECT_EQ(screen_fault(), "");
    machine.held = "/dev/dri/card1";
    machine.holders = "Xorg (process 812)";
    EXPECT_THAT(screen_fault(), StartsWith("screen: [surface]: /dev/dri/card1 (virtio_gpu): another program has the screen: Xorg "
                                           "(process 812); end it first"));
    machine.held.clear();
    settings.height_px = 481;
    EXPECT_THAT(screen_fault(), HasSubstr("modes here: 1024x768@60, 640x480@60"));
    settings.height_px = 480;
    machine.screens->cards[0].connectors[0].is_connected = false;
    EXPECT_THAT(screen_fault(), HasSubstr("no screen is connected"));
    machine.screens->cards[0].access = platform::CardAccess::no_permission;
    machine.screens->cards[0].group = "video";
    EXPECT_THAT(screen_fault(), HasSubstr("usermod -aG video USER"));
    machine.screens->cards[0].access = platform::CardAccess::no_screens;
    EXPECT_THAT(screen_fault(), HasSubstr("drives no screens"));
    machine.screens->cards.clear();
    EXPECT_THAT(screen_fault(), HasSubstr("nothing in /dev/dri"));
    ProbePorts ports = FakeMachine::ports();
    ports.has_screens = false;
    SelfTestReport report;
    EXPECT_FALSE(probe_screen(settings, ports, report));
    EXPECT_THAT(faults(report), HasSubstr("this build shows nothing on a screen"));
}

TEST_F(ProbeBoard, WhatTheScreenHasIsListed) {
    ask_for_screen();
    SelfTestReport report;
    EXPECT_TRUE(probe_screen(settings, FakeMachine::ports(), report));
    EXPECT_EQ(report.find("screen")->finding.view(), "Virtual-1 of /dev/dri/card1 (virtio_gpu), 640x480@60");
    EXPECT_EQ(report.find("connector")->finding.view(), "Virtual-1 of /dev/dri/card1: 1024x768@60, 640x480@60");
}

TEST_F(ProbeBoard, WhoOpensTheCardIsTold) {
    ask_for_screen();
    const auto seat = [&] {
        SelfTestReport report;
        EXPECT_TRUE(probe_screen(settings, FakeMachine::ports(), report)) << "no manager is no fault";
        return std::string(report.find("seat")->finding.view());
    };
    EXPECT_EQ(seat(), "no seat manager; the program opens the card itself");
    machine.seat = {true, "seatd at /run/seatd.sock"};
    EXPECT_EQ(seat(), "seatd at /run/seatd.sock would open the card");
    machine.seat = {false, "seatd runs, but this user may not reach it (mend)"};
    EXPECT_EQ(seat(),
              "seatd runs, but this user may not reach it (mend); the program opens the card itself as long as this is so");
}

TEST_F(ProbeBoard, WithoutItsScreenTheDisplayIsTriedOffScreen) {
    ask_for_screen();
    machine.held = "/dev/dri/card1";
    const SelfTestReport report = probed();
    EXPECT_THAT(faults(report), StartsWith("screen: "));
    EXPECT_TRUE(report.find("board_surface")->holds);
    EXPECT_THAT(std::string(report.find("board_surface")->finding.view()), StartsWith("off-screen"));
    EXPECT_TRUE(report.find("board_display")->holds);
}

TEST_F(ProbeBoard, OfASceneTheHeaderIsRead) {
    const test_support::TemporaryFolder folder;
    const std::vector<std::uint8_t> sound = host_sim::sdb_bytes(test_support::small_scene());
    std::string bytes(sound.begin(), sound.end());
    settings.scene = Path(folder.write("area.sdb", bytes));
    EXPECT_THAT(std::string(probed().find("board_scene")->finding.view()),
                StartsWith("4 layers, revision 1, the header is right"));
    bytes.back() = static_cast<char>(bytes.back() ^ 1);
    folder.write("area.sdb", bytes);
    EXPECT_EQ(faults(probed()), "") << "not every byte is read";
    bytes[20] = static_cast<char>(bytes[20] ^ 1);
    folder.write("area.sdb", bytes);
    EXPECT_THAT(faults(probed()), StartsWith("board_scene: "));
    folder.write("area.sdb", std::string(sound.begin(), sound.end() - 1));
    EXPECT_THAT(faults(probed()), HasSubstr("is not as long as its header says"));
}

TEST_F(ProbeBoard, WithoutAnAnswerOfTheKernelTheBusIsInDoubt) {
    machine.interfaces.is_read = false;
    SelfTestReport report;
    probe_can(settings, FakeMachine::ports(), report);
    EXPECT_THAT(faults(report), StartsWith("can: the kernel does not list"));
}

}  // namespace
}  // namespace tedavis::target::test_probe_board
