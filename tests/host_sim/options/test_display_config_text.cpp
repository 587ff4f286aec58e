#include "host_sim/options/display_config_text.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace tedavis::host_sim::test_display_config_text {
namespace {

const std::string kWhole = R"(title = "a \"b\""
device = "/d.toml"
design = "/e.toml"
designs = "/designs/"
palettes = "/p/"
bus = "/b.toml"
aircraft = "/a.toml"
light = "night"
symbology = "/s.toml"

[terrain]
database = "/t.tdb"

[scene]
database = "/s.sdb"

[costs]
file = "/c.toml"

[programs]
folder = "/programs"

[parameters]
tau_px = 0.29999999999999999
deadline_ms = 16.699999999999999
foci = ["radius_m = 700"]

[parameters.weights]
"my part" = 0.25000000000000000

[can]
interface = "can1"
fd = true
filter = false
receive_buffer_bytes = 65536
reopen_s = 2.5000000000000000

[switches]
config = "/w.toml"

[surface]
backend = "kms"
width_px = 640
height_px = 480

[screen]
driver = "vc4"
connector = "DSI-1"
mode = "640x480@59.94"

[records]
socket = "/run/r"

[display]
legend = "whole"

[memory]
touch = false
)";

std::string written_again(const std::string& text) {
    base::ConfigReader reader(text, "/x.toml");
    const auto config = std::make_unique<platform::DisplayConfig>();
    platform::read_display_config(reader, platform::ConfigUse::board, *config);
    EXPECT_TRUE(reader.finish()) << reader.error().message.view();
    return display_config_text(*config);
}

TEST(DisplayConfigText, SaysAllThatWasRead) {
    EXPECT_EQ(written_again(kWhole), kWhole);
    const std::string bare = "device = '/d'\ndesign = '/e'\nbus = '/b'\n[can]\ninterface = 'can0'\n";
    EXPECT_EQ(written_again(written_again(bare)), written_again(bare));
}

}  // namespace
}  // namespace tedavis::host_sim::test_display_config_text
