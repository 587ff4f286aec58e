#include "render_core/draw/drawers/data/solid_drawer.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/draw/drawers/magnified_uniforms.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/draw_triangles.hpp"

namespace tedavis::draw {
namespace {

enum Uniform : std::size_t {
    kAnchor = kFirstOwnDataUniform,
    kFading,
    kCover,
    kNearFade,
    kGrid,
    kMagnifier = kGrid + kGridUniforms,
    kUniforms = kMagnifier + kMagnifierUniforms
};

constexpr double kHour_ns = 3.6e12;

bool is_mixed(const SolidPiece& piece) {
    return piece.look.is_mixed || piece.look.opacity < 1 || piece.look.fading == SolidFading::transparency;
}

float grown_since(const SolidPiece& piece, const SolidFrame& frame) {
    if (!frame.has_date || piece.data_time_ns == INT64_MIN) return 0;
    const double hours = std::fabs(static_cast<double>(frame.time_ns - piece.data_time_ns)) / kHour_ns;
    return static_cast<float>(std::min(hours * static_cast<double>(piece.look.growth_per_hour), 1.0));
}

struct NearFade {
    float from_m, per_m;
};

/// What is opaque ends at once: it has no half.
NearFade near_fade(const SolidLook& look, bool is_opaque) {
    constexpr float kAtOnce_per_m = 100;
    if (look.near_m <= 0) return {-1, 1};
    if (is_opaque) return {SolidLook::kOpaqueFrom * look.near_m, kAtOnce_per_m};
    return {look.near_m, 1 / ((SolidLook::kWholeFrom - 1) * look.near_m)};
}

earth::GroundExtent extent_of(const SolidPiece& piece) { return {piece.anchor, {}, static_cast<double>(piece.radius_m)}; }

/// How far magnifiers may move it.
double moved_m(const SolidPiece& piece, const terrain::View& view) {
    double most_m = 0;
    for (const earth::Magnifier& magnifier : view.magnifiers)
        if (magnifier.reaches(piece.anchor, static_cast<double>(piece.radius_m)))
            most_m = std::fmax(most_m, magnifier.farthest_move_m());
    return most_m;
}

/// The ground has no lines of equal height, nor has what lies on it.
GridPlace grid_of(const SolidPiece& piece, const DataGrid& grid) {
    const SolidLook& look = piece.look;
    if (!look.has_grid || look.halo_px > 0) return {};
    return grid_place(grid, piece.anchor, look.raised_px <= 0);
}

}  // namespace

void point_solid_attributes(gl::Gl& gl, const SolidPiece& piece) {
    const std::uintptr_t start = std::uintptr_t{piece.first_vertex} * sizeof(SolidVertex);
    const auto at = [&](std::size_t offset) { return reinterpret_cast<const void*>(start + offset); };
    constexpr GLsizei kStride = sizeof(SolidVertex);
    gl->VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, kStride, at(offsetof(SolidVertex, place_m)));
    gl->VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, at(offsetof(SolidVertex, normal)));
    gl->VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, at(offsetof(SolidVertex, rgba)));
}

void set_solid_place(gl::Gl& gl, GLint anchor, const SolidPiece& piece, const glm::dvec3& eye) {
    const glm::vec3 from_eye(piece.anchor - eye);
    gl->Uniform3f(anchor, from_eye.x, from_eye.y, from_eye.z);
}

void set_solid_fading(gl::Gl& gl, GLint fading, const SolidPiece& piece, float grown) {
    const SolidLook& look = piece.look;
    const float strength = look.fading == SolidFading::none ? 0 : look.fading_strength;
    const bool is_transparency = look.fading == SolidFading::transparency;
    gl->Uniform4f(fading, is_transparency ? strength : 0, is_transparency ? 0 : strength, look.fading_levels, grown);
}

