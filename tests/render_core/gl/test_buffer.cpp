#include "render_core/gl/buffer.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "tests/support/programs/gl_session.hpp"

namespace tedavis::gl::test_buffer {
namespace {

class BufferTest : public testing::Test {
protected:
    BufferTest() : at_("egl", "es3-mid") {
        line_.name = "probe";
        line_.kind = base::MemoryKind::gpu;
        line_.bytes = 1000;
    }
    base::Result<Buffer, base::Error> make(std::uint64_t bytes) {
        return make_buffer(at_.gl, line_, BufferKind::vertices, BufferUse::streamed, bytes);
    }

    test_support::GlSession at_;
    base::BudgetLine line_;
};

TEST_F(BufferTest, TakesItsBytesFromTheLineAndGivesThemBack) {
    auto buffer = make(600);
    ASSERT_TRUE(buffer.ok());
    EXPECT_EQ(line_.use.in_use, 600u);
    EXPECT_EQ(buffer.value().bytes(), 600u);
    buffer.value().destroy(at_.gl);
    EXPECT_EQ(line_.use.in_use, 0u);
    EXPECT_FALSE(buffer.value().valid());
    buffer.value().destroy(at_.gl);  // again is nothing
    EXPECT_EQ(line_.use.in_use, 0u);
}

TEST_F(BufferTest, OverBudgetIsRefusedAndNamed) {
    auto first = make(600);
    ASSERT_TRUE(first.ok());
    const auto second = make(500);
    ASSERT_FALSE(second.ok());
    EXPECT_NE(second.error().message.view().find("'probe' has 400 of 1000"), std::string_view::npos);
    EXPECT_EQ(line_.use.in_use, 600u);
    EXPECT_EQ(line_.use.refused, 1u);
    EXPECT_FALSE(make(0).ok());
}

TEST_F(BufferTest, UploadsStayInside) {
    auto buffer = make(100);
    ASSERT_TRUE(buffer.ok());
    const unsigned char bytes[128] = {};
    EXPECT_TRUE(buffer.value().upload(at_.gl, 0, bytes, 100));
    EXPECT_TRUE(buffer.value().upload(at_.gl, 90, bytes, 10));
    EXPECT_FALSE(buffer.value().upload(at_.gl, 91, bytes, 10));
    EXPECT_FALSE(buffer.value().upload(at_.gl, ~std::uint64_t{0}, bytes, 10));
    EXPECT_FALSE(buffer.value().upload(at_.gl, 0, bytes, 101));
    EXPECT_TRUE(buffer.value().upload(at_.gl, 100, bytes, 0));
    EXPECT_EQ(at_.gl.frame().uploaded_bytes, 110u);
    EXPECT_FALSE(Buffer().upload(at_.gl, 0, bytes, 0));
}

TEST_F(BufferTest, MovesWithItsBytes) {
    auto made = make(100);
    ASSERT_TRUE(made.ok());
    const GLuint id = made.value().id();
    Buffer moved(std::move(made.value()));
    EXPECT_EQ(moved.id(), id);
    EXPECT_FALSE(made.value().valid());
    moved.destroy(at_.gl);
    EXPECT_EQ(line_.use.in_use, 0u);
}

TEST_F(BufferTest, SecondStorageIsRefused) {
    auto buffer = make(100);
    ASSERT_TRUE(buffer.ok());
    buffer.value().bind(at_.gl);
    at_.gl->BufferData(GL_ARRAY_BUFFER, 4000, nullptr, GL_STATIC_DRAW);
    EXPECT_EQ(at_.gl.denied().total, 1u);
    EXPECT_EQ(at_.gl.denied().first[0].call, CallId::BufferData);
}

TEST_F(BufferTest, CreationAfterTheStartIsRefusedAndTakesNothing) {
    at_.gl.seal();
    EXPECT_FALSE(make(100).ok());
    EXPECT_EQ(line_.use.in_use, 0u);
    EXPECT_GT(at_.gl.denied().total, 0u);
}

TEST(BufferOnSc2, KeepsItsBytesBecauseNothingCanBeDeleted) {
    test_support::GlSession at("egl", "sc2");
    base::BudgetLine line;
    line.bytes = 1000;
    auto buffer = make_buffer(at.gl, line, BufferKind::indices, BufferUse::fixed, 100);
    ASSERT_TRUE(buffer.ok());
    buffer.value().destroy(at.gl);
    EXPECT_EQ(line.use.in_use, 100u);
    EXPECT_EQ(at.gl.denied().total, 0u);
}

}  // namespace
}  // namespace tedavis::gl::test_buffer
