#include "render_core/gl/texture.hpp"

#include <utility>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/gl/gpu_memory.hpp"

namespace tedavis::gl {
namespace {

GLenum transfer_format(const Gl& gl, TextureFormat format) {
    if (format == TextureFormat::rgb8) return GL_RGB;
    if (format == TextureFormat::rgba32ui) return GL_RGBA_INTEGER;
    if (format != TextureFormat::r8) return GL_RGBA;
    return gl.has(CallId::TexStorage2D) ? GL_RED : GL_LUMINANCE;
}

GLenum texel_type(TextureFormat format) {
    if (format == TextureFormat::rgba32ui) return GL_UNSIGNED_INT;
    return format == TextureFormat::rgba16f ? GL_HALF_FLOAT : GL_UNSIGNED_BYTE;
}

GLenum sized_format(TextureFormat format) {
    constexpr GLenum kFormats[] = {GL_R8, GL_RGB8, GL_RGBA8, GL_RGBA16F, GL_RGBA32UI};
    return kFormats[static_cast<std::size_t>(format)];
}

GLsizei to_size(std::uint32_t value) { return static_cast<GLsizei>(value); }

void store(Gl& gl, const TextureSettings& settings) {
    if (gl.has(CallId::TexStorage2D)) {
        gl->TexStorage2D(GL_TEXTURE_2D, 1, sized_format(settings.format), to_size(settings.width_px),
                         to_size(settings.height_px));
    } else {
        const GLenum format = transfer_format(gl, settings.format);
        gl->TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), to_size(settings.width_px), to_size(settings.height_px), 0,
                       format, texel_type(settings.format), nullptr);
    }
    const GLint filter = settings.filter == TextureFilter::nearest ? GL_NEAREST : GL_LINEAR;
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

std::uint64_t texel_bytes(TextureFormat format) {
    constexpr std::uint64_t kBytes[] = {1, 4, 4, 8, 16};
    return kBytes[static_cast<std::size_t>(format)];
}

}  // namespace

std::uint64_t texture_bytes(const TextureSettings& settings) {
    return std::uint64_t{settings.width_px} * settings.height_px * texel_bytes(settings.format);
}

Texture& Texture::operator=(Texture&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(settings_, other.settings_);
    std::swap(line_, other.line_);
    return *this;
}

void Texture::bind(Gl& gl, std::uint32_t unit) const {
    gl->ActiveTexture(GL_TEXTURE0 + unit);
    gl->BindTexture(GL_TEXTURE_2D, id_);
}

bool Texture::upload(Gl& gl, const TexelRect& part, const void* texels) const {
    if (!valid() || part.width > settings_.width_px || part.x > settings_.width_px - part.width) return false;
    if (part.height > settings_.height_px || part.y > settings_.height_px - part.height) return false;
    if (part.width == 0 || part.height == 0) return true;
    bind(gl, 0);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl->TexSubImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(part.x), static_cast<GLint>(part.y), to_size(part.width),
                      to_size(part.height), transfer_format(gl, settings_.format), texel_type(settings_.format), texels);
    return true;
}

void Texture::copy_rows(Gl& gl, std::uint32_t to_row, std::uint32_t from_row, std::uint32_t rows) const {
    bind(gl, 0);
    gl->CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(to_row), 0, static_cast<GLint>(from_row),
                          to_size(settings_.width_px), to_size(rows));
}

void Texture::destroy(Gl& gl) {
    if (!valid()) return;
    if (gl.has(CallId::DeleteTextures)) {
        gl->DeleteTextures(1, &id_);
        give_back(*line_, texture_bytes(settings_));
    }
    id_ = 0;
    line_ = nullptr;
}

base::Result<Texture, base::Error> make_texture(Gl& gl, base::BudgetLine& line, const TextureSettings& settings) {
    const std::uint64_t bytes = texture_bytes(settings);
    if (bytes == 0)
        return base::fail(
            base::make_error("a texture of the budget line '", line.name.view(), "' would be empty; ask for texels"));
    if (!try_take(line, bytes)) return base::fail(base::shortage_error(line, bytes));
    Texture texture;
    texture.settings_ = settings;
    texture.line_ = &line;
    static_cast<void>(gl.take_error());
    const std::uint64_t denied = gl.denied().total;
    gl->GenTextures(1, &texture.id_);
    texture.bind(gl, 0);
    store(gl, settings);
    if (gl.take_error() == GL_NO_ERROR && gl.denied().total == denied) return texture;
    if (texture.id_ != 0 && gl.has(CallId::DeleteTextures)) gl->DeleteTextures(1, &texture.id_);
    give_back(line, bytes);
    base::Error error = base::make_error("the device or driver refused a texture of ", base::digits(settings.width_px).view(),
                                         " x ", base::digits(settings.height_px).view());
    error.message.append(" texels for the budget line ");
    error.message.append(line.name.view());
    return base::fail(error);
}

}  // namespace tedavis::gl
