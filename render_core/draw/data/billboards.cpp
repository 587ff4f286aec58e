#include "render_core/draw/data/billboards.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/billboard_look.hpp"
#include "render_core/draw/data/icons.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr double kBehind_m = 10'000;  // of the eye: what the ground's height may bring forward again
/// Stems are longer where a line of the symbology, the horizon above all, leaves no room; but not those of obstacles, of which
/// each is as high as it looks.
constexpr float kStem = BillboardSheet::kStem, kStems[] = {kStem, kStem + 2.5f, kStem + 5}, kOnTheSpot = 0;
constexpr float kGap = 0.25f;  // of the text's size, round an icon
constexpr float kNameSize = 0.9f;
constexpr float kHalo_px = 1.5f;
/// Of stems, which lead to a sign and are nothing that stands there; links have the element's colour.
constexpr float kStem_px = 1;
constexpr design::Color kStemColor{170, 170, 175};
/// Rim and strokes of an icon, dashes, name with halo: four each.
constexpr std::size_t kMostVertices = 4 * (2 * (6 + 10) + 16 + 2 * 31);
constexpr std::size_t kMostLinkVertices = BillboardSheet::kStemVertices + BillboardSheet::kLinkVertices;

/// Middle of an area's corners, in the plane of the first one.
scene::ScenePoint middle_of(const ElementInput& input, const scene::Run& run) {
    scene::ScenePoint middle = input.layer.points[run.first];
    double north = 0, east = 0;
    for (std::uint32_t n = 0; n < run.count; ++n) {
        const scene::ScenePoint& point = input.layer.points[run.first + n];
        north += (point.latitude_rad - middle.latitude_rad) / run.count;
        east += std::remainder(point.longitude_rad - middle.longitude_rad, 2 * base::kPi) / run.count;
    }
    middle.latitude_rad += north;
    middle.longitude_rad += east;
    middle.height_m = std::numeric_limits<float>::quiet_NaN();
    return middle;
}

scene::ScenePoint gone(scene::ScenePoint point, const glm::dvec2& drift_m) {
    const double across = std::cos(point.latitude_rad) * earth::prime_vertical_radius_m(point.latitude_rad);
    if (across > 0) point.longitude_rad += drift_m.x / across;
    point.latitude_rad += drift_m.y / earth::meridian_radius_m(point.latitude_rad);
    return point;
}

/// Where a feature's billboard stands; a run without points has none.
bool anchor_of(const ElementInput& input, std::uint32_t feature, scene::ScenePoint& anchor) {
    const scene::LayerShape shape = input.layer.entry->shape;
    if (shape == scene::LayerShape::points || shape == scene::LayerShape::meshes) {
        anchor = input.layer.points[feature];
        return true;
    }
    const scene::Run run = input.layer.points_of(feature);
    if (run.count == 0) return false;
    anchor = shape == scene::LayerShape::areas ? gone(middle_of(input, run), drift_m(input, feature))
                                               : input.layer.points[run.first + run.count / 2];
    return true;
}

/// Of a higher class of an ordinal attribute "kind".
double precedence_of(const scene::Layer& layer, std::uint32_t feature) {
    const scene::Attribute* const kind = layer.find("kind");
    if (kind == nullptr || kind->entry->scale != scene::AttributeScale::ordinal) return 1;
    const double code = value_or_nan(layer, "kind", feature);
    return code >= 0 ? std::exp2(code) : 1;
}

void offer_features(BillboardSheet& sheet, const ElementInput& input) {
    sheet.begin_candidates();
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        scene::ScenePoint anchor;
        if (!anchor_of(input, feature, anchor)) continue;
        const double height_m = std::isnan(anchor.height_m) ? 0 : static_cast<double>(anchor.height_m);
        const glm::dvec3 from_eye = earth::to_ecef({anchor.latitude_rad, anchor.longitude_rad, {height_m}}) - sheet.view().eye;
        const double distance_m = sheet.seen_distance_m(glm::length(from_eye));
        const bool is_near = distance_m <= kFarthestBillboard_m && glm::dot(from_eye, sheet.view().forward) > -kBehind_m;
        if (is_near) sheet.offer({distance_m / precedence_of(input.layer, feature), feature});
    }
}

class Billboard {
public:
    Billboard(BillboardSheet& sheet, const ElementInput& input, std::uint32_t feature)
        : sheet_(sheet), input_(input), feature_(feature) {}

