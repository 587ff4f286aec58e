#include "render_core/draw/data/traffic_signs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/billboard_look.hpp"
#include "render_core/draw/data/icons.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/traffic_state.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/text_size.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr float kHalf = 0.7f, kGap = 0.3f, kSize = 0.85f;  // of the text's size: the diamond, round it, its texts
constexpr float kLine_px = 2, kHalo_px = 1.5f;
constexpr float kTouch_px = 0.25f;  // texts touch the diamond's box; rounding must not make that an overlap
constexpr int kCircleSides = 24;
/// Diamond and its filling, dashes, cross; a text with its halo; two lines and the circle with their rims: four vertices each.
constexpr std::size_t kMaxTrafficVertices = 4 * (8 + 8 + 16 + 2), kMaxTrafficTextVertices = 4 * 2 * 31,
                      kMaxTrafficLinkVertices = 4 * 2 * (2 + kCircleSides);

/// Of a text, round the diamond.
enum class Side : std::uint8_t { right, left, below, above };
using Sides = std::array<Side, 4>;  ///< the best first
constexpr Sides kLowerSides{Side::below, Side::above, Side::right, Side::left};
constexpr Sides kHigherSides{Side::above, Side::below, Side::right, Side::left};
constexpr Sides kAgeSides{Side::above, Side::below, Side::right, Side::left};
constexpr Sides kNameSides{Side::right, Side::left, Side::above, Side::below};

/// "+12", "-03": hundreds of feet; "+370M", "-90M": metres by tens.
BillboardText height_text(double over_m, double climb_mps, base::DisplayUnits units) {
    BillboardText text;
    if (!std::isfinite(over_m)) return text;
    const bool is_metric = units == base::DisplayUnits::metric;
    const double per_count = is_metric ? 10 : 100, most = is_metric ? 3045 : 999;
    const auto counts = static_cast<int>(std::clamp(std::round(base::height_unit(units).of(over_m) / per_count), -most, most));
    char digits[16];
    const int size = std::abs(counts);
    std::snprintf(digits, sizeof digits, is_metric ? "%c%dM" : "%c%02d", counts < 0 ? '-' : '+', is_metric ? size * 10 : size);
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

    /// Without its texts.
    bool add() {
        if (!look() || !sheet_.has_room(kMaxTrafficVertices, kMaxTrafficLinkVertices)) return false;
        const float half = half_px();
        const Rect box{spot_.at.x - half, spot_.at.y - half, 2 * half, 2 * half};
        if (!sheet_.claim_under_symbology(box.shrunk(kTouch_px), place_.place)) return false;
        draw_lines();
        draw_sign();
        return true;
    }

    /// Of one that was added: what says most first.
    void add_texts() {
        if (!look()) return;
        const OwnPlace& own = input_.own_ship;
        const double over_m = place_.height_m - (own.has_height ? own.place.height.m : earth::from_ecef(input_.eye).height.m);
        add_text(height_text(over_m, state_.up, input_.units), over_m < 0 ? kLowerSides : kHigherSides);
        add_text(age_text(state_), kAgeSides);
        add_text(billboard_name(input_, feature_, look_), kNameSides);
    }

private:
    bool look() {
        state_ = traffic_state(input_, feature_);
        place_ = placed(input_, state_.point);
        if (!state_.is_known || !place_.is_known) return false;
        spot_ = sheet_.spot(place_.place);
        if (!spot_.is_ahead) return false;
        look_ = billboard_look(input_, feature_);
        look_.is_unsure = look_.is_unsure || (shows_circle() && !(state_.accuracy.level_m > 0));
        if (state_.is_stale) look_.color = {kStaleTraffic.red, kStaleTraffic.green, kStaleTraffic.blue, look_.color.alpha};
        return true;
    }

    [[nodiscard]] float size_px() const { return std::max(kSize * sheet_.text_px(), kMinText_px); }
    [[nodiscard]] float half_px() const { return (kHalf + kGap) * sheet_.text_px(); }

    /// Of a text with its halo.
    [[nodiscard]] Rect box(std::string_view text, Side side) const {
        const float width = text_width_px(text, size_px()) + 2 * kHalo_px, height = size_px(), half = half_px();
        const Point& at = spot_.at;
        switch (side) {
            case Side::right: return {at.x + half, at.y - 0.5f * height, width, height};
            case Side::left: return {at.x - half - width, at.y - 0.5f * height, width, height};
            case Side::below: return {at.x - 0.5f * width, at.y + half, width, height};
            case Side::above: break;
        }
        return {at.x - 0.5f * width, at.y - half - height, width, height};
    }

    /// Whole where it is seen whole, or not at all: half a number is another number.
    void add_text(const BillboardText& text, const Sides& sides) const {
        if (text.empty() || !sheet_.has_room(kMaxTrafficTextVertices, 0)) return;
        for (const Side side : sides) {
            const Rect room = box(text.view(), side);
            if (!sheet_.claim_beside(room)) continue;
            const TextStyle style{size_px(), look_.text, kHalo_px, {0, 0, 0, look_.text.alpha}};
            static_cast<void>(sheet_.signs().text(text.view(), room.center(), TextAnchor::center, style));
            return;
        }
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
        const bool is_near = is_proximate(input_, state_, place_.height_m);
        static_cast<void>(draw_icon(batch, is_near ? Icon::near_traffic : Icon::traffic, spot_.at, half, look_.color));
        if (state_.is_stale) {
            const Point &at = spot_.at, low{at.x - half, at.y + half}, high{at.x + half, at.y - half};
            static_cast<void>(batch.line(low, high, kLine_px + 2, {0, 0, 0, look_.color.alpha}));
            static_cast<void>(batch.line(low, high, kLine_px, look_.color));
        }
        if (const float rim = look_.rim(); rim > 0)
            static_cast<void>(draw_dashed_rim(batch, spot_.at, half_px(), look_.color, rim));
    }

    BillboardSheet& sheet_;
    const ElementInput& input_;
    std::uint32_t feature_;
    TrafficState state_;
    Placed place_;
    BillboardSheet::Spot spot_;
    BillboardLook look_;
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
    const base::Span<const BillboardCandidate> ranked = sheet.ranked();
    std::array<bool, BillboardSheet::kMaxCandidates> is_added{};
    for (std::size_t n = 0; n < ranked.size(); ++n) {
        is_added[n] = Sign(sheet, input, ranked[n].feature).add();
        if (is_added[n]) ++count.drawn;
    }
    for (std::size_t n = 0; n < ranked.size(); ++n)
        if (is_added[n]) Sign(sheet, input, ranked[n].feature).add_texts();
    count.hidden = input.layer.entry->feature_count - count.drawn;
    return count;
}

}  // namespace tedavis::draw
