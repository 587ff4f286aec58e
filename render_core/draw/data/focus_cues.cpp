#include "render_core/draw/data/focus_cues.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/base/units.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/text_size.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

using Text = base::FixedString<23>;

/// Rims, shapes and two lines of text with halos: four each.
constexpr std::size_t kMaxCueVertices = 4 * (2 * 4 + 2 * 2 * 23);
constexpr float kArrow = 0.8f, kSign = 0.6f, kLine = 1.0f, kGap = 0.3f;  // of the text's size
constexpr float kHalo_px = 1.5f, kCueRim_px = 1.5f, kStroke_px = 2;
constexpr design::Color kDark{0, 0, 0};

/// One decimal below ten.
Text distance_text(double distance_m, base::DisplayUnits units) {
    const base::DisplayUnit unit = base::distance_unit(units);
    const double length = unit.of(distance_m);
    char digits[24];
    const auto end = std::to_chars(digits, digits + sizeof(digits), std::llround(length < 10 ? length * 10 : length)).ptr;
    const std::string_view number(digits, static_cast<std::size_t>(end - digits));
    Text text;
    if (length < 10) {
        text.append(number.size() > 1 ? number.substr(0, number.size() - 1) : "0");
        text.append(".");
        text.append(number.substr(number.size() - 1));
    } else {
        text.append(number);
    }
    text.append(" ");
    text.append(unit.text);
    return text;
}

glm::dvec3 place_of(const scene::FocusRegion& region, std::uint32_t n, scene::Ground& ground) {
    const glm::dvec2 at = region.points[n];
    const earth::Geodetic foot = earth::from_ecef(region.anchor + region.east * at.x + region.north * at.y);
    double height_m =
        region.is_volume ? 0.5 * (region.lower_m + region.upper_m) : ground.height_m(foot.latitude_rad, foot.longitude_rad);
    if (!std::isfinite(height_m)) height_m = 0;
    return earth::to_ecef({foot.latitude_rad, foot.longitude_rad, {height_m}});
}

/// Where a focus is seen, or the point of it to be led to.
struct Found {
    FocusSight sight = FocusSight::out_of_view;
    glm::dvec3 place{0};
    double distance_m = 0;
};

Found look_for(const BillboardSheet& sheet, const scene::FocusRegion& region, const glm::dvec3& from, scene::Ground& ground) {
    Found best;
    if (scene::focus_distance_m(region, scene::in_focus_plane(region, from)) <= 0) {
        best.sight = FocusSight::around;
        return best;
    }
    for (std::uint32_t n = 0; n < region.point_count; ++n) {
        const glm::dvec3 place = place_of(region, n, ground);
        const BillboardSheet::Spot spot = sheet.spot(place);
        const bool is_in_picture = spot.is_ahead && sheet.is_in_picture({spot.at.x, spot.at.y, 0, 0});
        const FocusSight sight = !is_in_picture         ? FocusSight::out_of_view
                                 : sheet.is_seen(place) ? FocusSight::seen
                                                        : FocusSight::behind_terrain;
        const double distance_m = glm::distance(place, from);
        const bool is_better = n == 0 || sight < best.sight || (sight == best.sight && distance_m < best.distance_m);
        if (is_better) best = {sight, place, distance_m};
    }
    return best;
}

class Cue {
public:
    Cue(BillboardSheet& sheet, const design::FocusSettings& focus, const Found& found, base::DisplayUnits units)
        : sheet_(sheet),
          color_(focus.border.color),
          name_(focus.name.view()),
          distance_(distance_text(found.distance_m, units)),
          place_(found.place),
          text_px_(sheet.text_px()) {}

    /// At the place, or above it where that is taken.
    bool add_sign() {
        constexpr int kTries = 8;
        const Point at = sheet_.spot(place_).at;
        const float half = kSign * text_px_;
        for (int n = 0; n < kTries; ++n) {
            const Point middle{at.x, at.y - static_cast<float>(n) * 1.5f * text_px_};
            if (!claim({middle.x, middle.y + 0.5f * texts_px()}, half)) continue;
            const Point corners[] = {{middle.x, middle.y - half},
                                     {middle.x + half, middle.y},
                                     {middle.x, middle.y + half},
                                     {middle.x - half, middle.y}};
            static_cast<void>(sheet_.signs().polyline(corners, kStroke_px + 2 * kCueRim_px, kDark, true));
            static_cast<void>(sheet_.signs().polyline(corners, kStroke_px, color_, true));
            write({middle.x, middle.y + half});
            return true;
        }
        return false;
    }

