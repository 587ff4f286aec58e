#include "render_core/draw/data/billboards.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>

#include "render_core/base/units.hpp"
#include "render_core/draw/data/area_limits.hpp"
#include "render_core/draw/data/billboard_look.hpp"
#include "render_core/draw/data/icons.hpp"
#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr double kBehind_m = 10'000;  // of the eye: what the ground's height may bring forward again
/// Stems are longer where a line of the symbology, the horizon above all, leaves no room; but not those of obstacles, of which
/// each is as high as it looks.
constexpr float kStem = BillboardSheet::kStem, kOnTheSpot = 0;
constexpr float kStems[] = {kStem, kStem + 1.25f, kStem + 2.5f, kStem + 3.75f, kStem + 5, kStem + 6.25f, kStem + 7.5f};
constexpr float kGap = 0.25f;  // of the text's size, round an icon
constexpr float kNameSize = 0.9f;
constexpr float kHalo_px = 1.5f;
constexpr double kMostOfAll = 1e9;
/// Of stems, which lead to a sign and are nothing that stands there; links have the element's colour.
constexpr float kStem_px = 1;
constexpr design::Color kStemColor{170, 170, 175};
/// Rim and strokes of an icon, dashes, name with halo: four each.
constexpr std::size_t kMostVertices = 4 * (2 * (6 + 10) + 16 + 2 * 31);
constexpr std::size_t kMostLineVertices = 4 * 2 * 31;  // of another line
constexpr std::size_t kMostLinkVertices = BillboardSheet::kStemVertices + BillboardSheet::kLinkVertices;

/// Of a name, beside its icon.
enum class Side : std::uint8_t { none, right, left, above };
constexpr Side kSides[] = {Side::right, Side::left, Side::above};

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
        if (is_near && !look_of_feature(input, feature).is_hidden)
            sheet.offer({distance_m / precedence_of(input.layer, feature), feature});
    }
}

/// Airspaces stand there with what they reach from and to, as on charts.
bool has_limits(const scene::Layer& layer) {
    return layer.entry->role == scene::LayerRole::no_go || layer.entry->role == scene::LayerRole::airspace;
}

/// At the top where it has limits: there it is seen from afar.
Placed place_of(const ElementInput& input, std::uint32_t feature, const scene::ScenePoint& anchor) {
    if (!has_limits(input.layer)) return placed(input, anchor);
    const HeightLimit ceiling = area_limits(input.layer, feature).ceiling;
    if (ceiling.datum == scene::HeightDatum::ground && std::isfinite(ceiling.m))
        return placed_over_ground(input, anchor.latitude_rad, anchor.longitude_rad, ceiling.m);
    return placed(input, anchor.latitude_rad, anchor.longitude_rad, ceiling.m);
}

/// Lines beside the icon: its name, and under it what it reaches from and to.
class Label {
public:
    void add(const BillboardText& line) {
        if (!line.empty()) static_cast<void>(lines_.try_push_back(line));
    }
    void drop_first() {
        const Label whole = *this;
        lines_.clear();
        for (std::size_t n = 1; n < whole.size(); ++n) add(whole.lines_[n]);
    }
    [[nodiscard]] bool empty() const { return lines_.empty(); }
    [[nodiscard]] std::size_t size() const { return lines_.size(); }
    [[nodiscard]] std::string_view line(std::size_t n) const { return lines_[n].view(); }
    [[nodiscard]] float width_px(float size_px) const {
        float widest = 0;
        for (const BillboardText& line : lines_) widest = std::max(widest, text_width_px(line.view(), size_px));
        return widest;
    }

private:
    base::FixedVector<BillboardText, 2> lines_;
};

class Billboard {
public:
    Billboard(BillboardSheet& sheet, const ElementInput& input, std::uint32_t feature)
        : sheet_(sheet), input_(input), feature_(feature) {}

    bool add(bool with_name) {
        scene::ScenePoint anchor;
        if (!anchor_of(input_, feature_, anchor)) return false;
        const Placed place = place_of(input_, feature_, anchor);
        if (!place.is_known) return false;
        spot_ = sheet_.spot(place.place);
        if (!spot_.is_ahead || !sheet_.has_room(kMostVertices + kMostLineVertices, kMostLinkVertices)) return false;
        const BillboardLook look = billboard_look(input_, feature_);
        half_px_ = 0.5f * icon_px() * static_cast<float>(look_of_feature(input_, feature_).size);
        Label label = label_of(with_name, look);
        Side side = Side::none;
        if (!find_side(label, side) || !claim(box(label, side), place.place)) return false;
        if (input_.element.link) add_link(anchor, place, look);
        draw(label, side, look);
        return true;
    }

private:
    [[nodiscard]] Label label_of(bool with_name, const BillboardLook& look) const {
        Label label;
        label.add(with_name ? billboard_name(input_, feature_, look) : BillboardText(look.is_unsure ? "?" : ""));
        if (with_name && has_limits(input_.layer)) label.add(limits_text(input_.layer, feature_));
        return label;
    }

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

