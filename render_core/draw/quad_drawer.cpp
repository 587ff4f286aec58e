#include "render_core/draw/quad_drawer.hpp"

#include <cstddef>
#include <string_view>

#include "render_core/base/fixed_string.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/draw_triangles.hpp"

namespace tedavis::draw {
namespace {

enum Attribute : GLuint { kPosition, kUv, kExtent, kColor };
constexpr gl::AttributeBinding kAttributes[] = {{"position", kPosition}, {"uv", kUv}, {"extent", kExtent}, {"color", kColor}};
enum Uniform : std::size_t { kClipPerPixel, kAtlas };
constexpr const char* kUniforms[] = {"clip_per_pixel", "atlas"};

gl::GlError build_program(gl::Gl& gl, std::string_view defines, gl::Program& program) {
    base::FixedString<kMaxShaderText> fragment(defines);
    fragment.append(shader_text(k_symbology_frag));
    auto built = gl::build_program(
        gl, {"symbology", shader_text(k_symbology_vert), fragment.view(), base::Span<const gl::AttributeBinding>(kAttributes),
             base::Span<const char* const>(kUniforms), true});
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
}

}  // namespace

gl::GlError QuadDrawer::start(gl::Gl& gl, base::BudgetTable& budget, base::Arena& memory, std::size_t max_vertices) {
    const auto vertices = memory.allocate_array<QuadVertex>(max_vertices);
    const auto indices = memory.allocate_array<std::uint16_t>(max_vertices * 3 / 2);
    if (vertices.empty() || indices.empty())
        return gl::make_error("the budget line '", effects::kSymbology,
                              "' is too small for the symbology; raise it in the device file");
    batch_ = QuadBatch(vertices, indices);
    return make_objects(gl, budget, vertices.size(), indices.size());
}

gl::GlError QuadDrawer::make_objects(gl::Gl& gl, base::BudgetTable& budget, std::size_t vertices, std::size_t indices) {
    base::BudgetLine& quads = *budget.find(effects::kSymbologyVertices);
    auto vertex_buffer =
        gl::make_buffer(gl, quads, gl::BufferKind::vertices, gl::BufferUse::streamed, vertices * sizeof(QuadVertex));
    if (!vertex_buffer.ok()) return vertex_buffer.error();
    vertices_ = static_cast<gl::Buffer&&>(vertex_buffer.value());
    auto index_buffer =
        gl::make_buffer(gl, quads, gl::BufferKind::indices, gl::BufferUse::streamed, indices * sizeof(std::uint16_t));
    if (!index_buffer.ok()) return index_buffer.error();
    indices_ = static_cast<gl::Buffer&&>(index_buffer.value());

    const FontAtlas& font = font_atlas();
    const auto width = static_cast<std::uint32_t>(font.width), height = static_cast<std::uint32_t>(font.height);
    auto atlas = gl::make_texture(gl, *budget.find(effects::kFontAtlas),
                                  {gl::TextureFormat::r8, gl::TextureFilter::linear, width, height});
    if (!atlas.ok()) return atlas.error();
    atlas_ = static_cast<gl::Texture&&>(atlas.value());
    if (!atlas_.upload(gl, {0, 0, width, height}, font.texels.data())) return gl::make_error("the typeface cannot be uploaded");

    if (gl::GlError error = build_program(gl, "", box_program_); !error.sentence.empty()) return error;
    return build_program(gl, "#define GLYPHS 1\n", glyph_program_);
}

std::uint32_t QuadDrawer::draw(gl::Gl& gl, std::uint32_t width, std::uint32_t height) {
    const auto vertices = batch_.vertices();
    const auto indices = batch_.indices();
    if (indices.empty()) return 0;
    if (!vertices_.upload(gl, 0, vertices.data(), vertices.size() * sizeof(QuadVertex)) ||
        !indices_.upload(gl, 0, indices.data(), indices.size() * sizeof(std::uint16_t)))
        return 0;
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_CULL_FACE);
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    for (const gl::Program* program : {&box_program_, &glyph_program_}) {
        program->use(gl);
        gl->Uniform2f(program->uniform(kClipPerPixel), 2.0f / static_cast<float>(width), 2.0f / static_cast<float>(height));
    }
    gl->Uniform1i(glyph_program_.uniform(kAtlas), 0);
    atlas_.bind(gl, 0);
    vertices_.bind(gl);
    indices_.bind(gl);
    for (GLuint attribute = kPosition; attribute <= kColor; ++attribute) gl->EnableVertexAttribArray(attribute);
    point_attributes(gl);
    const base::Span<const QuadRun> runs = batch_.runs();
    for (std::size_t n = 0; n < runs.size(); ++n) {
        const std::uint32_t end = n + 1 < runs.size() ? runs[n + 1].first_index : static_cast<std::uint32_t>(indices.size());
        (runs[n].glyphs ? glyph_program_ : box_program_).use(gl);
        gl::draw_triangles(gl, {runs[n].first_index, end - runs[n].first_index, static_cast<std::uint32_t>(vertices.size() - 1)});
    }
    for (GLuint attribute = kPosition; attribute <= kColor; ++attribute) gl->DisableVertexAttribArray(attribute);
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
