#include "render_core/gl/call_rules.hpp"

#include <gtest/gtest.h>

namespace tedavis::gl::test_call_rules {
namespace {

CallState state_of(effects::CallClass calls) {
    CallState state;
    state.rules.calls = calls;
    state.rules.max_texture_px = 2048;
    return state;
}

template <auto Member, class... Arguments>
bool allowed(CallState& state, Arguments... arguments) {
    return CallRule<Member>::refusal(state, arguments...) == nullptr;
}

class CallRules : public testing::Test {
protected:
    CallState es2 = state_of(effects::CallClass::es2);
    CallState es3 = state_of(effects::CallClass::es3);
    CallState sc2 = state_of(effects::CallClass::sc2);
};

TEST_F(CallRules, CallsWithoutLimitsAreNeverRefused) {
    EXPECT_TRUE((allowed<&CallTable::Viewport>(es2, 0, 0, 9, 9)));
    EXPECT_TRUE((allowed<&CallTable::Flush>(es2)));
}

TEST_F(CallRules, ABufferHasOneStorage) {
    const void* none = nullptr;
    const auto store = [&](CallState& state) {
        return allowed<&CallTable::BufferData>(state, GLenum{GL_ARRAY_BUFFER}, GLsizeiptr{64}, none, GLenum{GL_STATIC_DRAW});
    };
    EXPECT_FALSE(store(es3)) << "nothing is bound";
    for (CallState* state : {&es2, &es3, &sc2}) {
        ASSERT_TRUE((allowed<&CallTable::BindBuffer>(*state, GLenum{GL_ARRAY_BUFFER}, 7u)));
        EXPECT_TRUE(store(*state));
        EXPECT_FALSE(store(*state)) << "a second BufferData";
        ASSERT_TRUE((allowed<&CallTable::BindBuffer>(*state, GLenum{GL_ARRAY_BUFFER}, 8u)));
        EXPECT_TRUE(store(*state)) << "another buffer";
    }
    const GLuint seven = 7;
    ASSERT_TRUE((allowed<&CallTable::DeleteBuffers>(es3, 1, &seven)));
    ASSERT_TRUE((allowed<&CallTable::BindBuffer>(es3, GLenum{GL_ARRAY_BUFFER}, 7u)));
    EXPECT_TRUE(store(es3)) << "a deleted buffer's name is new again";
}

TEST_F(CallRules, DeletingABoundBufferUnbindsIt) {
    ASSERT_TRUE((allowed<&CallTable::BindBuffer>(es3, GLenum{GL_ELEMENT_ARRAY_BUFFER}, 5u)));
    const GLuint five = 5;
    ASSERT_TRUE((allowed<&CallTable::DeleteBuffers>(es3, 1, &five)));
    EXPECT_EQ(es3.element_buffer, 0u);
}

TEST_F(CallRules, MoreBuffersThanFollowedAreRefused) {
    const void* none = nullptr;
    for (GLuint name = 1; name <= kMaxBuffers; ++name) {
        ASSERT_TRUE((allowed<&CallTable::BindBuffer>(es3, GLenum{GL_ARRAY_BUFFER}, name)));
        ASSERT_TRUE((allowed<&CallTable::BufferData>(es3, GLenum{GL_ARRAY_BUFFER}, GLsizeiptr{4}, none, GLenum{GL_STATIC_DRAW})));
    }
    ASSERT_TRUE((allowed<&CallTable::BindBuffer>(es3, GLenum{GL_ARRAY_BUFFER}, GLuint{kMaxBuffers} + 1)));
    EXPECT_FALSE((allowed<&CallTable::BufferData>(es3, GLenum{GL_ARRAY_BUFFER}, GLsizeiptr{4}, none, GLenum{GL_STATIC_DRAW})));
}

TEST_F(CallRules, OnlyTrianglesWithAllowedIndicesFromABuffer) {
    const void* none = nullptr;
    const auto draw = [&](CallState& state, GLenum mode, GLenum type) {
        return allowed<&CallTable::DrawElements>(state, mode, 3, type, none);
    };
    EXPECT_FALSE(draw(es2, GL_TRIANGLES, GL_UNSIGNED_SHORT)) << "no index buffer is bound";
    for (CallState* state : {&es2, &es3, &sc2}) {
        state->element_buffer = 1;
        EXPECT_TRUE(draw(*state, GL_TRIANGLES, GL_UNSIGNED_SHORT));
        EXPECT_TRUE(draw(*state, GL_TRIANGLE_STRIP, GL_UNSIGNED_SHORT));
        EXPECT_FALSE(draw(*state, GL_LINES, GL_UNSIGNED_SHORT));
        EXPECT_FALSE(draw(*state, GL_POINTS, GL_UNSIGNED_SHORT));
        EXPECT_FALSE((allowed<&CallTable::DrawArrays>(*state, GLenum{GL_LINE_STRIP}, 0, 2)));
        EXPECT_EQ(draw(*state, GL_TRIANGLES, GL_UNSIGNED_INT), state == &es3);
    }
    EXPECT_EQ(es2.frame.draws, 2u);
    EXPECT_EQ(es2.frame.indices, 6u);
    EXPECT_FALSE((allowed<&CallTable::DrawRangeElements>(sc2, GLenum{GL_TRIANGLES}, 5u, 4u, 3, GLenum{GL_UNSIGNED_SHORT}, none)));
    EXPECT_TRUE((allowed<&CallTable::DrawRangeElements>(sc2, GLenum{GL_TRIANGLES}, 0u, 4u, 3, GLenum{GL_UNSIGNED_SHORT}, none)));
}

TEST_F(CallRules, InstancesAreCountedWithTheirIndices) {
    const void* none = nullptr;
    const auto draw = [&](GLenum mode, GLsizei count, GLenum type, GLsizei instances) {
        return allowed<&CallTable::DrawElementsInstanced>(es3, mode, count, type, none, instances);
    };
    EXPECT_FALSE(draw(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, 2)) << "no index buffer is bound";
    es3.element_buffer = 1;
    EXPECT_FALSE(draw(GL_LINES, 2, GL_UNSIGNED_SHORT, 2));
    EXPECT_FALSE(draw(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, 2));
    EXPECT_EQ(es3.frame.draws, 0u);
    EXPECT_TRUE(draw(GL_TRIANGLES, 30, GL_UNSIGNED_SHORT, 1000));
    EXPECT_EQ(es3.frame.draws, 1u);
    EXPECT_EQ(es3.frame.indices, 30'000u);
    EXPECT_TRUE(draw(GL_TRIANGLES, 30, GL_UNSIGNED_SHORT, 0));
    EXPECT_EQ(es3.frame.indices, 30'000u);
    EXPECT_TRUE((allowed<&CallTable::VertexAttribDivisor>(es3, 3u, 1u)));
    EXPECT_TRUE((allowed<&CallTable::VertexAttribDivisor>(es3, 3u, 0u)));
    EXPECT_FALSE((allowed<&CallTable::VertexAttribDivisor>(es3, 3u, 2u))) << "steps of several instances have no use here";
    EXPECT_FALSE((allowed<&CallTable::VertexAttribDivisor>(es3, es3.rules.max_attributes, 1u)));
}

TEST_F(CallRules, VertexArraysComeFromBuffersInTypesOfTheDevice) {
    const void* none = nullptr;
    const auto point = [&](CallState& state, GLuint index, GLenum type) {
        return allowed<&CallTable::VertexAttribPointer>(state, index, 3, type, GLboolean{GL_FALSE}, 12, none);
    };
    EXPECT_FALSE(point(es2, 0, GL_FLOAT)) << "client memory";
    es2.array_buffer = es3.array_buffer = 1;
    EXPECT_TRUE(point(es2, 7, GL_FLOAT));
    EXPECT_FALSE(point(es2, 8, GL_FLOAT)) << "eight attributes";
    EXPECT_FALSE(point(es2, 0, GL_HALF_FLOAT));
    EXPECT_TRUE(point(es3, 0, GL_HALF_FLOAT));
    EXPECT_FALSE((allowed<&CallTable::EnableVertexAttribArray>(es2, 8u)));
}

TEST_F(CallRules, CopiesGoIntoTheOneLevelOfATexture) {
    const auto copy = [&](GLenum target, GLint level, GLsizei edge) {
        return allowed<&CallTable::CopyTexSubImage2D>(es2, target, level, 0, 0, 0, 0, edge, edge);
    };
    EXPECT_TRUE(copy(GL_TEXTURE_2D, 0, 2048));
    EXPECT_FALSE(copy(GL_TEXTURE_2D, 0, 2049));
    EXPECT_FALSE(copy(GL_TEXTURE_2D, 1, 16));
    EXPECT_FALSE(copy(GL_TEXTURE_CUBE_MAP_POSITIVE_X, 0, 16));
    EXPECT_FALSE(device_has(sc2.rules, CallId::CopyTexSubImage2D));
}

TEST_F(CallRules, TextureFormatsAndSizes) {
    const void* none = nullptr;
    const auto image = [&](CallState& state, GLint internal, GLsizei edge, GLenum format, GLenum type) {
        return allowed<&CallTable::TexImage2D>(state, GLenum{GL_TEXTURE_2D}, 0, internal, edge, edge, 0, format, type, none);
    };
    EXPECT_TRUE(image(es2, GL_RGBA, 2048, GL_RGBA, GL_UNSIGNED_BYTE));
    EXPECT_FALSE(image(es2, GL_RGBA, 2049, GL_RGBA, GL_UNSIGNED_BYTE));
    EXPECT_FALSE(image(es2, GL_RGBA, 0, GL_RGBA, GL_UNSIGNED_BYTE));
    EXPECT_FALSE(image(es2, GL_RGBA8, 64, GL_RGBA, GL_UNSIGNED_BYTE)) << "sized formats are not ES 2.0";
    EXPECT_TRUE(image(es2, GL_LUMINANCE, 64, GL_LUMINANCE, GL_UNSIGNED_BYTE));
    EXPECT_FALSE(image(es2, GL_RED, 64, GL_RED, GL_UNSIGNED_BYTE));
    EXPECT_FALSE(image(es3, GL_R32F, 64, GL_RED, GL_FLOAT));
    const auto storage = [&](GLsizei levels, GLenum format, GLsizei edge) {
        return allowed<&CallTable::TexStorage2D>(sc2, GLenum{GL_TEXTURE_2D}, levels, format, edge, edge);
    };
    EXPECT_TRUE(storage(1, GL_RGBA8, 100));
    EXPECT_FALSE(storage(2, GL_RGBA8, 100)) << "levels need powers of two";
    EXPECT_TRUE(storage(7, GL_RGBA8, 64));
    EXPECT_FALSE(storage(1, GL_RGBA16F, 64));
    EXPECT_FALSE(storage(1, GL_DEPTH_COMPONENT24, 64));
    EXPECT_FALSE(storage(1, GL_RGBA32UI, 64));
    EXPECT_TRUE((allowed<&CallTable::TexStorage2D>(es3, GLenum{GL_TEXTURE_2D}, 1, GLenum{GL_RGBA32UI}, 64, 64)));
    EXPECT_FALSE(image(es2, GL_RGBA_INTEGER, 64, GL_RGBA_INTEGER, GL_UNSIGNED_INT));
}

TEST_F(CallRules, UploadsAreCountedInBytes) {
    const unsigned char texels[64] = {};
    const void* pixels = texels;
    const auto upload = [&](CallState& state, GLenum format) {
        return allowed<&CallTable::TexSubImage2D>(state, GLenum{GL_TEXTURE_2D}, 0, 0, 0, 4, 4, format, GLenum{GL_UNSIGNED_BYTE},
                                                  pixels);
    };
    EXPECT_TRUE(upload(es2, GL_RGBA));
    EXPECT_EQ(es2.frame.uploaded_bytes, 64u);
    EXPECT_TRUE(upload(es2, GL_LUMINANCE));
    EXPECT_EQ(es2.frame.uploaded_bytes, 80u);
    EXPECT_FALSE(upload(es2, GL_RED));
    EXPECT_EQ(es2.frame.uploaded_bytes, 80u) << "a refused upload moves nothing";
    const auto words = [&](CallState& state, GLenum format) {
        return allowed<&CallTable::TexSubImage2D>(state, GLenum{GL_TEXTURE_2D}, 0, 0, 0, 2, 2, format, GLenum{GL_UNSIGNED_INT},
                                                  pixels);
    };
    EXPECT_FALSE(words(es2, GL_RGBA_INTEGER));
    EXPECT_FALSE(words(es3, GL_RGBA));
    EXPECT_TRUE(words(es3, GL_RGBA_INTEGER));
    EXPECT_EQ(es3.frame.uploaded_bytes, 64u);
    EXPECT_TRUE((allowed<&CallTable::BufferSubData>(es2, GLenum{GL_ARRAY_BUFFER}, GLintptr{0}, GLsizeiptr{20}, pixels)));
    EXPECT_EQ(es2.frame.uploaded_bytes, 100u);
}

TEST_F(CallRules, DepthIsNever16Bits) {
    const auto store = [&](CallState& state, GLenum format) {
        return allowed<&CallTable::RenderbufferStorage>(state, GLenum{GL_RENDERBUFFER}, format, 64, 64);
    };
    for (CallState* state : {&es2, &es3, &sc2}) {
        EXPECT_FALSE(store(*state, GL_DEPTH_COMPONENT16));
        EXPECT_EQ(store(*state, GL_DEPTH_COMPONENT24), state != &sc2);
        EXPECT_EQ(store(*state, GL_RGBA8), state == &es3);
        EXPECT_FALSE((allowed<&CallTable::RenderbufferStorage>(*state, GLenum{GL_RENDERBUFFER}, GLenum{GL_RGB565}, 4096, 64)));
    }
}

TEST_F(CallRules, EnumerantsOfLaterVersionsAreRefused) {
    EXPECT_TRUE((allowed<&CallTable::Enable>(es2, GLenum{GL_DEPTH_TEST})));
    EXPECT_FALSE((allowed<&CallTable::Enable>(es3, GLenum{GL_RASTERIZER_DISCARD})));
    EXPECT_FALSE((allowed<&CallTable::Disable>(es2, GLenum{GL_PRIMITIVE_RESTART_FIXED_INDEX})));
    EXPECT_FALSE((allowed<&CallTable::BlendEquation>(es2, GLenum{GL_MAX})));
    EXPECT_TRUE((allowed<&CallTable::BlendEquation>(es3, GLenum{GL_MAX})));
    EXPECT_FALSE((allowed<&CallTable::BlendEquationSeparate>(es2, GLenum{GL_FUNC_ADD}, GLenum{GL_MIN})));
    EXPECT_FALSE((allowed<&CallTable::BindFramebuffer>(es2, GLenum{GL_READ_FRAMEBUFFER}, 0u)));
    EXPECT_TRUE((allowed<&CallTable::BindFramebuffer>(es3, GLenum{GL_READ_FRAMEBUFFER}, 0u)));
    EXPECT_FALSE((allowed<&CallTable::BindTexture>(es3, GLenum{GL_TEXTURE_3D}, 0u)));
    EXPECT_FALSE((allowed<&CallTable::BindBuffer>(es3, GLenum{GL_UNIFORM_BUFFER}, 1u)));
    EXPECT_FALSE((allowed<&CallTable::TexParameteri>(es2, GLenum{GL_TEXTURE_2D}, GLenum{GL_TEXTURE_MAX_LEVEL}, 0)));
    EXPECT_TRUE((allowed<&CallTable::TexParameteri>(es3, GLenum{GL_TEXTURE_2D}, GLenum{GL_TEXTURE_MAX_LEVEL}, 0)));
    EXPECT_FALSE((allowed<&CallTable::ActiveTexture>(es2, GLenum{GL_TEXTURE0} + 8)));
    EXPECT_TRUE((allowed<&CallTable::ActiveTexture>(es2, GLenum{GL_TEXTURE0} + 7)));
    EXPECT_FALSE((allowed<&CallTable::CreateShader>(es3, GLenum{0x91B9})));  // a compute shader
    EXPECT_FALSE((allowed<&CallTable::FramebufferTexture2D>(es2, GLenum{GL_FRAMEBUFFER}, GLenum{GL_COLOR_ATTACHMENT1},
                                                            GLenum{GL_TEXTURE_2D}, 1u, 0)));
    EXPECT_FALSE((allowed<&CallTable::FramebufferTexture2D>(es2, GLenum{GL_FRAMEBUFFER}, GLenum{GL_COLOR_ATTACHMENT0},
                                                            GLenum{GL_TEXTURE_2D}, 1u, 1)));
    EXPECT_FALSE((allowed<&CallTable::FramebufferRenderbuffer>(es2, GLenum{GL_DRAW_FRAMEBUFFER}, GLenum{GL_DEPTH_ATTACHMENT},
                                                               GLenum{GL_RENDERBUFFER}, 1u)));
}

TEST_F(CallRules, OnlyRgba8IsReadBack) {
    void* none = nullptr;
    EXPECT_TRUE((allowed<&CallTable::ReadPixels>(es2, 0, 0, 1, 1, GLenum{GL_RGBA}, GLenum{GL_UNSIGNED_BYTE}, none)));
    EXPECT_FALSE((allowed<&CallTable::ReadPixels>(es3, 0, 0, 1, 1, GLenum{GL_RGBA}, GLenum{GL_FLOAT}, none)));
    EXPECT_FALSE((allowed<&CallTable::ReadnPixels>(sc2, 0, 0, 1, 1, GLenum{GL_RGB}, GLenum{GL_UNSIGNED_BYTE}, 3, none)));
}

}  // namespace
}  // namespace tedavis::gl::test_call_rules