    [[nodiscard]] float line_px() const { return kNameSize * sheet_.text_px(); }

    /// Box of the icon, with the stem where it is short, and with the label on a side.
    [[nodiscard]] Rect box(const Label& label, Side side) const {
        const float gap = kGap * sheet_.text_px(), half = half_px_ + gap;
        Rect result{middle_.x - half, middle_.y - half, 2 * half, stem_ == kStem ? spot_.at.y - middle_.y + half : 2 * half};
        if (side == Side::none) return result;
        const float width = label.width_px(line_px()) + gap, height = line_px() * static_cast<float>(label.size());
        if (side == Side::above) {
            result.y -= height;
            result.height += height;
            result.x = std::min(result.x, middle_.x - 0.5f * (width + gap));
            result.width = std::max(result.width, width + gap);
            return result;
        }
        const float more = std::max(0.5f * height - half, 0.0f);
        result.y -= more;
        result.height = std::max(result.height + more, height);
        result.width += width;
        if (side == Side::left) result.x -= width;
        return result;
    }

    /// True where the whole label has room.
    [[nodiscard]] bool find_side_of(const Label& label, base::Span<const float> stems, Side& found) {
        for (const float stem : stems)
            for (const Side side : kSides)
                if (set_stem(stem); sheet_.is_free(box(label, side))) return found = side, true;
        return false;
    }

    /// False where there is no room, not even without the label, which keeps what of it has room: of an airspace its limits.
    [[nodiscard]] bool find_side(Label& label, Side& found) {
        const base::Span<const float> stems = base::Span<const float>(kStems).subspan(0, is_obstacle() ? 1 : std::size(kStems));
        for (; !label.empty(); label.drop_first())
            if (find_side_of(label, stems, found)) return true;
        found = Side::none;
        for (const float stem : stems)
            if (set_stem(stem); sheet_.is_free(box(label, Side::none))) return true;
        set_stem(kOnTheSpot);
        return is_obstacle();
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

    /// Where a line of the label is anchored.
    [[nodiscard]] Point line_spot(const Label& label, std::size_t n, Side side) const {
        const float beside = half_px_ + kGap * sheet_.text_px(), from_top = (static_cast<float>(n) + 0.5f) * line_px(),
                    height = line_px() * static_cast<float>(label.size());
        if (side == Side::above) return {middle_.x, middle_.y - beside - height + from_top};
        return {middle_.x + (side == Side::right ? beside : -beside), middle_.y - 0.5f * height + from_top};
    }
    [[nodiscard]] static TextAnchor line_anchor(Side side) {
        return side == Side::right ? TextAnchor::left : side == Side::left ? TextAnchor::right : TextAnchor::center;
    }

    void draw(const Label& label, Side side, const BillboardLook& look) const {
        QuadBatch& batch = sheet_.signs();
        const float text_px = sheet_.text_px();
        if (stem_ > kOnTheSpot)
            sheet_.stem(spot_, {spot_.at.x, middle_.y + half_px_}, kStem_px,
                        {kStemColor.red, kStemColor.green, kStemColor.blue, look.color.alpha});
        static_cast<void>(draw_icon(batch, icon_of(input_.layer, feature_), middle_, half_px_, look.color));
        if (const float rim = look.rim(); rim > 0)
            static_cast<void>(draw_dashed_rim(batch, middle_, half_px_ + 0.5f * kGap * text_px, look.color, rim));
        if (side == Side::none) return;
        const TextStyle style{line_px(), look.text, kHalo_px, {0, 0, 0, look.text.alpha}};
        for (std::size_t n = 0; n < label.size(); ++n)
            static_cast<void>(batch.text(label.line(n), line_spot(label, n, side), line_anchor(side), style));
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
    const double detail = input.element.detail;
    const auto named = static_cast<std::size_t>(std::ceil(detail * static_cast<double>(ranked.size())));
    const bool are_places = input.layer.entry->role == scene::LayerRole::place;
    const std::size_t shown = are_places ? named : ranked.size();
    const double most = are_places && detail < 1 ? std::ceil(kMostPlaces * detail) : kMostOfAll;
    ElementCount count;
    for (std::size_t n = 0; n < shown && count.drawn < most; ++n)
        if (Billboard(sheet, input, ranked[n].feature).add(n < named && look_of_feature(input, ranked[n].feature).detail >= 1))
            ++count.drawn;
    count.hidden = input.layer.entry->feature_count - count.drawn;
    return count;
}

}  // namespace tedavis::draw
