#include "host_sim/terrain_builder/border_lines.hpp"

#include <gtest/gtest.h>

#include "tests/host_sim/terrain_builder/build_ground.hpp"

namespace tedavis::host_sim::test_border_lines {
namespace {

using test_support::BuildGround;

TEST(BorderLines, KeepCrossingsAsHighAsBothLines) {
    const BuildGround ground(test_support::make_rough_raster(300, 200));
    const LineGrid &rows = ground.lines.lines(LineDirection::row), &columns = ground.lines.lines(LineDirection::column);
    for (std::uint32_t r = 0; r < rows.count(); ++r)
        for (std::uint32_t c = 0; c < columns.count(); ++c) {
            const std::uint32_t j = rows.post_of(r), i = columns.post_of(c);
            const std::uint32_t both = std::min(rows.top_level(j), columns.top_level(i));
            EXPECT_GE(ground.lines.along(LineDirection::row, j, i, 1)[0], both);
            EXPECT_GE(ground.lines.along(LineDirection::column, i, j, 1)[0], both);
        }
}

TEST(BorderLines, NoPostStaysAboveItsLine) {
    const BuildGround ground(test_support::make_rough_raster(300, 200));
    const LineGrid& rows = ground.lines.lines(LineDirection::row);
    for (std::uint32_t r = 0; r < rows.count(); ++r) {
        const std::uint32_t j = rows.post_of(r);
        std::uint32_t inner = 0;
        for (const std::uint8_t level : ground.lines.along(LineDirection::row, j, 0, 300)) {
            EXPECT_LE(level, rows.top_level(j));
            inner += level;
        }
        EXPECT_EQ(inner > 0, rows.top_level(j) > 0);
    }
}

TEST(BorderLines, BothMeridiansOfTheSeamAreOneLine) {
    const BuildGround ground(test_support::make_earth_raster(2.5));
    const std::uint32_t rows = ground.plan.header.rows;
    EXPECT_EQ(ground.lines.along(LineDirection::column, 0, 0, rows), ground.lines.along(LineDirection::column, 144, 0, rows));
}

TEST(BorderLines, PiecesAgreeWhereTheyMeet) {
    // More posts than a piece has: the post where pieces meet is written by both.
    const BuildGround ground(test_support::make_raster(16400, 34, [](auto i, auto j) { return 10.0f * ((i * 7 + j) % 31); }));
    const std::vector<std::uint8_t> before = ground.lines.along(LineDirection::row, 32, 16380, 20);
    BorderLines again(ground.plan, ground.folder.path());
    for (std::uint32_t piece = again.piece_count(); piece-- > 0;) again.build_piece(ground.posts, piece);
    EXPECT_EQ(again.along(LineDirection::row, 32, 16380, 20), before);
    EXPECT_EQ(ground.lines.along(LineDirection::row, 0, 16384, 1)[0], ground.plan.levels() - 1);
}

}  // namespace
}  // namespace tedavis::host_sim::test_border_lines