base::Error SolidBuffers::start(gl::Gl& gl, base::BudgetLine& line, const SolidBatch& batch, const SolidRoom& room,
                                gl::BufferUse use) {
    batch_ = &batch;
    auto vertices = gl::make_buffer(gl, line, gl::BufferKind::vertices, use, std::uint64_t{room.vertices} * sizeof(SolidVertex));
    if (!vertices.ok()) return vertices.error();
    vertices_ = static_cast<gl::Buffer&&>(vertices.value());
    auto indices = gl::make_buffer(gl, line, gl::BufferKind::indices, use, std::uint64_t{room.indices} * sizeof(std::uint16_t));
    if (!indices.ok()) return indices.error();
    indices_ = static_cast<gl::Buffer&&>(indices.value());
    return {};
}

bool SolidBuffers::upload(gl::Gl& gl) const {
    const auto vertices = batch_->vertices();
    const auto indices = batch_->indices();
    return vertices_.upload(gl, 0, vertices.data(), vertices.size() * sizeof(SolidVertex)) &&
           indices_.upload(gl, 0, indices.data(), indices.size() * sizeof(std::uint16_t));
}

void SolidBuffers::bind(gl::Gl& gl) const {
    vertices_.bind(gl);
    indices_.bind(gl);
}

void SolidBuffers::destroy(gl::Gl& gl) {
    vertices_.destroy(gl);
    indices_.destroy(gl);
}

base::Error SolidDrawer::start(gl::Gl& gl, base::Arena& memory, std::uint32_t most_pieces, const DataVariant& variant) {
    order_ = memory.allocate_array<Ordered>(most_pieces);
    if (order_.size() < most_pieces) return base::shortage_error(effects::kSceneSolids, memory);
    has_grid_ = variant.grid;
    DataVariant plain = variant;
    plain.magnified = false;
    if (base::Error error = build(gl, plain, program_)) return error;
    return variant.magnified ? build(gl, variant, magnified_program_) : base::Error{};
}

base::Error SolidDrawer::build(gl::Gl& gl, const DataVariant& variant, gl::Program& program) const {
    static constexpr const char* kNames[kUniforms] = {kDataUniformNames[0],
                                                      kDataUniformNames[1],
                                                      kDataUniformNames[2],
                                                      kDataUniformNames[3],
                                                      kDataUniformNames[4],
                                                      kDataUniformNames[5],
                                                      kDataUniformNames[6],
                                                      kDataUniformNames[7],
                                                      kDataUniformNames[8],
                                                      "anchor",
                                                      "fading",
                                                      "cover",
                                                      "near_fade",
                                                      kGridUniformNames[0],
                                                      kGridUniformNames[1],
                                                      kGridUniformNames[2],
                                                      kGridUniformNames[3],
                                                      kGridUniformNames[4],
                                                      kGridUniformNames[5],
                                                      kGridUniformNames[6],
                                                      kMagnifierUniformNames[0],
                                                      kMagnifierUniformNames[1]};
    base::FixedString<kMaxShaderText> vertex(variant.grid ? "#define GRID 1\n" : "");
    DataFragment fragment("#define SOLIDS 1\n");
    if (variant.magnified) {
        vertex.append(kMagnifiedDefine);
        vertex.append(shader_text(k_magnified_vert));
        fragment.append(kMagnifiedDefine);
        fragment.append(shader_text(k_magnified_frag));
    }
    vertex.append(shader_text(k_data_light_vert));
    vertex.append(shader_text(k_solid_vert));
    if (variant.grid) {
        fragment.append("#define GRID 1\n");
        fragment.append(shader_text(k_surface_line_frag));
        fragment.append(shader_text(k_data_grid_frag));
    }
    add_data_fragment(fragment, variant.air);
    auto built =
        gl::build_program(gl, {"solid", vertex.view(), fragment.view(), base::Span<const gl::AttributeBinding>(kSolidBindings),
                               base::Span<const char* const>(kNames), true});
    if (!built.ok()) return built.error();
    program = built.value();
    return {};
}

