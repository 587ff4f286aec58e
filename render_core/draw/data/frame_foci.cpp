#include "render_core/draw/data/frame_foci.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/base/hash.hpp"
#include "render_core/design/grey_of.hpp"
#include "render_core/draw/data/layer_values.hpp"
#include "render_core/scene/data_time.hpp"

namespace tedavis::draw {

bool FrameFoci::is_any() const noexcept {
    for (const scene::FocusRegion& region : regions)
        if (region.is_valid) return true;
    return false;
}

FocusLook look_at(const FrameFoci& foci, double degree) noexcept {
    FocusLook look;
    if (degree >= 1 || !foci.changes_data()) return look;
    const design::FocusData& context = foci.look;
    if (degree <= 0 && context.context == design::FocusContextData::shown) return look;
    look.is_hidden = degree <= 0 && context.context == design::FocusContextData::hidden;
    const double share = std::fmax(degree - foci.least_degree, 0.0) / (1 - foci.least_degree);
    const auto between = [&](double least) { return least + (1 - least) * share; };
    look.detail = between(context.detail);
    look.brightness = between(context.brightness);
    look.saturation = between(context.saturation);
    look.size = between(context.size);
    look.aggregate = 1 + (context.aggregate - 1) * (1 - share);
    return look;
}

design::Color shown_color(const FocusLook& look, design::Color color) noexcept {
    const std::uint8_t alpha = color.alpha;
    if (look.saturation < 1) color = design::blended(color, design::grey_of(color), 1 - look.saturation);
    if (look.brightness < 1) color = design::blended(color, design::Color{0, 0, 0}, 1 - look.brightness);
    color.alpha = alpha;
    return color;
}

std::uint64_t key_of(const FrameFoci& foci, std::int64_t time_ns, bool has_date) noexcept {
    base::Fnv1a64 key;
    const auto add = [&](const auto& value) { key.add(&value, sizeof(value)); };
    bool has_values = false;
    for (std::size_t n = 0; n < foci.regions.size(); ++n) {
        const scene::FocusRegion& region = foci.regions[n];
        has_values = has_values || (*foci.foci)[n].shape == design::FocusShape::data;
        add(region.is_valid);
        if (!region.is_valid) continue;
        add(region.kind), add(region.is_square), add(region.context.distance), add(region.context.width_m);
        add(region.context.levels), add(region.radius_m), add(region.point_count), add(region.anchor), add(region.lower_m);
        add(region.upper_m), add(region.is_ball), add(region.is_volume);
        key.add(region.points.data(), region.point_count * sizeof(region.points[0]));
        add(foci.ranges[n].low), add(foci.ranges[n].high), add(foci.ranges[n].similar);
    }
    add(foci.look.detail), add(foci.look.brightness), add(foci.look.saturation), add(foci.look.size), add(foci.look.context);
    if (has_values && has_date) add(scene::start_of_data_step(time_ns));
    return std::max<std::uint64_t>(key.value(), 1);
}

bool is_meant(const design::FocusOfData& data, const scene::Layer& layer) noexcept {
    const bool is_named = data.layer.empty() ? layer.entry->role == data.role : data.layer.view() == layer.entry->name;
    return is_named && LayerValues::has(layer, data.attribute.view());
}

}  // namespace tedavis::draw
