#include "render_core/draw/data/wind_barbs.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/draw/data/billboard_look.hpp"
#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/wind_barb.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr float kBox = 0.75f;  // of a staff, to each side: room that a barb takes

/// Level unit vectors at a place: ahead and to the right on the picture.
struct Level {
    glm::dvec3 ahead, right;
};
Level level_of(const terrain::View& view, const LocalAxes& axes) {
    constexpr double kSteepView = 0.3;
    const auto flat = [&](const glm::dvec3& v) { return v - axes.up * glm::dot(v, axes.up); };
    glm::dvec3 ahead = flat(view.forward);
    // Steeply down or up, where the picture's up leads says more.
    if (glm::length(ahead) < kSteepView) ahead = flat(-view.down) * (glm::dot(view.forward, axes.up) < 0 ? 1.0 : -1.0);
    const double length = glm::length(ahead);
    ahead = length > 0 ? ahead / length : axes.north;
    return {ahead, glm::cross(ahead, axes.up)};
}

class BarbSign {
public:
    BarbSign(BillboardSheet& sheet, const ElementInput& input, const scene::SelectedGlyph& glyph)
        : sheet_(sheet), input_(input), summary_(glyph.summary), place_(sheet.view().eye + glm::dvec3(summary_.place)) {
        if (input.foci != nullptr && input.foci->frame() != nullptr) focus_ = look_at(*input.foci->frame(), degree_of(glyph));
    }

    bool add() const {
        const BillboardSheet::Spot spot = sheet_.spot(place_);
        if (!spot.is_ahead || !sheet_.has_room(kMaxBarbVertices, BillboardSheet::kLinkVertices)) return false;
        const float staff_px = kStaff * sheet_.text_px() * static_cast<float>(focus_.size), half = kBox * staff_px;
        if (!sheet_.claim({spot.at.x - half, spot.at.y - half, 2 * half, 2 * half}, place_)) return false;
        const earth::Geodetic at = earth::from_ecef(place_);
        const scene::Wind wind = scene::wind_of(summary_);
        const BillboardLook look = look_of(wind);
        if (input_.element.link) add_link(spot, look);
        const BarbStyle style{staff_px, at.latitude_rad < 0, look.color, look.text};
        static_cast<void>(draw_wind_barb(sheet_.signs(), spot.at, from_on_screen(at, wind), wind, style));
        return true;
    }

private:
    [[nodiscard]] BillboardLook look_of(const scene::Wind& wind) const {
        const design::ColorEncoding& by_color = input_.element.by_color;
        design::Color color = by_color.is_used() ? design::scale_color(by_color.scale, wind.speed_mps) : input_.element.color;
        if (wind.state == scene::WindState::unknown) color = input_.missing;
        BillboardLook look = faded_look(input_.element, color, summary_.uncertainty);
        look.color = shown_color(focus_, look.color);
        return look;
    }

    [[nodiscard]] Point from_on_screen(const earth::Geodetic& at, const scene::Wind& wind) const {
        const LocalAxes axes = local_axes(at.latitude_rad, at.longitude_rad);
        const Level level = level_of(sheet_.view(), axes);
        const glm::dvec3 from = axes.east * std::sin(wind.from_rad) + axes.north * std::cos(wind.from_rad);
        return {static_cast<float>(glm::dot(from, level.right)), static_cast<float>(-glm::dot(from, level.ahead))};
    }

    void add_link(const BillboardSheet::Spot& spot, const BillboardLook& look) const {
        const auto over_ground_m = double{summary_.over_ground_m};
        if (!(over_ground_m > kFloating_m)) return;
        sheet_.link(sheet_.spot(place_ - earth::up_at(place_) * over_ground_m), spot, look.color);
    }

    BillboardSheet& sheet_;
    const ElementInput& input_;
    const scene::GlyphSummary& summary_;
    glm::dvec3 place_;
    FocusLook focus_;
};

}  // namespace

ElementCount add_wind_barbs(BillboardSheet& sheet, const ElementInput& input, base::Span<const scene::SelectedGlyph> glyphs) {
    ElementCount count;
    sheet.begin_candidates();
    for (std::uint32_t n = 0; n < glyphs.size(); ++n) {
        count.hidden += glyphs[n].summary.members;
        sheet.offer({static_cast<double>(glm::length(glyphs[n].summary.place)), n});
    }
    for (const BillboardCandidate& candidate : sheet.ranked()) {
        const scene::SelectedGlyph& glyph = glyphs[candidate.feature];
        if (!BarbSign(sheet, input, glyph).add()) continue;
        count.hidden -= glyph.summary.members;
        (glyph.is_aggregate ? count.aggregated : count.drawn) += glyph.summary.members;
    }
    return count;
}

}  // namespace tedavis::draw
