/// A view beside the picture (thesis 2.3.2, coincident and adjacent): small maps of a field round the own ship, north up, read
/// from the section [data.adjacent] of a design.
///
/// Uncertainty is shown as a value of its own, 0..1 of what counts as 1; members of an ensemble stand side by side.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>

#include "render_core/base/config_reader.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/design/data_scale.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::design {

enum class AdjacentShows : std::uint8_t {
    uncertainty,
    value,
    members,  ///< a map each
};
inline constexpr std::size_t kAdjacentShows = 3;
extern const std::array<std::string_view, kAdjacentShows> kAdjacentShowsNames;

inline constexpr std::uint32_t kMinCells = 4, kMaxCells = 25;

struct AdjacentView {
    bool is_shown = false;
    base::FixedString<31> layer;  ///< empty: the first grid of the role
    scene::LayerRole role = scene::LayerRole::field;
    base::FixedString<31> attribute;
    AdjacentShows shows = AdjacentShows::uncertainty;
    double range_m = 20'000;                          ///< from the own ship to the edges of a map
    double size = 5;                                  ///< side of a map in texts, at most; as there is room
    std::uint32_t cells = kMaxCells;                  ///< across a map, at most; several maps share what there is room for
    std::uint32_t most_members = scene::kMaxMembers;  ///< of more, so many evenly spaced ones
    double height_m = std::numeric_limits<double>::quiet_NaN();  ///< as in GroundData
    DataScale scale;                                             ///< of uncertainty over 0..1
};
static_assert(std::is_trivially_copyable_v<AdjacentView>);

/// An absent section leaves `view` as it is.
void read_adjacent_view(base::ConfigSection section, PaletteSource& palettes, AdjacentView& view);

}  // namespace tedavis::design