    bool add(bool with_name) {
        scene::ScenePoint anchor;
        if (!anchor_of(input_, feature_, anchor)) return false;
        const Placed place = placed(input_, anchor);
        if (!place.is_known) return false;
        spot_ = sheet_.spot(place.place);
        if (!spot_.is_ahead || !sheet_.has_room(kMostVertices, kMostLinkVertices)) return false;
        const BillboardLook look = billboard_look(input_, feature_);
        half_px_ = 0.5f * icon_px();
        const BillboardText name = with_name ? billboard_name(input_, feature_, look) : BillboardText(look.is_unsure ? "?" : "");
        const float side = find_side(name.view());
        if (std::isnan(side) || !claim(box(name.view(), side), place.place)) return false;
        if (input_.element.link) add_link(anchor, place, look);
        draw(name.view(), side, look);
        return true;
    }

private:
    [[nodiscard]] float icon_px() const {
        const float least = kLeastIcon * sheet_.text_px(), greatest = kGreatestIcon * sheet_.text_px();
        const design::DataElement& element = input_.element;
        if (const scene::Attribute* const size = input_.layer.find(element.size_attribute.view()); size != nullptr) {
            const double share =
                value_or_nan(input_.layer, element.size_attribute.view(), feature_) / static_cast<double>(size->entry->maximum);
            return share > 0 ? least + (greatest - least) * static_cast<float>(std::min(share, 1.0)) : least;
        }
        const double size_m = element.size_m > 0 ? element.size_m : kIconSize_m;
        return std::clamp(static_cast<float>(size_m * sheet_.view().focal_px / spot_.distance_m), least, greatest);
    }

    [[nodiscard]] bool is_obstacle() const { return input_.layer.entry->role == scene::LayerRole::obstacle; }

    /// Of so many texts.
    void set_stem(float stem) {
        stem_ = stem;
        middle_ = {spot_.at.x, stem > kOnTheSpot ? spot_.at.y - stem * sheet_.text_px() - half_px_ : spot_.at.y};
    }

    /// Box of the icon, with the stem where it is short, and with a name on the side: 1 right, -1 left, 0 without one.
    [[nodiscard]] Rect box(std::string_view name, float side) const {
        const float gap = kGap * sheet_.text_px(), half = half_px_ + gap;
        Rect result{middle_.x - half, middle_.y - half, 2 * half, stem_ == kStem ? spot_.at.y - middle_.y + half : 2 * half};
        if (side == 0) return result;
        const float width = text_width_px(name, kNameSize * sheet_.text_px()) + gap;
        result.width += width;
        if (side < 0) result.x -= width;
        return result;
    }

    /// NaN where there is no room.
    [[nodiscard]] float find_side(std::string_view name) {
        const base::Span<const float> stems = base::Span<const float>(kStems).subspan(0, is_obstacle() ? 1 : std::size(kStems));
        for (const float stem : stems)
            for (const float side : {1.0f, -1.0f})
                if (set_stem(stem); !name.empty() && sheet_.is_free(box(name, side))) return side;
        for (const float stem : stems)
            if (set_stem(stem); sheet_.is_free(box(name, 0))) return 0;
        if (!is_obstacle()) return std::numeric_limits<float>::quiet_NaN();
        set_stem(kOnTheSpot);
        return 0;
    }

    [[nodiscard]] bool claim(const Rect& room, const glm::dvec3& place) const {
        return stem_ == kOnTheSpot ? sheet_.claim_under_symbology(room, place) : sheet_.claim(room, place);
    }

    void add_link(const scene::ScenePoint& anchor, const Placed& place, const BillboardLook& look) const {
        const double ground_m = input_.ground.height_m(anchor.latitude_rad, anchor.longitude_rad);
        if (!(place.height_m - ground_m > kFloating_m)) return;
        const BillboardSheet::Spot foot = sheet_.spot(earth::to_ecef({anchor.latitude_rad, anchor.longitude_rad, {ground_m}}));
        sheet_.link(foot, spot_, look.color);
    }

    void draw(std::string_view name, float side, const BillboardLook& look) const {
        QuadBatch& batch = sheet_.signs();
        const float text_px = sheet_.text_px();
        if (stem_ > kOnTheSpot)
            sheet_.stem(spot_, {spot_.at.x, middle_.y + half_px_}, kStem_px,
                        {kStemColor.red, kStemColor.green, kStemColor.blue, look.color.alpha});
        static_cast<void>(draw_icon(batch, icon_of(input_.layer, feature_), middle_, half_px_, look.color));
        if (const float rim = look.rim(); rim > 0)
            static_cast<void>(draw_dashed_rim(batch, middle_, half_px_ + 0.5f * kGap * text_px, look.color, rim));
        if (side == 0) return;
        const Point at{middle_.x + side * (half_px_ + kGap * text_px), middle_.y};
        const TextStyle style{kNameSize * text_px, look.text, kHalo_px, {0, 0, 0, look.text.alpha}};
        static_cast<void>(batch.text(name, at, side > 0 ? TextAnchor::left : TextAnchor::right, style));
    }

    BillboardSheet& sheet_;
    const ElementInput& input_;
    std::uint32_t feature_;
    BillboardSheet::Spot spot_;
    Point middle_;
    float half_px_ = 0, stem_ = kStem;
};

}  // namespace

ElementCount add_billboards(BillboardSheet& sheet, const ElementInput& input) {
    offer_features(sheet, input);
    const base::Span<const BillboardCandidate> ranked = sheet.ranked();
    const auto named = static_cast<std::size_t>(std::ceil(input.element.detail * static_cast<double>(ranked.size())));
    ElementCount count;
    for (std::size_t n = 0; n < ranked.size(); ++n)
        if (Billboard(sheet, input, ranked[n].feature).add(n < named)) ++count.drawn;
    count.hidden = input.layer.entry->feature_count - count.drawn;
    return count;
}

}  // namespace tedavis::draw
