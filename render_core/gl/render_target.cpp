#include "render_core/gl/render_target.hpp"

#include <utility>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/base/check.hpp"
#include "render_core/gl/gpu_memory.hpp"

namespace tedavis::gl {

RenderTarget& RenderTarget::operator=(RenderTarget&& other) noexcept {
    color_ = std::move(other.color_);
    std::swap(depth_, other.depth_);
    std::swap(framebuffer_, other.framebuffer_);
    std::swap(depth_bytes_, other.depth_bytes_);
    std::swap(line_, other.line_);
    return *this;
}

void RenderTarget::bind(Gl& gl) const {
    const TextureSettings& size = color_.settings();
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl->Viewport(0, 0, static_cast<GLsizei>(size.width_px), static_cast<GLsizei>(size.height_px));
}

void RenderTarget::destroy(Gl& gl) {
    if (gl.has(CallId::DeleteFramebuffers)) {
        if (framebuffer_ != 0) gl->DeleteFramebuffers(1, &framebuffer_);
        if (depth_ != 0) gl->DeleteRenderbuffers(1, &depth_);
        if (line_ != nullptr) give_back(*line_, depth_bytes_);
    }
    color_.destroy(gl);
    framebuffer_ = depth_ = 0;
    depth_bytes_ = 0;
    line_ = nullptr;
}

bool RenderTarget::make_depth(Gl& gl, base::BudgetLine& line) {
    const TextureSettings& size = color_.settings();
    const std::uint64_t bytes = std::uint64_t{4} * size.width_px * size.height_px;
    if (!try_take(line, bytes)) return false;
    line_ = &line;
    depth_bytes_ = bytes;
    gl->GenRenderbuffers(1, &depth_);
    gl->BindRenderbuffer(GL_RENDERBUFFER, depth_);
    gl->RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, static_cast<GLsizei>(size.width_px),
                            static_cast<GLsizei>(size.height_px));
    return true;
}

void RenderTarget::attach(Gl& gl) const {
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_.id(), 0);
    if (depth_ != 0) gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
}

base::Result<RenderTarget, base::Error> make_render_target(Gl& gl, base::BudgetLine& line, const TextureSettings& color,
                                                           TargetDepth depth) {
    TEDAVIS_CHECK(color.format == TextureFormat::rgba8);
    RenderTarget target;
    base::Result<Texture, base::Error> texture = make_texture(gl, line, color);
    if (!texture) return base::fail(texture.error());
    target.color_ = std::move(texture.value());
    const std::uint64_t denied = gl.denied().total;
    if (depth == TargetDepth::bits24 && !target.make_depth(gl, line)) {
        const base::Error error = base::shortage_error(line, texture_bytes(color));
        target.destroy(gl);
        return base::fail(error);
    }
    gl->GenFramebuffers(1, &target.framebuffer_);
    target.attach(gl);
    const bool complete = gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    if (complete && gl.denied().total == denied) return target;
    target.destroy(gl);
    return base::fail(base::make_error(
        "the device or driver cannot draw into a render target of the line '", line.name.view(),
        depth == TargetDepth::none ? "'; use another device file" : "' with 24-bit depth; use another device file"));
}

void bind_surface(Gl& gl, const base::Surface& surface) {
    gl->BindFramebuffer(GL_FRAMEBUFFER, surface.framebuffer());
    gl->Viewport(0, 0, static_cast<GLsizei>(surface.width()), static_cast<GLsizei>(surface.height()));
}

void DrawPlace::bind(Gl& gl) const {
    if (target_ != nullptr)
        target_->bind(gl);
    else
        bind_surface(gl, *surface_);
}

}  // namespace tedavis::gl
