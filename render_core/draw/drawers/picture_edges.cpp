#include "render_core/draw/drawers/picture_edges.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/budget_shortage.hpp"
#include "render_core/base/check.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/draw/shader_texts.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/readback.hpp"
#include "render_core/gl/render_target.hpp"
#include "render_core/perception/edge_density.hpp"

namespace tedavis::draw {
namespace {

using ClutterRegions = scene::DetailRegions;

constexpr perception::CannySettings kCanny;
constexpr std::uint32_t kEdgeStripRows = 16;
constexpr std::uint64_t kAlignmentBytes = 16;  // that the strip may lose before it
constexpr std::uint32_t kRegionsAcross{ClutterRegions::kAcross}, kRegionsDown{ClutterRegions::kDown};
constexpr perception::RegionGrid kClutterGrid{static_cast<int>(kRegionsAcross), static_cast<int>(kRegionsDown)};
constexpr float kFullTint = 0.25f;  // density with the last colour, as in the evaluation's views
static_assert(kRegionsDown <= kEdgeStripRows);

enum EdgeUniform : std::size_t { kEdgeTexture, kEdgeTextureSize, kEdgePicture, kEdgeTop, kEdgeUniforms };
constexpr gl::AttributeBinding kEdgeAttributes[] = {{"position", 0}};
constexpr const char* kEdgeUniformNames[kEdgeUniforms] = {"first", "first_size", "picture", "top"};

std::uint64_t edge_strip_bytes(std::uint32_t width_px) { return std::uint64_t{4} * width_px * kEdgeStripRows; }

}  // namespace

std::uint64_t PictureEdges::bytes(std::uint32_t width_px, std::uint32_t height_px) {
    return perception::EdgeDetector::bytes(static_cast<int>(width_px), static_cast<int>(height_px), kCanny.sigma) +
           edge_strip_bytes(width_px) + kAlignmentBytes;
}

base::Error PictureEdges::start(gl::Gl& gl, base::BudgetTable& budget, base::Arena& memory, std::uint32_t width_px,
                                std::uint32_t height_px, bool shows) {
    if (std::max(width_px, height_px) > perception::kMaxPictureSide)
        return base::make_error("edges are found in pictures of at most ", base::digits(perception::kMaxPictureSide).view(),
                                " pixels each way; take a smaller size");
    if (memory.use().capacity == 0)
        return base::make_error(
            "clutter is measured, for which the device file has no budget line 'picture_edges'; add one of kind ",
            "\"cpu\" with ", base::digits(bytes(width_px, height_px)).view(), " bytes");
    width_px_ = width_px;
    height_px_ = height_px;
    const bool has_room = detector_.start(memory, static_cast<int>(width_px), static_cast<int>(height_px), kCanny.sigma);
    pixels_ = memory.allocate_array<std::uint8_t>(static_cast<std::size_t>(edge_strip_bytes(width_px)));
    if (!has_room || pixels_.empty()) return base::shortage_error(effects::kPictureEdges, memory, "edges of the picture");
    return shows ? start_views(gl, budget) : base::Error{};
}

base::Error PictureEdges::start_views(gl::Gl& gl, base::BudgetTable& budget) {
    auto strip = gl::make_texture(
        gl, *budget.find(effects::kRenderTargets),
        {gl::TextureFormat::r8, gl::TextureFilter::nearest, std::max(width_px_, kRegionsAcross), kEdgeStripRows});
    if (!strip.ok()) return strip.error();
    strip_ = static_cast<gl::Texture&&>(strip.value());
    if (base::Error error = triangle_.start(gl, budget)) return error;
    if (base::Error error = build(gl, EdgeView::edges)) return error;
    return build(gl, EdgeView::regions);
}

base::Error PictureEdges::build(gl::Gl& gl, EdgeView view) {
    const bool is_tint = view == EdgeView::regions;
    base::FixedString<kMaxShaderText> fragment;
    if (is_tint) {
        fragment.append("#define REGIONS 1\n");
        fragment.append(shader_text(k_heat_frag));
    }
    fragment.append(shader_text(k_edge_show_frag));
    auto built = gl::build_program(
        gl, {is_tint ? "edges: regions shown" : "edges: shown", shader_text(k_saliency_vert), fragment.view(),
             base::Span<const gl::AttributeBinding>(kEdgeAttributes), base::Span<const char* const>(kEdgeUniformNames), true});
    if (!built.ok()) return built.error();
    programs_[static_cast<std::size_t>(view)] = built.value();
    return {};
}

effects::ClutterMap PictureEdges::measure(gl::Gl& gl, const base::Surface& surface) {
    gl::bind_surface(gl, surface);
    densities_ = {};
    edges_ = {};
    if (!read(gl)) return densities_;
    edges_ = detector_.finish();
    std::array<double, kRegionsAcross * kRegionsDown> found{};
    const perception::EdgeView view{edges_, static_cast<int>(width_px_), static_cast<int>(height_px_)};
    densities_.is_known = !edges_.empty() && perception::region_densities(view, kClutterGrid, found);
    for (std::size_t n = 0; n < found.size(); ++n) densities_.measure[n] = static_cast<float>(found[n]);
    return densities_;
}

bool PictureEdges::read(gl::Gl& gl) {
    if (!detector_.begin(static_cast<int>(width_px_), static_cast<int>(height_px_), kCanny)) return false;
    const std::ptrdiff_t row_bytes = std::ptrdiff_t{4} * width_px_;
    for (std::uint32_t top = 0; top < height_px_; top += kEdgeStripRows) {
        const std::uint32_t rows = std::min(kEdgeStripRows, height_px_ - top);
        const base::Span<std::uint8_t> strip = pixels_.subspan(0, std::size_t{4} * width_px_ * rows);
        if (!gl::read_rows(gl, height_px_ - top - rows, width_px_, rows, strip)) return false;
        const std::uint8_t* const upper = strip.data() + row_bytes * (static_cast<std::ptrdiff_t>(rows) - 1);
        if (!detector_.add_rows({upper, static_cast<int>(width_px_), static_cast<int>(rows), 4, -row_bytes})) return false;
    }
    return true;
}

void PictureEdges::show(gl::Gl& gl, EdgeView view) const {
    TEDAVIS_CHECK(can_show());
    if (edges_.empty()) return;
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_CULL_FACE);
    if (view == EdgeView::regions)
        show_regions(gl);
    else
        show_edges(gl);
    gl->Disable(GL_BLEND);
}

