#include "host_sim/terrain_builder/nested_polyline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tedavis::host_sim::test_nested_polyline {
namespace {

using terrain::PostClass;

struct Line {
    std::vector<float> surface_m;
    std::vector<PostClass> post_class;

    explicit Line(std::size_t posts) : surface_m(posts), post_class(posts, PostClass::land) {}

    [[nodiscard]] LinePiece piece(std::uint32_t top_level, double first_tolerance_m) const {
        LinePiece line;
        line.surface_m = {surface_m.data(), surface_m.size()};
        line.post_class = {post_class.data(), post_class.size()};
        line.top_level = top_level;
        line.tolerance_m = [first_tolerance_m](std::uint32_t level, std::uint32_t) {
            return first_tolerance_m * std::pow(2.5, level - 1);
        };
        return line;
    }
};

Line rough_line(std::size_t posts) {
    Line line(posts);
    std::mt19937 random(5);
    for (std::size_t n = 0; n < posts; ++n)
        line.surface_m[n] = static_cast<float>(100 * std::sin(0.03 * static_cast<double>(n)) + random() % 1000 * 0.01);
    return line;
}

/// Largest error at valid posts of the polyline through the posts that a level keeps.
double worst_error(const Line& line, const std::vector<std::uint8_t>& levels, std::uint32_t level) {
    double worst = 0;
    std::size_t from = 0;
    for (std::size_t to = 1; to < levels.size(); ++to) {
        if (levels[to] < level) continue;
        for (std::size_t n = from + 1; n < to; ++n) {
            const double part = static_cast<double>(n - from) / static_cast<double>(to - from);
            const double drawn = line.surface_m[from] + part * (double{line.surface_m[to]} - line.surface_m[from]);
            if (line.post_class[n] != PostClass::void_) worst = std::max(worst, std::abs(drawn - line.surface_m[n]));
        }
        from = to;
    }
    return worst;
}

std::size_t kept(const std::vector<std::uint8_t>& levels, std::uint32_t level) {
    std::size_t count = 0;
    for (const std::uint8_t l : levels) count += l >= level ? 1 : 0;
    return count;
}

TEST(NestedPolyline, KeepsWithinTheToleranceOfEveryLevel) {
    const Line line = rough_line(1025);
    const std::vector<std::uint8_t> levels = keep_levels(line.piece(5, 4));
    std::size_t before = levels.size() + 1;
    for (std::uint32_t level = 1; level <= 5; ++level) {
        EXPECT_LE(worst_error(line, levels, level), border_tolerance(level) * 4 * std::pow(2.5, level - 1) + 1e-9) << level;
        EXPECT_LT(kept(levels, level), before);
        before = kept(levels, level);
    }
}

TEST(NestedPolyline, KeepsCornersOfTheLevelBelowAndBothEnds) {
    const Line flat(700);
    const std::vector<std::uint8_t> levels = keep_levels(flat.piece(4, 4));
    EXPECT_EQ(levels.front(), 4);
    EXPECT_EQ(levels.back(), 4);
    for (std::size_t n = 1; n + 1 < levels.size(); ++n) {
        std::uint32_t expected = 0;
        for (std::uint32_t level = 1; level <= 4; ++level)
            if (n % (32u << (level - 1)) == 0) expected = level;
        EXPECT_EQ(levels[n], expected) << n;
    }
}

TEST(NestedPolyline, ALineOfLevelZeroKeepsEveryPostThereOnly) {
    for (const std::uint8_t level : keep_levels(rough_line(200).piece(0, 4))) EXPECT_EQ(level, 0);
}

TEST(NestedPolyline, SidesThatPassVoidsHaveAVoidEnd) {
    Line line(513);
    for (const std::size_t n : {std::size_t{40}, std::size_t{41}, std::size_t{42}, std::size_t{200}, std::size_t{300}})
        line.post_class[n] = PostClass::void_;
    const std::vector<std::uint8_t> levels = keep_levels(line.piece(4, 4));
    for (std::uint32_t level = 1; level <= 4; ++level) {
        std::size_t from = 0;
        for (std::size_t to = 1; to < levels.size(); ++to) {
            if (levels[to] < level) continue;
            bool passes = false;
            for (std::size_t n = from + 1; n < to; ++n) passes = passes || line.post_class[n] == PostClass::void_;
            EXPECT_TRUE(!passes || line.post_class[from] == PostClass::void_ || line.post_class[to] == PostClass::void_);
            from = to;
        }
    }
}

TEST(NestedPolyline, TheCurvedEarthNeedsPostsOnFlatLines) {
    const Line flat(513);
    LinePiece line = flat.piece(4, 10);
    line.sagitta_m = 0.01;  // a side of n posts misses n² / 100 metres
    const std::vector<std::uint8_t> levels = keep_levels(line);
    for (std::uint32_t level = 2; level <= 4; ++level) {
        const double longest = std::sqrt(border_tolerance(level) * 10 * std::pow(2.5, level - 1) / 0.01);
        std::size_t from = 0;
        for (std::size_t to = 1; to < levels.size(); ++to) {
            if (levels[to] < level) continue;
            EXPECT_LE(static_cast<double>(to - from), std::max(longest, 1.0));
            from = to;
        }
    }
    EXPECT_GT(kept(levels, 4), kept(keep_levels(flat.piece(4, 10)), 4));
}

TEST(NestedPolyline, NoChunkGetsMoreThanItsCapacity) {
    Line line(2049);
    std::mt19937 random(7);
    for (float& height : line.surface_m) height = static_cast<float>(random() % 100000);
    const std::vector<std::uint8_t> levels = keep_levels(line.piece(6, 1e-6));
    for (std::uint32_t level = 4; level <= 6; ++level)
        for (std::size_t first = 0; first + 1 < levels.size(); first += 16u << level) {
            std::size_t inside = 0;
            for (std::size_t n = first + 1; n < std::min<std::size_t>(first + (16u << level), levels.size() - 1); ++n)
                inside += levels[n] >= level ? 1 : 0;
            EXPECT_LE(inside, kMaxBorderInsertions + 1) << level;
        }
}

/// Pieces that are treated alone give what the whole line gives: both keep the posts where they meet.
TEST(NestedPolyline, PiecesOfALineAreIndependent) {
    const Line line = rough_line(1025);
    const std::vector<std::uint8_t> whole = keep_levels(line.piece(4, 4));
    for (const std::size_t first : {std::size_t{0}, std::size_t{512}}) {
        Line part(513);
        part.surface_m.assign(line.surface_m.begin() + static_cast<std::ptrdiff_t>(first),
                              line.surface_m.begin() + static_cast<std::ptrdiff_t>(first) + 513);
        LinePiece piece = part.piece(4, 4);
        piece.first = static_cast<std::uint32_t>(first);
        const std::vector<std::uint8_t> levels = keep_levels(piece);
        for (std::size_t n = 0; n < 513; ++n) EXPECT_EQ(levels[n], whole[first + n]) << first + n;
    }
}

}  // namespace
}  // namespace tedavis::host_sim::test_nested_polyline
