#include "render_core/gl/program.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "platform/surface_factory.hpp"
#include "tests/support/files/device_files.hpp"
#include "tests/support/programs/gl_session.hpp"
#include "tests/support/programs/headless_backends.hpp"

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

    std::string message(const ProgramSource& source) {
        const auto program = build_program(at_.gl, source);
        return program.ok() ? "" : std::string(program.error().message.view());
    }
    GlSession at_;
};

TEST_P(ProgramTest, BindsAttributesByNameAndFindsUniforms) {
    const auto program = build_program(at_.gl, triangle_program_source());
    ASSERT_TRUE(program.ok()) << program.error().message.c_str();
    EXPECT_EQ(at_.gl->GetAttribLocation(program.value().id(), "position"), 0);
    EXPECT_EQ(at_.gl->GetAttribLocation(program.value().id(), "color"), 1);
    EXPECT_EQ(program.value().uniform(0), at_.gl->GetUniformLocation(program.value().id(), "brightness"));
    EXPECT_EQ(at_.gl.denied().total, 0u);
}

TEST_P(ProgramTest, CompilerMessagesNameTheProgramAndTheLine) {
    ProgramSource source = triangle_program_source();
    source.fragment = "VARYING vec4 tint;\nuniform float brightness;\nvoid main() { FRAGMENT_COLOR = nonsense; }\n";
    const std::string text = message(source);
    EXPECT_NE(text.find("program 'triangle' has a fragment shader that does not compile"), std::string::npos);
    EXPECT_NE(text.find("nonsense"), std::string::npos) << text;
    EXPECT_NE(text.find(":3("), std::string::npos) << "line 3 of the file: " << text;
    source = triangle_program_source();
    source.vertex = "void main() { ";
    EXPECT_NE(message(source).find("vertex shader that does not compile"), std::string::npos);
}

TEST_P(ProgramTest, LinkFaultsAndUnusedUniformsAreErrors) {
    ProgramSource source = triangle_program_source();
    source.fragment =
        "VARYING vec4 elsewhere;\nuniform float brightness;\nvoid main() { FRAGMENT_COLOR = elsewhere * brightness; }\n";
    EXPECT_NE(message(source).find("does not link"), std::string::npos);
    source = triangle_program_source();
    const char* const uniforms[] = {"brightnes"};
    source.uniforms = uniforms;
    EXPECT_EQ(message(source), "program 'triangle' does not use the uniform brightnes");
    const std::vector<const char*> many(kMaxUniforms + 1, "brightness");
    source.uniforms = {many.data(), many.size() - 1};
    EXPECT_EQ(message(source), "");
    source.uniforms = {many.data(), many.size()};
    EXPECT_EQ(message(source), "program 'triangle' has more uniforms than kMaxUniforms");
}

std::vector<Place> places() {
    std::vector<Place> all;
    for (const std::string& backend : test_support::headless_backends())
        for (const char* device : {"es2-small", "es3-mid"}) all.push_back({backend, device});
    return all;
}

INSTANTIATE_TEST_SUITE_P(Places, ProgramTest, testing::ValuesIn(places()),
                         [](const auto& place) { return place.param.backend + "_" + place.param.device.substr(0, 3); });

/// One program, and what it is asked for.
struct OneProgram final : base::ProgramStore {
    bool find(std::uint64_t key, base::StoredProgram& program) override {
        program = {format, binary};
        return key == kept;
    }
    base::Span<unsigned char> room(std::size_t bytes) override {
        if (bytes > most) return {};
        binary.resize(bytes);
        return binary;
    }
    bool keep(std::uint64_t key, std::string_view name, const base::StoredProgram& program) override {
        kept = key;
        format = program.format;
        names += name;
        return !is_full;
    }
    std::uint64_t kept = 0;
    std::uint32_t format = 0;
    std::vector<unsigned char> binary;
    std::size_t most = 1 << 20;
    std::string names;
    bool is_full = false;
};

