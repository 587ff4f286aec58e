#include "render_core/draw/data/glyph_encoding.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "render_core/base/units.hpp"
#include "render_core/design/grey_of.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/placement.hpp"

namespace tedavis::draw {
namespace {

using scene::GlyphSummary;
using scene::GlyphValues;
using scene::SelectedGlyph;
using scene::ValueState;
using scene::WindState;

constexpr double kSignShare = 0.5;                                        // of signs, of the full size
constexpr double kBarWidth = 0.3, kSolidWidth = 0.6, kArrowWidth = 0.26;  // of the full size
constexpr double kStem_px = 2, kFootWidth_px = 12, kFootHeight_px = 4;

GlyphShape shape_of(GlyphForm form) {
    switch (form) {
        case GlyphForm::arrow: return GlyphShape::arrow;
        case GlyphForm::flat_arrow: return GlyphShape::flat_arrow;
        case GlyphForm::sphere: return GlyphShape::sphere;
        case GlyphForm::bar: return GlyphShape::box;
        case GlyphForm::cone: return GlyphShape::cone;
        case GlyphForm::tetrahedron: return GlyphShape::tetrahedron;
        case GlyphForm::circle: return GlyphShape::circle;
        case GlyphForm::triangle: return GlyphShape::triangle;
        case GlyphForm::puff: return GlyphShape::puff;
    }
    return GlyphShape::sphere;
}

bool is_arrow(GlyphForm form) { return form == GlyphForm::arrow || form == GlyphForm::flat_arrow; }

bool is_sign_shape(GlyphShape shape) {
    return shape == GlyphShape::ring || shape == GlyphShape::crossed_ring || shape == GlyphShape::cross;
}

class Encoder {
public:
    Encoder(GlyphValues values, const GlyphStyle& style, const design::DataScale& scale, const earth::Ecef& eye)
        : values_(values), style_(style), scale_(scale), eye_(eye) {}

    [[nodiscard]] GlyphShape shape(const SelectedGlyph& glyph) const {
        if (const std::optional<GlyphShape> sign = this->sign(glyph.summary)) return *sign;
        const GlyphShape whole = shape_of(style_.form);
        return glyph.size_px < kPlainBelow_px || look_of(glyph).detail < 1 ? plain_variant(whole) : whole;
    }

    /// `shape` as above.
    [[nodiscard]] GlyphInstance instance(const SelectedGlyph& glyph, GlyphShape shape) const {
        const GlyphSummary& summary = glyph.summary;
        const FocusLook look = look_of(glyph);
        const double size_m = static_cast<double>(glyph.size_m) * look.size;
        if (is_sign_shape(shape)) {
            const bool is_missing = summary.state == ValueState::missing;
            return make_glyph(summary.place, glm::vec3(static_cast<float>(kSignShare * size_m)), glm::dvec3(0),
                              shown_color(look, faded(is_missing ? style_.missing : style_.plain, summary)));
        }
        const double value = shown_value(summary);
        const LocalAxes axes = local_axes(eye_ + glm::dvec3(summary.place));
        glm::dvec3 direction = axes.north;
        if (shows_direction()) {
            const double towards = compass_angle(std::atan2(double{summary.value}, double{summary.north_mps}));
            direction = axes.east * std::sin(towards) + axes.north * std::cos(towards);
        }
        const bool shows_value = look.detail >= kMinDetailOfValues;
        const design::Color shown = shows_value ? color(summary, value) : faded(style_.plain, summary);
        return make_glyph(summary.place, extent(size_m, shows_value ? share(value) : style_.least_share), direction,
                          shown_color(look, shown));
    }

    [[nodiscard]] bool has_link(const SelectedGlyph& glyph) const {
        return style_.link_per_px > 0 && double{glyph.summary.over_ground_m} > kFloating_m;
    }
    /// The line and its mark, from who is linked.
    void add_link(const SelectedGlyph& glyph, const GlyphInstance& linked, GlyphInstance (&parts)[kLinkParts]) const {
        const glm::dvec3 place(glyph.summary.place), up = earth::up_at(eye_ + place);
        const auto length_m = double{glyph.summary.over_ground_m};
        const double pixel_m = glm::length(place) * style_.link_per_px;
        const design::Color color{linked.rgba[0], linked.rgba[1], linked.rgba[2], linked.rgba[3]};
        parts[0] = make_glyph(glm::vec3(place - up * (0.5 * length_m)), glm::vec3(glm::dvec3(length_m, kStem_px * pixel_m, 1)),
                              up, color);
        parts[1] = make_glyph(glm::vec3(place - up * (length_m - 0.5 * kFootHeight_px * pixel_m)),
                              glm::vec3(glm::dvec3(kFootHeight_px, kFootWidth_px, 1) * pixel_m), up, color);
    }