    /// At the picture's edge, where the way to the place leaves it, or beside; farther in where that is taken.
    bool add_arrow() {
        constexpr int kTries = 31, kRings = 4;
        constexpr double kStep_rad = base::radians(6);
        const terrain::View& view = sheet_.view();
        const glm::dvec3 way = place_ - view.eye;
        const double angle = std::atan2(glm::dot(way, view.down), glm::dot(way, view.right));
        const float half = kArrow * text_px_;
        for (int n = 0; n < kRings * kTries; ++n) {
            const int ring = n / kTries, turn = n % kTries, steps = turn % 2 == 0 ? turn / 2 : -(turn + 1) / 2;
            const Point middle = near_edge(angle + steps * kStep_rad, 1 - 0.2 * ring);
            if (!claim(middle, half)) continue;
            const bool is_down = std::sin(angle) > 0;  // the arrow then stands below its text
            const float top = middle.y - half - 0.5f * texts_px();
            const Point at{middle.x, is_down ? top + texts_px() + half : top + half};
            draw_arrow(at, angle, half + kCueRim_px, kDark);
            draw_arrow(at, angle, half, color_);
            write({middle.x, is_down ? top : top + 2 * half});
            return true;
        }
        return false;
    }

private:
    [[nodiscard]] float line_px() const { return std::max(kLine * text_px_, kMinText_px); }
    [[nodiscard]] float texts_px() const { return 2 * line_px(); }
    [[nodiscard]] float width_px() const {
        return std::max(text_width_px(name_.view(), line_px()), text_width_px(distance_.view(), line_px()));
    }
    /// Of a shape with two lines of text.
    [[nodiscard]] Rect box(Point middle, float half) const {
        const float width = std::max(width_px(), 2 * half) + 2 * kGap * text_px_,
                    height = texts_px() + 2 * half + kGap * text_px_;
        return {middle.x - 0.5f * width, middle.y - 0.5f * height, width, height};
    }
    [[nodiscard]] bool claim(Point middle, float half) {
        return sheet_.has_room(kMaxCueVertices, 0) && sheet_.claim_beside(box(middle, half));
    }
    /// The middle of a cue, seen from the picture's middle in this direction; at 1 it touches the edge.
    [[nodiscard]] Point near_edge(double angle, double share) const {
        const Rect screen = sheet_.screen(), own = box({0, 0}, kArrow * text_px_);
        constexpr float kFromEdge_px = 2;
        const double across = 0.5 * static_cast<double>(screen.width - own.width) - static_cast<double>(kFromEdge_px);
        const double along = 0.5 * static_cast<double>(screen.height - own.height) - static_cast<double>(kFromEdge_px);
        const double x = std::cos(angle), y = std::sin(angle);
        constexpr double kMin = 1e-9;
        const double reach = share * std::fmin(across / std::fmax(std::fabs(x), kMin), along / std::fmax(std::fabs(y), kMin));
        return {screen.x + 0.5f * screen.width + static_cast<float>(x * reach),
                screen.y + 0.5f * screen.height + static_cast<float>(y * reach)};
    }
    void draw_arrow(Point at, double angle, float half, design::Color color) const {
        const auto corner = [&](double turn, float reach) {
            return Point{at.x + reach * static_cast<float>(std::cos(angle + turn)),
                         at.y + reach * static_cast<float>(std::sin(angle + turn))};
        };
        constexpr double kBack_rad = 2.5;
        static_cast<void>(sheet_.signs().triangle(corner(0, half), corner(kBack_rad, half), corner(-kBack_rad, half), color));
    }
    /// Two lines below a place.
    void write(Point top) const {
        const TextStyle style{line_px(), color_, kHalo_px, kDark};
        static_cast<void>(sheet_.signs().text(name_.view(), {top.x, top.y + 0.6f * line_px()}, TextAnchor::center, style));
        static_cast<void>(sheet_.signs().text(distance_.view(), {top.x, top.y + 1.6f * line_px()}, TextAnchor::center, style));
    }

    BillboardSheet& sheet_;
    design::Color color_;
    Text name_, distance_;
    glm::dvec3 place_;
    float text_px_;
};

}  // namespace

const char* name_of(FocusSight sight) noexcept {
    switch (sight) {
        case FocusSight::nowhere: return "nowhere";
        case FocusSight::around: return "around";
        case FocusSight::seen: return "seen";
        case FocusSight::behind_terrain: return "behind terrain";
        case FocusSight::out_of_view: return "out of view";
    }
    return "";
}

FocusCues add_focus_cues(BillboardSheet& sheet, const FrameFoci& foci, scene::Ground& ground, base::DisplayUnits units) {
    FocusCues cues;
    const glm::dvec3 from = foci.has_own_ship ? foci.own_ship : sheet.view().eye;
    for (std::size_t n = 0; n < foci.regions.size(); ++n) {
        if (!foci.regions[n].is_valid) continue;
        const Found found = look_for(sheet, foci.regions[n], from, ground);
        cues[n] = {found.sight, found.distance_m, false};
        Cue cue(sheet, (*foci.foci)[n], found, units);
        if (found.sight == FocusSight::behind_terrain) cues[n].is_drawn = cue.add_sign() || cue.add_arrow();
        if (found.sight == FocusSight::out_of_view) cues[n].is_drawn = cue.add_arrow();
    }
    return cues;
}

}  // namespace tedavis::draw
