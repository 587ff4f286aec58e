/// The arguments that a device allows for a call. `CallRule<&CallTable::X>::refusal` returns null when the call may go to the
/// driver, else a short reason; calls without limits use the general rule, which refuses nothing.
///
/// The rules also track the state that they need: bound buffers, buffers that have storage, and the frame's counts.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/effects/device_capability.hpp"
#include "render_core/gl/call_table.hpp"

namespace tedavis::gl {

/// GL calls and draws of one frame, read by the frame record.
struct FrameCounts {
    std::uint64_t uploaded_bytes = 0;
    std::uint32_t draws = 0;
    std::uint64_t indices = 0;  ///< indices drawn; includes vertices of DrawArrays, and counts each instance
};

inline constexpr std::size_t kMaxBuffers = 256;

struct CallState {
    effects::GlRules rules;
    GLuint array_buffer = 0;
    GLuint element_buffer = 0;
    base::FixedVector<GLuint, kMaxBuffers> stored_buffers;  ///< buffers that have received their only BufferData
    FrameCounts frame;

    [[nodiscard]] bool es3() const { return rules.calls == effects::CallClass::es3; }
    [[nodiscard]] bool sc2() const { return rules.calls == effects::CallClass::sc2; }
};

template <auto Member>
struct CallRule {
    template <class... Arguments>
    static const char* refusal(CallState&, Arguments...) {
        return nullptr;
    }
};

#define TEDAVIS_GL_RULE(name, ...)                                 \
    template <>                                                    \
    struct CallRule<&CallTable::name> {                            \
        static const char* refusal(CallState& state, __VA_ARGS__); \
    };
TEDAVIS_GL_RULE(ActiveTexture, GLenum unit)
TEDAVIS_GL_RULE(BindBuffer, GLenum target, GLuint buffer)
TEDAVIS_GL_RULE(BindFramebuffer, GLenum target, GLuint framebuffer)
TEDAVIS_GL_RULE(BindTexture, GLenum target, GLuint texture)
TEDAVIS_GL_RULE(BlendEquation, GLenum mode)
TEDAVIS_GL_RULE(BlendEquationSeparate, GLenum color, GLenum alpha)
TEDAVIS_GL_RULE(BufferData, GLenum target, GLsizeiptr bytes, const void* data, GLenum usage)
TEDAVIS_GL_RULE(BufferSubData, GLenum target, GLintptr offset, GLsizeiptr bytes, const void* data)
TEDAVIS_GL_RULE(CopyTexSubImage2D, GLenum target, GLint level, GLint x, GLint y, GLint from_x, GLint from_y, GLsizei width,
                GLsizei height)
TEDAVIS_GL_RULE(CreateShader, GLenum type)
TEDAVIS_GL_RULE(DeleteBuffers, GLsizei count, const GLuint* buffers)
TEDAVIS_GL_RULE(Disable, GLenum capability)
TEDAVIS_GL_RULE(DrawArrays, GLenum mode, GLint first, GLsizei count)
TEDAVIS_GL_RULE(DrawElements, GLenum mode, GLsizei count, GLenum type, const void* offset)
TEDAVIS_GL_RULE(DrawElementsInstanced, GLenum mode, GLsizei count, GLenum type, const void* offset, GLsizei instances)
TEDAVIS_GL_RULE(DrawRangeElements, GLenum mode, GLuint low, GLuint high, GLsizei count, GLenum type, const void* offset)
TEDAVIS_GL_RULE(Enable, GLenum capability)
TEDAVIS_GL_RULE(EnableVertexAttribArray, GLuint index)
TEDAVIS_GL_RULE(FramebufferRenderbuffer, GLenum target, GLenum attachment, GLenum kind, GLuint renderbuffer)
TEDAVIS_GL_RULE(FramebufferTexture2D, GLenum target, GLenum attachment, GLenum kind, GLuint texture, GLint level)
TEDAVIS_GL_RULE(ReadPixels, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, void* pixels)
TEDAVIS_GL_RULE(ReadnPixels, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format, GLenum type, GLsizei size,
                void* pixels)
TEDAVIS_GL_RULE(RenderbufferStorage, GLenum target, GLenum format, GLsizei width, GLsizei height)
TEDAVIS_GL_RULE(TexImage2D, GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height, GLint border,
                GLenum format, GLenum type, const void* pixels)
TEDAVIS_GL_RULE(TexParameteri, GLenum target, GLenum name, GLint value)
TEDAVIS_GL_RULE(TexStorage2D, GLenum target, GLsizei levels, GLenum format, GLsizei width, GLsizei height)
TEDAVIS_GL_RULE(TexSubImage2D, GLenum target, GLint level, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                GLenum type, const void* pixels)
TEDAVIS_GL_RULE(VertexAttribDivisor, GLuint index, GLuint divisor)
TEDAVIS_GL_RULE(VertexAttribPointer, GLuint index, GLint size, GLenum type, GLboolean normalized, GLsizei stride,
                const void* offset)
#undef TEDAVIS_GL_RULE

}  // namespace tedavis::gl