void SolidDrawer::choose(base::Span<const SolidBuffers* const> solids, const SolidFrame& frame, const DepthRange& range) {
    chosen_ = 0;
    for (std::uint32_t b = 0; b < solids.size(); ++b) {
        const auto pieces = solids[b]->batch().pieces();
        for (std::uint32_t n = 0; n < pieces.size() && chosen_ < order_.size(); ++n) {
            const SolidPiece& piece = pieces[n];
            const double depth_m = glm::dot(piece.anchor - frame.frame.view.eye, frame.frame.view.forward);
            const double reach_m = static_cast<double>(piece.radius_m) + moved_m(piece, frame.frame.view);
            const bool is_shown = (frame.shown_groups >> piece.look.group & 1u) != 0;
            if (!is_shown || !terrain::overlap({depth_m - reach_m, depth_m + reach_m}, range)) continue;
            order_[chosen_++] = {depth_m, b, n};
        }
    }
}

/// The farthest first, the same order for equal ones. Few are mixed, and their order changes little from frame to frame.
void SolidDrawer::order_by_depth() {
    for (std::uint32_t n = 1; n < chosen_; ++n) {
        const Ordered moved = order_[n];
        std::uint32_t place = n;
        for (; place > 0 && order_[place - 1].depth_m < moved.depth_m; --place) order_[place] = order_[place - 1];
        order_[place] = moved;
    }
}

std::uint32_t SolidDrawer::draw(gl::Gl& gl, base::Span<const SolidBuffers* const> solids, const SolidFrame& frame,
                                const DepthRange& range) {
    draws_ = 0;
    choose(solids, frame, range);
    if (chosen_ == 0) return 0;
    order_by_depth();
    set_frame(gl, frame, range);
    for (GLuint attribute = 0; attribute < kSolidAttributes; ++attribute) gl->EnableVertexAttribArray(attribute);
    gl->Enable(GL_CULL_FACE);
    gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    draw_pass(gl, solids, frame, Pass::ghosts);
    draw_pass(gl, solids, frame, Pass::opaque);
    draw_pass(gl, solids, frame, Pass::mixed);
    draw_pass(gl, solids, frame, Pass::last);
    if (frame.frame.left.is_left()) draw_pass(gl, solids, frame, Pass::distances);
    gl->Disable(GL_CULL_FACE);
    for (GLuint attribute = 0; attribute < kSolidAttributes; ++attribute) gl->DisableVertexAttribArray(attribute);
    return draws_;
}

bool SolidDrawer::takes_part(const SolidPiece& piece, Pass pass) {
    switch (pass) {
        case Pass::ghosts: return piece.look.ghost > 0 && piece.look.halo_px <= 0;
        case Pass::opaque: return !is_mixed(piece) && !piece.look.is_last;
        case Pass::mixed: return is_mixed(piece) && !piece.look.is_last;
        case Pass::distances: return is_mixed(piece) || piece.look.is_last;
        case Pass::last: return piece.look.is_last;
    }
    return false;
}

void SolidDrawer::draw_pass(gl::Gl& gl, base::Span<const SolidBuffers* const> solids, const SolidFrame& frame, Pass pass) {
    const bool blends = pass == Pass::ghosts || pass == Pass::mixed || pass == Pass::last;
    if (blends) gl->Enable(GL_BLEND);
    if (pass != Pass::opaque) gl->DepthMask(GL_FALSE);
    if (pass == Pass::distances) gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    if (pass == Pass::ghosts) gl->DepthFunc(GL_GREATER);
    if (magnified_program_.valid()) {
        magnified_program_.use(gl);
        set_opaque(gl, magnified_program_, frame.frame, !blends);
        program_.use(gl);
    }
    set_opaque(gl, program_, frame.frame, !blends);
    std::uint32_t bound = kMaxSolidBuffers;
    for (std::uint32_t n = 0; n < chosen_; ++n) {
        const SolidBuffers& buffers = *solids[order_[n].buffer];
        const SolidPiece& piece = buffers.batch().pieces()[order_[n].piece];
        if (!takes_part(piece, pass)) continue;
        if (bound != order_[n].buffer) buffers.bind(gl);
        bound = order_[n].buffer;
        draw_piece(gl, piece, frame, pass);
    }
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl->DepthFunc(GL_LESS);
    gl->DepthMask(GL_TRUE);
    gl->Disable(GL_BLEND);
}

