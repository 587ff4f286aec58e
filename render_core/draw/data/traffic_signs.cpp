#include "render_core/draw/data/traffic_signs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/billboard_look.hpp"
#include "render_core/draw/data/icons.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/traffic_state.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr design::Color kStale{150, 150, 150};
constexpr float kHalf = 0.7f, kGap = 0.3f, kSize = 0.85f;  // of the text's size: the diamond, round it, its texts
constexpr float kLine_px = 2, kHalo_px = 1.5f;
constexpr int kCircleSides = 24;
/// Diamond, dashes, cross, three texts with their halos; two lines and the circle with their rims: four vertices each.
constexpr std::size_t kMostVertices = 4 * (8 + 16 + 2 + 2 * 3 * 31), kMostLinkVertices = 4 * 2 * (2 + kCircleSides);

/// "+12", "-03": hundreds of feet.
BillboardText height_text(double over_m, double climb_mps) {
    constexpr double kFeet = 3.280839895, kMost = 999;
    BillboardText text;
    if (!std::isfinite(over_m)) return text;
    const double hundreds = std::clamp(std::round(over_m * kFeet / 100), -kMost, kMost);
    char digits[16];
    std::snprintf(digits, sizeof digits, "%c%02d", hundreds < 0 ? '-' : '+', std::abs(static_cast<int>(hundreds)));
    text.append(digits);
    if (std::abs(climb_mps) >= kShownClimb_mps) text.append(climb_mps > 0 ? "\xE2\x86\x91" : "\xE2\x86\x93");
    return text;
}

BillboardText age_text(const TrafficState& state) {
    BillboardText text;
    if (std::isnan(state.age_s)) text = "AGE ?";
    if (!(state.age_s >= kShownAge_s)) return text;
    char digits[16];
    std::snprintf(digits, sizeof digits, "%d s", static_cast<int>(std::min(state.age_s, kRemoved_s)));
    text.append(digits);
    return text;
}

class Sign {
public:
    Sign(BillboardSheet& sheet, const ElementInput& input, std::uint32_t feature)
        : sheet_(sheet), input_(input), feature_(feature) {}

    bool add() {
        state_ = traffic_state(input_, feature_);
        place_ = placed(input_, state_.point);
        if (!state_.is_known || !place_.is_known) return false;
        spot_ = sheet_.spot(place_.place);
        if (!spot_.is_ahead || !sheet_.has_room(kMostVertices, kMostLinkVertices)) return false;
        look_ = billboard_look(input_, feature_);
        look_.is_unsure = look_.is_unsure || (shows_circle() && !(state_.accuracy.level_m > 0));
        if (state_.is_stale) look_.color = {kStale.red, kStale.green, kStale.blue, look_.color.alpha};
        write();
        if (!sheet_.claim_under_symbology(box(), place_.place)) return false;
        draw_lines();
        draw_sign();
        return true;
    }

private:
    void write() {
        name_ = billboard_name(input_, feature_, look_);
        const double eye_m = earth::from_ecef(input_.eye).height.m;
        height_ = height_text(place_.height_m - eye_m, state_.up);
        age_ = age_text(state_);
    }

    [[nodiscard]] float size_px() const { return kSize * sheet_.text_px(); }
    [[nodiscard]] float half_px() const { return (kHalf + kGap) * sheet_.text_px(); }

    /// Of the diamond with its texts: the name right of it, the height below, the age above.
    [[nodiscard]] Rect box() const {
        const float half = half_px(), line = size_px();
        const float half_width =
            0.5f * std::max({text_width_px(height_.view(), line), text_width_px(age_.view(), line), 2 * half});
        const float right = std::max(half_width, half + text_width_px(name_.view(), line));
        const float above = age_.empty() ? 0 : line;
        return {spot_.at.x - half_width, spot_.at.y - half - above, half_width + right, 2 * half + above + line};
    }

