#include "render_core/gl/gl.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "platform/surface_factory.hpp"
#include "tests/support/programs/gl_session.hpp"

namespace tedavis::gl::test_gl {
namespace {

using test_support::GlSession;
using test_support::TriangleScene;

std::uint64_t denied(const Gl& gl, CallId call) {
    std::uint64_t count = 0;
    for (const DeniedCall& one : gl.denied().first)
        if (one.call == call) count += one.count;
    return count;
}

TEST(Gl, CallsOutsideTheDeviceAreCountedByNameAndNotExecuted) {
    GlSession at("egl", "es2-small");
    GLuint texture = 0;
    at.gl->GenTextures(1, &texture);
    at.gl->BindTexture(GL_TEXTURE_2D, texture);
    at.gl->TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 8, 8);  // ES 3.0
    at.gl->TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, 8, 8);
    at.gl->DrawRangeElements(GL_TRIANGLES, 0, 2, 3, GL_UNSIGNED_SHORT, nullptr);
    EXPECT_EQ(at.gl.denied().total, 3u);
    EXPECT_EQ(denied(at.gl, CallId::TexStorage2D), 2u);
    EXPECT_EQ(denied(at.gl, CallId::DrawRangeElements), 1u);
    // Not executed: an immutable texture would refuse TexImage2D.
    at.gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 8, 8, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(at.gl.take_error(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(at.gl.denied().total, 3u);
}

TEST(Gl, ReportsAResetStatusWhereTheDriverIsRobust) {
    GlSession at("egl", "sc2");
    EXPECT_EQ(at.gl->GetGraphicsResetStatus(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(at.gl.denied().total, 0u);
}

TEST(Gl, DeniedCallsReturnZero) {
    GlSession at("egl", "sc2");
    EXPECT_EQ(at.gl->CreateShader(GL_VERTEX_SHADER), 0u);
    EXPECT_EQ(denied(at.gl, CallId::CreateShader), 1u);
    EXPECT_NE(at.gl->CreateProgram(), 0u) << "sc2 has programs, from binaries";
}

TEST(Gl, SealIsOneWayAndDeniesStartUpCalls) {
    GlSession at("egl", "es3-mid");
    TriangleScene scene(at.gl, at.device.budget);
    scene.draw(at.gl, *at.surface);
    const auto before = at.pixels();
    at.gl.seal();
    EXPECT_EQ(at.gl.stage(), Stage::run);
    scene.draw(at.gl, *at.surface);
    EXPECT_EQ(at.pixels(), before);
    EXPECT_EQ(at.gl.denied().total, 0u) << "drawing needs no start-up call";

    GLuint name = 0;
    at.gl->GenBuffers(1, &name);
    EXPECT_EQ(name, 0u);
    EXPECT_EQ(at.gl->CreateProgram(), 0u);
    EXPECT_EQ(at.gl->CreateShader(GL_VERTEX_SHADER), 0u);
    at.gl->BufferData(GL_ARRAY_BUFFER, 64, nullptr, GL_STATIC_DRAW);
    EXPECT_EQ(at.gl->GetString(GL_VERSION), nullptr);
    at.gl->DeleteBuffers(1, &name);
    EXPECT_EQ(at.gl.denied().total, 6u);
    EXPECT_STREQ(at.gl.denied().first[0].reason, "a start-up call after the start");
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_DEATH(at.gl.seal(), "stage_ == Stage::start");
}

TEST(Gl, RetiredGlOnlyDeletes) {
    GlSession at("egl", "es3-mid");
    TriangleScene scene(at.gl, at.device.budget);
    at.gl.seal();
    at.gl.retire();
    scene.destroy(at.gl);
    EXPECT_EQ(at.gl.denied().total, 0u);
    at.gl->Clear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(denied(at.gl, CallId::Clear), 1u);
    EXPECT_STREQ(at.gl.denied().first[0].reason, "only deletion is left after the run");
}

TEST(Gl, LedgerCountsOneFrame) {
    GlSession at("egl", "es3-mid");
    TriangleScene scene(at.gl, at.device.budget);
    at.gl.begin_frame();
    EXPECT_EQ(at.gl.frame().uploaded_bytes, 0u);
    scene.draw(at.gl, *at.surface);
    EXPECT_EQ(at.gl.frame().draws, 1u);
    EXPECT_EQ(at.gl.frame().indices, 6u);
    const float values[4] = {};
    at.gl->BufferSubData(GL_ARRAY_BUFFER, 0, sizeof values, values);
    EXPECT_EQ(at.gl.frame().uploaded_bytes, sizeof values);
    at.gl.begin_frame();
    EXPECT_EQ(at.gl.frame().draws, 0u);
}

TEST(Gl, CallsOnAnInactiveGlStopTheProgram) {
    GlSession at("egl", "es3-mid");
    at.surface->release_current();
    GlSession other("egl", "es3-mid");
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_DEATH(at.gl->Flush(), "active_gl == this");
    other.surface->release_current();
    ASSERT_TRUE(at.surface->make_current());
    at.gl.activate();
    at.gl->Flush();
    EXPECT_EQ(at.gl.denied().total, 0u);
}

class OpenRefuses : public testing::Test {
protected:
    OpenRefuses() : device_(), surface_(platform::make_surface("egl", {64, 48, platform::ContextLane::es3})) {
        EXPECT_TRUE(surface_.ok());
        EXPECT_TRUE(surface_.value()->make_current());
    }
    ~OpenRefuses() override { surface_.value()->release_current(); }

    std::string message() {
        Gl gl;
        const auto facts = gl.open(*surface_.value(), device_);
        return facts.ok() ? "" : std::string(facts.error().message.view());
    }

    effects::DeviceCapability device_;
    base::Result<std::unique_ptr<base::Surface>, base::Error> surface_;
};

TEST_F(OpenRefuses, NothingOnAGoodDevice) { EXPECT_EQ(message(), ""); }

TEST_F(OpenRefuses, AnUnknownCallName) {
    ASSERT_TRUE(device_.gl.also.try_push_back("DrawMagic"));
    EXPECT_NE(message().find("'DrawMagic'"), std::string::npos);
}

TEST_F(OpenRefuses, ADepthBufferThatIsTooShallow) {
    device_.surface_depth_bits = 33;
    EXPECT_NE(message().find("depth bits"), std::string::npos);
}

TEST_F(OpenRefuses, LimitsBeyondTheDriver) {
    device_.gl.max_texture_px = 1u << 20;
    EXPECT_NE(message().find("smaller limits"), std::string::npos);
}

/// A driver that is real but pretends to lack one call.
class Lacking final : public base::Surface {
public:
    Lacking(base::Surface& whole, const char* missing) : whole_(whole), missing_(missing) {}
    std::uint32_t width() const override { return whole_.width(); }
    std::uint32_t height() const override { return whole_.height(); }
    bool make_current() override { return whole_.make_current(); }
    void release_current() override { whole_.release_current(); }
    void* proc_address(const char* name) override {
        return std::strncmp(name, missing_, std::strlen(missing_)) == 0 ? nullptr : whole_.proc_address(name);
    }
    base::SurfaceState present() override { return whole_.present(); }
    const char* backend_name() const override { return whole_.backend_name(); }

private:
    base::Surface& whole_;
    const char* missing_;
};

TEST_F(OpenRefuses, ADriverThatLacksAnAllowedCall) {
    Lacking lacking(*surface_.value(), "glScissor");
    Gl gl;
    const auto facts = gl.open(lacking, device_);
    ASSERT_FALSE(facts.ok());
    EXPECT_NE(facts.error().message.view().find("lacks glScissor"), std::string_view::npos);
    EXPECT_EQ(gl.stage(), Stage::closed);

    Lacking harmless(*surface_.value(), "glReadnPixels");  // not in the device's list
    Gl second;
    EXPECT_TRUE(second.open(harmless, device_).ok());
}

}  // namespace
}  // namespace tedavis::gl::test_gl