/// The device without a compiler, and the same with one.
effects::DeviceSettings sc2_with_compiler() {
    effects::DeviceSettings device = test_support::shipped_device("sc2");
    device.capability = with_compiler(device.capability);
    return device;
}

std::unique_ptr<base::Surface> es2_surface() {
    return std::move(platform::make_surface("egl", {64, 48, platform::ContextLane::es2}).value());
}

std::string refused(GlSession& at) {
    const auto built = build_program(at.gl, triangle_program_source());
    return built.ok() ? "" : std::string(built.error().message.view());
}

void make_triangle_program(OneProgram& store) {
    GlSession maker(es2_surface(), sc2_with_compiler());
    maker.gl.use_programs(&store);
    ASSERT_EQ(refused(maker), "");
    EXPECT_EQ(store.names, "triangle");
    EXPECT_EQ(store.kept, program_key(maker.gl, triangle_program_source()));
    EXPECT_EQ(maker.gl.denied().total, 0u);
}

TEST(ProgramBinary, MadeWithACompilerServesTheDeviceWithoutOne) {
    OneProgram store;
    make_triangle_program(store);
    GlSession sc2("egl", "sc2");
    EXPECT_NE(refused(sc2).find("'triangle' has no binary for this driver, and the device has no compiler"), std::string::npos);
    sc2.gl.use_programs(&store);
    const auto loaded = build_program(sc2.gl, triangle_program_source());
    ASSERT_TRUE(loaded.ok()) << loaded.error().message.c_str();
    EXPECT_EQ(sc2.gl->GetAttribLocation(loaded.value().id(), "color"), 1);
    EXPECT_EQ(sc2.gl.denied().total, 0u);
}

TEST(ProgramBinary, ThatIsChangedOrForeignIsRefused) {
    OneProgram store;
    make_triangle_program(store);
    GlSession sc2("egl", "sc2");
    sc2.gl.use_programs(&store);
    OneProgram changed = store;
    changed.binary[changed.binary.size() / 2] ^= 1;
    sc2.gl.use_programs(&changed);
    EXPECT_NE(refused(sc2).find("'triangle' has a binary that the driver refuses; make its programs"), std::string::npos);
    changed = store;
    changed.format = 0x1234;
    EXPECT_NE(refused(sc2), "");
    EXPECT_EQ(sc2.gl.take_error(), static_cast<GLenum>(GL_NO_ERROR));
    ProgramSource other = triangle_program_source();
    const std::string text = std::string(other.fragment) + "\n";
    other.fragment = text;
    EXPECT_NE(program_key(sc2.gl, other), store.kept) << "another text is another program";
    changed = store;
    EXPECT_FALSE(build_program(sc2.gl, other).ok());
    EXPECT_EQ(sc2.gl.denied().total, 0u);
}

TEST(ProgramBinary, ADeviceFileThatNamesAllTheCallsItMayStillGetsACompiler) {
    effects::DeviceCapability device = test_support::shipped_device("sc2").capability;
    device.gl.also.clear();
    for (std::size_t n = 0; n < effects::kMaxNamedCalls; ++n) ASSERT_TRUE(device.gl.also.try_push_back("Finish"));
    const effects::DeviceCapability made = with_compiler(device);
    for (const char* call : {"CompileShader", "LinkProgram", "GetProgramBinary", "DeleteProgram"})
        EXPECT_TRUE(device_has(made.gl, find_call(call))) << call;
}

TEST(ProgramBinary, IsNotKeptWhereItCannotBe) {
    OneProgram store;
    {
        GlSession es2("egl", "es2-small");
        es2.gl.use_programs(&store);
        EXPECT_NE(refused(es2).find("no program binaries"), std::string::npos);
    }
    GlSession maker(es2_surface(), sc2_with_compiler());
    maker.gl.use_programs(&store);
    store.most = 16;
    EXPECT_NE(refused(maker).find("too many"), std::string::npos);
    store.most = 1 << 20;
    store.is_full = true;
    EXPECT_NE(refused(maker).find("full"), std::string::npos);
}

}  // namespace
}  // namespace tedavis::gl::test_program
