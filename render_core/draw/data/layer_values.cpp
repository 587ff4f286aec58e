#include "render_core/draw/data/layer_values.hpp"

#include "render_core/earth/geodetic.hpp"
#include "render_core/scene/grid_field.hpp"

namespace tedavis::draw {
namespace {

bool makes_speed(const scene::Layer& layer, std::string_view attribute) {
    return attribute == "speed" && layer.entry->role == scene::LayerRole::wind && layer.find("east") != nullptr &&
           layer.find("north") != nullptr;
}

}  // namespace

bool LayerValues::has(const scene::Layer& layer, std::string_view attribute) noexcept {
    return layer.find(attribute) != nullptr || makes_speed(layer, attribute);
}

LayerValues::LayerValues(const scene::Layer& layer, std::string_view attribute, std::int64_t time_ns) : layer_(&layer) {
    const scene::Attribute* value = layer.find(attribute);
    const scene::Attribute* north = nullptr;
    if (value == nullptr && makes_speed(layer, attribute)) {
        value = layer.find("east");
        north = layer.find("north");
    }
    if (value == nullptr) return;
    is_of_points_ = value->entry->of == scene::AttributeOf::point;
    is_grid_ = layer.entry->shape == scene::LayerShape::grid;
    std::size_t first = 0, second = 0;
    size_ = value->values.size();
    if (is_grid_) {
        const scene::GridShape& grid = layer.entry->grid;
        size_ = std::size_t{grid.columns} * grid.rows * grid.levels;
        const scene::AxisPlace time = scene::GridField(layer, *value).time_at(time_ns);
        const bool is_linear = value->entry->scale == scene::AttributeScale::quantitative;
        const bool is_between = is_linear && time.fraction > 0 && time.fraction < 1;
        first = (is_between || time.fraction < 0.5 ? time.first : time.second) * size_;
        second = time.second * size_;
        fraction_ = is_between ? time.fraction : 0;
    }
    const auto times = [&](const scene::Attribute& of) { return Times{of.values.data() + first, of.values.data() + second}; };
    value_ = times(*value);
    if (north != nullptr) north_ = times(*north);
}

scene::Run LayerValues::points_of(std::size_t n) const {
    const auto number = static_cast<std::uint32_t>(n);
    const bool is_run = layer_->entry->shape == scene::LayerShape::lines || layer_->entry->shape == scene::LayerShape::areas;
    if (is_grid_) return {};
    return is_run && !is_of_points_ ? layer_->points_of(number) : scene::Run{number, 1};
}

LayerValues::Place LayerValues::post(std::size_t n) const {
    const scene::GridShape& grid = layer_->entry->grid;
    const std::size_t post = n % (std::size_t{grid.columns} * grid.rows), row = post / grid.columns;
    return {grid.north_rad - static_cast<double>(row) * grid.step_lat_rad,
            earth::wrap_longitude(grid.west_rad + static_cast<double>(post % grid.columns) * grid.step_lon_rad)};
}

}  // namespace tedavis::draw
