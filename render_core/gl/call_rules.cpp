#include "render_core/gl/call_rules.hpp"

#include <initializer_list>

namespace tedavis::gl {
namespace {

constexpr const char* kTarget = "target outside the device's list";
constexpr const char* kFormat = "format outside the device's list";
constexpr const char* kSize = "larger than the device allows";
constexpr const char* kMode = "only triangles are drawn; lines and points are quads";
constexpr const char* kIndexType = "index type outside the device's list";
constexpr const char* kClientMemory = "no buffer is bound; client memory is not drawn from";
constexpr const char* kAttributes = "more attributes than the device has";
constexpr const char* kEnumerant = "value outside the device's list";

bool one_of(GLenum value, std::initializer_list<GLenum> choices) {
    for (GLenum choice : choices)
        if (value == choice) return true;
    return false;
}

const char* size_refusal(const CallState& state, GLsizei width, GLsizei height) {
    const auto limit = static_cast<std::int64_t>(state.rules.max_texture_px);
    return width < 1 || height < 1 || width > limit || height > limit ? kSize : nullptr;
}

/// Bytes of a texel of the formats that the rules let through.
std::uint64_t texel_bytes(GLenum format, GLenum type) {
    if (type == GL_HALF_FLOAT) return 8;
    if (type == GL_UNSIGNED_INT) return 16;
    switch (format) {
        case GL_RGBA: return 4;
        case GL_RGB: return 3;
        case GL_RG:
        case GL_LUMINANCE_ALPHA: return 2;
        default: return 1;
    }
}

const char* upload_format_refusal(const CallState& state, GLenum format, GLenum type) {
    if (type == GL_HALF_FLOAT) return state.es3() && format == GL_RGBA ? nullptr : kFormat;
    if (type == GL_UNSIGNED_INT) return state.es3() && format == GL_RGBA_INTEGER ? nullptr : kFormat;
    if (type != GL_UNSIGNED_BYTE) return kFormat;
    if (one_of(format, {GL_RGBA, GL_RGB})) return nullptr;
    if (state.rules.calls == effects::CallClass::es2)
        return one_of(format, {GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_ALPHA}) ? nullptr : kFormat;
    return one_of(format, {GL_RED, GL_RG}) ? nullptr : kFormat;
}

bool power_of_two(GLsizei value) { return value > 0 && (value & (value - 1)) == 0; }

const char* capability_refusal(GLenum capability) {
    return one_of(capability,
                  {GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_DITHER, GL_POLYGON_OFFSET_FILL, GL_SCISSOR_TEST, GL_STENCIL_TEST})
               ? nullptr
               : kEnumerant;
}

const char* blend_refusal(const CallState& state, GLenum mode) {
    if (one_of(mode, {GL_FUNC_ADD, GL_FUNC_SUBTRACT, GL_FUNC_REVERSE_SUBTRACT})) return nullptr;
    return state.es3() && one_of(mode, {GL_MIN, GL_MAX}) ? nullptr : kEnumerant;
}

const char* framebuffer_refusal(const CallState& state, GLenum target) {
    if (target == GL_FRAMEBUFFER) return nullptr;
    return state.es3() && one_of(target, {GL_READ_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER}) ? nullptr : kTarget;
}

const char* attachment_refusal(const CallState& state, GLenum target, GLenum attachment) {
    if (const char* refusal = framebuffer_refusal(state, target)) return refusal;
    return one_of(attachment, {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT}) ? nullptr : kEnumerant;
}

const char* indexed_draw_refusal(CallState& state, GLenum mode, GLsizei count, GLenum type, GLsizei instances = 1) {
    if (mode != GL_TRIANGLES && mode != GL_TRIANGLE_STRIP) return kMode;
    if (type != GL_UNSIGNED_SHORT && !(state.es3() && type == GL_UNSIGNED_INT)) return kIndexType;
    if (state.element_buffer == 0) return kClientMemory;
    ++state.frame.draws;
    if (count > 0 && instances > 0)
        state.frame.indices += static_cast<std::uint64_t>(count) * static_cast<std::uint64_t>(instances);
    return nullptr;
}

const char* read_refusal(GLenum format, GLenum type) { return format == GL_RGBA && type == GL_UNSIGNED_BYTE ? nullptr : kFormat; }

GLuint bound(const CallState& state, GLenum target) {
    return target == GL_ELEMENT_ARRAY_BUFFER ? state.element_buffer : state.array_buffer;
}

bool has_storage(const CallState& state, GLuint buffer) {
    for (GLuint stored : state.stored_buffers)
        if (stored == buffer) return true;
    return false;
}

}  // namespace

const char* CallRule<&CallTable::ActiveTexture>::refusal(CallState& state, GLenum unit) {
    return unit >= GL_TEXTURE0 && unit - GL_TEXTURE0 < state.rules.max_texture_units ? nullptr : kEnumerant;
}

const char* CallRule<&CallTable::BindBuffer>::refusal(CallState& state, GLenum target, GLuint buffer) {
    if (!one_of(target, {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER})) return kTarget;
    (target == GL_ARRAY_BUFFER ? state.array_buffer : state.element_buffer) = buffer;
    return nullptr;
}

const char* CallRule<&CallTable::BindFramebuffer>::refusal(CallState& state, GLenum target, GLuint) {
    return framebuffer_refusal(state, target);
}

const char* CallRule<&CallTable::BindTexture>::refusal(CallState&, GLenum target, GLuint) {
    return target == GL_TEXTURE_2D ? nullptr : kTarget;
}

const char* CallRule<&CallTable::BlendEquation>::refusal(CallState& state, GLenum mode) { return blend_refusal(state, mode); }

const char* CallRule<&CallTable::BlendEquationSeparate>::refusal(CallState& state, GLenum color, GLenum alpha) {
    const char* refusal = blend_refusal(state, color);
    return refusal != nullptr ? refusal : blend_refusal(state, alpha);
}

const char* CallRule<&CallTable::BufferData>::refusal(CallState& state, GLenum target, GLsizeiptr bytes, const void* data,
                                                      GLenum usage) {
    if (!one_of(target, {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER})) return kTarget;
    if (!one_of(usage, {GL_STREAM_DRAW, GL_STATIC_DRAW, GL_DYNAMIC_DRAW})) return kEnumerant;
    const GLuint buffer = bound(state, target);
    if (buffer == 0) return kClientMemory;
    if (has_storage(state, buffer)) return "the buffer has its storage; a second BufferData would allocate again";
    if (!state.stored_buffers.try_push_back(buffer)) return "more buffers than the call table follows";
    if (data != nullptr && bytes > 0) state.frame.uploaded_bytes += static_cast<std::uint64_t>(bytes);
    return nullptr;
}

const char* CallRule<&CallTable::BufferSubData>::refusal(CallState& state, GLenum target, GLintptr, GLsizeiptr bytes,
                                                         const void*) {
    if (!one_of(target, {GL_ARRAY_BUFFER, GL_ELEMENT_ARRAY_BUFFER})) return kTarget;
    if (bytes > 0) state.frame.uploaded_bytes += static_cast<std::uint64_t>(bytes);
    return nullptr;
}

const char* CallRule<&CallTable::CopyTexSubImage2D>::refusal(CallState& state, GLenum target, GLint level, GLint, GLint, GLint,
                                                             GLint, GLsizei width, GLsizei height) {
    if (target != GL_TEXTURE_2D) return kTarget;
    if (level != 0) return kEnumerant;
    return size_refusal(state, width, height);
}

const char* CallRule<&CallTable::CreateShader>::refusal(CallState&, GLenum type) {
    return one_of(type, {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER}) ? nullptr : kEnumerant;
}

const char* CallRule<&CallTable::DeleteBuffers>::refusal(CallState& state, GLsizei count, const GLuint* buffers) {
    auto& stored = state.stored_buffers;
    for (GLsizei i = 0; i < count; ++i) {
        if (state.array_buffer == buffers[i]) state.array_buffer = 0;
        if (state.element_buffer == buffers[i]) state.element_buffer = 0;
        for (std::size_t k = 0; k < stored.size(); ++k) {
            if (stored[k] != buffers[i]) continue;
            stored[k] = stored.back();
            stored.pop_back();
            break;
        }
    }
    return nullptr;
}

const char* CallRule<&CallTable::Disable>::refusal(CallState&, GLenum capability) { return capability_refusal(capability); }

const char* CallRule<&CallTable::DrawArrays>::refusal(CallState& state, GLenum mode, GLint, GLsizei count) {
    if (mode != GL_TRIANGLES && mode != GL_TRIANGLE_STRIP) return kMode;
    ++state.frame.draws;
    state.frame.indices += count > 0 ? static_cast<std::uint64_t>(count) : 0;
    return nullptr;
}

const char* CallRule<&CallTable::DrawElements>::refusal(CallState& state, GLenum mode, GLsizei count, GLenum type, const void*) {
    return indexed_draw_refusal(state, mode, count, type);
}

const char* CallRule<&CallTable::DrawElementsInstanced>::refusal(CallState& state, GLenum mode, GLsizei count, GLenum type,
                                                                 const void*, GLsizei instances) {
    return indexed_draw_refusal(state, mode, count, type, instances);
}

const char* CallRule<&CallTable::DrawRangeElements>::refusal(CallState& state, GLenum mode, GLuint low, GLuint high,
                                                             GLsizei count, GLenum type, const void*) {
    if (high < low) return kEnumerant;
    return indexed_draw_refusal(state, mode, count, type);
}

const char* CallRule<&CallTable::Enable>::refusal(CallState&, GLenum capability) { return capability_refusal(capability); }

const char* CallRule<&CallTable::EnableVertexAttribArray>::refusal(CallState& state, GLuint index) {
    return index < state.rules.max_attributes ? nullptr : kAttributes;
}

const char* CallRule<&CallTable::FramebufferRenderbuffer>::refusal(CallState& state, GLenum target, GLenum attachment, GLenum,
                                                                   GLuint) {
    return attachment_refusal(state, target, attachment);
}

const char* CallRule<&CallTable::FramebufferTexture2D>::refusal(CallState& state, GLenum target, GLenum attachment, GLenum kind,
                                                                GLuint, GLint level) {
    if (kind != GL_TEXTURE_2D) return kTarget;
    if (level != 0) return kEnumerant;
    return attachment_refusal(state, target, attachment);
}

const char* CallRule<&CallTable::ReadPixels>::refusal(CallState&, GLint, GLint, GLsizei, GLsizei, GLenum format, GLenum type,
                                                      void*) {
    return read_refusal(format, type);
}

const char* CallRule<&CallTable::ReadnPixels>::refusal(CallState&, GLint, GLint, GLsizei, GLsizei, GLenum format, GLenum type,
                                                       GLsizei, void*) {
    return read_refusal(format, type);
}

const char* CallRule<&CallTable::RenderbufferStorage>::refusal(CallState& state, GLenum target, GLenum format, GLsizei width,
                                                               GLsizei height) {
    if (target != GL_RENDERBUFFER) return kTarget;
    const bool color = one_of(format, {GL_RGBA4, GL_RGB5_A1, GL_RGB565}) || (state.es3() && format == GL_RGBA8);
    // A 16-bit depth buffer cannot separate near from far terrain, so it is never requested.
    const bool depth = !state.sc2() && format == GL_DEPTH_COMPONENT24;
    if (!color && !depth && format != GL_STENCIL_INDEX8) return kFormat;
    return size_refusal(state, width, height);
}

const char* CallRule<&CallTable::TexImage2D>::refusal(CallState& state, GLenum target, GLint, GLint internal, GLsizei width,
                                                      GLsizei height, GLint border, GLenum format, GLenum type,
                                                      const void* pixels) {
    if (target != GL_TEXTURE_2D) return kTarget;
    if (border != 0) return kEnumerant;
    if (const char* refusal = upload_format_refusal(state, format, type)) return refusal;
    if (!state.es3() && static_cast<GLenum>(internal) != format) return kFormat;
    if (const char* refusal = size_refusal(state, width, height)) return refusal;
    if (pixels != nullptr)
        state.frame.uploaded_bytes +=
            texel_bytes(format, type) * static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    return nullptr;
}

const char* CallRule<&CallTable::TexParameteri>::refusal(CallState& state, GLenum target, GLenum name, GLint) {
    if (target != GL_TEXTURE_2D) return kTarget;
    if (one_of(name, {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER, GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})) return nullptr;
    return state.es3() && one_of(name, {GL_TEXTURE_BASE_LEVEL, GL_TEXTURE_MAX_LEVEL}) ? nullptr : kEnumerant;
}

const char* CallRule<&CallTable::TexStorage2D>::refusal(CallState& state, GLenum target, GLsizei levels, GLenum format,
                                                        GLsizei width, GLsizei height) {
    if (target != GL_TEXTURE_2D) return kTarget;
    // Those that OpenGL SC 2.0 has, too, but for the first two.
    const bool is_es3_only = state.es3() && one_of(format, {GL_RGBA16F, GL_RGBA32UI});
    if (!is_es3_only && !one_of(format, {GL_R8, GL_RG8, GL_RGB8, GL_RGBA8, GL_RGBA4, GL_RGB5_A1, GL_RGB565})) return kFormat;
    if (levels != 1 && !(power_of_two(width) && power_of_two(height))) return "levels need edges that are powers of two";
    return size_refusal(state, width, height);
}

const char* CallRule<&CallTable::TexSubImage2D>::refusal(CallState& state, GLenum target, GLint, GLint, GLint, GLsizei width,
                                                         GLsizei height, GLenum format, GLenum type, const void*) {
    if (target != GL_TEXTURE_2D) return kTarget;
    if (const char* refusal = upload_format_refusal(state, format, type)) return refusal;
    if (const char* refusal = size_refusal(state, width, height)) return refusal;
    state.frame.uploaded_bytes +=
        texel_bytes(format, type) * static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    return nullptr;
}

const char* CallRule<&CallTable::VertexAttribDivisor>::refusal(CallState& state, GLuint index, GLuint divisor) {
    if (index >= state.rules.max_attributes) return kAttributes;
    return divisor <= 1 ? nullptr : kEnumerant;
}

const char* CallRule<&CallTable::VertexAttribPointer>::refusal(CallState& state, GLuint index, GLint, GLenum type, GLboolean,
                                                               GLsizei, const void*) {
    if (index >= state.rules.max_attributes) return kAttributes;
    if (state.array_buffer == 0) return kClientMemory;
    const bool basic = one_of(type, {GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_FLOAT});
    return basic || (state.es3() && one_of(type, {GL_HALF_FLOAT, GL_INT_2_10_10_10_REV})) ? nullptr : kFormat;
}

}  // namespace tedavis::gl
