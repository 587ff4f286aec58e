#include "render_core/gl/program.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "render_core/base/hash.hpp"
#include "render_core/gl/shader_prefix.hpp"

namespace tedavis::gl {
namespace {

constexpr std::size_t kLogLength = 768;
constexpr const char* kMakeAgain =
    "; make its programs on this machine with 'tedavis-display --write-shaders' or 'tedavis shaders'";
constexpr std::string_view kCompilerCalls[] = {"AttachShader", "BindAttribLocation", "CompileShader",     "CreateShader",
                                               "DeleteShader", "GetProgramBinary",   "GetProgramInfoLog", "GetShaderInfoLog",
                                               "GetShaderiv",  "LinkProgram",        "ProgramParameteri", "ShaderSource",
                                               "DeleteProgram"};
static_assert(effects::kMaxNamedCalls + std::size(kCompilerCalls) <= effects::kMaxCallExceptions);

GLint text_length(std::string_view text) { return static_cast<GLint>(text.size()); }

base::Error stage_error(const ProgramSource& source, std::string_view what, const char* log) {
    base::Error error = base::make_error("program '", source.name, "' ", what);
    error.message.append(log[0] == '\0' ? "the driver gives no message" : log);
    return error;
}

/// 0 and the error filled when it does not compile.
GLuint compile(Gl& gl, const ProgramSource& source, ShaderStage stage, base::Error& error) {
    const bool vertex = stage == ShaderStage::vertex;
    const std::string_view prefix = shader_prefix(gl.device().lane, stage);
    const std::string_view body = vertex ? source.vertex : source.fragment;
    const GLchar* const texts[] = {prefix.data(), body.data()};
    const GLint lengths[] = {text_length(prefix), text_length(body)};
    const GLuint shader = gl->CreateShader(vertex ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
    gl->ShaderSource(shader, 2, texts, lengths);
    gl->CompileShader(shader);
    GLint compiled = GL_FALSE;
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled != GL_FALSE) return shader;
    char log[kLogLength] = "";
    gl->GetShaderInfoLog(shader, kLogLength, nullptr, log);
    gl->DeleteShader(shader);
    error = stage_error(
        source, vertex ? "has a vertex shader that does not compile: " : "has a fragment shader that does not compile: ", log);
    return 0;
}

base::Error link(Gl& gl, const ProgramSource& source, GLuint program, GLuint vertex, GLuint fragment) {
    gl->AttachShader(program, vertex);
    gl->AttachShader(program, fragment);
    for (const AttributeBinding& attribute : source.attributes)
        gl->BindAttribLocation(program, attribute.location, attribute.name);
    if (gl.has(CallId::ProgramParameteri)) gl->ProgramParameteri(program, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
    gl->LinkProgram(program);
    GLint linked = GL_FALSE;
    gl->GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked != GL_FALSE) return {};
    char log[kLogLength] = "";
    gl->GetProgramInfoLog(program, kLogLength, nullptr, log);
    return stage_error(source, "does not link: ", log);
}

base::Error distrusted(const ProgramSource& source, const KnownFault& fault) {
    return base::make_error(source.name, ": this driver's binaries of programs are not trusted, for its fault ", fault.name,
                            "; use another device, or ignore_faults in the device file's [gl] where the driver is proved good");
}

base::Error keep(Gl& gl, const ProgramSource& source, const Program& program, base::ProgramStore& store) {
    if (const KnownFault* const fault = gl.binaries_fault(); fault != nullptr) return distrusted(source, *fault);
    if (!gl.has(CallId::GetProgramBinary) || gl.driver().program_binary_formats == 0)
        return stage_error(source, "cannot be kept", ": the driver or the device's call list has no program binaries");
    GLint bytes = 0;
    gl->GetProgramiv(program.id(), GL_PROGRAM_BINARY_LENGTH, &bytes);
    const base::Span<unsigned char> room = store.room(bytes > 0 ? static_cast<std::size_t>(bytes) : 0);
    if (room.empty()) return stage_error(source, "cannot be kept", ": its binary has no bytes, or too many");
    GLsizei written = 0;
    GLenum format = 0;
    gl->GetProgramBinary(program.id(), static_cast<GLsizei>(room.size()), &written, &format, room.data());
    const base::Span<const unsigned char> binary(room.data(), static_cast<std::size_t>(written));
    if (store.keep(program_key(gl, source), source.name, {format, binary})) return {};
    return stage_error(source, "cannot be kept", ": the store of programs is full");
}

}  // namespace

void Program::destroy(Gl& gl) {
    if (valid() && gl.has(CallId::DeleteProgram)) gl->DeleteProgram(id_);
    *this = Program();
}

base::Error Program::look_up_uniforms(Gl& gl, const ProgramSource& source) {
    for (const char* name : source.uniforms) {
        const GLint location = gl->GetUniformLocation(id_, name);
        if (location < 0 && !source.some_unused)
            return base::make_error("program '", source.name, "' does not use the uniform ", name);
        if (!uniforms_.try_push_back(location))
            return base::make_error("program '", source.name, "' has more uniforms than kMaxUniforms");
    }
    return {};
}

base::Result<Program, base::Error> compile_program(Gl& gl, const ProgramSource& source) {
    base::Error error;
    const GLuint vertex = compile(gl, source, ShaderStage::vertex, error);
    if (vertex == 0) return base::fail(error);
    const GLuint fragment = compile(gl, source, ShaderStage::fragment, error);
    Program program;
    if (fragment != 0) {
        program.id_ = gl->CreateProgram();
        error = link(gl, source, program.id_, vertex, fragment);
        gl->DeleteShader(fragment);
    }
    gl->DeleteShader(vertex);
    if (!error) error = program.look_up_uniforms(gl, source);
    if (!error) return program;
    program.destroy(gl);
    return base::fail(error);
}

base::Result<Program, base::Error> load_program(Gl& gl, const ProgramSource& source, const base::StoredProgram& stored) {
    Program program;
    program.id_ = gl->CreateProgram();
    gl->ProgramBinary(program.id_, stored.format, stored.binary.data(), static_cast<GLsizei>(stored.binary.size()));
    GLint linked = GL_FALSE;
    gl->GetProgramiv(program.id_, GL_LINK_STATUS, &linked);
    base::Error error;
    if (linked == GL_FALSE)  // GL reports no error for a changed binary
        error = stage_error(source, "has a binary that the driver refuses", kMakeAgain);
    if (!error) error = program.look_up_uniforms(gl, source);
    static_cast<void>(gl.take_error());  // a foreign format is also a GL error, and the sentence says it
    if (!error) return program;
    program.destroy(gl);
    return base::fail(error);
}

base::Result<Program, base::Error> build_program(Gl& gl, const ProgramSource& source) {
    base::ProgramStore* const store = gl.programs();
    if (!gl.has(CallId::CompileShader)) {
        if (const KnownFault* const fault = gl.binaries_fault(); fault != nullptr) return base::fail(distrusted(source, *fault));
        base::StoredProgram stored;
        if (store == nullptr || !store->find(program_key(gl, source), stored))
            return base::fail(stage_error(source, "has no binary for this driver, and the device has no compiler", kMakeAgain));
        return load_program(gl, source, stored);
    }
    base::Result<Program, base::Error> built = compile_program(gl, source);
    if (!built.ok() || store == nullptr) return built;
    const base::Error error = keep(gl, source, built.value(), *store);
    if (!error) return built;
    built.value().destroy(gl);
    return base::fail(error);
}

std::uint64_t program_key(const Gl& gl, const ProgramSource& source) {
    base::Fnv1a64 key;
    const auto add = [&](std::string_view text) {
        key.add(text.data(), text.size());
        key.add("", 1);  // so that texts do not run into one another
    };
    for (std::string_view text : {gl.driver().renderer.view(), gl.driver().version.view()}) add(text);
    const effects::Lane lane = gl.device().lane;
    add(shader_prefix(lane, ShaderStage::vertex));
    add(source.vertex);
    add(shader_prefix(lane, ShaderStage::fragment));
    add(source.fragment);
    for (const AttributeBinding& attribute : source.attributes) {
        add(attribute.name);
        key.add_u32_little_endian(attribute.location);
    }
    return key.value();
}

effects::DeviceCapability with_compiler(effects::DeviceCapability device) {
    const auto never = device.gl.never;
    device.gl.never.clear();
    for (const effects::CallName& name : never)
        if (std::find(std::begin(kCompilerCalls), std::end(kCompilerCalls), name.view()) == std::end(kCompilerCalls))
            static_cast<void>(device.gl.never.try_push_back(name));
    for (const std::string_view call : kCompilerCalls)
        if (!device_has(device.gl, find_call(call))) static_cast<void>(device.gl.also.try_push_back(effects::CallName(call)));
    return device;
}

bool has_compiler(const effects::DeviceCapability& device) { return device_has(device.gl, CallId::CompileShader); }

}  // namespace tedavis::gl
