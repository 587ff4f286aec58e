#include "render_core/draw/outline_pass.hpp"

#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::draw {
namespace {

constexpr float kCorners[] = {-1, -1, 3, -1, -1, 3};
constexpr gl::AttributeBinding kAttributes[] = {{"position", 0}};
enum Uniform : std::size_t { kScene, kTexel, kLineColor, kJump };
constexpr const char* kUniforms[] = {"scene", "texel", "line_color", "jump"};
// A step of the code is 3.6 % of the distance (13 octaves in 255 steps).
constexpr float kJumpBegins = 2.5f / 255.0f, kJumpFull = 6.0f / 255.0f;

}  // namespace

gl::GlError OutlinePass::start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px) {
    const gl::TextureSettings color{gl::TextureFormat::rgba8, gl::TextureFilter::nearest, width_px, height_px};
    auto target = gl::make_render_target(gl, *budget.find(effects::kRenderTargets), color, gl::TargetDepth::bits24);
    if (!target.ok()) return target.error();
    target_ = static_cast<gl::RenderTarget&&>(target.value());
    auto corners = gl::make_buffer(gl, *budget.find(effects::kSymbologyVertices), gl::BufferKind::vertices, gl::BufferUse::fixed,
                                   sizeof kCorners);
    if (!corners.ok()) return corners.error();
    corners_ = static_cast<gl::Buffer&&>(corners.value());
    if (!corners_.upload(gl, 0, kCorners, sizeof kCorners)) return gl::make_error("the outline's corners cannot be uploaded");
    auto program =
        gl::build_program(gl, {"outline", shader_text(k_outline_vert), shader_text(k_outline_frag),
                               base::Span<const gl::AttributeBinding>(kAttributes), base::Span<const char* const>(kUniforms)});
    if (!program.ok()) return program.error();
    program_ = static_cast<gl::Program&&>(program.value());
    return {};
}

void OutlinePass::finish(gl::Gl& gl, const base::Surface& surface, design::Color line, double strength) const {
    gl::bind_surface(gl, surface);
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_CULL_FACE);
    gl->Disable(GL_BLEND);
    program_.use(gl);
    target_.color().bind(gl, 0);
    gl->Uniform1i(program_.uniform(kScene), 0);
    const gl::TextureSettings& size = target_.color().settings();
    gl->Uniform2f(program_.uniform(kTexel), 1.0f / static_cast<float>(size.width_px), 1.0f / static_cast<float>(size.height_px));
    gl->Uniform4f(program_.uniform(kLineColor), static_cast<float>(line.red) / 255.0f, static_cast<float>(line.green) / 255.0f,
                  static_cast<float>(line.blue) / 255.0f, static_cast<float>(strength));
    gl->Uniform2f(program_.uniform(kJump), kJumpBegins, kJumpFull);
    corners_.bind(gl);
    gl->EnableVertexAttribArray(0);
    gl->VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->DisableVertexAttribArray(0);
}

void OutlinePass::destroy(gl::Gl& gl) {
    program_.destroy(gl);
    corners_.destroy(gl);
    target_.destroy(gl);
}

}  // namespace tedavis::draw
