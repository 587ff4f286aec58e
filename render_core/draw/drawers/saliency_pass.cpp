#include "render_core/draw/drawers/saliency_pass.hpp"

#include <algorithm>

#include "render_core/base/check.hpp"
#include "render_core/draw/drawers/pass_targets.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/perception/entropy.hpp"
#include "render_core/perception/saliency_model.hpp"

namespace tedavis::draw {
namespace {

constexpr std::uint32_t kStripRows = 64;    // of the picture; whole blocks at every level
constexpr std::uint32_t kBlockTexels = 16;  // texels that become one, across and down
constexpr std::uint32_t kFigureColumns = 5, kFigureRows = 2;
constexpr int kConspicuity = 3, kTotal = 4;  // their columns; those of groups before
constexpr int kMax = 0, kCount = 1;          // rows

std::uint32_t level_side(std::uint32_t side, int level) { return (side + (1u << level) - 1) >> level; }
std::uint32_t extent_side(std::uint32_t side) { return (side + kBlockTexels - 1) / kBlockTexels; }

}  // namespace

int saliency_map_level(effects::Lane lane, std::uint32_t width_px, std::uint32_t height_px) noexcept {
    const int level = perception::saliency_level(static_cast<int>(width_px), static_cast<int>(height_px));
    return lane == effects::Lane::es2 ? level + 1 : level;
}

base::Error SaliencyPass::start(gl::Gl& gl, base::BudgetTable& budget, std::uint32_t width_px, std::uint32_t height_px,
                                bool shows_map, bool shows_heat) {
    width_px_ = width_px;
    height_px_ = height_px;
    level_ = saliency_map_level(gl.device().lane, width_px, height_px);
    taps_ = perception::gabor_taps();
    if (base::Error error = start_targets(gl, budget)) return error;
    if (base::Error error = triangle_.start(gl, budget)) return error;
    return programs_.start(gl, level_, shows_map, shows_heat);
}

base::Error SaliencyPass::start_targets(gl::Gl& gl, base::BudgetTable& budget) {
    base::BudgetLine& line = *budget.find(effects::kRenderTargets);
    PassTargets targets(gl, line);
    const std::uint32_t width = level_side(width_px_, level_), height = level_side(height_px_, level_);
    auto strip = gl::make_texture(gl, line, {gl::TextureFormat::rgb8, gl::TextureFilter::nearest, width_px_, kStripRows});
    if (!strip.ok()) return strip.error();
    strip_ = static_cast<gl::Texture&&>(strip.value());
    for (std::size_t n = 0; n < kLevels; ++n)
        for (auto* of : {&colors_, &straight_, &slanted_, &directions_})
            targets.make((*of)[n], level_side(width, static_cast<int>(n)), level_side(height, static_cast<int>(n)));
    for (auto& group : contrasts_)
        for (std::size_t n = 0; n < kCenters; ++n)
            targets.make(group[n], level_side(width, static_cast<int>(n)), level_side(height, static_cast<int>(n)));
    targets.make(conspicuity_, width, height);
    targets.make(total_, width, height);
    targets.make(map_, width, height, gl::TextureFilter::linear);
    std::uint32_t across = width, down = height;
    for (std::size_t n = 0; n < kScratch && (n == 0 || across > kBlockTexels || down > kBlockTexels); ++n) {
        across = extent_side(across);
        down = extent_side(down);
        targets.make(scratch_[n], across, down);
    }
    targets.make(figures_, kFigureColumns, kFigureRows);
    return targets.error();
}

bool SaliencyPass::can_show(design::SaliencyView view) const {
    return view == design::SaliencyView::none ||
           programs_.has(view == design::SaliencyView::map ? SaliencyStep::show_map : SaliencyStep::show_heat);
}

/// Means of blocks are narrower than levels of a pyramid (perception/pyramid.hpp), by so much.
void SaliencyPass::soften(gl::Gl& gl) {
    constexpr float kShares[] = {0, 1.0f / 16, 5.0f / 64, 21.0f / 256};
    const gl::Program& soften = programs_.use(gl, SaliencyStep::soften);
    read_texture(gl, soften, kSaliencyFirst, total_.color());
    gl->Uniform1f(soften.uniform(kSaliencyShare), kShares[level_]);
    colors_[0].bind(gl);
    triangle_.draw(gl);
}

/// Into one texel of the target.
void SaliencyPass::run(gl::Gl& gl, const gl::Program& program, const gl::RenderTarget& target, int column, int row) {
    target.bind(gl);
    gl->Viewport(column, row, 1, 1);
    gl->Uniform2f(program.uniform(kSaliencyOrigin), static_cast<float>(column), static_cast<float>(row));
    triangle_.draw(gl);
}

/// Numbers are packed in bytes: nothing may be blended, and no driver may dither them.
void SaliencyPass::measure(gl::Gl& gl, const base::Surface& surface, design::SaliencyScale scale) {
    is_fixed_ = scale == design::SaliencyScale::fixed;
    for (const GLenum state : {GL_DEPTH_TEST, GL_CULL_FACE, GL_BLEND, GL_DITHER}) gl->Disable(state);
    copy_colors(gl, surface);
    soften(gl);
    const gl::Program& reduce = programs_.use(gl, SaliencyStep::reduce);
    for (std::size_t n = 1; n < kLevels; ++n) {
        read_texture(gl, reduce, kSaliencyFirst, colors_[n - 1].color());
        colors_[n].bind(gl);
        triangle_.draw(gl);
    }
    measure_directions(gl);
    const Feature features[kGroups] = {{SaliencyStep::colors_contrast, colors_},
                                       {SaliencyStep::blue_contrast, colors_},
                                       {SaliencyStep::energy_contrast, directions_}};
    for (std::size_t group = 0; group < kGroups; ++group) {
        compare(gl, features[group], group);
        find_most(gl, SaliencyStep::most, contrasts_[group][0], static_cast<int>(group));
        count(gl, contrasts_[group][0], static_cast<int>(group));
    }
    mix(gl);
    gl->Enable(GL_DITHER);
    gl::bind_surface(gl, surface);
}

void SaliencyPass::copy_colors(gl::Gl& gl, const base::Surface& surface) {
    const std::uint32_t map_rows = kStripRows >> level_, width = colors_[0].color().settings().width_px;
    const gl::Program& lab = programs_.use(gl, SaliencyStep::lab);
    read_texture(gl, lab, kSaliencyFirst, strip_);
    std::uint32_t map_row = 0;
    for (std::uint32_t top = 0; top < height_px_; top += kStripRows, map_row += map_rows) {
        const std::uint32_t rows = std::min(kStripRows, height_px_ - top);
        gl::bind_surface(gl, surface);
        strip_.copy_rows(gl, kStripRows - rows, height_px_ - top - rows, rows);
        total_.bind(gl);
        gl->Viewport(0, static_cast<GLint>(map_row), static_cast<GLsizei>(width), static_cast<GLsizei>(map_rows));
        gl->Uniform3f(lab.uniform(kSaliencyStrip), static_cast<float>(map_row), static_cast<float>(width_px_),
                      static_cast<float>(rows));
        triangle_.draw(gl);
    }
}

void SaliencyPass::set_taps(gl::Gl& gl, const gl::Program& program, SaliencyUniform at,
                            const perception::GaborTaps::Taps& taps) const {
    gl->Uniform1fv(program.uniform(at), perception::kGaborRadius + 1, taps);
}

void SaliencyPass::measure_directions(gl::Gl& gl) {
    const gl::Program& rows = programs_.use(gl, SaliencyStep::rows);
    set_taps(gl, rows, kSaliencyBell, taps_.bell);
    for (const bool slanted : {false, true}) {
        set_taps(gl, rows, kSaliencyCosine, slanted ? taps_.slant_cosine : taps_.cosine);
        set_taps(gl, rows, kSaliencySine, slanted ? taps_.slant_sine : taps_.sine);
        for (std::size_t n = 0; n < kLevels; ++n) {
            read_texture(gl, rows, kSaliencyFirst, colors_[n].color());
            (slanted ? slanted_ : straight_)[n].bind(gl);
            triangle_.draw(gl);
        }
    }
    const gl::Program& energy = programs_.use(gl, SaliencyStep::energy);
    set_taps(gl, energy, kSaliencyBell, taps_.bell);
    set_taps(gl, energy, kSaliencyCosine, taps_.cosine);
    set_taps(gl, energy, kSaliencySine, taps_.sine);
    set_taps(gl, energy, kSaliencySlantCosine, taps_.slant_cosine);
    set_taps(gl, energy, kSaliencySlantSine, taps_.slant_sine);
    gl->Uniform2f(energy.uniform(kSaliencyFlatShare), taps_.flat_share, taps_.slant_flat);
    for (std::size_t n = 0; n < kLevels; ++n) {
        read_texture(gl, energy, kSaliencyFirst, straight_[n].color());
        read_texture(gl, energy, kSaliencySecond, slanted_[n].color());
        directions_[n].bind(gl);
        triangle_.draw(gl);
    }
}

/// From the coarsest centre to the finest, which takes in what the others say.
void SaliencyPass::compare(gl::Gl& gl, const Feature& feature, std::size_t group) {
    const gl::Program& contrast = programs_.use(gl, feature.step);
    for (std::size_t center = kCenters; center-- > 0;) {
        const bool has_coarser = center + 1 < kCenters;
        const std::size_t near = center + perception::kNearestSurround;
        read_texture(gl, contrast, kSaliencyFirst, feature.levels[center].color());
        read_texture(gl, contrast, kSaliencySecond, feature.levels[near].color());
        read_texture(gl, contrast, kSaliencyThird, feature.levels[near + 1].color());
        read_texture(gl, contrast, kSaliencyFourth,
                     has_coarser ? contrasts_[group][center + 1].color() : feature.levels[near].color());
        gl->Uniform1f(contrast.uniform(kSaliencyHasCoarser), has_coarser ? 1 : 0);
        contrasts_[group][center].bind(gl);
        triangle_.draw(gl);
    }
}

/// What scratch holds becomes one texel of the figures.
void SaliencyPass::gather(gl::Gl& gl, SaliencyStep step, int column, int row) {
    const gl::Program& program = programs_.use(gl, step);
    for (std::size_t n = 0; n < kScratch; ++n) {
        read_texture(gl, program, kSaliencyFirst, scratch_[n].color());
        const bool is_last = n + 1 == kScratch || !scratch_[n + 1].valid();
        if (is_last) return run(gl, program, figures_, column, row);
        gl->Uniform2f(program.uniform(kSaliencyOrigin), 0, 0);
        scratch_[n + 1].bind(gl);
        triangle_.draw(gl);
    }
}

void SaliencyPass::find_most(gl::Gl& gl, SaliencyStep step, const gl::RenderTarget& of, int column) {
    const gl::Program& most = programs_.use(gl, step);
    read_texture(gl, most, kSaliencyFirst, of.color());
    gl->Uniform2f(most.uniform(kSaliencyOrigin), 0, 0);
    scratch_[0].bind(gl);
    triangle_.draw(gl);
    gather(gl, step, column, kMax);
}

void SaliencyPass::count(gl::Gl& gl, const gl::RenderTarget& of, int column) {
    const gl::Program& above = programs_.use(gl, SaliencyStep::count);
    read_texture(gl, above, kSaliencyFirst, of.color());
    read_figures(gl, above);
    gl->Uniform2f(above.uniform(kSaliencyOrigin), 0, 0);
    gl->Uniform1f(above.uniform(kSaliencyColumn), static_cast<float>(column));
    scratch_[0].bind(gl);
    triangle_.draw(gl);
    gather(gl, SaliencyStep::sum_counts, column, kCount);
}

void SaliencyPass::read_figures(gl::Gl& gl, const gl::Program& program) const {
    read_texture(gl, program, kSaliencyFigures, figures_.color());
    const gl::TextureSettings& map = map_.color().settings();
    const double most_bits = perception::most_information(std::uint64_t{map.width_px} * map.height_px);
    gl->Uniform4f(program.uniform(kSaliencyScale), static_cast<float>(most_bits), is_fixed_ ? 1 : 0, perception::kNoticeable,
                  perception::kFixedGain);
}

void SaliencyPass::mix(gl::Gl& gl) {
    const gl::Program& conspicuity = programs_.use(gl, SaliencyStep::conspicuity);
    read_texture(gl, conspicuity, kSaliencyFirst, contrasts_[0][0].color());
    read_texture(gl, conspicuity, kSaliencySecond, contrasts_[1][0].color());
    read_texture(gl, conspicuity, kSaliencyThird, contrasts_[2][0].color());
    read_figures(gl, conspicuity);
    conspicuity_.bind(gl);
    triangle_.draw(gl);
    find_most(gl, SaliencyStep::most, conspicuity_, kConspicuity);
    if (!is_fixed_) count(gl, conspicuity_, kConspicuity);
    const gl::Program& total = programs_.use(gl, SaliencyStep::total);
    read_texture(gl, total, kSaliencyFirst, conspicuity_.color());
    read_figures(gl, total);
    total_.bind(gl);
    triangle_.draw(gl);
    if (!is_fixed_) find_most(gl, SaliencyStep::most_total, total_, kTotal);
    const gl::Program& map = programs_.use(gl, SaliencyStep::map);
    read_texture(gl, map, kSaliencyFirst, total_.color());
    read_figures(gl, map);
    map_.bind(gl);
    triangle_.draw(gl);
}

void SaliencyPass::show(gl::Gl& gl, design::SaliencyView view) {
    TEDAVIS_CHECK(can_show(view));
    const bool is_map = view == design::SaliencyView::map;
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_CULL_FACE);
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    const gl::Program& program = programs_.use(gl, is_map ? SaliencyStep::show_map : SaliencyStep::show_heat);
    read_texture(gl, program, kSaliencyFirst, map_.color());
    triangle_.draw(gl);
    gl->Disable(GL_BLEND);
}

void SaliencyPass::destroy(gl::Gl& gl) {
    programs_.destroy(gl);
    triangle_.destroy(gl);
    strip_.destroy(gl);
    for (auto* levels : {&colors_, &straight_, &slanted_, &directions_})
        for (gl::RenderTarget& target : *levels) target.destroy(gl);
    for (auto& group : contrasts_)
        for (gl::RenderTarget& target : group) target.destroy(gl);
    for (gl::RenderTarget& target : scratch_) target.destroy(gl);
    for (gl::RenderTarget* target : {&conspicuity_, &total_, &map_, &figures_}) target->destroy(gl);
}

}  // namespace tedavis::draw
