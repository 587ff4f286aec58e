/// Evaluates an attribute of a grid layer as a field in space and time.
///
/// Between posts quantitative values are interpolated linearly in longitude, latitude, height and time; nominal and ordinal
/// ones are those of the nearest post. The value is missing where a post with non-zero weight is missing, and `interpolated`
/// where one is. The level of uncertainty is interpolated linearly too; it is unknown where that of a post with weight is, and
/// grows with age (uncertainty.hpp). Nothing is extrapolated in space: outside the outermost posts and levels the field is
/// missing. Before the first time and after the last, the nearest one is used, with its age.
/// Frames   WGS84 radians; heights m in the layer's datum. Pure; any thread; the layer must outlive the field.
#pragma once

#include "render_core/scene/scene.hpp"

namespace tedavis::scene {

struct FieldValue {
    double value = 0;  ///< 0 where missing
    Uncertainty uncertainty;
    ValueState state = ValueState::missing;
};

/// A position between two neighbouring posts of an axis: `first` + `fraction`. A fraction of 0 needs no second post.
struct AxisPlace {
    std::uint32_t first = 0, second = 0;
    double fraction = 0;
    bool inside = false;
};

class GridField {
public:
    /// `attribute` must be one of the layer's, and the layer a grid.
    GridField(const Layer& layer, const Attribute& attribute);

    /// The positions of a height and a time on their axes; computed once, they serve for many points.
    [[nodiscard]] AxisPlace level_at(double height_m) const;
    [[nodiscard]] AxisPlace time_at(std::int64_t time_ns) const;
    /// Returns the time before the first or after the last of the data's times, relative to the layer's time where the grid has
    /// none; 0 where neither is stated.
    [[nodiscard]] base::Duration age(std::int64_t time_ns) const;

    [[nodiscard]] FieldValue at(double latitude_rad, double longitude_rad, double height_m, std::int64_t time_ns) const;
    /// Returns the value at a post, given by its indices instead of its angles.
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
    bool is_closed_;  ///< the last column is next to, or the same as, the first
};

}  // namespace tedavis::scene
