/// Entries of the legend for the spatial data that a frame shows.
///
/// Pure; any thread. Memory  the caller's list; what does not fit in it is refused and counted there.
#pragma once

#include "render_core/design/design_settings.hpp"
#include "render_core/display/planner/spatial_data.hpp"
#include "render_core/draw/symbology/data_legend.hpp"

namespace tedavis::display {

/// Title, unit, class names, data time, age and source of an attribute: what an entry says whatever the technique. The age is
/// known while the time is confirmed. Scale, uncertainty and signs are left to the caller. `made_of`: the layer whose values the
/// attribute's were made of, which has its time and source; null: its own.
[[nodiscard]] draw::DataLegend legend_of(const scene::Layer& layer, const scene::Attribute& attribute,
                                         const flight::FlightTime& time, const design::DesignSettings& design,
                                         const scene::Layer* made_of = nullptr) noexcept;

/// How long ago what the layer holds of this date was measured, where that is longer than `stale_after_s`; else 0. Forecasts, and
/// what nobody dates, are not stale.
[[nodiscard]] base::Duration stale_age(const scene::Layer& layer, const flight::FlightTime& time, double stale_after_s) noexcept;

/// The unit that pilots read: degrees of radians, degrees Celsius of kelvins, and of metres per second the display's unit of
/// speeds, or of vertical speeds where the attribute's name says that they are vertical. Others as they are.
struct ShownUnit {
    double factor = 1;  ///< the number in this unit of one of the attribute's
    base::FixedString<15> name;
    double offset = 0;  ///< the number in this unit of the attribute's 0; no part of a difference
};
[[nodiscard]] ShownUnit shown_unit(const scene::AttributeEntry& attribute, base::DisplayUnits units) noexcept;

/// With a nominal palette: the classes in use (bit n: class n) that the palette names, each with its colour.
void keep_named_classes(const scene::Attribute& attribute, std::uint32_t in_use, draw::DataLegend& legend) noexcept;

/// A level 0..1 in the attribute's shown unit: "±4 KT", "±20 %"; of the full scale where the source has classes of its own: "50
/// %", and "UNCERTAIN" for 1.
[[nodiscard]] base::FixedString<15> uncertainty_text(const scene::AttributeEntry& attribute, double level,
                                                     base::DisplayUnits units) noexcept;
/// What counts as the least sure.
[[nodiscard]] base::FixedString<15> full_uncertainty_text(const scene::AttributeEntry& attribute,
                                                          base::DisplayUnits units) noexcept;

/// "GUST": the shortest that names what is shown.
[[nodiscard]] base::FixedString<31> attribute_title(const scene::AttributeEntry& attribute) noexcept;

/// Of the uncertainty itself as a value 0..1, in its unit: "GUST ±".
[[nodiscard]] draw::DataLegend uncertainty_legend_of(const scene::Layer& layer, const scene::Attribute& attribute,
                                                     const flight::FlightTime& time,
                                                     const design::DesignSettings& design) noexcept;

/// "MEMBER 3/9": the legend's part of an ensemble.
[[nodiscard]] base::FixedString<15> member_text(std::uint32_t member, std::uint32_t count) noexcept;

/// Unless there is one already that says the same. A full list counts the refusal itself.
void add_legend(const draw::DataLegend& entry, draw::DataLegends& legends) noexcept;

/// True where a palette states a unit, and it is another one than the attribute's.
[[nodiscard]] bool is_in_another_unit(const design::Palette& palette, const scene::AttributeEntry& attribute) noexcept;

/// The colours on the ground, where they are shown.
void add_ground_legend(const SpatialData& data, const SpatialDataPlan& plan, const design::DesignSettings& design,
                       const flight::FlightTime& time, draw::DataLegends& legends) noexcept;

}  // namespace tedavis::display
