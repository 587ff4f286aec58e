#include "target/board_display.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/temporary_folder.hpp"
#include "tests/target/fake_board.hpp"

namespace tedavis::target::test_board_display {
namespace {

using ::testing::HasSubstr;

std::string start(BoardDisplay& board) {
    base::Error error = board.open_surface();
    if (!error) error = board.start();
    if (!error) error = board.hold_deadline();
    return std::string(error.message.view());
}

bool has_flag(const display::FrameRecord& record, std::string_view name) {
    return std::any_of(record.flags.begin(), record.flags.end(), [name](const auto& flag) { return flag.view() == name; });
}

/// Draws a frame and gives its record.
const display::FrameRecord& drawn(BoardDisplay& board) {
    board.core().plan({{}, {}, base::Time{1}});
    board.core().draw(board.surface());
    EXPECT_EQ(board.surface().present(), base::SurfaceState::ready);
    return board.core().record();
}

TEST(BoardDisplay, StartsWithItsTerrain) {
    const BoardSettings settings = board_settings();
    BoardDisplay board(settings);
    ASSERT_EQ(start(board), "");
    EXPECT_EQ(board.terrain_fault().message.view(), "");
    EXPECT_NE(board.core().planner().terrain_database(), nullptr);
    EXPECT_FALSE(has_flag(drawn(board), "terrain.failed"));
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
        BoardDisplay board(settings);
        EXPECT_EQ(start(board), "") << bad.file;
        EXPECT_THAT(std::string(board.terrain_fault().message.view()), HasSubstr(bad.says));
        const display::FrameRecord& record = drawn(board);
        EXPECT_TRUE(has_flag(record, "terrain.failed")) << bad.file;
        EXPECT_FALSE(has_flag(record, "terrain.missing")) << "which would say that nobody wanted any";
        EXPECT_EQ(board.core().gl().denied().total, 0u);
    }
    BoardSettings settings = board_settings();
    settings.terrain = Path();
    BoardDisplay board(settings);
    EXPECT_EQ(start(board), "");
    EXPECT_TRUE(has_flag(drawn(board), "terrain.missing")) << "control: none is asked for";
}

TEST(BoardDisplay, AnImpossibleDeviceIsRefused) {
    BoardSettings settings = board_settings();
    settings.device.budget.find(effects::kLodScratch)->bytes = 8;
    BoardDisplay board(settings);
    EXPECT_THAT(start(board), HasSubstr("the budget line 'lod_scratch' is too small"));
    settings = board_settings();
    settings.surface = base::FixedString<15>("kms");
    BoardDisplay other(settings);
    EXPECT_THAT(start(other), HasSubstr("[surface]: the surface 'kms' is not known"));
}

}  // namespace
}  // namespace tedavis::target::test_board_display
