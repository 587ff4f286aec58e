#include "render_core/draw/data/diagrams.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render_core/draw/data/billboard_look.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr double kFarthest_m = 60'000;
constexpr float kStem = BillboardSheet::kStem, kMargin = 0.3f, kNameSize = 0.75f;  // of the text's size
constexpr float kLine_px = 1.6f;
constexpr design::Color kPlate{16, 20, 28, 170}, kAxis{200, 200, 200};
/// Plate, frame, axis; a line, a reach and a cross or a knot each sample; a name with its halo: four each.
constexpr std::size_t kMaxDiagramVertices = 4 * (1 + 4 + 2 + 5 * kMaxProfileSamples + 2 * 31);
constexpr std::size_t kMaxDiagramLinkVertices = BillboardSheet::kStemVertices + BillboardSheet::kLinkVertices;

design::Color with_alpha(design::Color color, std::uint8_t alpha) {
    color.alpha = static_cast<std::uint8_t>(color.alpha * alpha / 255);
    return color;
}

bool is_quantity(const scene::Attribute& attribute) {
    return attribute.entry->scale == scene::AttributeScale::quantitative && attribute.entry->of == scene::AttributeOf::feature;
}

bool is_missing(const scene::Attribute& attribute, std::uint32_t feature) {
    return feature >= attribute.values.size() || attribute.state(feature) == scene::ValueState::missing;
}

/// 0..1 between the least and the largest of the layer; 0.5 where they are one.
float share_of(const scene::Attribute& attribute, std::uint32_t feature) {
    const float least = attribute.entry->minimum, range = attribute.entry->maximum - least;
    return range > 0 ? std::clamp((attribute.values[feature] - least) / range, 0.0f, 1.0f) : 0.5f;
}

bool is_same_place(const scene::ScenePoint& a, const scene::ScenePoint& b) {
    return a.latitude_rad == b.latitude_rad && a.longitude_rad == b.longitude_rad;
}

/// Number of points that follow each other at one place.
std::uint32_t run_at(const scene::Layer& layer, std::uint32_t first) {
    std::uint32_t count = 1;
    while (first + count < layer.points.size() && is_same_place(layer.points[first], layer.points[first + count])) ++count;
    return count;
}

class Diagram {
public:
    Diagram(BillboardSheet& sheet, const ElementInput& input, std::uint32_t first)
        : sheet_(sheet),
          input_(input),
          first_(first),
          count_(std::min<std::uint32_t>(run_at(input.layer, first), kMaxProfileSamples)),
          knots_(share_of_detail(count_)) {}

    /// Whether its points have fewer knots than they are.
    [[nodiscard]] bool is_aggregate() const { return knots_ < count_; }

    /// Points that it shows: none where it has no room.
    [[nodiscard]] std::uint32_t add() {
        const Placed place = placed(input_, input_.layer.points[lowest()]);
        if (!place.is_known) return 0;
        const BillboardSheet::Spot spot = sheet_.spot(place.place);
        if (!spot.is_ahead || !sheet_.has_room(kMaxDiagramVertices, kMaxDiagramLinkVertices)) return 0;
        const float text = sheet_.text_px(), width = kDiagramWidth * text, height = (kDiagramHeight + 1) * text;
        plate_ = {spot.at.x - width / 2, spot.at.y - kStem * text - height, width, height};
        if (!sheet_.claim({plate_.x, plate_.y, width, height + kStem * text}, place.place)) return 0;
        look_ = billboard_look(input_, first_);
        if (input_.element.link) add_link(place, spot);
        sheet_.stem(spot, {spot.at.x, plate_.bottom()}, kLine_px, look_.color);
        draw_plate();
        if (count_ > 1)
            draw_profile();
        else
            draw_bars();
        return count_;
    }

private:
    /// At least one.
    [[nodiscard]] std::uint32_t share_of_detail(std::size_t count) const {
        const double share = std::ceil(input_.element.detail * static_cast<double>(count));
        return std::max(1u, static_cast<std::uint32_t>(share));
    }
    [[nodiscard]] QuadBatch& batch() const { return sheet_.signs(); }

    [[nodiscard]] std::uint32_t lowest() const {
        std::uint32_t lowest = first_;
        for (std::uint32_t n = first_; n < first_ + count_; ++n)
            if (input_.layer.points[n].height_m < input_.layer.points[lowest].height_m) lowest = n;
        return lowest;
    }

