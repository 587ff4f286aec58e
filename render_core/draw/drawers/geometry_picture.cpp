#include "render_core/draw/drawers/geometry_picture.hpp"

#include "render_core/base/check.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"

namespace tedavis::draw {
namespace {

enum GeometryUniform : std::size_t { kWords, kDepthRange, kGeometryUniforms };
constexpr const char* kGeometryUniformNames[kGeometryUniforms] = {"geometry", "depth_range"};
constexpr gl::AttributeBinding kGeometryCorners[] = {{"position", 0}};

base::Error build(gl::Gl& gl, const char* name, std::string_view fragment, gl::Program& program) {
    auto built = gl::build_program(
        gl, {name, shader_text(k_saliency_vert), fragment, base::Span<const gl::AttributeBinding>(kGeometryCorners),
             base::Span<const char* const>(kGeometryUniformNames), true});
    if (!built.ok()) return built.error();
    program = built.value();
    return {};
}

}  // namespace

base::Error GeometryPicture::start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px) {
    const gl::TextureSettings words{gl::TextureFormat::rgba32ui, gl::TextureFilter::nearest, width_px, height_px};
    auto texture = gl::make_texture(gl, *budget.find(effects::kTracedPictures), words);
    if (!texture.ok()) return texture.error();
    words_ = static_cast<gl::Texture&&>(texture.value());
    if (base::Error error = screen_.start(gl, budget)) return error;
    if (base::Error error = build(gl, "chunk numbers", shader_text(k_chunk_numbers_frag), numbers_)) return error;
    return build(gl, "geometry depths", shader_text(k_geometry_depth_frag), depths_);
}

void GeometryPicture::upload(gl::Gl& gl, base::Span<const GeometryWords> words) const {
    const gl::TextureSettings& size = words_.settings();
    TEDAVIS_CHECK(words.size() == std::size_t{size.width_px} * size.height_px);
    TEDAVIS_CHECK(words_.upload(gl, {0, 0, size.width_px, size.height_px}, words.data()));
}

void GeometryPicture::leave_numbers(gl::Gl& gl) const {
    gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl->Enable(GL_DEPTH_TEST);
    leave(gl, numbers_);
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void GeometryPicture::leave_depths(gl::Gl& gl, const DepthRange& range) const {
    depths_.use(gl);
    gl->Uniform2f(depths_.uniform(kDepthRange), static_cast<float>(range.near_m), static_cast<float>(range.far_m));
    leave(gl, depths_);
}

void GeometryPicture::leave(gl::Gl& gl, const gl::Program& program) const {
    words_.bind(gl, 0);
    program.use(gl);
    gl->Uniform1i(program.uniform(kWords), 0);
    screen_.draw(gl);
}

void GeometryPicture::destroy(gl::Gl& gl) {
    numbers_.destroy(gl);
    depths_.destroy(gl);
    screen_.destroy(gl);
    words_.destroy(gl);
}

}  // namespace tedavis::draw
