#include "render_core/draw/data/ghost_signs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/draw/data/billboard_look.hpp"
#include "render_core/draw/data/icons.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/planned_track.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/text_size.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr float kGhostHalf = 0.85f, kGhostGap = 0.25f, kGhostText = 0.85f;  // of the text's size
constexpr float kGhostLine_px = 1.5f, kGhostHalo_px = 1.5f;
constexpr double kFaint = 0.45;         // of the opacity, of the way that comes
constexpr double kFromAbove_cos = 0.7;  // of the angle between the view and straight down
constexpr int kNameRings = 4;
constexpr std::int64_t kSecond_ns = 1'000'000'000;
constexpr std::size_t kMaxGhostVertices = 4 * 2 * 6, kMaxGhostTextVertices = 4 * 2 * 31;

class Ghost {
public:
    Ghost(BillboardSheet& sheet, const ElementInput& input, std::uint32_t feature)
        : sheet_(sheet), input_(input), feature_(feature) {}

    bool add() {
        const GhostPlace here = ghost_place(input_.layer, feature_, input_.time_ns);
        if (!here.is_known) return false;
        const Placed at = placed(input_, here.point);
        if (!at.is_known) return false;
        look_ = billboard_look(input_, feature_);
        add_way();
        spot_ = sheet_.spot(at.place);
        if (!spot_.is_ahead || !sheet_.has_room(kMaxGhostVertices, BillboardSheet::kLinkVertices)) return false;
        const float half = half_px();
        if (!sheet_.claim_under_symbology({spot_.at.x - half, spot_.at.y - half, 2 * half, 2 * half}, at.place)) return false;
        if (input_.element.link) add_link(here.point);
        static_cast<void>(
            draw_icon(sheet_.signs(), Icon::ghost, spot_.at, kGhostHalf * sheet_.text_px(), look_.color, turn_rad(at.place)));
        add_name();
        return true;
    }

private:
    [[nodiscard]] float half_px() const { return (kGhostHalf + kGhostGap) * sheet_.text_px(); }

    [[nodiscard]] BillboardSheet::Spot spot_at(std::int64_t time_ns) const {
        const GhostPlace then = ghost_place(input_.layer, feature_, time_ns);
        const Placed at = then.is_known ? placed(input_, then.point) : Placed();
        return at.is_known ? sheet_.spot(at.place) : BillboardSheet::Spot();
    }

    /// Joins stand at whole multiples of kGhostLine_s, so that the line does not change its shape while the ghost flies along it.
    void add_way() const {
        constexpr std::int64_t kLeg_ns = kGhostLine_s * kSecond_ns;
        const std::int64_t now = input_.time_ns, end = now + kGhostComes_s * kSecond_ns;
        design::Color faint = look_.color;
        faint.alpha = static_cast<std::uint8_t>(std::lround(kFaint * look_.color.alpha));
        std::int64_t at = now - kGhostFlown_s * kSecond_ns;
        BillboardSheet::Spot from = spot_at(at);
        while (at < end) {
            const bool is_flown = at < now;
            std::int64_t next = (at / kLeg_ns + 1) * kLeg_ns;
            next = std::min(next, is_flown ? now : end);
            const BillboardSheet::Spot to = spot_at(next);
            if (sheet_.has_room(0, BillboardSheet::kStemVertices))
                sheet_.line(from, to, kGhostLine_px, is_flown ? look_.color : faint);
            from = to;
            at = next;
        }
    }

    void add_link(const scene::ScenePoint& point) const {
        const double ground_m = input_.ground.height_m(point.latitude_rad, point.longitude_rad);
        if (!std::isfinite(ground_m)) return;
        sheet_.link(sheet_.spot(earth::to_ecef({point.latitude_rad, point.longitude_rad, {ground_m}})), spot_, look_.color);
    }

    /// Of the aeroplane on the screen, clockwise; upright but where it is seen from above.
    [[nodiscard]] float turn_rad(const glm::dvec3& place) const {
        if (glm::dot(sheet_.view().forward, glm::normalize(place)) > -kFromAbove_cos) return 0;
        BillboardSheet::Spot from = spot_, to = spot_at(input_.time_ns + kSecond_ns);
        if (!to.is_ahead) from = spot_at(input_.time_ns - kSecond_ns), to = spot_;
        const float x = to.at.x - from.at.x, y = to.at.y - from.at.y;
        return from.is_ahead && to.is_ahead && std::hypot(x, y) > 0 ? std::atan2(x, -y) : 0;
    }

    void add_name() const {
        const BillboardText name = billboard_name(input_, feature_, look_);
        if (name.empty() || !sheet_.has_room(kMaxGhostTextVertices, 0)) return;
        const float size = std::max(kGhostText * sheet_.text_px(), kMinText_px);
        const float width = text_width_px(name.view(), size) + 2 * kGhostHalo_px;
        for (int ring = 0; ring < kNameRings; ++ring)
            for (const Rect& room : rooms_round(half_px() + static_cast<float>(ring) * size, width, size))
                if (sheet_.claim_beside(room)) {
                    const TextStyle style{size, look_.color, kGhostHalo_px, {0, 0, 0, look_.color.alpha}};
                    static_cast<void>(sheet_.signs().text(name.view(), room.center(), TextAnchor::center, style));
                    return;
                }
    }

    /// Of a name, the best first. Farther out there is room where the symbology lies round the aeroplane, as on an approach.
    [[nodiscard]] std::array<Rect, 4> rooms_round(float apart, float width, float height) const {
        const Point& at = spot_.at;
        return {{{at.x + apart, at.y - 0.5f * height, width, height},
                 {at.x - apart - width, at.y - 0.5f * height, width, height},
                 {at.x - 0.5f * width, at.y - apart - height, width, height},
                 {at.x - 0.5f * width, at.y + apart, width, height}}};
    }

    BillboardSheet& sheet_;
    const ElementInput& input_;
    std::uint32_t feature_;
    BillboardLook look_;
    BillboardSheet::Spot spot_;
};

}  // namespace

bool shows_ghosts(const scene::Layer& layer) {
    return layer.entry->role == scene::LayerRole::ghost && layer.entry->shape == scene::LayerShape::lines;
}

GhostPlace ghost_place(const scene::Layer& layer, std::uint32_t feature, std::int64_t time_ns) {
    const scene::Run run = layer.points_of(feature);
    if (run.count < 2) return {};
    const scene::ScenePoint *const first = layer.points.data() + run.first, *const end = first + run.count;
    if (first->time_ns == scene::kNoTime || time_ns < first->time_ns || time_ns > end[-1].time_ns) return {};
    const auto* const after = std::upper_bound(
        first, end, time_ns, [](std::int64_t time, const scene::ScenePoint& point) { return time < point.time_ns; });
    // At the last point the last leg ends. Where times run back it is some leg.
    const auto leg = static_cast<std::uint32_t>(std::clamp<std::ptrdiff_t>(after - first - 1, 0, run.count - 2));
    const std::int64_t span_ns = first[leg + 1].time_ns - first[leg].time_ns;
    if (span_ns <= 0) return {first[leg], true};
    const double part = static_cast<double>(time_ns - first[leg].time_ns) / static_cast<double>(span_ns);
    return {point_on({&layer, run, leg, 0}, leg, std::clamp(part, 0.0, 1.0)), true};
}

ElementCount add_ghost_signs(BillboardSheet& sheet, const ElementInput& input) {
    ElementCount count;
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature)
        if (Ghost(sheet, input, feature).add()) ++count.drawn;
    count.hidden = input.layer.entry->feature_count - count.drawn;
    return count;
}

}  // namespace tedavis::draw