    void add_link(const Placed& place, const BillboardSheet::Spot& spot) const {
        const scene::ScenePoint& point = input_.layer.points[first_];
        const double ground_m = input_.ground.height_m(point.latitude_rad, point.longitude_rad);
        if (!(place.height_m - ground_m > kFloating_m)) return;
        sheet_.link(sheet_.spot(earth::to_ecef({point.latitude_rad, point.longitude_rad, {ground_m}})), spot, look_.color);
    }

    void draw_plate() {
        const float text = sheet_.text_px();
        const std::uint8_t alpha = look_.color.alpha;
        static_cast<void>(batch().box(plate_, with_alpha(kPlate, alpha)));
        static_cast<void>(batch().frame(plate_, 1, with_alpha(kAxis, alpha)));
        BillboardText name = billboard_name(input_, first_, look_);
        if (name.empty()) name.append(input_.layer.entry->title);
        // Names that are wider than their plate would cover the neighbours.
        const float wide = text_width_px(name.view(), kNameSize * text), room = plate_.width - kMargin * text;
        const float size = kNameSize * text * std::min(1.0f, wide > 0 ? room / wide : 1.0f);
        static_cast<void>(batch().text(name.view(), {plate_.center().x, plate_.y + 0.5f * text}, TextAnchor::center,
                                       {size, look_.text, 1, {0, 0, 0, alpha}}));
        inner_ = {plate_.x + kMargin * text, plate_.y + text, plate_.width - 2 * kMargin * text,
                  plate_.height - (1 + kMargin) * text};
        const Point corner{inner_.x, inner_.bottom()};
        static_cast<void>(batch().line(corner, {inner_.right(), corner.y}, 1, with_alpha(kAxis, alpha)));
        static_cast<void>(batch().line(corner, {corner.x, inner_.y}, 1, with_alpha(kAxis, alpha)));
    }

    void draw_cross(Point at) {
        const float arm = 0.2f * sheet_.text_px();
        const design::Color color = with_alpha(input_.missing, look_.color.alpha);
        static_cast<void>(batch().line({at.x - arm, at.y - arm}, {at.x + arm, at.y + arm}, kLine_px, color));
        static_cast<void>(batch().line({at.x - arm, at.y + arm}, {at.x + arm, at.y - arm}, kLine_px, color));
    }

    void draw_bars() {
        std::size_t count = 0;
        for (const scene::Attribute& attribute : input_.layer.attributes) count += is_quantity(attribute) ? 1 : 0;
        if (count == 0) return draw_cross(inner_.center());
        count = share_of_detail(std::min(count, kMaxDiagramBars));
        const float step = inner_.width / static_cast<float>(count);
        float x = inner_.x + 0.2f * step;
        for (const scene::Attribute& attribute : input_.layer.attributes) {
            if (!is_quantity(attribute) || count == 0) continue;
            --count;
            if (is_missing(attribute, first_))
                draw_cross({x + 0.3f * step, inner_.bottom() - 0.3f * sheet_.text_px()});
            else
                draw_bar(x, 0.6f * step, share_of(attribute, first_));
            x += step;
        }
    }

    void draw_bar(float x, float width, float share) {
        const float height = inner_.height * (kMinBar + (1 - kMinBar) * share);
        static_cast<void>(batch().box({x, inner_.bottom() - height, width, height}, look_.color));
    }

    /// What a profile's height reaches from and to.
    struct Heights {
        float low, high;
    };
    [[nodiscard]] Heights heights() const {
        Heights reach{input_.layer.points[first_].height_m, input_.layer.points[first_].height_m};
        for (std::uint32_t n = first_; n < first_ + count_; ++n) {
            reach.low = std::fmin(reach.low, input_.layer.points[n].height_m);
            reach.high = std::fmax(reach.high, input_.layer.points[n].height_m);
        }
        return reach;
    }