    void draw_lines() const {
        if (state_.has_velocity && !state_.is_stale) {
            const LocalAxes axes = local_axes(state_.point.latitude_rad, state_.point.longitude_rad);
            const glm::dvec3 velocity = axes.east * state_.east + axes.north * state_.north + axes.up * state_.up;
            line_between(spot_, sheet_.spot(place_.place + velocity * kVelocityLine_s));
        }
        if (input_.element.link) {
            const double ground_m = input_.ground.height_m(state_.point.latitude_rad, state_.point.longitude_rad);
            if (std::isfinite(ground_m))
                line_between(sheet_.spot(earth::to_ecef({state_.point.latitude_rad, state_.point.longitude_rad, {ground_m}})),
                             spot_);
        }
        if (shows_circle()) draw_circle();
    }

    [[nodiscard]] bool shows_circle() const { return input_.element.uncertainty == design::ElementUncertainty::ellipsoid; }

    void line_between(const BillboardSheet::Spot& from, const BillboardSheet::Spot& to) const {
        sheet_.line(from, to, kLine_px, look_.color);
    }

    /// Where it may be, on the level.
    void draw_circle() const {
        const double radius_m = state_.accuracy.level_m;
        if (!(radius_m > 0)) return;
        const LocalAxes axes = local_axes(state_.point.latitude_rad, state_.point.longitude_rad);
        const auto on_circle = [&](int n) {
            const double angle = 2 * base::kPi * n / kCircleSides;
            return sheet_.spot(place_.place + (axes.east * std::cos(angle) + axes.north * std::sin(angle)) * radius_m);
        };
        BillboardSheet::Spot before = on_circle(0);
        for (int n = 1; n <= kCircleSides; ++n) {
            const BillboardSheet::Spot next = on_circle(n);
            line_between(before, next);
            before = next;
        }
    }

    void draw_sign() const {
        QuadBatch& batch = sheet_.signs();
        const float half = kHalf * sheet_.text_px();
        static_cast<void>(draw_icon(batch, Icon::traffic, spot_.at, half, look_.color));
        if (state_.is_stale) {
            const Point &at = spot_.at, low{at.x - half, at.y + half}, high{at.x + half, at.y - half};
            static_cast<void>(batch.line(low, high, kLine_px + 2, {0, 0, 0, look_.color.alpha}));
            static_cast<void>(batch.line(low, high, kLine_px, look_.color));
        }
        if (look_.is_unsure) static_cast<void>(draw_dashed_rim(batch, spot_.at, half_px(), look_.color));
        const TextStyle style{size_px(), look_.text, kHalo_px, {0, 0, 0, look_.color.alpha}};
        const float line = half_px() + 0.5f * size_px();
        static_cast<void>(batch.text(name_.view(), {spot_.at.x + half_px(), spot_.at.y}, TextAnchor::left, style));
        static_cast<void>(batch.text(height_.view(), {spot_.at.x, spot_.at.y + line}, TextAnchor::center, style));
        static_cast<void>(batch.text(age_.view(), {spot_.at.x, spot_.at.y - line}, TextAnchor::center, style));
    }

    BillboardSheet& sheet_;
    const ElementInput& input_;
    std::uint32_t feature_;
    TrafficState state_;
    Placed place_;
    BillboardSheet::Spot spot_;
    BillboardLook look_;
    BillboardText name_, height_, age_;
};

}  // namespace

ElementCount add_traffic_signs(BillboardSheet& sheet, const ElementInput& input) {
    sheet.begin_candidates();
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        const TrafficState state = traffic_state(input, feature);
        if (!state.is_known) continue;
        const glm::dvec3 place = earth::to_ecef({state.point.latitude_rad, state.point.longitude_rad, {0}});
        const double distance_m = sheet.seen_distance_m(glm::distance(place, sheet.view().eye));
        if (distance_m <= kFarthestTraffic_m) sheet.offer({distance_m, feature});
    }
    ElementCount count;
    for (const BillboardCandidate& candidate : sheet.ranked())
        if (Sign(sheet, input, candidate.feature).add()) ++count.drawn;
    count.hidden = input.layer.entry->feature_count - count.drawn;
    return count;
}

}  // namespace tedavis::draw
