#include "render_core/draw/data/billboard_shape.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/draw/data/billboard_place.hpp"
#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/draw/data/obstacle_color.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/text_size.hpp"
#include "render_core/scene/area_limits.hpp"

namespace tedavis::draw {
namespace {

constexpr float kGap = 0.25f;  // of the text's size, round an icon
constexpr float kNameSize = 0.9f;

float icon_px(const ElementInput& input, std::uint32_t feature, const SignView& view, double distance_m) {
    const float least = kMinIcon * view.text_px, greatest = kGreatestIcon * view.text_px;
    const design::DataElement& element = input.element;
    if (const scene::Attribute* const size = input.layer.find(element.size_attribute.view()); size != nullptr) {
        const double share =
            scene::value_or_nan(input.layer, element.size_attribute.view(), feature) / static_cast<double>(size->entry->maximum);
        return share > 0 ? least + (greatest - least) * static_cast<float>(std::min(share, 1.0)) : least;
    }
    const double size_m = element.size_m > 0 ? element.size_m : kIconSize_m;
    return std::clamp(static_cast<float>(size_m * view.view.focal_px / distance_m), least, greatest);
}

/// Returns the opacity of a sign: a runway's sign fades out at the distance at which the runway itself is seen.
double sign_share(const ElementInput& input, double distance_m) {
    if (input.layer.entry->role != scene::LayerRole::runway) return 1;
    return std::clamp((distance_m - kRunwaySignFrom_m) / (kRunwaySignWhole_m - kRunwaySignFrom_m), 0.0, 1.0);
}

void fade_sign(design::Color& color, double share) { color.alpha = static_cast<std::uint8_t>(std::lround(color.alpha * share)); }

SignText text_of(const ElementInput& input, std::uint32_t feature, const BillboardLook& look, bool with_name) {
    SignText text;
    text.add(with_name ? billboard_name(input, feature, look) : BillboardText(look.is_unsure ? "?" : ""));
    if (with_name && has_limits(input.layer)) text.add(scene::limits_text(input.layer, feature, input.units));
    return text;
}

}  // namespace

void SignText::drop_first() {
    const SignText whole = *this;
    lines_.clear();
    for (std::size_t n = 1; n < whole.size(); ++n) add(whole.lines_[n]);
}

float SignText::width_px(float size_px) const {
    float widest = 0;
    for (const BillboardText& line : lines_) widest = std::max(widest, text_width_px(line.view(), size_px));
    return widest;
}

float BillboardShape::line_px() const { return std::max(kNameSize * text_px, kMinText_px); }

SignBox BillboardShape::on_the_spot() const {
    SignBox made = box;
    made.middle = spot.at;
    made.foot_px = 0;
    return made;
}

void BillboardShape::set_lines(const SignText& lines) {
    box.name_width_px = lines.width_px(line_px());
    box.name_height_px = line_px() * static_cast<float>(lines.size());
}

bool billboard_shape(const ElementInput& input, std::uint32_t feature, const SignView& view, bool with_name,
                     BillboardShape& shape) {
    if (!anchor_of(input, feature, shape.anchor)) return false;
    shape.place = place_of(input, feature, shape.anchor);
    if (!shape.place.is_known) return false;
    shape.spot = view.spot(shape.place.place);
    if (!shape.spot.is_ahead) return false;
    const double share = sign_share(input, shape.spot.distance_m);
    if (share <= 0) return false;
    shape.text_px = view.text_px;
    shape.look = billboard_look(input, feature);
    shape.look.color = obstacle_color(input, feature, shape.look.color);
    fade_sign(shape.look.color, share);
    fade_sign(shape.look.text, share);
    shape.text = text_of(input, feature, shape.look, with_name);
    const auto size = static_cast<float>(look_of_feature(input, feature).size);
    shape.box.half_px = 0.5f * size * icon_px(input, feature, view, shape.spot.distance_m);
    shape.box.gap_px = kGap * view.text_px;
    shape.set_lines(shape.text);
    shape.box.foot_px = kSignStem * view.text_px + shape.box.half_px;
    shape.box.middle = {shape.spot.at.x, shape.spot.at.y - shape.box.foot_px};
    return true;
}

}  // namespace tedavis::draw
