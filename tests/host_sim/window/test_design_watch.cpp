#include "host_sim/window/design_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "tests/support/files/temporary_folder.hpp"
#include "tests/support/programs/expect_user_error.hpp"

namespace tedavis::host_sim::test_design_watch {
namespace {

const std::string kSound = "name = \"a\"\n[terrain]\ntau_px = 2\n";
const std::string kOther = "name = \"b\"\n[terrain]\ntau_px = 3\n";
const std::string kBroken = "name = \"c\"\n[terrain]\ntau_px = \"much\"\n";

struct Watched {
    test_support::TemporaryFolder folder;
    PictureOptions options;
    Watched() { options.design = folder.write("design.toml", kSound); }
    void write(const std::string& text) const { folder.write("design.toml", text); }
};

TEST(DesignWatch, TakesAChangeThatHasSettled) {
    const Watched watched;
    DesignWatch watch(watched.options);
    EXPECT_EQ(watch.look(), DesignNews::none);
    watched.write(kOther);
    EXPECT_EQ(watch.look(), DesignNews::none) << "may be half written";
    EXPECT_EQ(watch.look(), DesignNews::changed);
    EXPECT_EQ(watch.designs().design.terrain.tau_px, 3);
    EXPECT_EQ(watch.look(), DesignNews::none);
}

TEST(DesignWatch, ABrokenEditIsToldOnceAndTheOldDesignStays) {
    const Watched watched;
    DesignWatch watch(watched.options);
    watched.write(kBroken);
    EXPECT_EQ(watch.look(), DesignNews::none);
    EXPECT_EQ(watch.look(), DesignNews::broken);
    EXPECT_THAT(watch.message(), ::testing::HasSubstr("design.toml:3"));
    EXPECT_EQ(watch.look(), DesignNews::none);
    EXPECT_EQ(watch.designs().design.terrain.tau_px, 2);
    watched.write(kOther);
    static_cast<void>(watch.look());
    EXPECT_EQ(watch.look(), DesignNews::changed) << "mended";
}

TEST(DesignWatch, AFileThatIsAwayForAMomentIsNoNews) {
    const Watched watched;
    DesignWatch watch(watched.options);
    std::filesystem::remove(watched.options.design);
    for (int n = 0; n < 3; ++n) EXPECT_EQ(watch.look(), DesignNews::none);
    watched.write(kSound);
    for (int n = 0; n < 3; ++n) EXPECT_EQ(watch.look(), DesignNews::none) << "the same again";
}

TEST(DesignWatch, ThePaletteIsWatchedToo) {
    const Watched watched;
    const std::string grey = read_file(shipped_root() + "/configs/palettes/grey.toml");
    const std::string names_it = "name = \"a\"\n[terrain]\npalette = \"mine.toml\"\n";
    DesignWatch watch(watched.options);
    const auto settled = [&watch] {
        EXPECT_EQ(watch.look(), DesignNews::none);
        return watch.look();
    };
    watched.write(names_it);
    EXPECT_EQ(settled(), DesignNews::broken) << "there is none yet";
    EXPECT_THAT(watch.message(), ::testing::HasSubstr("mine.toml"));
    watched.folder.write("mine.toml", grey);
    EXPECT_EQ(settled(), DesignNews::changed);
    EXPECT_EQ(watch.designs().design.terrain.palette.stops[0].color, (design::Color{0x2C, 0x2C, 0x2C}));
    EXPECT_EQ(settled(), DesignNews::none);
    std::string darker = grey;
    darker.replace(darker.find("#2c2c2c"), 7, "#202020");
    watched.folder.write("mine.toml", darker);
    EXPECT_EQ(settled(), DesignNews::changed);
    EXPECT_EQ(watch.designs().design.terrain.palette.stops[0].color, (design::Color{0x20, 0x20, 0x20}));
}

TEST(DesignWatch, TheBaseIsWatchedToo) {
    const Watched watched;
    watched.folder.write("base.toml", "name = \"base\"\n[terrain]\ntau_px = 5\n");
    watched.write("name = \"a\"\nbased_on = \"base.toml\"\n");
    DesignWatch watch(watched.options);
    EXPECT_EQ(watch.designs().design.terrain.tau_px, 5);
    watched.folder.write("base.toml", "name = \"base\"\n[terrain]\ntau_px = 6\n");
    EXPECT_EQ(watch.look(), DesignNews::none);
    EXPECT_EQ(watch.look(), DesignNews::changed);
    EXPECT_EQ(watch.designs().design.terrain.tau_px, 6);
    watched.folder.write("base.toml", "name = \"base\"\n[terrain]\ntau = 6\n");
    EXPECT_EQ(watch.look(), DesignNews::none);
    EXPECT_EQ(watch.look(), DesignNews::broken);
    EXPECT_THAT(watch.message(), ::testing::HasSubstr("base.toml:3: unknown key"));
}

TEST(DesignWatch, TheCommandLineStaysAboveTheFile) {
    Watched watched;
    watched.options.tau_px = 8;
    DesignWatch watch(watched.options);
    watched.write(kOther);
    static_cast<void>(watch.look());
    EXPECT_EQ(watch.look(), DesignNews::changed);
    EXPECT_EQ(watch.designs().design.terrain.tau_px, 8);
}

TEST(DesignWatch, AnUnsoundDesignIsRefusedAtTheStart) {
    const Watched watched;
    watched.write(kBroken);
    test_support::expect_user_error([&] { DesignWatch watch(watched.options); }, "design.toml:3");
}

}  // namespace
}  // namespace tedavis::host_sim::test_design_watch
