#include "render_core/draw/data/glyph_memory.hpp"

#include <gtest/gtest.h>

namespace tedavis::draw::test_glyph_memory {
namespace {

TEST(GlyphMemory, InstancesFillWhatTheirShapesLeave) {
    EXPECT_EQ(glyph_instances_within(true, kGlyphShapeBytes - 1), 0u);
    EXPECT_EQ(glyph_instances_within(true, kGlyphShapeBytes), 0u);
    EXPECT_EQ(glyph_instances_within(true, kGlyphShapeBytes + 7 * sizeof(GlyphInstance)), 7u);
    EXPECT_EQ(glyph_instances_within(true, kGlyphShapeBytes + 8 * sizeof(GlyphInstance) - 1), 7u);
    EXPECT_EQ(glyph_instances_within(false, 1000), 0xFFFFFFFFu) << "they are drawn as vertices, as many at a time as fit";
}

TEST(GlyphMemory, CornersNeedRoomInBothMemories) {
    constexpr std::uint64_t kACorner = sizeof(GlyphCorner) + kIndicesACorner * sizeof(std::uint16_t);
    EXPECT_EQ(glyph_corners_within(10 * kACorner), 10u);
    EXPECT_EQ(glyph_corners_within(10 * kACorner - 1), 9u);
    EXPECT_EQ(glyph_corners_within(std::uint64_t{1} << 40), 65'536u) << "an index has 16 bits";
    EXPECT_EQ(glyph_drawer_bytes(false, 10 * kACorner) - glyph_drawer_bytes(false, 0), 10 * kACorner);
    EXPECT_EQ(glyph_drawer_bytes(true, 10 * kACorner), glyph_drawer_bytes(true, 0)) << "instances take none of the arena";
}

}  // namespace
}  // namespace tedavis::draw::test_glyph_memory
