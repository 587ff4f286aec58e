#include "render_core/gl/capability_probe.hpp"

#include <gtest/gtest.h>

#include "tests/support/programs/gl_session.hpp"
#include "tests/support/programs/headless_backends.hpp"

namespace tedavis::gl::test_capability_probe {
namespace {

TEST(ParseVersion, ReadsEmbeddedAndDesktopForms) {
    DriverFacts facts;
    ASSERT_TRUE(parse_version("OpenGL ES 3.2 Mesa 22.3.6", facts));
    EXPECT_TRUE(facts.embedded);
    EXPECT_EQ(facts.major, 3);
    EXPECT_EQ(facts.minor, 2);
    ASSERT_TRUE(parse_version("4.5 (Compatibility Profile) Mesa 22.3.6", facts));
    EXPECT_FALSE(facts.embedded);
    EXPECT_EQ(facts.major, 4);
    EXPECT_EQ(facts.minor, 5);
    ASSERT_TRUE(parse_version("OpenGL ES 2.0", facts));
    EXPECT_EQ(facts.major * 10 + facts.minor, 20);
}

TEST(ParseVersion, RefusesWhatIsNone) {
    DriverFacts facts;
    for (const char* text : {"", "OpenGL ES ", "OpenGL ES-CM 1.1", "Mesa 22", "4", "4.", "OpenGL ES 3,2"})
        EXPECT_FALSE(parse_version(text, facts)) << text;
}

TEST(HasExtension, MatchesWholeWords) {
    const char* list = "GL_OES_depth24_stencil GL_OES_depth24 GL_EXT_robustness";
    EXPECT_TRUE(has_extension(list, "GL_OES_depth24"));
    EXPECT_TRUE(has_extension(list, "GL_EXT_robustness"));
    EXPECT_FALSE(has_extension(list, "GL_OES_depth"));
    EXPECT_FALSE(has_extension("GL_OES_depth24_stencil", "GL_OES_depth24"));
    EXPECT_FALSE(has_extension("XGL_OES_depth24", "GL_OES_depth24"));
    EXPECT_FALSE(has_extension("", "GL_OES_depth24"));
    EXPECT_FALSE(has_extension(list, ""));
}

DriverFacts version(bool embedded, int major, int minor) {
    DriverFacts facts;
    facts.embedded = embedded;
    facts.major = major;
    facts.minor = minor;
    return facts;
}

TEST(Provides, FollowsTheVersion) {
    EXPECT_TRUE(provides(version(true, 2, 0), CallOrigin::es20));
    EXPECT_FALSE(provides(version(true, 2, 0), CallOrigin::es30));
    EXPECT_FALSE(provides(version(true, 1, 1), CallOrigin::es20));
    EXPECT_TRUE(provides(version(true, 3, 0), CallOrigin::es30));
    EXPECT_FALSE(provides(version(false, 4, 0), CallOrigin::es20));
    EXPECT_TRUE(provides(version(false, 4, 3), CallOrigin::es30));
    DriverFacts facts = version(true, 2, 0);
    EXPECT_FALSE(provides(facts, CallOrigin::storage));
    facts.texture_storage = facts.program_binary = facts.robustness = true;
    for (CallOrigin origin : {CallOrigin::storage, CallOrigin::binary, CallOrigin::robust}) EXPECT_TRUE(provides(facts, origin));
}

TEST(ProbeDriver, FindsPlausibleLimitsOnEveryBackend) {
    for (const std::string& backend : test_support::headless_backends()) {
        test_support::GlSession at(backend, "es3-mid");
        const DriverFacts& facts = at.gl.driver();
        EXPECT_FALSE(facts.version.empty());
        EXPECT_FALSE(facts.renderer.empty());
        EXPECT_EQ(facts.embedded, backend == "egl");
        EXPECT_GE(facts.depth_bits, 24);
        EXPECT_GE(facts.max_texture_px, 4096);
        EXPECT_GE(facts.max_attributes, 16);
        EXPECT_GE(facts.max_texture_units, 16);
        EXPECT_TRUE(facts.depth24_targets);
    }
}

class SurfaceWithoutGl final : public base::Surface {
public:
    std::uint32_t width() const override { return 16; }
    std::uint32_t height() const override { return 16; }
    bool make_current() override { return true; }
    void release_current() override {}
    void* proc_address(const char*) override { return nullptr; }
    base::SurfaceState present() override { return base::SurfaceState::failed; }
    const char* backend_name() const override { return "mute"; }
};

TEST(ProbeDriver, RefusesASurfaceWithoutGl) {
    SurfaceWithoutGl surface;
    const auto facts = probe_driver(surface);
    ASSERT_FALSE(facts.ok());
    EXPECT_NE(facts.error().message.view().find("the mute surface has no GL"), std::string_view::npos);
}

}  // namespace
}  // namespace tedavis::gl::test_capability_probe
