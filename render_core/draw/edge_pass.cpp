#include "render_core/draw/edge_pass.hpp"

#include <algorithm>

#include "render_core/base/check.hpp"
#include "render_core/draw/pass_targets.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/gl/readback.hpp"
#include "render_core/perception/edge_density.hpp"
#include "render_core/perception/edge_detector.hpp"

namespace tedavis::draw {
namespace {

using ClutterRegions = scene::DetailRegions;

constexpr std::uint32_t kBlockPixels = 4;  // across and down
constexpr std::uint32_t kLevelRows = 2;    // of levels above and below, that a crest depends on
constexpr std::uint32_t kBlurRows = 3;     // of the picture, that a level depends on
constexpr std::uint32_t kReadRows = kLevelRows + kBlurRows;
constexpr std::uint32_t kMaxCounted = 255;  // pixels of a row, in a byte

std::uint32_t edge_blocks(std::uint32_t pixels) { return (pixels + kBlockPixels - 1) / kBlockPixels; }
/// Columns of a colour's plane: a texel more at both ends.
std::uint32_t plane_columns(std::uint32_t width_px) { return edge_blocks(width_px) + 2; }
/// Parts of a region so narrow that a byte holds what they count.
std::uint32_t parts_of_region(std::uint32_t width_px) {
    const std::uint32_t widest = width_px / std::uint32_t{ClutterRegions::kAcross} + 1;
    return (widest + kMaxCounted - 1) / kMaxCounted;
}
/// Blocks that a run of so many pixels reaches, wherever it begins.
std::uint32_t blocks_under(std::uint32_t pixels) { return pixels / kBlockPixels + 2; }
EdgeLoops edge_loops(std::uint32_t width_px, std::uint32_t height_px, std::uint32_t parts) {
    const std::uint32_t across = width_px / std::uint32_t{ClutterRegions::kAcross} / parts + 1;
    const std::uint32_t down = height_px / std::uint32_t{ClutterRegions::kDown} + 1;
    return {blocks_under(across), blocks_under(down) * parts};
}

}  // namespace

base::Error EdgePass::start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px, bool shows) {
    if (std::max(width_px, height_px) > perception::kMaxPictureSide)
        return base::make_error("edges are found in pictures of at most ", base::digits(perception::kMaxPictureSide).view(),
                                " pixels each way; take a smaller size");
    width_px_ = width_px;
    height_px_ = height_px;
    strip_rows_ = gl.device().lane == effects::Lane::es2 ? 16 : 64;
    parts_ = parts_of_region(width_px);
    if (base::Error error = start_edge_targets(gl, budget)) return error;
    if (base::Error error = triangle_.start(gl, budget)) return error;
    return programs_.start(gl, edge_loops(width_px, height_px, parts_), shows);
}

base::Error EdgePass::start_edge_targets(gl::Gl& gl, base::BudgetTable& budget) {
    base::BudgetLine& line = *budget.find(effects::kRenderTargets);
    PassTargets targets(gl, line);
    const std::uint32_t planes = perception::kColors * plane_columns(width_px_);
    const std::uint32_t strip_rows = strip_rows_ + 2 * kReadRows;
    auto strip = gl::make_texture(gl, line, {gl::TextureFormat::rgb8, gl::TextureFilter::nearest, width_px_, strip_rows});
    if (!strip.ok()) return strip.error();
    strip_ = static_cast<gl::Texture&&>(strip.value());
    targets.make(planes_, planes, strip_rows);
    targets.make(levels_, planes, strip_rows_ + 2 * kLevelRows);
    for (gl::RenderTarget& edges : edges_)
        targets.make(edges, perception::kColors * edge_blocks(width_px_), edge_blocks(height_px_));
    targets.make(regions_, ClutterRegions::kAcross, ClutterRegions::kDown);
    targets.make(counts_, ClutterRegions::kAcross * parts_, edge_blocks(height_px_));
    return targets.error();
}

const gl::Program& EdgePass::use(gl::Gl& gl, EdgeStep step, const gl::RenderTarget& of) const {
    return programs_.use(gl, step, of.color(), width_px_, height_px_);
}

EdgePass::Rows EdgePass::around(const Rows& rows, std::uint32_t more) const {
    return {rows.first - std::min(rows.first, more), std::min(rows.end + more, height_px_)};
}

/// Numbers are packed in bytes: nothing may be blended, and no driver may dither them.
void EdgePass::measure(gl::Gl& gl, const base::Surface& surface) {
    for (const GLenum state : {GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND, GL_DITHER}) gl->Disable(state);
    for (std::uint32_t top = 0; top < height_px_; top += strip_rows_) {
        const Rows rows{top, std::min(top + strip_rows_, height_px_)};
        const Rows read = around(rows, kReadRows);
        copy_planes(gl, surface, read);
        find_crests(gl, read, around(rows, kLevelRows), rows);
    }
    follow(gl);
    count(gl);
    is_measured_ = true;
    gl->Enable(GL_DITHER);
    gl::bind_surface(gl, surface);
}

void EdgePass::copy_planes(gl::Gl& gl, const base::Surface& surface, const Rows& rows) {
    gl::bind_surface(gl, surface);
    strip_.copy_rows(gl, strip_.settings().height_px - rows.count(), height_px_ - rows.end, rows.count());
    const gl::Program& planes = programs_.use(gl, EdgeStep::planes, strip_, width_px_, height_px_);
    gl->Uniform1f(planes.uniform(kEdgeBand), static_cast<float>(plane_columns(width_px_)));
    planes_.bind(gl);
    gl->Viewport(0, 0, static_cast<GLsizei>(planes_.color().settings().width_px), static_cast<GLsizei>(rows.count()));
    triangle_.draw(gl);
}

