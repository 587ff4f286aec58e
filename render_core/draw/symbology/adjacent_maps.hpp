/// Adjacent maps: a field of the scene round the own ship, north up, in one map or one for each member of an ensemble.
///
/// A map consists of cells of a grid that is fixed to the ground, in the colour of the scale for the field's value at the
/// cell's centre (GridField::at); edges lie between pixels, so that colours do not mix. Cells without a colour have a sign on a
/// dark background: a dot for missing values and outside the grid, a stroke for unknown uncertainty. Interpolated values have a
/// gap round them.
/// Frames   cells are as wide as high, or slightly wider: their width in longitude is computed again for each eighth of a degree
///          of latitude.
/// Memory   only the batch's: kAdjacentCells quads for all cells of all maps. Pure: no GL, no clock, no heap. Thread  any.
#pragma once

#include <type_traits>

#include "render_core/design/adjacent_view.hpp"
#include "render_core/draw/symbology/layout.hpp"
#include "render_core/scene/grid_field.hpp"

namespace tedavis::draw {

/// Number of cells of all maps together. A map has one more cell across and down than fit, for those cut at its edges.
inline constexpr std::uint32_t kAdjacentCells = 676;

/// What the maps show. Layer and attribute must stay valid until the picture is built.
struct AdjacentInput {
    const scene::Layer* layer = nullptr;  ///< null: there are no maps
    const scene::Attribute* attribute = nullptr;
    design::AdjacentView view;
    double height_m = 0;
    std::int64_t time_ns = 0;
    double latitude_rad = 0, longitude_rad = 0;  ///< of the own ship
    design::Color sign;                          ///< of what is missing or unknown
    base::FixedString<31> title;
};
static_assert(std::is_trivially_copyable_v<AdjacentInput>);

/// Number of maps; 0 without a layer.
[[nodiscard]] std::uint32_t map_count(const AdjacentInput& input) noexcept;
/// Returns the number of cells across a map: that of the design, limited by kAdjacentCells for all maps together and by the
/// smallest legible cell.
[[nodiscard]] std::uint32_t cells_across(const AdjacentInput& input, float side_px) noexcept;
/// Returns what make_layout() needs to place the maps.
[[nodiscard]] AdjacentNeed adjacent_need(const AdjacentInput& input) noexcept;

enum class CellSign : std::uint8_t { none, interpolated, unknown, missing };
struct MapCell {
    Rect box;  ///< whole pixels, within the map
    design::Color color;
    CellSign sign = CellSign::none;
};

/// The cells of one map, which shows `box`: their places first, by column from the west and row from the north.
class MapLattice {
public:
    MapLattice(const AdjacentInput& input, const Rect& box);

    [[nodiscard]] std::uint32_t columns() const { return columns_; }
    [[nodiscard]] std::uint32_t rows() const { return rows_; }
    /// The middle of a cell.
    [[nodiscard]] double latitude_rad(std::uint32_t row) const { return (north_ - row - 0.5) * step_lat_rad_; }
    [[nodiscard]] double longitude_rad(std::uint32_t column) const { return (west_ + column + 0.5) * step_lon_rad_; }
    [[nodiscard]] Rect box_of(std::uint32_t column, std::uint32_t row) const;

private:
    [[nodiscard]] float x_of(double longitude_rad) const;
    [[nodiscard]] float y_of(double latitude_rad) const;

    Rect box_;
    double latitude_rad_, longitude_rad_, px_per_lat_rad_ = 0, px_per_lon_rad_ = 0;
    double step_lat_rad_ = 1, step_lon_rad_ = 1;
    double west_ = 0, north_ = 0;  ///< outermost lines of the lattice, counted from 0N 0E
    std::uint32_t columns_ = 0, rows_ = 0;
};

/// Returns the cell for a value.
[[nodiscard]] MapCell cell_of(const scene::FieldValue& value, const AdjacentInput& input) noexcept;

class Painter;
struct SymbologyInput;
/// Draws the maps in the layout's box for them; nothing where that is empty.
void build_adjacent_maps(const Painter& painter, const SymbologyInput& input);

}  // namespace tedavis::draw
