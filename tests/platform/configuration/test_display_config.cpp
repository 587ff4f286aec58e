#include "platform/configuration/display_config.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace tedavis::platform::test_display_config {
namespace {

using ::testing::HasSubstr;

const std::string kHead = "device = 'd.toml'\ndesign = 'e.toml'\nbus = 'b.toml'\n";
const std::string kCan = "[can]\ninterface = 'can0'\n";

struct Read {
    std::unique_ptr<DisplayConfig> config = std::make_unique<DisplayConfig>();
    std::string fault;
};

Read read_as(ConfigUse use, const std::string& text) {
    Read read;
    base::ConfigReader reader(text, "/etc/x.toml");
    read_display_config(reader, use, *read.config);
    if (!reader.finish()) read.fault = reader.error().message.view();
    return read;
}

TEST(DisplayConfig, OneFileIsReadByDeskAndBoardAlike) {
    const std::string text =
        "title = 't'\n" + kHead +
        "designs = 'own'\npalettes = '/p'\nlight = 'night'\n[terrain]\ndatabase = '/srv/a.tdb'\n"
        "[parameters]\ntau_px = 2\ndeadline_ms = 12.5\nfoci = ['shape = 1']\n[parameters.weights]\nterrain = "
        "0.25\n'my part' = 1\n[surface]\nwidth_px = 640\nheight_px = 480\n" +
        kCan;
    for (const ConfigUse use : {ConfigUse::board, ConfigUse::desk}) {
        const Read read = read_as(use, text);
        ASSERT_EQ(read.fault, "");
        const DisplayConfig& config = *read.config;
        EXPECT_EQ(config.title.view(), "t");
        EXPECT_EQ(config.device.view(), "/etc/d.toml");
        EXPECT_EQ(config.designs.view(), "/etc/own/");
        EXPECT_EQ(config.palettes.view(), "/p/");
        EXPECT_EQ(config.terrain.view(), "/srv/a.tdb");
        EXPECT_TRUE(config.scene.empty());
        EXPECT_EQ(config.light, design::SymbologyLight::night);
        EXPECT_EQ(config.parameters.tau_px, 2);
        EXPECT_EQ(config.deadline_ms, 12.5);
        EXPECT_EQ(config.parameters.foci[0].view(), "shape = 1");
        ASSERT_EQ(config.parameters.weights.size(), 2u);
        EXPECT_EQ(config.parameters.weights[0].aspect.view(), "my part");
        EXPECT_EQ(config.parameters.weights[1].weight, 0.25);
        EXPECT_EQ(config.width_px, 640u);
        EXPECT_EQ(config.height_px, 480u);
        EXPECT_TRUE(config.has_can);
    }
}

TEST(DisplayConfig, ABoardNeedsABusAndLeavesTheDesksSectionAlone) {
    EXPECT_THAT(read_as(ConfigUse::board, kHead).fault, HasSubstr("interface"));
    const Read desk = read_as(ConfigUse::desk, kHead);
    EXPECT_EQ(desk.fault, "");
    EXPECT_FALSE(desk.config->has_can);
    EXPECT_EQ(desk.config->palettes.view(), "/etc/") << "the file's own folder";
    EXPECT_TRUE(desk.config->designs.empty());
    const std::string replay = "[replay]\nlog = 'a.log'\nwhatever = [1, 2]\n";
    EXPECT_EQ(read_as(ConfigUse::board, kHead + kCan + replay).fault, "");
    EXPECT_THAT(read_as(ConfigUse::board, kHead + kCan + "[replay\n").fault, HasSubstr("/etc/x.toml:6")) << "no TOML";
    EXPECT_THAT(read_as(ConfigUse::board, kHead + kCan + "[play]\nlog = 1\n").fault, HasSubstr("play")) << "control";
}

TEST(DisplayConfig, OneHalfOfASizeIsAFaultOnDeskAndBoard) {
    for (const ConfigUse use : {ConfigUse::board, ConfigUse::desk})
        for (const char* half : {"width_px = 640\n", "height_px = 480\n"})
            EXPECT_THAT(read_as(use, kHead + kCan + "[surface]\n" + half).fault, HasSubstr("write both, or none"));
}

TEST(DisplayConfig, FaultsHaveTheirLine) {
    const auto fault = [](const std::string& rest) { return read_as(ConfigUse::desk, kHead + rest).fault; };
    EXPECT_THAT(fault("[parameters]\ntau_px = 0\n"), HasSubstr("/etc/x.toml:5"));
    EXPECT_THAT(fault("[parameters.weights]\nterrain = 2\n"), HasSubstr("/etc/x.toml:5"));
    EXPECT_THAT(fault("[parameters.weights]\n" + std::string(70, 'x') + " = 1\n"), HasSubstr("no aspect"));
    EXPECT_THAT(fault("[parameters]\nfoci = ['" + std::string(1100, 'x') + "']\n"), HasSubstr("a thousand bytes"));
    EXPECT_THAT(fault("[parameters]\nfoci = ['', '', '', '', '']\n"), HasSubstr("foci"));
    EXPECT_THAT(fault("[parameters]\ntau = 1\n"), HasSubstr("tau"));
    EXPECT_THAT(read_as(ConfigUse::desk, "design = 'e'\nbus = 'b'\n").fault, HasSubstr("device"));
}

}  // namespace
}  // namespace tedavis::platform::test_display_config
