#include "render_core/design/config_values.hpp"

#include <gtest/gtest.h>

namespace tedavis::design::test_config_values {
namespace {

TEST(ConfigValues, AColorIsReadOrIsAFaultAtItsLine) {
    base::ConfigReader sound("a = 1\ncolor = '#a0B0c0'\n", "f.toml");
    base::ConfigSection root = sound.root();
    EXPECT_EQ(required_color(root, "color"), (Color{0xA0, 0xB0, 0xC0}));
    EXPECT_TRUE(sound.ok());
    base::ConfigReader wrong("a = 1\ncolor = 'red'\n", "f.toml");
    base::ConfigSection faulty = wrong.root();
    EXPECT_EQ(required_color(faulty, "color"), Color());
    EXPECT_EQ(wrong.error().message.view(), "f.toml:2: 'color' is no colour; write it as \"#rrggbb\"");
}

TEST(ConfigValues, FaultsNameTheirKey) {
    base::ConfigReader reader("\nsize = 1\n", "f.toml");
    base::ConfigSection root = reader.root();
    fault_of(root, "size", "is too small; take more");
    EXPECT_EQ(reader.error().message.view(), "f.toml:2: 'size' is too small; take more");
}

}  // namespace
}  // namespace tedavis::design::test_config_values
