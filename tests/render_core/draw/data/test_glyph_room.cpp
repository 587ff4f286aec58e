#include "render_core/draw/data/glyph_room.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "render_core/draw/drawers/data/glyph_drawer.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/scene/glyph_selection.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::draw::test_glyph_room {
namespace {

TEST(GlyphRoom, AllOfItFitsTheLinesOfShippedDevices) {
    for (const std::string device : {"es2-small", "es3-mid", "desktop"})
        for (const std::uint32_t fields : {1u, 2u, 5u}) {
            test_support::GlSession session("egl", device);
            base::BudgetLine& gpu = *session.device.budget.find(effects::kSceneGlyphVertices);
            const std::uint64_t cpu = session.device.budget.find(effects::kSceneGlyphs)->bytes;
            const GlyphRoom room = glyph_room(GlyphDrawer::has_instances(session.gl), cpu, gpu.bytes, fields);
            EXPECT_GT(room.sites, device == "es2-small" ? 500u : 100'000u) << device;
            EXPECT_GT(room.glyphs, device == "es2-small" ? 200u : 10'000u) << device;
            std::vector<unsigned char> block(cpu);
            base::Arena arena(block.data(), block.size());
            GlyphDrawer drawer;
            EXPECT_EQ(drawer.start(session.gl, gpu, arena).message.view(), "");
            scene::GlyphSelection selection;
            EXPECT_TRUE(selection.start(arena, room.glyphs));
            EXPECT_EQ(arena.allocate_array<GlyphInstance>(room.glyphs).size(), room.glyphs);
            std::vector<scene::GlyphField> held(fields);
            for (scene::GlyphField& field : held) EXPECT_TRUE(field.start(arena, room.sites / fields)) << device;
            EXPECT_LT(arena.use().capacity - arena.use().in_use, 300u * fields) << "and nothing is left over";
            drawer.destroy(session.gl);
        }
}

TEST(GlyphRoom, ThereMayBeNone) {
    test_support::GlSession session("egl", "es2-small");
    EXPECT_EQ(glyph_room(GlyphDrawer::has_instances(session.gl), 0, 0, 1).sites, 0u);
    EXPECT_EQ(glyph_room(GlyphDrawer::has_instances(session.gl), 1 << 20, 32768, 0).sites, 0u);
    EXPECT_EQ(glyph_room(GlyphDrawer::has_instances(session.gl),
                         glyph_drawer_bytes(GlyphDrawer::has_instances(session.gl), 32768) + 200, 32768, 1)
                  .sites,
              0u);
    EXPECT_GT(glyph_room(GlyphDrawer::has_instances(session.gl), 1 << 20, 32768, 1).sites, 0u);
}

}  // namespace
}  // namespace tedavis::draw::test_glyph_room
