#include "render_core/draw/data/billboards.hpp"

#include "render_core/draw/data/billboard_place.hpp"
#include "render_core/draw/data/icons.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/earth/wgs84.hpp"
#include "render_core/scene/obstacle_stand.hpp"

namespace tedavis::draw {
namespace {

constexpr float kHalo_px = 1.5f;
/// Of stems, which lead to a sign and are nothing that stands there; links have the element's colour.
constexpr float kStem_px = 1;
constexpr design::Color kStemColor{170, 170, 175};
/// Rim and strokes of an icon, dashes, name with halo: four each.
constexpr std::size_t kMaxSignVertices = 4 * (2 * (6 + 10) + 16 + 2 * 31);
constexpr std::size_t kMaxLineVertices = 4 * 2 * 31;  // of another line
constexpr std::size_t kMaxStandVertices = BillboardSheet::kStemVertices + BillboardSheet::kLinkVertices;

class Billboard {
public:
    Billboard(BillboardSheet& sheet, const ElementInput& input, std::uint32_t feature, const BillboardShape& shape)
        : sheet_(sheet), input_(input), feature_(feature), shape_(shape) {}

    BillboardAnswer add(const BillboardWish& wish) {
        if (!sheet_.has_room(kMaxSignVertices + kMaxLineVertices, kMaxStandVertices)) return {};
        BillboardAnswer answer;
        SignText text = shape_.text;
        answer.fate = BillboardFate::no_room;
        if (!find_room(text, wish, answer)) return answer;
        answer.room = box(answer).with(answer.side);
        if (!claim(answer)) {
            if (!is_on_the_spot(answer)) answer.fate = BillboardFate::hidden;
            return answer;
        }
        answer.fate = BillboardFate::stands;
        if (input_.element.link) add_link();
        draw(text, answer);
        return answer;
    }

private:
    /// Stems are longer where a line of the symbology, the horizon above all, leaves no room; but not those of obstacles, of
    /// which each is as high as it looks.
    [[nodiscard]] std::uint8_t stems() const { return sign_stems(input_.layer); }
    [[nodiscard]] bool is_obstacle() const { return stems() == 1; }
    [[nodiscard]] static bool is_on_the_spot(const BillboardAnswer& answer) { return answer.stem == kSignStems; }
    [[nodiscard]] SignBox box(const BillboardAnswer& answer) const {
        return is_on_the_spot(answer) ? shape_.on_the_spot() : shape_.box.raised(answer.stem, shape_.text_px);
    }

    [[nodiscard]] bool has_room(SignSide side, std::uint8_t stem, BillboardAnswer& answer) const {
        answer.side = side;
        answer.stem = stem;
        return sheet_.is_free(box(answer).with(side));
    }
    [[nodiscard]] bool has_room(const BillboardWish& wish, SignSide side, std::uint8_t stem, BillboardAnswer& answer) const {
        if (!has_room(side, stem, answer)) return false;
        return wish.kept_clear == nullptr || wish.kept_clear->is_free(box(answer).with(side), wish.own);
    }

    /// True where the whole text has room: first where it is wished for.
    [[nodiscard]] bool find_side(const BillboardWish& wish, BillboardAnswer& answer) const {
        if (wish.side != SignSide::none && wish.stem < stems() && has_room(wish, wish.side, wish.stem, answer)) return true;
        for (std::uint8_t stem = 0; stem < stems(); ++stem)
            for (const SignSide side : kNameSides)
                if (has_room(wish, side, stem, answer)) return true;
        return false;
    }

    /// False where there is no room, not even without the text, which keeps what of it has room: of an airspace its limits.
    [[nodiscard]] bool find_room(SignText& text, const BillboardWish& wish, BillboardAnswer& answer) {
        for (; !text.empty(); text.drop_first()) {
            shape_.set_lines(text);
            if (find_side(wish, answer)) return true;
        }
        for (std::uint8_t stem = 0; stem < stems(); ++stem)
            if (has_room(SignSide::none, stem, answer)) return true;
        answer.stem = kSignStems;
        return is_obstacle();
    }

    [[nodiscard]] bool claim(const BillboardAnswer& answer) const {
        const glm::dvec3& place = shape_.place.place;
        return is_on_the_spot(answer) ? sheet_.claim_under_symbology(answer.room, place) : sheet_.claim(answer.room, place);
    }

    void add_link() const {
        const scene::ScenePoint& anchor = shape_.anchor;
        const double ground_m = input_.ground.height_m(anchor.latitude_rad, anchor.longitude_rad);
        if (!(shape_.place.height_m - ground_m > kFloating_m)) return;
        const SignSpot foot = sheet_.spot(earth::to_ecef({anchor.latitude_rad, anchor.longitude_rad, {ground_m}}));
        sheet_.link(foot, shape_.spot, shape_.look.color);
    }

    /// Where a line of the text is anchored.
    [[nodiscard]] Point line_spot(std::size_t n, SignSide side, const SignBox& box) const {
        const float beside = box.half_px + box.gap_px, from_top = (static_cast<float>(n) + 0.5f) * shape_.line_px();
        if (side == SignSide::above) return {box.middle.x, box.middle.y - beside - box.name_height_px + from_top};
        return {box.middle.x + (side == SignSide::right ? beside : -beside), box.middle.y - 0.5f * box.name_height_px + from_top};
    }
    [[nodiscard]] static TextAnchor line_anchor(SignSide side) {
        return side == SignSide::right ? TextAnchor::left : side == SignSide::left ? TextAnchor::right : TextAnchor::center;
    }

    [[nodiscard]] Icon icon() const {
        const scene::Layer& layer = input_.layer;
        const Icon icon = icon_of(layer, feature_);
        if (!is_obstacle() || layer.entry->shape != scene::LayerShape::points) return icon;
        const double height_m = scene::value_or_nan(layer, "height", feature_);
        return icon_by_height(
            icon, scene::obstacle_stand(layer, shape_.anchor, height_m, scene::kUnknownObstacle_m, input_.ground).height_m());
    }

    void draw(const SignText& text, const BillboardAnswer& answer) const {
        QuadBatch& batch = sheet_.signs();
        const SignBox box = this->box(answer);
        const BillboardLook& look = shape_.look;
        if (!is_on_the_spot(answer))
            sheet_.stem(shape_.spot, {shape_.spot.at.x, box.middle.y + box.half_px}, kStem_px,
                        {kStemColor.red, kStemColor.green, kStemColor.blue, look.color.alpha});
        static_cast<void>(draw_icon(batch, icon(), box.middle, box.half_px, look.color));
        if (const float rim = look.rim(); rim > 0)
            static_cast<void>(draw_dashed_rim(batch, box.middle, box.half_px + 0.5f * box.gap_px, look.color, rim));
        if (answer.side == SignSide::none) return;
        const TextStyle style{shape_.line_px(), look.text, kHalo_px, {0, 0, 0, look.text.alpha}};
        for (std::size_t n = 0; n < text.size(); ++n)
            static_cast<void>(batch.text(text.line(n), line_spot(n, answer.side, box), line_anchor(answer.side), style));
    }

    BillboardSheet& sheet_;
    const ElementInput& input_;
    std::uint32_t feature_;
    BillboardShape shape_;
};

}  // namespace

BillboardAnswer add_billboard(BillboardSheet& sheet, const ElementInput& input, std::uint32_t feature,
                              const BillboardShape& shape, const BillboardWish& wish) {
    return Billboard(sheet, input, feature, shape).add(wish);
}

}  // namespace tedavis::draw
