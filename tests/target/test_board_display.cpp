#include "target/board_display.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/files/temporary_folder.hpp"
#include "tests/target/fake_board.hpp"

namespace tedavis::target::test_board_display {
namespace {

using ::testing::HasSubstr;

std::string start(const BoardSettings& settings, platform::DisplayHost& host) {
    const platform::HostFault fault = start_board_display(settings, host);
    const base::Error error = fault ? fault.error : hold_board_deadline(settings, host);
    return std::string(error.message.view());
}

bool has_flag(const display::FrameRecord& record, std::string_view name) {
    return std::any_of(record.flags.begin(), record.flags.end(), [name](const auto& flag) { return flag.view() == name; });
}

/// Draws a frame and gives its record.
const display::FrameRecord& drawn(platform::DisplayHost& board) {
    board.display().plan({{}, {}, base::Time{1}});
    board.display().draw(board.surface());
    EXPECT_EQ(board.surface().present(), base::SurfaceState::ready);
    return board.display().record();
}

TEST(BoardDisplay, StartsWithItsTerrain) {
    const BoardSettings settings = board_settings();
    platform::DisplayHost board;
    ASSERT_EQ(start(settings, board), "");
    EXPECT_EQ(board.terrain_fault().message.view(), "");
    EXPECT_NE(board.display().planner().terrain_database(), nullptr);
    EXPECT_FALSE(has_flag(drawn(board), "terrain.failed"));
}

TEST(BoardDisplay, HasTheBoardsAircraft) {
    BoardSettings settings = board_settings();
    EXPECT_FALSE(board_host_settings(settings).display.aircraft.is_stated());
    settings.aircraft.name = "own";
    EXPECT_EQ(board_host_settings(settings).display.aircraft.name.view(), "own");
}

TEST(BoardDisplay, HasTheBoardsPaletteAndLight) {
    BoardSettings settings = board_settings();
    settings.symbology.name = "own";
    settings.light = design::SymbologyLight::night;
    EXPECT_EQ(board_host_settings(settings).display.symbology.name.view(), "own");
    EXPECT_EQ(board_host_settings(settings).display.light, design::SymbologyLight::night);
}

TEST(BoardDisplay, WithoutTerrainThatThereShouldBeItSaysTerrainFail) {
    const test_support::TemporaryFolder folder;
    const std::string sound(embedded_inputs().terrain.begin(), embedded_inputs().terrain.end());
    std::string damaged = sound;
    damaged[100] = static_cast<char>(damaged[100] ^ 8);
    struct Case {
        std::string file, says;
    };
    for (const Case& bad : {Case{folder.file("absent.tdb"), "cannot be read (No such file or directory)"},
                            Case{folder.path(), folder.path()}, Case{folder.write("empty.tdb", ""), "empty.tdb: "},
                            Case{folder.write("text.tdb", std::string(600, '.')), "text.tdb: is not a terrain database"},
                            Case{folder.write("cut.tdb", sound.substr(0, 3000)), "cut.tdb: is shorter than its header says"},
                            Case{folder.write("damaged.tdb", damaged), "damaged.tdb: has a damaged header"}}) {
        BoardSettings settings = board_settings();
        settings.terrain = Path(bad.file);
        platform::DisplayHost board;
        EXPECT_EQ(start(settings, board), "") << bad.file;
        EXPECT_THAT(std::string(board.terrain_fault().message.view()), HasSubstr(bad.says));
        const display::FrameRecord& record = drawn(board);
        EXPECT_TRUE(has_flag(record, "terrain.failed")) << bad.file;
        EXPECT_FALSE(has_flag(record, "terrain.missing")) << "which would say that nobody wanted any";
        EXPECT_EQ(board.display().gl().denied().total, 0u);
    }
    BoardSettings settings = board_settings();
    settings.terrain = Path();
    platform::DisplayHost board;
    EXPECT_EQ(start(settings, board), "");
    EXPECT_TRUE(has_flag(drawn(board), "terrain.missing")) << "control: none is asked for";
}

TEST(BoardDisplay, AnImpossibleDeviceIsRefused) {
    BoardSettings settings = board_settings();
    settings.device.budget.find(effects::kLodScratch)->bytes = 8;
    platform::DisplayHost board;
    EXPECT_THAT(start(settings, board), HasSubstr("the budget line 'lod_scratch' has 8 of 8 bytes left"));
    settings = board_settings();
    settings.surface = base::FixedString<15>("glut");
    platform::DisplayHost other;
    EXPECT_THAT(start(settings, other), HasSubstr("[surface]: the surface 'glut' is not known"));
}

TEST(BoardDisplay, AScreenIsMadeOfTheBoardsSettingsAndBenchesDrawBesideIt) {
    BoardSettings settings = board_settings();
    EXPECT_EQ(board_host_settings(settings).surface.make, nullptr) << "control: off-screen";
    EXPECT_FALSE(is_on_screen(settings));
    settings.surface = base::FixedString<15>("kms");
    settings.screen.path = "/dev/null";
    EXPECT_TRUE(is_on_screen(settings));
    const platform::SurfaceSource source = board_host_settings(settings).surface;
    ASSERT_NE(source.make, nullptr);
    EXPECT_EQ(source.self, &settings.screen);
    EXPECT_FALSE(source.make(source.self, {640, 480, platform::ContextLane::es2}).ok()) << "no card is named so";
    const platform::SurfaceSource beside = off_screen_host_settings(settings).surface;
    EXPECT_EQ(beside.make, nullptr);
    EXPECT_EQ(beside.backend, "egl");
    settings.surface = base::FixedString<15>("osmesa");
    EXPECT_EQ(off_screen_host_settings(settings).surface.backend, "osmesa");
}

}  // namespace
}  // namespace tedavis::target::test_board_display
