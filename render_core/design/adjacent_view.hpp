/// The adjacent view (thesis 2.3.2, coincident and adjacent views): small north-up maps of a field round the own ship, beside
/// the picture; read from the section [data.adjacent] of a design.
///
/// Uncertainty is shown as a separate value, level 0..1; members of an ensemble are shown side by side.
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
    members,  ///< one map for each member
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
    double size = 5;                                  ///< largest side of a map, in text heights
    std::uint32_t cells = kMaxCells;                  ///< largest number of cells across a map; several maps share the room
    std::uint32_t most_members = scene::kMaxMembers;  ///< most members shown; of a larger ensemble evenly spaced ones
    double height_m = std::numeric_limits<double>::quiet_NaN();  ///< as in GroundData
    DataScale scale;                                             ///< for uncertainty over 0..1
};
static_assert(std::is_trivially_copyable_v<AdjacentView>);

/// Reads the section; an absent one leaves `view` unchanged.
void read_adjacent_view(base::ConfigSection section, PaletteSource& palettes, AdjacentView& view);

}  // namespace tedavis::design
