#include "render_core/display/planner/stated_layer.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render_core/base/check.hpp"

namespace tedavis::display {
namespace {

constexpr std::int64_t kAlways_ns = INT64_MAX;

template <std::size_t N>
void set_text(char (&field)[N], std::string_view text) {
    TEDAVIS_CHECK(text.size() < N);
    std::memcpy(field, text.data(), text.size());
}

}  // namespace

void name_layer(scene::LayerEntry& entry, std::string_view name, std::string_view title) {
    set_text(entry.name, name);
    set_text(entry.title, title);
    set_text(entry.source, "on board");
    entry.height_datum = scene::HeightDatum::ellipsoid;
    entry.valid_from_ns = -kAlways_ns;
    entry.valid_until_ns = kAlways_ns;
    entry.data_time_ns = scene::kNoTime;
}

void name_attribute(scene::AttributeEntry& entry, std::string_view name, std::string_view unit) {
    set_text(entry.name, name);
    set_text(entry.unit, unit);
    entry.scale = scene::AttributeScale::quantitative;
    entry.of = scene::AttributeOf::point;
    entry.uncertainty_kind = scene::UncertaintyKind::none;
}

void set_range(base::Span<const float> values, scene::AttributeEntry& entry) {
    entry.minimum = entry.maximum = 0;
    entry.value_count = values.size();
    bool is_first = true;
    for (const float value : values) {
        if (!std::isfinite(value)) continue;
        entry.minimum = is_first ? value : std::min(entry.minimum, value);
        entry.maximum = is_first ? value : std::max(entry.maximum, value);
        is_first = false;
    }
}

}  // namespace tedavis::display
