#include "render_core/draw/data/glyph_sites.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render_core/draw/data/placement.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::draw {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// For points without attributes: all of one size, with unknown uncertainty.
constexpr scene::AttributeEntry alike() {
    scene::AttributeEntry entry{};
    entry.scale = scene::AttributeScale::quantitative;
    entry.of = scene::AttributeOf::point;
    entry.maximum = 1;
    return entry;
}
constexpr scene::AttributeEntry kAlikeEntry = alike();
const scene::Attribute kAlike{&kAlikeEntry, {}, {}, {}, {}, {}};

bool is_wind(const scene::Layer& layer) {
    return layer.entry->role == scene::LayerRole::wind && layer.find("east") != nullptr && layer.find("north") != nullptr;
}

struct Box {
    double west = 1e9, east = -1e9, south = 1e9, north = -1e9;
};

Box box_of(const scene::Layer& layer) {
    Box box;
    if (layer.entry->shape == scene::LayerShape::grid) {
        const scene::GridShape& grid = layer.entry->grid;
        return {grid.west_rad, grid.west_rad + (grid.columns - 1) * grid.step_lon_rad,
                grid.north_rad - (grid.rows - 1) * grid.step_lat_rad, grid.north_rad};
    }
    for (const scene::ScenePoint& point : layer.points) {
        box.west = std::min(box.west, point.longitude_rad);
        box.east = std::max(box.east, point.longitude_rad);
        box.south = std::min(box.south, point.latitude_rad);
        box.north = std::max(box.north, point.latitude_rad);
    }
    return box;
}

double metres_north(double latitude_rad, double step_rad) { return step_rad * earth::meridian_radius_m(latitude_rad); }
double metres_east(double latitude_rad, double step_rad) {
    return step_rad * earth::prime_vertical_radius_m(latitude_rad) * std::cos(latitude_rad);
}

float over_ground_m(const ElementInput& input, const Placed& at, double latitude_rad, double longitude_rad) {
    return static_cast<float>(at.is_known ? at.height_m - input.ground.height_m(latitude_rad, longitude_rad) : kNone);
}

}  // namespace

const scene::Attribute* glyph_attribute(const design::DataElement& element, const scene::Layer& layer) {
    if (is_wind(layer)) return layer.find("east");
    if (element.by_color.is_used()) return layer.find(element.by_color.attribute.view());
    if (!element.size_attribute.view().empty()) return layer.find(element.size_attribute.view());
    if (!layer.attributes.empty()) return &layer.attributes[0];
    return layer.entry->shape == scene::LayerShape::points ? &kAlike : nullptr;
}

scene::GlyphValues glyph_values(const scene::Layer& layer, const scene::Attribute& attribute) {
    if (is_wind(layer)) return scene::GlyphValues::wind;
    return attribute.entry->scale == scene::AttributeScale::quantitative ? scene::GlyphValues::number
                                                                         : scene::GlyphValues::category;
}

bool glyphs_change(const scene::Layer& layer, const scene::Attribute& attribute) {
    return layer.times_ns.size() > 1 || attribute.entry->uncertainty_growth_per_hour > 0;
}

std::uint32_t glyph_count(const design::DataElement& element, const scene::Layer& layer) {
    if (layer.entry->shape != scene::LayerShape::grid) return layer.entry->point_count;
    const double heights = std::ceil(element.detail * static_cast<double>(element.heights_m.size()));
    const auto slices = static_cast<std::uint32_t>(std::max(1.0, heights));
    return layer.entry->grid.columns * layer.entry->grid.rows * slices;
}

scene::GlyphFrame GlyphSites::frame_of(const ElementInput& input) {
    const Box box = box_of(*layer_);
    const earth::Geodetic middle{0.5 * (box.south + box.north), 0.5 * (box.west + box.east), {0}};
    const double half_east = metres_east(middle.latitude_rad, 0.5 * (box.east - box.west));
    const double half_north = metres_north(middle.latitude_rad, 0.5 * (box.north - box.south));
    constexpr double kMinReach_m = 20'000;  // heights as well
    const bool is_grid = layer_->entry->shape == scene::LayerShape::grid;
    const scene::GridShape& grid = layer_->entry->grid;
    const double spacing = is_grid ? std::min(metres_east(middle.latitude_rad, grid.step_lon_rad),
                                              metres_north(middle.latitude_rad, grid.step_lat_rad))
                                   : kPointGlyph_m / kShareOfSpacing;
    const double own_m = std::min(kShareOfSpacing * spacing, kMaxGridGlyph_m);
    size_m_ = static_cast<float>(input.element.size_m > 0 ? input.element.size_m : own_m);
    return scene::level_frame(middle, std::max({half_east, half_north, kMinReach_m}));
}

