#include "host_sim/tracing/traced_data.hpp"

#include <algorithm>
#include <limits>

#include "host_sim/scene_builder/open_scene.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/scene/data_time.hpp"
#include "render_core/scene/grid_field.hpp"

namespace tedavis::host_sim {
namespace {

struct Quantity {
    const scene::Layer* layer = nullptr;
    const scene::Attribute* attribute = nullptr;
};

bool is_named(const std::string& wish, const scene::Layer& layer, const scene::Attribute& attribute) {
    const std::string name = layer.entry->name;
    return wish.empty() || wish == name || wish == name + "." + attribute.entry->name;
}

Quantity find_quantity(const scene::Scene& scene, const std::string& path, const std::string& wish) {
    std::string known;
    for (const scene::Layer& layer : scene.layers()) {
        if (layer.entry->shape != scene::LayerShape::grid) continue;
        for (const scene::Attribute& attribute : layer.attributes) {
            if (attribute.entry->scale != scene::AttributeScale::quantitative) continue;
            if (is_named(wish, layer, attribute)) return {&layer, &attribute};
            known += (known.empty() ? "" : ", ") + std::string(layer.entry->name) + "." + attribute.entry->name;
        }
    }
    if (known.empty())
        throw UserError(path + ": has no quantity on a grid, which ground could be colored by; name another scene");
    throw UserError(path + ": has no quantity '" + wish + "' on a grid; it has " + known);
}

}  // namespace

TracedData::TracedData(const TracedGround& ground, const std::string& scene_path, const std::string& name,
                       const std::optional<base::Time>& time)
    : palette_{
          {0.02f, 0.06f, 0.30f}, {0.03f, 0.30f, 0.42f}, {0.10f, 0.45f, 0.22f}, {0.62f, 0.55f, 0.07f}, {0.80f, 0.20f, 0.03f}} {
    const OpenScene open(scene_path);
    const Quantity quantity = find_quantity(open.scene(), scene_path, name);
    const scene::AttributeEntry& entry = *quantity.attribute->entry;
    name_ = std::string(quantity.layer->entry->name) + "." + entry.name;
    unit_ = entry.unit;
    lowest_ = entry.minimum;
    highest_ = entry.maximum > entry.minimum ? entry.maximum : entry.minimum + 1.0;
    columns_ = std::min(kMaxAcross, ground.columns());
    rows_ = std::min(kMaxAcross, ground.rows());
    step_x_ = (ground.columns() - 1.0) / (columns_ - 1.0);
    step_y_ = (ground.rows() - 1.0) / (rows_ - 1.0);
    const scene::GridField field(*quantity.layer, *quantity.attribute);
    const std::int64_t at_ns = time ? (*time - base::Time{0}).ns : scene::own_time_ns(*quantity.layer);
    const double level_m = quantity.layer->levels_m.empty() ? 0.0 : double{quantity.layer->levels_m[0]};
    std::size_t known = 0;
    for (std::uint32_t n = 0; n < columns_ * rows_; ++n) {
        const std::uint32_t column = n % columns_, row = n / columns_;
        const glm::dvec3 post(column * step_x_, row * step_y_, 0);
        const earth::Geodetic place = earth::from_ecef(ground.space().position(post));
        const scene::FieldValue value = field.at(place.latitude_rad, place.longitude_rad, level_m, at_ns);
        const bool is_known = value.state != scene::ValueState::missing;
        values_.push_back(is_known ? static_cast<float>(value.value) : std::numeric_limits<float>::quiet_NaN());
        uncertainties_.push_back(value.uncertainty.is_known() ? static_cast<float>(value.uncertainty.level())
                                                              : std::numeric_limits<float>::quiet_NaN());
        known += is_known ? 1 : 0;
    }
    share_ = static_cast<double>(known) / values_.size();
}

void TracedData::show(raytrace::TraceLook& look) const {
    look.values = {values_.data(), columns_, rows_, 0, 0, step_x_, step_y_};
    look.uncertainties = {uncertainties_.data(), columns_, rows_, 0, 0, step_x_, step_y_};
    look.legend = {palette_, static_cast<float>(lowest_), static_cast<float>(highest_), 0, 1, 0.75f};
}

}  // namespace tedavis::host_sim
