#include "render_core/display/planner/adjacent_data.hpp"

#include "render_core/scene/data_time.hpp"

namespace tedavis::display {
namespace {

constexpr design::Color kMapGround{0, 0, 0};

const scene::Layer* find_layer(const scene::Scene& scene, const design::AdjacentView& view) {
    if (!view.layer.empty()) return scene.find(view.layer.view());
    for (const scene::Layer& layer : scene.layers())
        if (layer.entry->role == view.role && layer.entry->shape == scene::LayerShape::grid) return &layer;
    return nullptr;
}

GroundDataState find_field(const SpatialData& data, const design::AdjacentView& view, draw::AdjacentInput& maps) {
    if (!view.is_shown) return GroundDataState::not_asked_for;
    if (!data.has_scene()) return GroundDataState::no_scene;
    const scene::Layer* const layer = find_layer(data.scene(), view);
    if (layer == nullptr) return GroundDataState::no_such_layer;
    if (layer->entry->shape != scene::LayerShape::grid) return GroundDataState::too_large;
    maps.attribute = layer->find(view.attribute.view());
    if (maps.attribute == nullptr) return GroundDataState::no_such_attribute;
    if (view.shows == design::AdjacentShows::members && maps.attribute->member_count() == 0) return GroundDataState::no_members;
    maps.layer = layer;
    return GroundDataState::shown;
}

/// Mixes colours as adjacent_maps.cpp draws cells: `under` on or through `color`.
void add_sign(std::string_view text, draw::SampleLook look, design::Color color, design::Color under, draw::DataLegend& legend) {
    draw::LegendSample sample;
    sample.text.append(text);
    sample.color = color;
    sample.under = under;
    sample.look = look;
    static_cast<void>(legend.signs.try_push_back(sample));
}

}  // namespace

AdjacentData plan_adjacent_data(const SpatialData& data, const design::AdjacentView& view, const earth::Geodetic& place,
                                const flight::FlightTime& time, design::Color sign) noexcept {
    AdjacentData planned;
    draw::AdjacentInput maps;
    planned.state = find_field(data, view, maps);
    if (planned.state != GroundDataState::shown) return planned;
    maps.time_ns = time.is_date ? scene::start_of_data_step(time.utc.ns) : scene::own_time_ns(*maps.layer);
    if (!is_valid_at(*maps.layer, maps.time_ns)) {
        planned.state = GroundDataState::out_of_date;
        return planned;
    }
    maps.view = view;
    maps.height_m = height_or_lowest_m(view.height_m, *maps.layer);
    maps.latitude_rad = place.latitude_rad;
    maps.longitude_rad = place.longitude_rad;
    maps.sign = sign;
    maps.title = attribute_title(*maps.attribute->entry);
    planned.maps = maps;
    return planned;
}

void add_adjacent_legend(const AdjacentData& data, const flight::FlightTime& time, const design::DesignSettings& design,
                         draw::DataLegends& legends) noexcept {
    if (data.state != GroundDataState::shown) return;
    const draw::AdjacentInput& maps = data.maps;
    const bool is_uncertainty = maps.view.shows == design::AdjacentShows::uncertainty;
    draw::DataLegend legend = is_uncertainty ? uncertainty_legend_of(*maps.layer, *maps.attribute, time, design)
                                             : legend_of(*maps.layer, *maps.attribute, time, design);
    legend.scale = maps.view.scale;
    if (is_uncertainty) add_sign(draw::kUnknownText, draw::SampleLook::cut_stripes, kMapGround, maps.sign, legend);
    add_sign("MISSING", draw::SampleLook::dots, kMapGround, maps.sign, legend);
    const auto& stops = legend.scale.palette.stops;
    const design::Color middle = scale_color(legend.scale, 0.5 * (stops[0].value + stops.back().value));
    add_sign("INTERPOLATED", draw::SampleLook::cut_grid, middle, kMapGround, legend);
    add_legend(legend, legends);
}

}  // namespace tedavis::display
