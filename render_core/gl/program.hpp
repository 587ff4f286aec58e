/// A linked vertex and fragment shader, built from one text for both lanes (see shader_prefix.hpp).
///
/// Memory    none of ours. Thread  the GL thread. Failure  one sentence with the compiler's message.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/result.hpp"
#include "render_core/base/span.hpp"
#include "render_core/gl/gl.hpp"

namespace tedavis::gl {

inline constexpr std::size_t kMaxUniforms = 64;

struct AttributeBinding {
    const char* name;
    GLuint location;
};

struct ProgramSource {
    const char* name = "";              ///< for messages
    std::string_view vertex, fragment;  ///< without #version
    base::Span<const AttributeBinding> attributes;
    base::Span<const char* const> uniforms;  ///< looked up once; Program::uniform(i) is the i-th
    bool some_unused = false;                ///< a program of many variants: uniforms that this one lacks are -1
};

class Program {
public:
    Program() = default;
    [[nodiscard]] bool valid() const { return id_ != 0; }
    [[nodiscard]] GLuint id() const { return id_; }
    [[nodiscard]] GLint uniform(std::size_t index) const { return uniforms_[index]; }
    void use(Gl& gl) const { gl->UseProgram(id_); }
    void destroy(Gl& gl);

private:
    friend base::Result<Program, GlError> build_program(Gl&, const ProgramSource&);
    friend base::Result<Program, GlError> load_program(Gl&, const ProgramSource&, GLenum, base::Span<const unsigned char>);
    [[nodiscard]] GlError look_up_uniforms(Gl& gl, const ProgramSource& source);
    GLuint id_ = 0;
    base::FixedVector<GLint, kMaxUniforms> uniforms_;
};

/// Compiles and links in the device's lane; start stage, es2 and es3 call lists. A named uniform that the program does not
/// use is an error, since a misspelt name looks the same.
[[nodiscard]] base::Result<Program, GlError> build_program(Gl& gl, const ProgramSource& source);

/// From a binary that this driver made (sc2 has no compiler). Attribute locations are those it was linked with. A changed or
/// foreign binary is refused: LINK_STATUS tells, GL reports no error.
[[nodiscard]] base::Result<Program, GlError> load_program(Gl& gl, const ProgramSource& source, GLenum format,
                                                          base::Span<const unsigned char> binary);

struct ProgramBinary {
    GLenum format = 0;
    std::size_t bytes = 0;
};
/// The linked program as this driver's binary, written to `out`; needs the es3 call list.
[[nodiscard]] base::Result<ProgramBinary, GlError> save_program(Gl& gl, const Program& program, base::Span<unsigned char> out);

}  // namespace tedavis::gl