void EdgePass::find_crests(gl::Gl& gl, const Rows& read, const Rows& blurred, const Rows& rows) {
    const perception::CannySettings settings;
    const perception::GaussianWeights weights = perception::gaussian_weights(settings.sigma);
    TEDAVIS_CHECK(weights.radius == static_cast<int>(kBlurRows));
    const auto band = static_cast<float>(plane_columns(width_px_));
    const gl::Program& blur = use(gl, EdgeStep::blur, planes_);
    gl->Uniform1f(blur.uniform(kEdgeBand), band);
    gl->Uniform2f(blur.uniform(kEdgeRows), static_cast<float>(read.first), static_cast<float>(blurred.first));
    gl->Uniform4f(blur.uniform(kEdgeBell), weights.at[0], weights.at[1], weights.at[2], weights.at[3]);
    levels_.bind(gl);
    gl->Viewport(0, 0, static_cast<GLsizei>(levels_.color().settings().width_px), static_cast<GLsizei>(blurred.count()));
    triangle_.draw(gl);
    const gl::Program& crests = use(gl, EdgeStep::crests, levels_);
    gl->Uniform1f(crests.uniform(kEdgeBand), band);
    gl->Uniform2f(crests.uniform(kEdgeRows), static_cast<float>(blurred.first), 0);
    gl->Uniform2f(crests.uniform(kEdgeThresholds), static_cast<float>(settings.low * settings.low),
                  static_cast<float>(settings.high * settings.high));
    edges_[0].bind(gl);
    gl->Viewport(0, static_cast<GLint>(rows.first / kBlockPixels), static_cast<GLsizei>(edges_[0].color().settings().width_px),
                 static_cast<GLsizei>(edge_blocks(rows.count())));
    triangle_.draw(gl);
}

void EdgePass::follow(gl::Gl& gl) {
    static_assert(kIterations % 2 == 0, "the last iteration leaves its edges where the first one found them");
    for (int iteration = 0; iteration < kIterations; ++iteration) {
        const gl::Program& follow = use(gl, EdgeStep::follow, edges_[iteration % 2]);
        gl->Uniform1f(follow.uniform(kEdgeBand), static_cast<float>(edge_blocks(width_px_)));
        edges_[(iteration + 1) % 2].bind(gl);
        triangle_.draw(gl);
    }
}

void EdgePass::count(gl::Gl& gl) {
    const gl::Program& count = use(gl, EdgeStep::count, edges_[0]);
    gl->Uniform1f(count.uniform(kEdgeBand), static_cast<float>(edge_blocks(width_px_)));
    gl->Uniform1f(count.uniform(kEdgeParts), static_cast<float>(parts_));
    counts_.bind(gl);
    triangle_.draw(gl);
    const gl::Program& regions = use(gl, EdgeStep::regions, counts_);
    gl->Uniform1f(regions.uniform(kEdgeParts), static_cast<float>(parts_));
    regions_.bind(gl);
    triangle_.draw(gl);
}

effects::ClutterMap EdgePass::densities(gl::Gl& gl, const base::Surface& surface) const {
    effects::ClutterMap map;
    std::array<std::uint8_t, 4 * ClutterRegions::kAcross * ClutterRegions::kDown> bytes{};
    if (!is_measured_) return map;
    regions_.bind(gl);
    map.is_known = gl::read_pixels(gl, ClutterRegions::kAcross, ClutterRegions::kDown, {bytes.data(), bytes.size()});
    gl::bind_surface(gl, surface);
    if (!map.is_known) return map;
    const perception::RegionGrid grid{static_cast<int>(ClutterRegions::kAcross), static_cast<int>(ClutterRegions::kDown)};
    for (std::size_t n = 0; n < map.measure.size(); ++n) {
        const perception::PixelRegion region = perception::region_of(grid, static_cast<int>(n % ClutterRegions::kAcross),
                                                                     static_cast<int>(n / ClutterRegions::kAcross),
                                                                     static_cast<int>(width_px_), static_cast<int>(height_px_));
        const int pixels = (region.right - region.left) * (region.bottom - region.top);
        const int edges = bytes[4 * n] << 16 | bytes[4 * n + 1] << 8 | bytes[4 * n + 2];
        map.measure[n] = pixels > 0 ? static_cast<float>(static_cast<double>(edges) / pixels) : 0;
    }
    return map;
}

void EdgePass::show(gl::Gl& gl, EdgeView view) const {
    TEDAVIS_CHECK(can_show() && is_measured_);
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_CULL_FACE);
    const bool is_tint = view == EdgeView::regions;
    if (is_tint) {
        gl->Enable(GL_BLEND);
        gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    }
    const gl::Program& program = is_tint ? use(gl, EdgeStep::show_regions, regions_) : use(gl, EdgeStep::show_edges, edges_[0]);
    gl->Uniform1f(program.uniform(kEdgeBand), static_cast<float>(edge_blocks(width_px_)));
    triangle_.draw(gl);
    gl->Disable(GL_BLEND);
}

void EdgePass::destroy(gl::Gl& gl) {
    programs_.destroy(gl);
    triangle_.destroy(gl);
    strip_.destroy(gl);
    for (gl::RenderTarget* target : {&planes_, &levels_, &edges_[0], &edges_[1], &counts_, &regions_}) target->destroy(gl);
    is_measured_ = false;
}

}  // namespace tedavis::draw