const gl::Program& PictureEdges::use(gl::Gl& gl, EdgeView view) const {
    const gl::Program& program = programs_[static_cast<std::size_t>(view)];
    program.use(gl);
    strip_.bind(gl, 0);
    gl->Uniform1i(program.uniform(kEdgeTexture), 0);
    gl->Uniform2f(program.uniform(kEdgeTextureSize), static_cast<float>(strip_.settings().width_px),
                  static_cast<float>(strip_.settings().height_px));
    gl->Uniform2f(program.uniform(kEdgePicture), static_cast<float>(width_px_), static_cast<float>(height_px_));
    return program;
}

/// Each strip covers its own rows of the surface.
void PictureEdges::show_edges(gl::Gl& gl) const {
    const gl::Program& program = use(gl, EdgeView::edges);
    gl->Disable(GL_BLEND);
    const auto width = static_cast<GLsizei>(width_px_);
    for (std::uint32_t top = 0; top < height_px_; top += kEdgeStripRows) {
        const std::uint32_t rows = std::min(kEdgeStripRows, height_px_ - top);
        static_cast<void>(strip_.upload(gl, {0, 0, width_px_, rows}, edges_.data() + std::size_t{width_px_} * top));
        gl->Uniform1f(program.uniform(kEdgeTop), static_cast<float>(top));
        gl->Viewport(0, static_cast<GLint>(height_px_ - top - rows), width, static_cast<GLsizei>(rows));
        triangle_.draw(gl);
    }
    gl->Viewport(0, 0, width, static_cast<GLsizei>(height_px_));
}

void PictureEdges::show_regions(gl::Gl& gl) const {
    std::array<std::uint8_t, kRegionsAcross * kRegionsDown> tints{};
    for (std::size_t n = 0; n < tints.size(); ++n)
        tints[n] = static_cast<std::uint8_t>(std::lround(255.0f * std::min(densities_.measure[n] / kFullTint, 1.0f)));
    static_cast<void>(use(gl, EdgeView::regions));
    static_cast<void>(strip_.upload(gl, {0, 0, kRegionsAcross, kRegionsDown}, tints.data()));
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    triangle_.draw(gl);
}

void PictureEdges::destroy(gl::Gl& gl) {
    for (gl::Program& program : programs_) program.destroy(gl);
    triangle_.destroy(gl);
    strip_.destroy(gl);
    edges_ = {};
    pixels_ = {};
}

}  // namespace tedavis::draw
