/// Checks of the entries and arrays of a scene database. Pure functions; any thread. Comparisons fail for NaN where it is not
/// allowed.
#pragma once

#include <cstddef>
#include <cstring>

#include "render_core/base/span.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::scene {

/// True where a text ends within its field.
template <std::size_t N>
[[nodiscard]] bool ends(const char (&field)[N]) {
    return std::memchr(field, 0, N) != nullptr;
}

[[nodiscard]] bool entry_holds(const LayerEntry& entry, std::uint32_t all_attributes);
[[nodiscard]] bool entry_holds(const AttributeEntry& entry, const LayerEntry& layer);

[[nodiscard]] bool points_hold(base::Span<const ScenePoint> points);
/// True where starts ascend from 0 to `point_count`, with runs of at least `least` points.
[[nodiscard]] bool starts_hold(base::Span<const std::uint32_t> starts, std::uint32_t point_count, std::uint32_t least);
[[nodiscard]] bool levels_hold(base::Span<const float> levels_m);
[[nodiscard]] bool times_hold(base::Span<const std::int64_t> times_ns);
/// True where each name ends within its kNameBytes.
[[nodiscard]] bool names_hold(base::Span<const char> names);
[[nodiscard]] bool model_holds(base::Span<const ModelVertex> vertices, base::Span<const std::uint16_t> triangles);
/// True where values are NaN (missing) or lie between the entry's limits, and classes are integers below their count.
[[nodiscard]] bool values_hold(base::Span<const float> values, const AttributeEntry& entry);
[[nodiscard]] bool states_hold(base::Span<const ValueState> states);

/// Least number of points in a run of a shape.
[[nodiscard]] std::uint32_t least_points(LayerShape shape);

}  // namespace tedavis::scene
