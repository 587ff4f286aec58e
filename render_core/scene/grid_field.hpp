/// An attribute of a grid layer as a field in space and time.
///
/// Between posts quantitative values are linear in longitude, latitude, height and time; nominal and ordinal ones are those of
/// the nearest post. Where a post that has weight is missing, the value is missing; where one is interpolated, so is the value.
/// The level of uncertainty is linear likewise, unknown where one with weight is unknown, and grows with age (uncertainty.hpp).
/// Nothing is extrapolated in space: beside the outermost posts and levels the field is missing. Before its first time and after
/// its last the nearest one holds, and ages.
/// Frames   WGS84 radians; heights m in the layer's datum. Pure; any thread; the layer must outlive the field.
#pragma once

#include "render_core/scene/scene.hpp"

namespace tedavis::scene {

struct FieldValue {
    double value = 0;  ///< 0 where missing
    Uncertainty uncertainty;
    ValueState state = ValueState::missing;
};

/// A place between two neighbours of an axis: `first` + `fraction` posts. Fractions of 0 need no second.
struct AxisPlace {
    std::uint32_t first = 0, second = 0;
    double fraction = 0;
    bool inside = false;
};

class GridField {
public:
    /// `attribute` must be one of the layer's, and the layer a grid.
    GridField(const Layer& layer, const Attribute& attribute);

    /// With both, the value of a place costs no look at other places.
    [[nodiscard]] AxisPlace level_at(double height_m) const;
    [[nodiscard]] AxisPlace time_at(std::int64_t time_ns) const;
    /// How long before or after all the data's times; from the layer's time where the grid has none; 0 where neither states any.
    [[nodiscard]] base::Duration age(std::int64_t time_ns) const;

    [[nodiscard]] FieldValue at(double latitude_rad, double longitude_rad, double height_m, std::int64_t time_ns) const;
    /// Of a post's column: by its indices instead of its angles.
    [[nodiscard]] FieldValue at_post(std::uint32_t column, std::uint32_t row, const AxisPlace& level, const AxisPlace& time,
                                     base::Duration age) const;

private:
    [[nodiscard]] AxisPlace column_at(double longitude_rad) const;
    [[nodiscard]] AxisPlace row_at(double latitude_rad) const;
    [[nodiscard]] FieldValue blend(const AxisPlace (&axes)[4], base::Duration age) const;
    [[nodiscard]] FieldValue nearest(const AxisPlace (&axes)[4], base::Duration age) const;
    [[nodiscard]] std::size_t index_of(std::uint32_t column, std::uint32_t row, std::uint32_t level, std::uint32_t time) const;

    const Layer* layer_;
    const Attribute* attribute_;
    bool is_closed_;  ///< its last column stands beside or upon its first
};

}  // namespace tedavis::scene