    [[nodiscard]] bool is_transparent() const {
        return style_.opacity < 1 || style_.fading > 0 || style_.form == GlyphForm::puff;
    }

private:
    [[nodiscard]] FocusLook look_of(const SelectedGlyph& glyph) const {
        return style_.foci == nullptr ? FocusLook() : look_at(*style_.foci, degree_of(glyph));
    }
    [[nodiscard]] bool shows_direction() const {
        return values_ == GlyphValues::wind && is_arrow(style_.form) && style_.subject == GlyphSubject::value;
    }
    [[nodiscard]] double compass_angle(double angle_rad) const {
        if (style_.directions == 0) return angle_rad;
        const double step = 2 * base::kPi / style_.directions;
        return std::round(angle_rad / step) * step;
    }
    /// Of what has no value, or no direction that an arrow could show; else none.
    [[nodiscard]] std::optional<GlyphShape> sign(const GlyphSummary& summary) const {
        if (summary.state == ValueState::missing) return GlyphShape::cross;
        if (style_.subject == GlyphSubject::uncertainty) return std::nullopt;
        if (summary.is_mixed) return GlyphShape::crossed_ring;
        if (!shows_direction()) return std::nullopt;
        const WindState state = scene::wind_of(summary).state;
        if (state == WindState::steady) return std::nullopt;
        return state == WindState::calm ? GlyphShape::ring : GlyphShape::crossed_ring;
    }
    [[nodiscard]] double shown_value(const GlyphSummary& summary) const {
        if (style_.subject == GlyphSubject::uncertainty) return summary.uncertainty.level();
        return values_ == GlyphValues::wind ? summary.speed_mps : summary.value;
    }
    /// 0..1 of the full size.
    [[nodiscard]] double share(double value) const {
        if (style_.sizing == GlyphSizing::alike) return 1;
        const std::size_t breaks = scale_.breaks.size();
        double part = (value - style_.least_value) / (style_.full_value - style_.least_value);
        if (style_.sizing == GlyphSizing::classes && breaks > 0)
            part = static_cast<double>(design::class_of(scale_, value)) / static_cast<double>(breaks);
        return style_.least_share + (1 - style_.least_share) * std::fmin(std::fmax(part, 0), 1);
    }
    /// Length, width and height.
    [[nodiscard]] glm::vec3 extent(double size_m, double share) const {
        const double sized_m = size_m * share;
        if (is_arrow(style_.form)) {
            const double width_m = size_m * kArrowWidth * 0.5 * (1 + share);
            return glm::vec3(glm::dvec3(sized_m, width_m, width_m));
        }
        if (style_.form == GlyphForm::bar) return glm::vec3(glm::dvec3(size_m * kBarWidth, size_m * kBarWidth, sized_m));
        if (style_.form == GlyphForm::cone || style_.form == GlyphForm::tetrahedron)
            return glm::vec3(glm::dvec3(size_m * kSolidWidth, size_m * kSolidWidth, sized_m));
        return glm::vec3(static_cast<float>(sized_m));
    }
    [[nodiscard]] design::Color color(const GlyphSummary& summary, double value) const {
        if (style_.subject == GlyphSubject::uncertainty && !summary.uncertainty.is_known()) return faded(style_.unknown, summary);
        return faded(style_.is_colored ? design::scale_color(scale_, value) : style_.plain, summary);
    }
    [[nodiscard]] design::Color faded(design::Color color, const GlyphSummary& summary) const {
        const bool is_missing = summary.state == ValueState::missing;
        const bool fades = style_.fading > 0 || style_.greying > 0;
        if (fades && !is_missing && !summary.uncertainty.is_known()) color = style_.unknown;
        const double level = is_missing || !summary.uncertainty.is_known() ? 0 : summary.uncertainty.level();
        const double lost = style_.fading * level;
        if (style_.greying > 0) color = design::blended(color, design::grey_of(color), style_.greying * level);
        color.alpha = static_cast<std::uint8_t>(std::lround(color.alpha * style_.opacity * (1 - lost)));
        return color;
    }

    GlyphValues values_;
    const GlyphStyle& style_;
    const design::DataScale& scale_;
    earth::Ecef eye_;
};

/// From far to near.
void order(base::Span<GlyphInstance> glyphs) {
    std::sort(glyphs.begin(), glyphs.end(), [](const GlyphInstance& a, const GlyphInstance& b) {
        return glm::dot(a.place, a.place) > glm::dot(b.place, b.place);
    });
}

}  // namespace

std::uint32_t encode_glyphs(base::Span<const SelectedGlyph> glyphs, GlyphValues values, const GlyphStyle& style,
                            const design::DataScale& scale, const earth::Ecef& eye, GlyphBatch& batch) {
    const Encoder encoder(values, style, scale, eye);
    std::uint32_t counts[kGlyphShapes] = {};
    constexpr auto kStem = static_cast<std::size_t>(GlyphShape::stem);
    for (const SelectedGlyph& glyph : glyphs) {
        ++counts[static_cast<std::size_t>(encoder.shape(glyph))];
        if (encoder.has_link(glyph)) counts[kStem] += kLinkParts;
    }
    base::Span<GlyphInstance> rooms[kGlyphShapes];
    std::uint32_t left_out = 0;
    for (std::size_t n = 0; n < kGlyphShapes; ++n) {
        const auto shape = static_cast<GlyphShape>(n);
        const GlyphFacing facing = n == kStem ? GlyphFacing::eye_upright : is_sign_shape(shape) ? GlyphFacing::eye : style.facing;
        rooms[n] = batch.add(shape, facing, encoder.is_transparent(), counts[n]);
        if (rooms[n].empty()) left_out += counts[n];
    }
    std::uint32_t filled[kGlyphShapes] = {};
    for (const SelectedGlyph& glyph : glyphs) {
        const GlyphShape shape = encoder.shape(glyph);
        const auto n = static_cast<std::size_t>(shape);
        if (rooms[n].empty()) continue;
        const GlyphInstance& made = rooms[n][filled[n]++] = encoder.instance(glyph, shape);
        if (rooms[kStem].empty() || !encoder.has_link(glyph)) continue;
        GlyphInstance parts[kLinkParts];
        encoder.add_link(glyph, made, parts);
        for (const GlyphInstance& part : parts) rooms[kStem][filled[kStem]++] = part;
    }
    if (encoder.is_transparent())
        for (const base::Span<GlyphInstance>& room : rooms) order(room);
    return left_out;
}

}  // namespace tedavis::draw
