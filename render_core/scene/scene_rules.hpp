/// What the entries and arrays of a scene database must hold. Pure functions; any thread. Comparisons are such that NaN fails
/// them where it is not allowed.
#pragma once

#include <cstddef>
#include <cstring>

#include "render_core/base/span.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::scene {

/// A text ends within its field.
template <std::size_t N>
[[nodiscard]] bool ends(const char (&field)[N]) {
    return std::memchr(field, 0, N) != nullptr;
}

[[nodiscard]] bool entry_holds(const LayerEntry& entry, std::uint32_t all_attributes);
[[nodiscard]] bool entry_holds(const AttributeEntry& entry, const LayerEntry& layer);

[[nodiscard]] bool points_hold(base::Span<const ScenePoint> points);
/// Ascending from 0 to `point_count`, each run at least `least` long.
[[nodiscard]] bool starts_hold(base::Span<const std::uint32_t> starts, std::uint32_t point_count, std::uint32_t least);
[[nodiscard]] bool levels_hold(base::Span<const float> levels_m);
[[nodiscard]] bool times_hold(base::Span<const std::int64_t> times_ns);
/// Names of kNameBytes each end within them.
[[nodiscard]] bool names_hold(base::Span<const char> names);
[[nodiscard]] bool model_holds(base::Span<const ModelVertex> vertices, base::Span<const std::uint16_t> triangles);
/// Missing ones are NaN; the others lie between the entry's limits, and classes are whole numbers below their count.
[[nodiscard]] bool values_hold(base::Span<const float> values, const AttributeEntry& entry);
[[nodiscard]] bool states_hold(base::Span<const ValueState> states);

/// Points that a run of a shape has at least.
[[nodiscard]] std::uint32_t least_points(LayerShape shape);

}  // namespace tedavis::scene
