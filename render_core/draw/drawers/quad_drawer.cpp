#include "render_core/draw/drawers/quad_drawer.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>

#include "render_core/base/fixed_string.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/draw_triangles.hpp"

namespace tedavis::draw {
namespace {

enum Attribute : GLuint { kPosition, kUv, kExtent, kColor, kDistance };
constexpr gl::AttributeBinding kAttributes[] = {
    {"position", kPosition}, {"uv", kUv}, {"extent", kExtent}, {"color", kColor}, {"distance_m", kDistance}};
enum QuadUniform : std::size_t { kQuadClipPerPixel, kQuadAtlas, kQuadDepth, kQuadParting, kQuadIsNearer };
constexpr const char* kQuadUniforms[] = {"clip_per_pixel", "atlas", "depth", "parting_m", "is_nearer"};
constexpr std::string_view kGlyphs = "#define GLYPHS 1\n", kAmongTerrain = "#define AMONG_TERRAIN 1\n";

base::Error build_program(gl::Gl& gl, std::string_view defines, gl::Program& program) {
    const bool with_depth = defines == kAmongTerrain;
    base::FixedString<kMaxShaderText> vertex(defines), fragment(defines);
    vertex.append(shader_text(k_symbology_vert));
    fragment.append(shader_text(k_symbology_frag));
    constexpr std::size_t kAll = std::size(kAttributes);
    auto built = gl::build_program(gl, {"symbology", vertex.view(), fragment.view(),
                                        base::Span<const gl::AttributeBinding>(kAttributes, with_depth ? kAll : kAll - 1),
                                        base::Span<const char* const>(kQuadUniforms), true});
    if (!built.ok()) return built.error();
    program = built.value();
    return {};
}

void point_attributes(gl::Gl& gl) {
    const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
    constexpr GLsizei kStride = sizeof(QuadVertex);
    gl->VertexAttribPointer(kPosition, 2, GL_FLOAT, GL_FALSE, kStride, at(offsetof(QuadVertex, x)));
    gl->VertexAttribPointer(kUv, 2, GL_FLOAT, GL_FALSE, kStride, at(offsetof(QuadVertex, u)));
    gl->VertexAttribPointer(kExtent, 2, GL_FLOAT, GL_FALSE, kStride, at(offsetof(QuadVertex, extent_x)));
    gl->VertexAttribPointer(kColor, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, at(offsetof(QuadVertex, rgba)));
    gl->VertexAttribPointer(kDistance, 1, GL_FLOAT, GL_FALSE, kStride, at(offsetof(QuadVertex, distance_m)));
}

}  // namespace

base::Error QuadDrawer::start(gl::Gl& gl, base::BudgetTable& budget, const QuadBatch& batch) {
    boxes_ = &box_program_;
    glyphs_ = &glyph_program_;
    if (base::Error error = make_buffers(gl, *budget.find(effects::kSymbologyVertices), batch)) return error;
    if (base::Error error = make_typeface(gl, budget)) return error;
    if (base::Error error = build_program(gl, "", box_program_)) return error;
    return build_program(gl, kGlyphs, glyph_program_);
}

base::Error QuadDrawer::start_signs(gl::Gl& gl, base::BudgetTable& budget, const QuadBatch& batch, const QuadDrawer& lender) {
    typeface_ = lender.typeface_;
    boxes_ = lender.boxes_;
    glyphs_ = lender.glyphs_;
    return make_buffers(gl, *budget.find(effects::kSceneBillboardVertices), batch);
}

base::Error QuadDrawer::start_links(gl::Gl& gl, base::BudgetTable& budget, const QuadBatch& batch) {
    boxes_ = &box_program_;
    if (base::Error error = make_buffers(gl, *budget.find(effects::kSceneBillboardVertices), batch)) return error;
    return build_program(gl, kAmongTerrain, box_program_);
}

base::Error QuadDrawer::make_buffers(gl::Gl& gl, base::BudgetLine& line, const QuadBatch& batch) {
    batch_ = &batch;
    const std::size_t vertices = batch.use().capacity, indices = vertices * 3 / 2;
    auto vertex_buffer =
        gl::make_buffer(gl, line, gl::BufferKind::vertices, gl::BufferUse::streamed, vertices * sizeof(QuadVertex));
    if (!vertex_buffer.ok()) return vertex_buffer.error();
    vertices_ = static_cast<gl::Buffer&&>(vertex_buffer.value());
    auto index_buffer =
        gl::make_buffer(gl, line, gl::BufferKind::indices, gl::BufferUse::streamed, indices * sizeof(std::uint16_t));
    if (!index_buffer.ok()) return index_buffer.error();
    indices_ = static_cast<gl::Buffer&&>(index_buffer.value());
    return {};
}

base::Error QuadDrawer::make_typeface(gl::Gl& gl, base::BudgetTable& budget) {
    const FontAtlas& font = font_atlas();
    const auto width = static_cast<std::uint32_t>(font.width), height = static_cast<std::uint32_t>(font.height);
    auto atlas = gl::make_texture(gl, *budget.find(effects::kFontAtlas),
                                  {gl::TextureFormat::r8, gl::TextureFilter::linear, width, height});
    if (!atlas.ok()) return atlas.error();
    atlas_ = static_cast<gl::Texture&&>(atlas.value());
    typeface_ = &atlas_;
    if (!atlas_.upload(gl, {0, 0, width, height}, font.texels.data())) return base::make_error("the typeface cannot be uploaded");
    return {};
}

bool QuadDrawer::upload(gl::Gl& gl) {
    const auto vertices = batch_->vertices();
    const auto indices = batch_->indices();
    is_uploaded_ = !indices.empty() && vertices_.upload(gl, 0, vertices.data(), vertices.size() * sizeof(QuadVertex)) &&
                   indices_.upload(gl, 0, indices.data(), indices.size() * sizeof(std::uint16_t));
    return is_uploaded_;
}

std::uint32_t QuadDrawer::draw(gl::Gl& gl, std::uint32_t width, std::uint32_t height) {
    if (!upload(gl)) return 0;
    gl->Disable(GL_DEPTH_TEST);
    return draw_runs(gl, width, height, kColor);
}

std::uint32_t QuadDrawer::draw_within(gl::Gl& gl, std::uint32_t width, std::uint32_t height, const DepthPlan& plan,
                                      std::size_t n) {
    if (!is_uploaded_) return 0;
    set_depths(gl, plan, n);
    gl->DepthMask(GL_FALSE);
    const std::uint32_t draws = draw_runs(gl, width, height, kDistance);
    gl->DepthMask(GL_TRUE);
    return draws;
}

/// Those of the perspective: scale + offset / distance (view_projection.hpp).
void QuadDrawer::set_depths(gl::Gl& gl, const DepthPlan& plan, std::size_t n) const {
    const double near_m = plan.ranges[n].near_m, far_m = plan.ranges[n].far_m;
    boxes_->use(gl);
    gl->Uniform2f(boxes_->uniform(kQuadDepth), static_cast<float>((far_m + near_m) / (far_m - near_m)),
                  static_cast<float>(-2 * far_m * near_m / (far_m - near_m)));
    gl->Uniform1f(boxes_->uniform(kQuadParting), static_cast<float>(plan.parting_m()));
    gl->Uniform1f(boxes_->uniform(kQuadIsNearer), n > 0 ? 1.0f : 0.0f);
}

std::uint32_t QuadDrawer::draw_runs(gl::Gl& gl, std::uint32_t width, std::uint32_t height, GLuint last) {
    const auto vertices = batch_->vertices();
    const auto indices = batch_->indices();
    gl->Disable(GL_CULL_FACE);
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    for (const gl::Program* program : {boxes_, glyphs_}) {
        if (program == nullptr) continue;
        program->use(gl);
        gl->Uniform2f(program->uniform(kQuadClipPerPixel), 2.0f / static_cast<float>(width), 2.0f / static_cast<float>(height));
    }
    if (glyphs_ != nullptr) {
        gl->Uniform1i(glyphs_->uniform(kQuadAtlas), 0);
        typeface_->bind(gl, 0);
    }
    vertices_.bind(gl);
    indices_.bind(gl);
    for (GLuint attribute = kPosition; attribute <= last; ++attribute) gl->EnableVertexAttribArray(attribute);
    point_attributes(gl);
    const base::Span<const QuadRun> runs = batch_->runs();
    for (std::size_t n = 0; n < runs.size(); ++n) {
        const std::uint32_t end = n + 1 < runs.size() ? runs[n + 1].first_index : static_cast<std::uint32_t>(indices.size());
        if (runs[n].glyphs && glyphs_ == nullptr) continue;
        (runs[n].glyphs ? glyphs_ : boxes_)->use(gl);
        gl::draw_triangles(gl, {runs[n].first_index, end - runs[n].first_index, static_cast<std::uint32_t>(vertices.size() - 1)});
    }
    for (GLuint attribute = kPosition; attribute <= last; ++attribute) gl->DisableVertexAttribArray(attribute);
    gl->Disable(GL_BLEND);
    return static_cast<std::uint32_t>(runs.size());
}

void QuadDrawer::destroy(gl::Gl& gl) {
    box_program_.destroy(gl);
    glyph_program_.destroy(gl);
    vertices_.destroy(gl);
    indices_.destroy(gl);
    atlas_.destroy(gl);
}

}  // namespace tedavis::draw
