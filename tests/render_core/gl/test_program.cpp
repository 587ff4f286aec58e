#include "render_core/gl/program.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/gl_session.hpp"

namespace tedavis::gl::test_program {
namespace {

using test_support::GlSession;
using test_support::triangle_program_source;

struct Place {
    std::string backend, device;
};
void PrintTo(const Place& place, std::ostream* out) { *out << place.device << " on " << place.backend; }

class ProgramTest : public testing::TestWithParam<Place> {
protected:
    ProgramTest() : at_(GetParam().backend, GetParam().device) {}

    std::string sentence(const ProgramSource& source) {
        const auto program = build_program(at_.gl, source);
        return program.ok() ? "" : std::string(program.error().sentence.view());
    }
    GlSession at_;
};

TEST_P(ProgramTest, BindsAttributesByNameAndFindsUniforms) {
    const auto program = build_program(at_.gl, triangle_program_source());
    ASSERT_TRUE(program.ok()) << program.error().sentence.c_str();
    EXPECT_EQ(at_.gl->GetAttribLocation(program.value().id(), "position"), 0);
    EXPECT_EQ(at_.gl->GetAttribLocation(program.value().id(), "color"), 1);
    EXPECT_EQ(program.value().uniform(0), at_.gl->GetUniformLocation(program.value().id(), "brightness"));
    EXPECT_EQ(at_.gl.denied().total, 0u);
}

TEST_P(ProgramTest, CompilerMessagesNameTheProgramAndTheLine) {
    ProgramSource source = triangle_program_source();
    source.fragment = "VARYING vec4 tint;\nuniform float brightness;\nvoid main() { FRAGMENT_COLOR = nonsense; }\n";
    const std::string text = sentence(source);
    EXPECT_NE(text.find("program 'triangle' has a fragment shader that does not compile"), std::string::npos);
    EXPECT_NE(text.find("nonsense"), std::string::npos) << text;
    EXPECT_NE(text.find(":3("), std::string::npos) << "line 3 of the file: " << text;
    source = triangle_program_source();
    source.vertex = "void main() { ";
    EXPECT_NE(sentence(source).find("vertex shader that does not compile"), std::string::npos);
}

TEST_P(ProgramTest, LinkFaultsAndUnusedUniformsAreErrors) {
    ProgramSource source = triangle_program_source();
    source.fragment =
        "VARYING vec4 elsewhere;\nuniform float brightness;\nvoid main() { FRAGMENT_COLOR = elsewhere * brightness; }\n";
    EXPECT_NE(sentence(source).find("does not link"), std::string::npos);
    source = triangle_program_source();
    const char* const uniforms[] = {"brightnes"};
    source.uniforms = uniforms;
    EXPECT_EQ(sentence(source), "program 'triangle' does not use the uniform brightnes");
    const std::vector<const char*> many(kMaxUniforms + 1, "brightness");
    source.uniforms = {many.data(), many.size() - 1};
    EXPECT_EQ(sentence(source), "");
    source.uniforms = {many.data(), many.size()};
    EXPECT_EQ(sentence(source), "program 'triangle' has more uniforms than kMaxUniforms");
}

std::vector<Place> places() {
    std::vector<Place> all;
    for (const std::string& backend : test_support::headless_backends())
        for (const char* device : {"es2-small", "es3-mid"}) all.push_back({backend, device});
    return all;
}

INSTANTIATE_TEST_SUITE_P(Places, ProgramTest, testing::ValuesIn(places()),
                         [](const auto& place) { return place.param.backend + "_" + place.param.device.substr(0, 3); });

TEST(ProgramBinary, OfAnEs3ContextServesTheDeviceWithoutACompiler) {
    std::vector<unsigned char> binary(1 << 20);
    ProgramBinary saved;
    {
        GlSession maker("egl", "es3-mid");
        const auto program = build_program(maker.gl, triangle_program_source());
        ASSERT_TRUE(program.ok());
        const auto result = save_program(maker.gl, program.value(), binary);
        ASSERT_TRUE(result.ok()) << result.error().sentence.c_str();
        saved = result.value();
        binary.resize(saved.bytes);
        unsigned char little[4];
        EXPECT_FALSE(save_program(maker.gl, program.value(), little).ok());
    }
    GlSession sc2("egl", "sc2");
    EXPECT_FALSE(build_program(sc2.gl, triangle_program_source()).ok());
    const auto loaded = load_program(sc2.gl, triangle_program_source(), saved.format, binary);
    ASSERT_TRUE(loaded.ok()) << loaded.error().sentence.c_str();
    EXPECT_EQ(sc2.gl->GetAttribLocation(loaded.value().id(), "color"), 1);

    std::vector<unsigned char> flipped = binary;
    flipped[flipped.size() / 2] ^= 1;
    const auto refused = load_program(sc2.gl, triangle_program_source(), saved.format, flipped);
    ASSERT_FALSE(refused.ok());
    EXPECT_NE(refused.error().sentence.view().find("refused the binary of program 'triangle'"), std::string_view::npos);
    EXPECT_FALSE(load_program(sc2.gl, triangle_program_source(), 0x1234, binary).ok());
    EXPECT_EQ(sc2.gl.take_error(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(sc2.gl.denied().total, 0u);
}

TEST(ProgramBinary, NeedsTheEs3CallList) {
    GlSession at("egl", "es2-small");
    const auto program = build_program(at.gl, triangle_program_source());
    ASSERT_TRUE(program.ok());
    unsigned char memory[16];
    EXPECT_FALSE(save_program(at.gl, program.value(), memory).ok());
    EXPECT_EQ(at.gl.denied().total, 0u);
}

}  // namespace
}  // namespace tedavis::gl::test_program
