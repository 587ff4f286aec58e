#include "platform/egl_kms/screen_choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace tedavis::platform::test_screen_choice {
namespace {

using ::testing::HasSubstr;

ScreenMode mode(std::uint32_t width, std::uint32_t height, std::uint32_t refresh_mhz, bool preferred = false) {
    ScreenMode made;
    made.width_px = width;
    made.height_px = height;
    made.refresh_mhz = refresh_mhz;
    made.is_preferred = preferred;
    return made;
}

ScreenConnector connector(const char* name, std::uint32_t id, bool connected, std::uint32_t crtcs = 3) {
    ScreenConnector made;
    made.name = name;
    made.id = id;
    made.is_connected = connected;
    made.possible_crtcs = crtcs;
    if (connected) {
        for (const ScreenMode& m : {mode(1920, 1080, 60000, true), mode(1920, 1080, 50000), mode(1024, 768, 75029),
                                    mode(1024, 768, 60004), mode(800, 600, 60317)})
            EXPECT_TRUE(made.modes.try_push_back(m));
    }
    for (std::size_t n = 0; n < made.modes.size(); ++n) made.modes[n].index = static_cast<std::uint16_t>(n);
    return made;
}

ScreenCard card(const char* path, const char* driver) {
    ScreenCard made;
    made.path = path;
    made.driver = driver;
    made.access = CardAccess::open;
    for (const std::uint32_t crtc : {41u, 42u}) EXPECT_TRUE(made.crtcs.try_push_back(crtc));
    return made;
}

/// A card that draws only, one with two screens of which one is off, and one with a screen.
struct ScreenChoiceTest : testing::Test {
    void SetUp() override {
        ScreenCard renderer = card("/dev/dri/card0", "v3d");
        renderer.access = CardAccess::no_screens;
        ScreenCard first = card("/dev/dri/card1", "vc4"), second = card("/dev/dri/card2", "virtio_gpu");
        for (const ScreenConnector& c :
             {connector("HDMI-A-1", 10, false), connector("HDMI-A-2", 11, true), connector("DSI-1", 12, true)})
            ASSERT_TRUE(first.connectors.try_push_back(c));
        ASSERT_TRUE(second.connectors.try_push_back(connector("Virtual-1", 20, true)));
        for (const ScreenCard& c : {renderer, first, second}) ASSERT_TRUE(inventory->cards.try_push_back(c));
    }
    ScreenChoice chosen(std::uint32_t width = 1920, std::uint32_t height = 1080) {
        const auto choice = choose_screen(*inventory, settings, width, height);
        EXPECT_TRUE(choice.ok()) << choice.error().error.message.c_str();
        return choice.ok() ? choice.value() : ScreenChoice{99, 99, {}, 0, 0};
    }
    std::string refusal(std::uint32_t width = 1920, std::uint32_t height = 1080) {
        const auto choice = choose_screen(*inventory, settings, width, height);
        EXPECT_FALSE(choice.ok());
        may_come = !choice.ok() && choice.error().may_come;
        return choice.ok() ? "" : choice.error().error.message.c_str();
    }
    std::unique_ptr<ScreenInventory> inventory = std::make_unique<ScreenInventory>();
    ScreenSettings settings;
    bool may_come = false;  // of the last refusal
};

TEST_F(ScreenChoiceTest, WithoutAWishItIsTheFirstConnectedScreen) {
    const ScreenChoice choice = chosen();
    EXPECT_EQ(choice.card, 1u);
    EXPECT_EQ(choice.connector, 1u) << "the first one is not connected";
    EXPECT_EQ(choice.mode.refresh_mhz, 60000u);
    EXPECT_EQ(choice.crtc_id, 41u);
}

TEST_F(ScreenChoiceTest, TheDriverNamesTheCardWhateverItsNumber) {
    settings.driver = "virtio_gpu";
    EXPECT_EQ(chosen().card, 2u);
    std::swap(inventory->cards[1], inventory->cards[2]);
    EXPECT_EQ(chosen().card, 1u);
}

TEST_F(ScreenChoiceTest, OfTwoCardsOfOneDriverTheOneWithTheConnectorServes) {
    inventory->cards[1].driver = "virtio_gpu";
    settings.driver = "virtio_gpu";
    EXPECT_EQ(chosen().card, 1u);
    settings.connector = "Virtual-1";
    EXPECT_EQ(chosen().card, 2u);
}

TEST_F(ScreenChoiceTest, TheConnectorIsFoundByItsName) {
    settings.connector = "DSI-1";
    EXPECT_EQ(chosen().connector, 2u);
    settings.connector = "Virtual-1";
    EXPECT_EQ(chosen().card, 2u) << "on whatever card";
}

TEST_F(ScreenChoiceTest, ModesAreFoundBySizeAndNearestRate) {
    settings.mode = {1024, 768, 0};
    EXPECT_EQ(chosen(1024, 768).mode.index, 2u) << "the first listed, where none is preferred";
    settings.mode = {1024, 768, 60000};
    EXPECT_EQ(chosen(1024, 768).mode.index, 3u);
    settings.mode = {1920, 1080, 0};
    EXPECT_EQ(chosen().mode.index, 0u) << "the preferred one";
    settings.mode = {1920, 1080, 50000};
    EXPECT_EQ(chosen().mode.index, 1u);
    inventory->cards[1].connectors[1].modes[0].is_preferred = false;
    settings.mode = {};
    EXPECT_EQ(chosen().mode.index, 0u) << "a screen without EDID prefers nothing";
}

TEST_F(ScreenChoiceTest, InterlacedModesAreNotTaken) {
    for (std::size_t n = 0; n < 2; ++n) inventory->cards[1].connectors[1].modes[n].is_interlaced = true;
    settings.mode = {1920, 1080, 0};
    EXPECT_THAT(refusal(), HasSubstr("has no mode 1920x1080; modes here: 1024x768@75.029, 1024x768@60.004, 800x600@60.317;"));
}

TEST_F(ScreenChoiceTest, TheCrtcThatDrivesTheScreenIsKeptAndThoseOfOthersAreSpared) {
    settings.connector = "DSI-1";
    inventory->cards[1].connectors[1].crtc_id = 41;
    EXPECT_EQ(chosen().crtc_id, 42u);
    EXPECT_EQ(chosen().crtc_index, 1u);
    inventory->cards[1].connectors[2].crtc_id = 42;
    EXPECT_EQ(chosen().crtc_id, 42u);
    inventory->cards[1].connectors[2].possible_crtcs = 1;
    EXPECT_EQ(chosen().crtc_id, 41u) << "the only one that can";
    inventory->cards[1].connectors[2].possible_crtcs = 0;
    EXPECT_EQ(refusal(), "/dev/dri/card1 (vc4): has no CRTC for the connector DSI-1; name another connector in [screen]");
}

TEST_F(ScreenChoiceTest, EachRefusalSaysWhatIsThere) {
    settings.driver = "imx-drm";
    EXPECT_EQ(refusal(),
              "no card has the driver 'imx-drm'; drivers here: v3d, vc4, virtio_gpu; correct driver of [screen], or load it");
    EXPECT_TRUE(may_come) << "drivers may be loaded late";
    settings.driver = "v3d";
    EXPECT_EQ(refusal(), "/dev/dri/card0 (v3d): drives no screens (no KMS); name another card in [screen]");
    settings.driver = "vc4";
    settings.connector = "HDMI-A-1";
    EXPECT_EQ(refusal(),
              "/dev/dri/card1 (vc4): no screen is connected to HDMI-A-1; connectors here: HDMI-A-1 (not connected), HDMI-A-2 "
              "(connected), DSI-1 (connected); connect it and switch it on");
    EXPECT_TRUE(may_come) << "somebody may switch it on";
    settings.connector = "DP-1";
    EXPECT_THAT(refusal(), HasSubstr("(vc4): has no connector 'DP-1'; connectors here: HDMI-A-1 (not connected), "));
    EXPECT_FALSE(may_come) << "a card has the connectors that it has";
    settings.connector = "DSI-1";
    settings.mode = {1280, 800, 60000};
    EXPECT_EQ(refusal(),
              "the screen at DSI-1 has no mode 1280x800@60; modes here: 1920x1080@60, 1920x1080@50, 1024x768@75.029, "
              "1024x768@60.004, 800x600@60.317; correct mode of [screen]");
    EXPECT_FALSE(may_come);
}

TEST_F(ScreenChoiceTest, AnUnpluggedMachineIsRefused) {
    for (ScreenCard& c : inventory->cards)
        for (ScreenConnector& wire : c.connectors) wire.is_connected = false;
    EXPECT_THAT(refusal(),
                HasSubstr("/dev/dri/card1 (vc4): no screen is connected; connectors here: HDMI-A-1 (not connected), "));
    EXPECT_TRUE(may_come);
}

TEST_F(ScreenChoiceTest, TheBoardsPictureMustHaveTheSizeOfTheMode) {
    EXPECT_EQ(refusal(640, 480),
              "the board's picture of 640x480 does not have the size of the mode 1920x1080@60 of the screen at HDMI-A-2; set "
              "width_px and height_px of [surface], or mode of [screen]; modes here: 1920x1080@60, 1920x1080@50, "
              "1024x768@75.029, 1024x768@60.004, 800x600@60.317");
    settings.mode = {800, 600, 0};
    EXPECT_EQ(chosen(800, 600).mode.index, 4u);
}

TEST_F(ScreenChoiceTest, WithoutACardThatServesTheReasonIsNamed) {
    const ScreenCard closed = [] {
        ScreenCard made;
        made.path = "/dev/dri/card7";
        made.access = CardAccess::no_permission;
        made.group = "render";
        return made;
    }();
    inventory->cards.clear();
    EXPECT_THAT(refusal(), HasSubstr("nothing in /dev/dri"));
    EXPECT_TRUE(may_come) << "the card's driver may be loaded late";
    ASSERT_TRUE(inventory->cards.try_push_back(closed));
    settings.driver = "vc4";
    EXPECT_EQ(refusal(),
              "/dev/dri/card7: may not be opened; it belongs to the group render: add the user (usermod -aG render USER) and "
              "start again");
    EXPECT_FALSE(may_come);
    settings.driver.clear();
    settings.path = "/dev/dri/card7";
    inventory->cards[0].access = CardAccess::missing;
    EXPECT_THAT(refusal(), HasSubstr("/dev/dri/card7: there is no such card"));
    EXPECT_TRUE(may_come);
    inventory->cards[0].access = CardAccess::no_screens;
    EXPECT_THAT(refusal(), HasSubstr("drives no screens"));
    EXPECT_FALSE(may_come);
    inventory->cards[0].access = CardAccess::failed;
    EXPECT_THAT(refusal(), HasSubstr("dmesg"));
}

TEST_F(ScreenChoiceTest, AListThatDoesNotFitIsCutWhereItSaysSo) {
    ScreenConnector& wire = inventory->cards[1].connectors[1];
    while (!wire.modes.full()) ASSERT_TRUE(wire.modes.try_push_back(mode(1600, 1200, 60000)));
    const std::string message = refusal(640, 480);
    EXPECT_THAT(message, HasSubstr(", ..."));
    EXPECT_EQ(message.find(", ..., ..."), std::string::npos);
    EXPECT_LT(message.size(), 1000u);
}

}  // namespace
}  // namespace tedavis::platform::test_screen_choice
