#include "render_core/draw/drawers/data/glyph_drawer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/draw_triangles.hpp"

namespace tedavis::draw {
namespace {

using glm::vec3;

enum Attribute : GLuint { kPlace, kColor, kNormal, kCornersAttributes, kCorner = kCornersAttributes, kLook, kSize, kDirection };
constexpr GLuint kInstanceAttributes[] = {kPlace, kColor, kSize, kDirection};
constexpr gl::AttributeBinding kAttributes[] = {{"place", kPlace},        {"color", kColor}, {"normal", kNormal},
                                                {"corner", kCorner},      {"look", kLook},   {"size", kSize},
                                                {"direction", kDirection}};
constexpr GLuint kInstancedAttributes = kDirection + 1;
enum GlyphUniform : std::size_t { kEarthToEye = kFirstOwnDataUniform, kFacing, kGlyphUniformCount };
constexpr const char* kGlyphUniforms[kGlyphUniformCount] = {kDataUniformNames[0],
                                                            kDataUniformNames[1],
                                                            kDataUniformNames[2],
                                                            kDataUniformNames[3],
                                                            kDataUniformNames[4],
                                                            kDataUniformNames[5],
                                                            kDataUniformNames[6],
                                                            kDataUniformNames[7],
                                                            kDataUniformNames[8],
                                                            "earth_to_eye",
                                                            "facing"};
enum CasterUniform : std::size_t { kCasterAxes, kCasterLevel, kCasterEarthToEye, kCasterFacing, kCasterUniformCount };
constexpr const char* kCasterUniforms[kCasterUniformCount] = {"shadow_axes", "caster_level", "earth_to_eye", "facing"};
constexpr float kOne = 127;  // of signed bytes

const void* at(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

std::uint8_t product(std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>((a * b + 127) / 255); }

}  // namespace

GlyphAxes glyph_axes(const GlyphInstance& glyph, GlyphFacing facing, const vec3& earth_to_eye) noexcept {
    constexpr float kParallel = 1e-4f, kSteep = 0.7f;
    const vec3 kOfNormal(1, 1, static_cast<float>(1 / (1 - earth::kEccentricitySquared)));  // as earth::up_at()
    const vec3 to_eye = -glm::normalize(glyph.place), up = glm::normalize((earth_to_eye + glyph.place) * kOfNormal);
    const bool is_upright = glyph.direction[3] > 0;
    GlyphAxes axes;
    axes.z = is_upright || facing != GlyphFacing::up ? to_eye : up;
    axes.x = facing == GlyphFacing::eye_upright ? up
             : is_upright                       ? glm::cross(up, to_eye)
                          : glm::normalize(vec3(glyph.direction[0], glyph.direction[1], glyph.direction[2]) / kOne);
    axes.y = glm::cross(axes.z, axes.x);
    if (glm::dot(axes.y, axes.y) < kParallel)
        axes.y = glm::cross(axes.z, std::fabs(axes.z.x) < kSteep ? vec3(1, 0, 0) : vec3(0, 1, 0));
    axes.y = glm::normalize(axes.y);
    if (is_upright)
        axes.x = glm::cross(axes.y, axes.z);
    else
        axes.z = glm::cross(axes.x, axes.y);
    return axes;
}

bool GlyphDrawer::has_instances(const gl::Gl& gl) {
    return gl.has(gl::CallId::DrawElementsInstanced) && gl.has(gl::CallId::VertexAttribDivisor);
}

base::Error GlyphDrawer::start(gl::Gl& gl, base::BudgetLine& line, base::Arena& memory, bool with_air) {
    with_air_ = with_air;
    is_instanced_ = has_instances(gl);
    most_instances_ = glyph_instances_within(is_instanced_, line.bytes);
    shapes_ = memory.allocate_array<GlyphShapes>(1);
    if (shapes_.empty()) return base::shortage_error(effects::kSceneGlyphs, memory);
    shapes_[0].build();
    if (is_instanced_ && most_instances_ == 0) return base::shortage_error(line, kGlyphShapeBytes + sizeof(GlyphInstance));
    if (!is_instanced_)
        if (base::Error error = start_corners(line, memory)) return error;
    if (base::Error error = make_buffers(gl, line)) return error;
    return build_programs(gl);
}

/// Room for one glyph of the largest shape at least.
base::Error GlyphDrawer::start_corners(const base::BudgetLine& line, base::Arena& memory) {
    const std::uint32_t corners = glyph_corners_within(line.bytes);
    const std::uint32_t of_indices = (shapes_[0].most_indices() + kIndicesACorner - 1) / kIndicesACorner;
    const std::uint32_t least = std::max(shapes_[0].most_vertices(), of_indices);
    if (corners < least) {
        const std::uint64_t needed = least * std::uint64_t{sizeof(GlyphCorner) + kIndicesACorner * sizeof(std::uint16_t)};
        return base::shortage_error(line, needed, "one glyph");
    }
    corners_ = memory.allocate_array<GlyphCorner>(corners);
    corner_indices_ = memory.allocate_array<std::uint16_t>(std::size_t{corners} * kIndicesACorner);
    const bool has_room = !corners_.empty() && !corner_indices_.empty();
    return has_room ? base::Error{} : base::shortage_error(effects::kSceneGlyphs, memory);
}

base::Error GlyphDrawer::make_buffers(gl::Gl& gl, base::BudgetLine& line) {
    const auto make = [&](gl::Buffer& buffer, gl::BufferKind kind, gl::BufferUse use, std::uint64_t bytes) {
        auto made = gl::make_buffer(gl, line, kind, use, bytes);
        if (!made.ok()) return made.error();
        buffer = static_cast<gl::Buffer&&>(made.value());
        return base::Error{};
    };
    using gl::BufferKind;
    using gl::BufferUse;
    const std::uint64_t room = is_instanced_ ? most_instances_ * sizeof(GlyphInstance) : corners_.size() * sizeof(GlyphCorner);
    base::Error error = make(vertices_, BufferKind::vertices, BufferUse::streamed, room);
    if (error) return error;
    if (!is_instanced_)
        return make(indices_, BufferKind::indices, BufferUse::streamed, corner_indices_.size() * sizeof(std::uint16_t));
    const auto shape_vertices = shapes_[0].vertices();
    const auto shape_indices = shapes_[0].indices();
    error = make(shape_vertices_, BufferKind::vertices, BufferUse::fixed, shape_vertices.size() * sizeof(GlyphVertex));
    if (error) return error;
    error = make(indices_, BufferKind::indices, BufferUse::fixed, shape_indices.size() * sizeof(std::uint16_t));
    if (error) return error;
    if (!shape_vertices_.upload(gl, 0, shape_vertices.data(), shape_vertices_.bytes()) ||
        !indices_.upload(gl, 0, shape_indices.data(), indices_.bytes()))
        return base::make_error("the shapes of glyphs cannot be uploaded");
    return {};
}

base::Error GlyphDrawer::build_programs(gl::Gl& gl) {
    base::FixedString<kMaxShaderText> vertex(is_instanced_ ? "#define INSTANCED 1\n" : "");
    vertex.append(shader_text(k_data_light_vert));
    vertex.append(shader_text(k_glyph_vert));
    const std::size_t attributes = is_instanced_ ? kInstancedAttributes : kCornersAttributes;
    const std::size_t uniforms = is_instanced_ ? kGlyphUniformCount : std::size_t{kFirstOwnDataUniform};
    DataFragment fragment;
    add_data_fragment(fragment, with_air_);
    auto built = gl::build_program(
        gl, {"glyph", vertex.view(), fragment.view(), base::Span<const gl::AttributeBinding>(kAttributes).subspan(0, attributes),
             base::Span<const char* const>(kGlyphUniforms).subspan(0, uniforms), true});
    if (!built.ok()) return built.error();
    program_ = built.value();
    return {};
}

void GlyphDrawer::upload(gl::Gl& gl, const GlyphBatch& batch) {
    batch_ = &batch;
    const base::Span<const GlyphInstance> instances = batch.instances();
    uploaded_ = std::min(static_cast<std::uint32_t>(instances.size()), most_instances_);
    if (is_instanced_ && uploaded_ > 0 && !vertices_.upload(gl, 0, instances.data(), uploaded_ * sizeof(GlyphInstance)))
        uploaded_ = 0;
}

std::uint32_t GlyphDrawer::draw(gl::Gl& gl, const DataFrame& frame, const DepthRange& range) {
    draws_ = 0;
    if (batch_ == nullptr || uploaded_ == 0) return 0;
    begin(gl, frame, range);
    for (const bool is_transparent : {false, true}) {
        set_opaque(gl, program_, frame, !is_transparent);
        if (is_transparent) {
            gl->Enable(GL_BLEND);
            gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
            gl->DepthMask(GL_FALSE);
        }
        for (const GlyphRun& run : batch_->runs()) {
            const bool is_left_out = frame.without_uncertainty && is_of_uncertainty(run.shape);
            if (run.is_transparent != is_transparent || run.first >= uploaded_ || is_left_out) continue;
            is_flat(run.shape) ? gl->Disable(GL_CULL_FACE) : gl->Enable(GL_CULL_FACE);
            is_instanced_ ? draw_instances(gl, run, program_.uniform(kFacing)) : draw_corners(gl, run, frame, range);
        }
    }
    end(gl);
    return draws_;
}

void GlyphDrawer::begin(gl::Gl& gl, const DataFrame& frame, const DepthRange& range) {
    earth_to_eye_ = vec3(frame.view.eye);
    gl->Enable(GL_DEPTH_TEST);
    gl->Disable(GL_BLEND);
    program_.use(gl);
    set_data_frame(gl, program_, frame, range);
    indices_.bind(gl);
    const GLuint attributes = is_instanced_ ? kInstancedAttributes : GLuint{kCornersAttributes};
    for (GLuint attribute = 0; attribute < attributes; ++attribute) gl->EnableVertexAttribArray(attribute);
    if (!is_instanced_) return;
    gl->Uniform3f(program_.uniform(kEarthToEye), earth_to_eye_.x, earth_to_eye_.y, earth_to_eye_.z);
    bind_instances(gl);
}

void GlyphDrawer::bind_instances(gl::Gl& gl) {
    shape_vertices_.bind(gl);
    constexpr GLsizei kStride = sizeof(GlyphVertex);
    gl->VertexAttribPointer(kCorner, 3, GL_FLOAT, GL_FALSE, kStride, at(offsetof(GlyphVertex, place)));
    gl->VertexAttribPointer(kNormal, 3, GL_BYTE, GL_FALSE, kStride, at(offsetof(GlyphVertex, normal)));
    gl->VertexAttribPointer(kLook, 2, GL_UNSIGNED_BYTE, GL_TRUE, kStride, at(offsetof(GlyphVertex, tone)));
    for (const GLuint attribute : kInstanceAttributes) gl->VertexAttribDivisor(attribute, 1);
    vertices_.bind(gl);
}

void GlyphDrawer::end(gl::Gl& gl) {
    if (is_instanced_)
        for (const GLuint attribute : kInstanceAttributes) gl->VertexAttribDivisor(attribute, 0);
    const GLuint attributes = is_instanced_ ? kInstancedAttributes : GLuint{kCornersAttributes};
    for (GLuint attribute = 0; attribute < attributes; ++attribute) gl->DisableVertexAttribArray(attribute);
    gl->DepthMask(GL_TRUE);
    gl->Disable(GL_BLEND);
    gl->Disable(GL_CULL_FACE);
}

void GlyphDrawer::draw_instances(gl::Gl& gl, const GlyphRun& run, GLint facing) {
    constexpr GLsizei kStride = sizeof(GlyphInstance);
    const std::size_t first = run.first * sizeof(GlyphInstance);
    gl->Uniform1f(facing, static_cast<float>(run.facing));
    gl->VertexAttribPointer(kPlace, 3, GL_FLOAT, GL_FALSE, kStride, at(first + offsetof(GlyphInstance, place)));
    gl->VertexAttribPointer(kSize, 3, GL_FLOAT, GL_FALSE, kStride, at(first + offsetof(GlyphInstance, size_m)));
    gl->VertexAttribPointer(kDirection, 4, GL_BYTE, GL_FALSE, kStride, at(first + offsetof(GlyphInstance, direction)));
    gl->VertexAttribPointer(kColor, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, at(first + offsetof(GlyphInstance, rgba)));
    const GlyphMesh& mesh = shapes_[0].mesh(run.shape);
    const std::uint32_t count = std::min(run.count, uploaded_ - run.first);
    gl->DrawElementsInstanced(GL_TRIANGLES, mesh.indices, GL_UNSIGNED_SHORT, at(mesh.first_index * sizeof(std::uint16_t)),
                              static_cast<GLsizei>(count));
    ++draws_;
}

void GlyphDrawer::draw_corners(gl::Gl& gl, const GlyphRun& run, const DataFrame& frame, const DepthRange& range) {
    const GlyphMesh& mesh = shapes_[0].mesh(run.shape);
    const vec3 forward(frame.view.forward);
    const auto near_m = static_cast<float>(range.near_m), far_m = static_cast<float>(range.far_m);
    for (const GlyphInstance& glyph : batch_->of(run)) {
        const float depth = glm::dot(glyph.place, forward), reach = glm::length(glyph.size_m);
        if (depth + reach < near_m || depth - reach > far_m) continue;
        if (corner_count_ + mesh.vertices > corners_.size() || index_count_ + mesh.indices > corner_indices_.size())
            flush_corners(gl);
        add_corners(glyph, mesh, glyph_axes(glyph, run.facing, earth_to_eye_));
    }
    flush_corners(gl);
}

void GlyphDrawer::add_corners(const GlyphInstance& glyph, const GlyphMesh& mesh, const GlyphAxes& axes) {
    const GlyphShapes& shapes = shapes_[0];
    const vec3 x = axes.x * glyph.size_m.x, y = axes.y * glyph.size_m.y, z = axes.z * glyph.size_m.z;
    const vec3 across_x = axes.x / glyph.size_m.x, across_y = axes.y / glyph.size_m.y, across_z = axes.z / glyph.size_m.z;
    for (std::uint32_t n = 0; n < mesh.vertices; ++n) {
        const GlyphVertex& vertex = shapes.vertices()[mesh.first_vertex + n];
        const vec3 place = glyph.place + x * vertex.place[0] + y * vertex.place[1] + z * vertex.place[2];
        vec3 normal = across_x * static_cast<float>(vertex.normal[0]) + across_y * static_cast<float>(vertex.normal[1]) +
                      across_z * static_cast<float>(vertex.normal[2]);
        const float steep = glm::length(normal);
        if (steep > 0) normal *= kOne / steep;
        GlyphCorner& corner = corners_[corner_count_ + n];
        for (int axis = 0; axis < 3; ++axis) {
            corner.place[axis] = place[axis];
            corner.normal[axis] = static_cast<std::int8_t>(std::lround(normal[axis]));
            corner.rgba[axis] = product(glyph.rgba[axis], vertex.tone);
        }
        corner.normal[3] = 0;
        corner.rgba[3] = product(glyph.rgba[3], vertex.opacity);
    }
    for (std::uint32_t n = 0; n < mesh.indices; ++n)
        corner_indices_[index_count_ + n] =
            static_cast<std::uint16_t>(shapes.indices()[mesh.first_index + n] - mesh.first_vertex + corner_count_);
    corner_count_ += mesh.vertices;
    index_count_ += mesh.indices;
}

void GlyphDrawer::flush_corners(gl::Gl& gl) {
    if (index_count_ == 0) return;
    if (vertices_.upload(gl, 0, corners_.data(), corner_count_ * sizeof(GlyphCorner)) &&
        indices_.upload(gl, 0, corner_indices_.data(), index_count_ * sizeof(std::uint16_t))) {
        constexpr GLsizei kStride = sizeof(GlyphCorner);
        vertices_.bind(gl);
        gl->VertexAttribPointer(kPlace, 3, GL_FLOAT, GL_FALSE, kStride, at(offsetof(GlyphCorner, place)));
        gl->VertexAttribPointer(kNormal, 3, GL_BYTE, GL_FALSE, kStride, at(offsetof(GlyphCorner, normal)));
        gl->VertexAttribPointer(kColor, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, at(offsetof(GlyphCorner, rgba)));
        gl::draw_triangles(gl, {0, index_count_, corner_count_ - 1});
        ++draws_;
    }
    corner_count_ = index_count_ = 0;
}

base::Error GlyphDrawer::start_casters(gl::Gl& gl) {
    if (!is_instanced_) return {};
    base::FixedString<kMaxShaderText> vertex("#define INSTANCED 1\n");
    vertex.append(shader_text(k_caster_light_vert));
    vertex.append(shader_text(k_glyph_vert));
    auto built = gl::build_program(
        gl, {"glyph caster", vertex.view(), shader_text(k_caster_frag), base::Span<const gl::AttributeBinding>(kAttributes),
             base::Span<const char* const>(kCasterUniforms)});
    if (!built.ok()) return built.error();
    caster_program_ = built.value();
    return {};
}

std::uint32_t GlyphDrawer::draw_casters(gl::Gl& gl, std::uint32_t slots, const CasterView& view) {
    draws_ = 0;
    if (batch_ == nullptr || uploaded_ == 0 || !caster_program_.valid()) return 0;
    const vec3 to_eye(view.eye);
    caster_program_.use(gl);
    gl->Uniform3f(caster_program_.uniform(kCasterEarthToEye), to_eye.x, to_eye.y, to_eye.z);
    set_caster_level(gl, caster_program_.uniform(kCasterAxes), caster_program_.uniform(kCasterLevel), view, 0);
    indices_.bind(gl);
    for (GLuint attribute = 0; attribute < kInstancedAttributes; ++attribute) gl->EnableVertexAttribArray(attribute);
    bind_instances(gl);
    for (const GlyphRun& run : batch_->runs())
        if (run.first < uploaded_ && (slots >> run.slot & 1u) != 0 && casts_shadow(run))
            draw_instances(gl, run, caster_program_.uniform(kCasterFacing));
    for (const GLuint attribute : kInstanceAttributes) gl->VertexAttribDivisor(attribute, 0);
    for (GLuint attribute = 0; attribute < kInstancedAttributes; ++attribute) gl->DisableVertexAttribArray(attribute);
    return draws_;
}

void GlyphDrawer::destroy(gl::Gl& gl) {
    caster_program_.destroy(gl);
    program_.destroy(gl);
    shape_vertices_.destroy(gl);
    indices_.destroy(gl);
    vertices_.destroy(gl);
    batch_ = nullptr;
}

}  // namespace tedavis::draw