void SolidDrawer::set_frame(gl::Gl& gl, const SolidFrame& frame, const DepthRange& range) {
    for (const gl::Program* program : {&magnified_program_, &program_}) {
        if (!program->valid()) continue;
        program->use(gl);
        set_data_frame(gl, *program, frame.frame, range);
    }
}

void SolidDrawer::set_piece(gl::Gl& gl, const gl::Program& program, const SolidPiece& piece, const SolidFrame& frame,
                            Pass pass) const {
    const SolidLook& look = piece.look;
    set_solid_place(gl, program.uniform(kAnchor), piece, frame.frame.view.eye);
    set_solid_fading(gl, program.uniform(kFading), piece, grown_since(piece, frame));
    const auto focal_px = static_cast<float>(frame.frame.view.focal_px);
    gl->Uniform4f(program.uniform(kCover), look.opacity * (pass == Pass::ghosts ? look.ghost : 1.0f), look.halo_px / focal_px,
                  look.raised_px / focal_px, look.nearer_m);
    const NearFade fade = near_fade(look, pass == Pass::opaque);
    gl->Uniform2f(program.uniform(kNearFade), fade.from_m, fade.per_m);
    if (has_grid_) set_grid_place(gl, program, kGrid, grid_of(piece, frame.frame.grid), frame.frame.view.focal_px);
}

void SolidDrawer::draw_piece(gl::Gl& gl, const SolidPiece& piece, const SolidFrame& frame, Pass pass) {
    point_solid_attributes(gl, piece);
    if (magnified_program_.valid() && earth::is_magnified(frame.frame.view.magnifiers, extent_of(piece)))
        return draw_parts(gl, piece, frame, pass);
    set_piece(gl, program_, piece, frame, pass);
    draw_sides(gl, piece, pass);
}

/// Lines of a grid are as wide on the screen in each.
void SolidDrawer::draw_parts(gl::Gl& gl, const SolidPiece& piece, const SolidFrame& frame, Pass pass) {
    const DataFrame& data = frame.frame;
    const earth::GroundExtent extent = extent_of(piece);
    magnified_program_.use(gl);
    set_piece(gl, magnified_program_, piece, frame, pass);
    earth::MagnifiedParts parts(data.view.magnifiers, extent);
    for (earth::MagnifiedPart part; parts.next(part);) {
        set_magnifier_uniforms(gl, magnified_program_, kMagnifier, part, data.view.eye);
        if (has_grid_)
            set_grid_place(gl, magnified_program_, kGrid, grid_of(piece, data.grid), data.view.focal_px * part.scale());
        draw_sides(gl, piece, pass);
    }
    program_.use(gl);
}

void SolidDrawer::draw_sides(gl::Gl& gl, const SolidPiece& piece, Pass pass) {
    const SolidLook& look = piece.look;
    const gl::IndexRange range{piece.first_index, piece.indices, piece.vertices - 1};
    if ((pass == Pass::mixed && !look.is_hollow) || look.halo_px > 0) {
        gl->CullFace(GL_FRONT);
        gl::draw_triangles(gl, range);
        ++draws_;
    }
    gl->CullFace(GL_BACK);
    if (look.halo_px > 0) return;
    gl::draw_triangles(gl, range);
    ++draws_;
}

void SolidDrawer::destroy(gl::Gl& gl) {
    magnified_program_.destroy(gl);
    program_.destroy(gl);
}

}  // namespace tedavis::draw