    /// Neighbours of a profile that have one knot: shares of the diagram.
    struct Knot {
        float up = 0, mean = 0, least = 1, most = 0;
        std::uint32_t unsure = 0, values = 0, missing = 0;  ///< the least sure one; how many
    };
    [[nodiscard]] Knot knot(const scene::Attribute& attribute, const Heights& reach, std::uint32_t n) const {
        Knot knot;
        const std::uint32_t begin = first_ + n * count_ / knots_, end = first_ + (n + 1) * count_ / knots_;
        knot.unsure = begin;
        for (std::uint32_t k = begin; k < end; ++k) {
            if (encoded_uncertainty(input_, k).code() > encoded_uncertainty(input_, knot.unsure).code()) knot.unsure = k;
            const float height = input_.layer.points[k].height_m;
            const bool has_height = reach.high > reach.low && !std::isnan(height);
            knot.up += (has_height ? (height - reach.low) / (reach.high - reach.low) : 0) / static_cast<float>(end - begin);
            if (is_missing(attribute, k)) {
                ++knot.missing;
                continue;
            }
            const float share = share_of(attribute, k);
            knot.mean += (share - knot.mean) / static_cast<float>(++knot.values);
            knot.least = std::min(knot.least, share);
            knot.most = std::max(knot.most, share);
        }
        return knot;
    }
    [[nodiscard]] Point at(const Knot& knot, float right) const {
        return {inner_.x + right * inner_.width, inner_.bottom() - knot.up * inner_.height};
    }

    /// A line from knot to knot; none to and from missing ones.
    void draw_profile() {
        const scene::Attribute* const attribute = profile_attribute(input_.element, input_.layer);
        if (attribute == nullptr) return draw_cross(inner_.center());
        const Heights reach = heights();
        Knot before;
        for (std::uint32_t n = 0; n < knots_; ++n) {
            const Knot here = knot(*attribute, reach, n);
            draw_knot(here);
            const BillboardLook look = billboard_look(input_, here.unsure);
            if (before.values > 0 && here.values > 0)
                static_cast<void>(batch().line(at(before, before.mean), at(here, here.mean), kLine_px, look.color));
            before = here;
        }
    }

    void draw_knot(const Knot& knot) {
        if (knot.missing > 0) draw_cross(at(knot, knot.values > 0 ? 0 : 0.5f));
        if (knot.values == 0) return;
        const BillboardLook look = billboard_look(input_, knot.unsure);
        const Point middle = at(knot, knot.mean);
        const float half = 0.14f * sheet_.text_px();
        static_cast<void>(batch().box({middle.x - half, middle.y - half, 2 * half, 2 * half}, look.color));
        if (knot.values > 1) static_cast<void>(batch().line(at(knot, knot.least), at(knot, knot.most), kLine_px, look.color));
    }

    BillboardSheet& sheet_;
    const ElementInput& input_;
    std::uint32_t first_, count_, knots_;
    Rect plate_, inner_;
    BillboardLook look_;
};

}  // namespace

const scene::Attribute* profile_attribute(const design::DataElement& element, const scene::Layer& layer) {
    if (element.by_color.is_used()) return layer.find(element.by_color.attribute.view());
    if (!element.size_attribute.view().empty()) return layer.find(element.size_attribute.view());
    for (const scene::Attribute& attribute : layer.attributes)
        if (is_quantity(attribute)) return &attribute;
    return nullptr;
}

bool has_profiles(const scene::Layer& layer) {
    for (std::uint32_t n = 1; n < layer.points.size(); ++n)
        if (is_same_place(layer.points[n - 1], layer.points[n])) return true;
    return false;
}

ElementCount add_diagrams(BillboardSheet& sheet, const ElementInput& input) {
    const auto all = static_cast<std::uint32_t>(input.layer.points.size());
    sheet.begin_candidates();
    for (std::uint32_t first = 0; first < all; first += run_at(input.layer, first)) {
        const scene::ScenePoint& point = input.layer.points[first];
        const double distance_m = sheet.seen_distance_m(
            glm::distance(earth::to_ecef({point.latitude_rad, point.longitude_rad, {0}}), sheet.view().eye));
        if (distance_m <= kFarthest_m) sheet.offer({distance_m, first});
    }
    ElementCount count;
    for (const BillboardCandidate& candidate : sheet.ranked()) {
        Diagram diagram(sheet, input, candidate.feature);
        (diagram.is_aggregate() ? count.aggregated : count.drawn) += diagram.add();
    }
    count.hidden = all - count.drawn - count.aggregated;
    return count;
}

}  // namespace tedavis::draw
