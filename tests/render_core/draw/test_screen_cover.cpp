#include "render_core/draw/screen_cover.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace tedavis::draw::test_screen_cover {
namespace {

constexpr std::uint32_t kWidth = 640, kHeight = 480;
constexpr float kCell = 8;

struct Batch {
    Batch() : batch({vertices.data(), vertices.size()}, {indices.data(), indices.size()}) {}
    std::vector<QuadVertex> vertices = std::vector<QuadVertex>(4096);
    std::vector<std::uint16_t> indices = std::vector<std::uint16_t>(6144);
    QuadBatch batch;
};

/// Whether a point lies in a triangle of the batch, by the signs of areas.
bool is_in(const QuadBatch& batch, Point p) {
    const auto vertices = batch.vertices();
    const auto indices = batch.indices();
    for (std::size_t n = 0; n + 2 < indices.size(); n += 3) {
        float least = 1e9f, greatest = -1e9f;
        for (std::size_t k = 0; k < 3; ++k) {
            const QuadVertex &a = vertices[indices[n + k]], &b = vertices[indices[n + (k + 1) % 3]];
            const float area = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
            least = std::min(least, area);
            greatest = std::max(greatest, area);
        }
        if (least >= 0 || greatest <= 0) return true;
    }
    return false;
}

TEST(ScreenCover, TakesEveryPointAndHardlyMore) {
    std::mt19937 random(3);
    const auto any = [&](float most) { return std::uniform_real_distribution<float>(0, most)(random); };
    for (int round = 0; round < 20; ++round) {
        Batch drawn;
        for (int n = 0; n < 3; ++n) {
            drawn.batch.line({any(640), any(480)}, {any(640), any(480)}, 1 + any(6), {});
            drawn.batch.box({any(600), any(400), any(90), any(90)}, {});
            const Point tip{any(600), any(400)};
            drawn.batch.triangle(tip, {tip.x + 10, tip.y + 60}, {tip.x + 40, tip.y + 5}, {});
        }
        ScreenCover cover;
        cover.clear(kWidth, kHeight, kCell);
        cover.take(drawn.batch);
        int taken = 0;
        for (int n = 0; n < 2000; ++n) {
            const Point p{any(640), any(480)};
            const bool is_free = cover.is_free({p.x, p.y, 0, 0});
            if (is_in(drawn.batch, p)) {
                ASSERT_FALSE(is_free) << p.x << ", " << p.y;
            }
            if (is_free) continue;
            ++taken;
            bool near = false;
            for (float dy = -kCell; dy <= kCell; ++dy)
                for (float dx = -kCell; dx <= kCell; ++dx) near = near || is_in(drawn.batch, {p.x + dx, p.y + dy});
            ASSERT_TRUE(near) << "a cell away at most: " << p.x << ", " << p.y;
        }
        EXPECT_GT(taken, 100);
    }
}

TEST(ScreenCover, ABoxIsFreeWhereNoneOfItsCellsIsTaken) {
    Batch drawn;
    drawn.batch.box({300, 200, 40, 20}, {});
    ScreenCover cover;
    cover.clear(kWidth, kHeight, kCell);
    EXPECT_TRUE(cover.is_free({0, 0, 640, 480}));
    cover.take(drawn.batch);
    EXPECT_FALSE(cover.is_free({0, 0, 640, 480})) << "though its corners are free";
    EXPECT_FALSE(cover.is_free({330, 210, 200, 3}));
    EXPECT_TRUE(cover.is_free({360, 210, 200, 3}));
    EXPECT_TRUE(cover.is_free({300, 240, 40, 20}));
    EXPECT_FALSE(cover.is_free({-100, -100, 1000, 1000}));
    cover.clear(kWidth, kHeight, kCell);
    EXPECT_TRUE(cover.is_free({300, 200, 40, 20}));
}

/// An upright box is taken at once; the same one as two triangles that have corners of their own is not.
TEST(ScreenCover, ABoxTakesWhatItsTrianglesTake) {
    std::mt19937 random(7);
    const auto any = [&](float most) { return std::uniform_real_distribution<float>(-40, most)(random); };
    for (int round = 0; round < 300; ++round) {
        Batch whole, halves;
        whole.batch.box({any(640), any(480), std::abs(any(90)), std::abs(any(90))}, {});
        const auto vertices = whole.batch.vertices();
        const auto corner = [&](std::size_t n) { return Point{vertices[n].x, vertices[n].y}; };
        halves.batch.triangle(corner(0), corner(1), corner(2), {});
        halves.batch.triangle(corner(0), corner(2), corner(3), {});
        ScreenCover of_whole, of_halves;
        of_whole.clear(kWidth, kHeight, kCell);
        of_halves.clear(kWidth, kHeight, kCell);
        of_whole.take(whole.batch, 3);
        of_halves.take(halves.batch, 3);
        for (float y = 0; y < kHeight; y += kCell)
            for (float x = 0; x < kWidth; x += kCell)
                ASSERT_EQ(of_whole.is_free({x + 1, y + 1, 1, 1}), of_halves.is_free({x + 1, y + 1, 1, 1})) << x << ", " << y;
    }
}

TEST(ScreenCover, LargePicturesHaveLargerCells) {
    Batch drawn;
    drawn.batch.box({3700, 2000, 100, 100}, {});
    ScreenCover cover;
    cover.clear(3840, 2160, 1);
    cover.take(drawn.batch);
    EXPECT_FALSE(cover.is_free({3790, 2050, 5, 5}));
    EXPECT_TRUE(cover.is_free({3600, 2050, 5, 5}));
}

}  // namespace
}  // namespace tedavis::draw::test_screen_cover
