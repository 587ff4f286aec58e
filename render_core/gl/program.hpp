/// A linked vertex and fragment shader, built from the same source text for both lanes (shader_prefix.hpp).
///
/// Memory    none outside the driver. Thread  the GL thread. Failure  one sentence with the compiler's message.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/result.hpp"
#include "render_core/base/span.hpp"
#include "render_core/gl/gl.hpp"

namespace tedavis::gl {

inline constexpr std::size_t kMaxUniforms = 80;

struct AttributeBinding {
    const char* name;
    GLuint location;
};

struct ProgramSource {
    const char* name = "";              ///< for messages
    std::string_view vertex, fragment;  ///< without #version
    base::Span<const AttributeBinding> attributes;
    base::Span<const char* const> uniforms;  ///< located once at build; Program::uniform(i) is the i-th
    bool some_unused = false;                ///< the program has variants: uniforms that this one lacks have location -1
};

class Program;
[[nodiscard]] base::Result<Program, base::Error> compile_program(Gl&, const ProgramSource&);
[[nodiscard]] base::Result<Program, base::Error> load_program(Gl&, const ProgramSource&, const base::StoredProgram&);

class Program {
public:
    Program() = default;
    [[nodiscard]] bool valid() const { return id_ != 0; }
    [[nodiscard]] GLuint id() const { return id_; }
    [[nodiscard]] GLint uniform(std::size_t index) const { return uniforms_[index]; }
    void use(Gl& gl) const { gl->UseProgram(id_); }
    void destroy(Gl& gl);

private:
    // Both are program.cpp's own.
    friend base::Result<Program, base::Error> compile_program(Gl&, const ProgramSource&);
    friend base::Result<Program, base::Error> load_program(Gl&, const ProgramSource&, const base::StoredProgram&);
    [[nodiscard]] base::Error look_up_uniforms(Gl& gl, const ProgramSource& source);
    GLuint id_ = 0;
    base::FixedVector<GLint, kMaxUniforms> uniforms_;
};

/// Builds a program; start stage only. It is compiled and linked for the device's lane, and stored in the Gl's program store if
/// there is one. On a device without a compiler it is read from that store; a missing, damaged or foreign binary is refused. A
/// named uniform that the program does not use is an error, since a misspelt name looks the same.
[[nodiscard]] base::Result<Program, base::Error> build_program(Gl& gl, const ProgramSource& source);

/// Returns the key of a program in the store: a hash of its text, lane and attributes, and of the driver, since only that
/// driver can load its binaries.
[[nodiscard]] std::uint64_t program_key(const Gl& gl, const ProgramSource& source);

/// Returns the device with the calls that compile programs and read their binaries, to make programs for a device that lacks
/// them.
[[nodiscard]] effects::DeviceCapability with_compiler(effects::DeviceCapability device);
[[nodiscard]] bool has_compiler(const effects::DeviceCapability& device);

}  // namespace tedavis::gl
