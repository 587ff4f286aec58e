#include "render_core/gl/program.hpp"

#include "render_core/gl/shader_prefix.hpp"

namespace tedavis::gl {
namespace {

constexpr std::size_t kLogLength = 768;

GLint text_length(std::string_view text) { return static_cast<GLint>(text.size()); }

GlError stage_error(const ProgramSource& source, std::string_view what, const char* log) {
    GlError error = make_error("program '", source.name, "' ", what);
    error.sentence.append(log);
    return error;
}

/// 0 and the error filled when it does not compile.
GLuint compile(Gl& gl, const ProgramSource& source, ShaderStage stage, GlError& error) {
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
    char log[kLogLength] = "no message";
    gl->GetShaderInfoLog(shader, kLogLength, nullptr, log);
    gl->DeleteShader(shader);
    error = stage_error(
        source, vertex ? "has a vertex shader that does not compile: " : "has a fragment shader that does not compile: ", log);
    return 0;
}

GlError link(Gl& gl, const ProgramSource& source, GLuint program, GLuint vertex, GLuint fragment) {
    gl->AttachShader(program, vertex);
    gl->AttachShader(program, fragment);
    for (const AttributeBinding& attribute : source.attributes)
        gl->BindAttribLocation(program, attribute.location, attribute.name);
    if (gl.has(CallId::ProgramParameteri)) gl->ProgramParameteri(program, GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
    gl->LinkProgram(program);
    GLint linked = GL_FALSE;
    gl->GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked != GL_FALSE) return {};
    char log[kLogLength] = "no message";
    gl->GetProgramInfoLog(program, kLogLength, nullptr, log);
    return stage_error(source, "does not link: ", log);
}

}  // namespace

void Program::destroy(Gl& gl) {
    if (valid() && gl.has(CallId::DeleteProgram)) gl->DeleteProgram(id_);
    *this = Program();
}

GlError Program::look_up_uniforms(Gl& gl, const ProgramSource& source) {
    for (const char* name : source.uniforms) {
        const GLint location = gl->GetUniformLocation(id_, name);
        if (location < 0 && !source.some_unused) return make_error("program '", source.name, "' does not use the uniform ", name);
        if (!uniforms_.try_push_back(location))
            return make_error("program '", source.name, "' has more uniforms than kMaxUniforms");
    }
    return {};
}

base::Result<Program, GlError> build_program(Gl& gl, const ProgramSource& source) {
    if (!gl.has(CallId::CompileShader))
        return base::fail(
            make_error("program '", source.name, "' cannot be compiled: the device has no compiler; load its binary"));
    GlError error;
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
    if (error.sentence.empty()) error = program.look_up_uniforms(gl, source);
    if (error.sentence.empty()) return program;
    program.destroy(gl);
    return base::fail(error);
}

base::Result<Program, GlError> load_program(Gl& gl, const ProgramSource& source, GLenum format,
                                            base::Span<const unsigned char> binary) {
    Program program;
    program.id_ = gl->CreateProgram();
    gl->ProgramBinary(program.id_, format, binary.data(), static_cast<GLsizei>(binary.size()));
    GLint linked = GL_FALSE;
    gl->GetProgramiv(program.id_, GL_LINK_STATUS, &linked);
    GlError error;
    if (linked == GL_FALSE)
        error = make_error("the driver refused the binary of program '", source.name,
                           "'; make the shader binaries again on this device");
    if (error.sentence.empty()) error = program.look_up_uniforms(gl, source);
    static_cast<void>(gl.take_error());  // a foreign format is also a GL error, and the sentence says it
    if (error.sentence.empty()) return program;
    program.destroy(gl);
    return base::fail(error);
}

base::Result<ProgramBinary, GlError> save_program(Gl& gl, const Program& program, base::Span<unsigned char> out) {
    if (!gl.has(CallId::GetProgramBinary) || gl.driver().program_binary_formats == 0)
        return base::fail(make_error("the driver has no program binaries; use a device with the es3 call list"));
    GLint bytes = 0;
    gl->GetProgramiv(program.id(), GL_PROGRAM_BINARY_LENGTH, &bytes);
    if (bytes <= 0 || static_cast<std::size_t>(bytes) > out.size())
        return base::fail(make_error("the program's binary does not fit the memory given for it"));
    ProgramBinary binary;
    GLsizei written = 0;
    gl->GetProgramBinary(program.id(), static_cast<GLsizei>(out.size()), &written, &binary.format, out.data());
    binary.bytes = static_cast<std::size_t>(written);
    return binary;
}

}  // namespace tedavis::gl