bool GlyphSites::begin(const ElementInput& input, std::int64_t time_ns, scene::GlyphField& field) {
    const scene::Attribute* const attribute = glyph_attribute(input.element, input.layer);
    if (attribute == nullptr) return false;
    element_ = &input.element;
    layer_ = &input.layer;
    attribute_ = attribute;
    north_ = is_wind(*layer_) ? layer_->find("north") : nullptr;
    time_ns_ = time_ns;
    next_ = 0;
    posts_ = layer_->entry->grid.columns * layer_->entry->grid.rows;
    all_ = glyph_count(*element_, *layer_);
    field.begin(frame_of(input), glyph_values(*layer_, *attribute));
    return true;
}

bool GlyphSites::step(scene::Ground& ground, scene::GlyphField& field, std::uint32_t most_sites) {
    const ElementInput input{*element_, 0, *layer_, ground, {}, time_ns_, true};
    const bool is_grid = layer_->entry->shape == scene::LayerShape::grid;
    for (std::uint32_t n = 0; n < most_sites && next_ < all_; ++n, ++next_)
        static_cast<void>(field.add(is_grid ? post(input, next_) : point(input, next_)));
    return next_ == all_;
}

scene::GlyphSite GlyphSites::post(const ElementInput& input, std::uint32_t n) const {
    const scene::GridShape& grid = layer_->entry->grid;
    const std::uint32_t slice = n / posts_, column = n % posts_ % grid.columns, row = n % posts_ / grid.columns;
    const bool has_heights = !element_->heights_m.empty(), has_levels = !layer_->levels_m.empty();
    const double height_m = has_heights  ? element_->heights_m[slice]
                            : has_levels ? static_cast<double>(layer_->levels_m[0])
                                         : kNone;
    const double longitude = grid.west_rad + column * grid.step_lon_rad, latitude = grid.north_rad - row * grid.step_lat_rad;
    const bool is_over_ground = std::isnan(height_m) || element_->heights_over_ground;
    const Placed at = is_over_ground ? placed_over_ground(input, latitude, longitude, has_heights ? height_m : kOverGround_m)
                                     : placed(input, latitude, longitude, height_m);
    scene::GlyphSite site;
    site.place = at.is_known ? at.place : glm::dvec3(kNone);
    site.size_m = size_m_;
    const double level_m = !is_over_ground             ? height_m
                           : has_levels && at.is_known ? height_in_datum_m(input, latitude, longitude, at.height_m)
                                                       : 0;
    if (element_->link) site.over_ground_m = over_ground_m(input, at, latitude, longitude);
    const auto value_of = [&](const scene::Attribute& attribute) {
        const scene::GridField values(*layer_, attribute);
        return values.at_post(column, row, values.level_at(level_m), values.time_at(time_ns_), values.age(time_ns_));
    };
    const scene::FieldValue value = value_of(*attribute_);
    const auto number = [](const scene::FieldValue& of) {
        return of.state == scene::ValueState::missing ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(of.value);
    };
    site.value = number(value);
    if (north_ != nullptr) site.north_mps = number(value_of(*north_));
    site.uncertainty = value.uncertainty;
    site.state = value.state;
    return site;
}

scene::FieldValue GlyphSites::value_of_point(const scene::Attribute& attribute, std::uint32_t n) const {
    if (&attribute == &kAlike) return {kAlikeEntry.maximum, scene::Uncertainty(), scene::ValueState::valid};
    std::uint32_t index = n;
    if (attribute.entry->of == scene::AttributeOf::feature && !layer_->starts.empty()) {
        const auto* const after = std::upper_bound(layer_->starts.begin(), layer_->starts.end(), n);
        index = static_cast<std::uint32_t>(after - layer_->starts.begin()) - 1;
    }
    const std::int64_t own = layer_->points[n].time_ns;
    const std::int64_t measured = own == scene::kNoTime ? layer_->entry->data_time_ns : own;
    const base::Duration age{measured == scene::kNoTime ? 0 : time_ns_ - measured};
    return {static_cast<double>(attribute.values[index]),
            scene::aged(attribute.uncertainty(index), age, static_cast<double>(attribute.entry->uncertainty_growth_per_hour)),
            attribute.state(index)};
}

scene::GlyphSite GlyphSites::point(const ElementInput& input, std::uint32_t n) const {
    const Placed at = placed(input, layer_->points[n]);
    const scene::FieldValue value = value_of_point(*attribute_, n);
    scene::GlyphSite site;
    site.place = at.is_known ? at.place : glm::dvec3(kNone);
    site.size_m = size_m_;
    if (element_->link)
        site.over_ground_m = over_ground_m(input, at, layer_->points[n].latitude_rad, layer_->points[n].longitude_rad);
    site.value = static_cast<float>(value.value);
    if (north_ != nullptr) site.north_mps = static_cast<float>(value_of_point(*north_, n).value);
    site.uncertainty = value.uncertainty;
    site.state = value.state;
    return site;
}

}  // namespace tedavis::draw
