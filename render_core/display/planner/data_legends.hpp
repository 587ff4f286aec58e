/// Entries of the legend for the spatial data that a frame shows.
///
/// Pure; any thread. Memory  the caller's list; what does not fit in it is refused and counted there.
#pragma once

#include "render_core/design/design_settings.hpp"
#include "render_core/display/planner/spatial_data.hpp"
#include "render_core/draw/symbology/data_legend.hpp"

namespace tedavis::display {

/// Returns the parts of an entry that do not depend on the technique: title, unit, class names, data time, age and source of an
/// attribute. The age is known while the time is confirmed. The caller adds scale, uncertainty and signs. `made_of`: the layer
/// from which the attribute's values were computed, and which states their time and source; null: its own layer.
[[nodiscard]] draw::DataLegend legend_of(const scene::Layer& layer, const scene::Attribute& attribute,
                                         const flight::FlightTime& time, const design::DesignSettings& design,
                                         const scene::Layer* made_of = nullptr) noexcept;

/// Returns how long ago the layer's values for this time were measured if that is longer than `stale_after_s`, else 0. Forecasts
/// and values without a date are not stale.
[[nodiscard]] base::Duration stale_age(const scene::Layer& layer, const flight::FlightTime& time, double stale_after_s) noexcept;

/// The unit that is shown to pilots: degrees for radians, degrees Celsius for kelvins, and for metres per second the display's
/// unit of speeds, or that of vertical speeds where the attribute's name says that they are vertical. Other units are unchanged.
struct ShownUnit {
    double factor = 1;  ///< the value in this unit of 1 in the attribute's unit
    base::FixedString<15> name;
    double offset = 0;  ///< the value in this unit of the attribute's 0; not added to differences
};
[[nodiscard]] ShownUnit shown_unit(const scene::AttributeEntry& attribute, base::DisplayUnits units) noexcept;

/// Keeps, where the palette is nominal, the classes in use (bit n: class n) that the palette names, each with its colour.
void keep_named_classes(const scene::Attribute& attribute, std::uint32_t in_use, draw::DataLegend& legend) noexcept;

/// Returns an uncertainty level 0..1 in the attribute's shown unit: "±4 KT", "±20 %". Where the source has classes of its own it
/// is a part of the full scale: "50 %", and "UNCERTAIN" for 1.
[[nodiscard]] base::FixedString<15> uncertainty_text(const scene::AttributeEntry& attribute, double level,
                                                     base::DisplayUnits units) noexcept;
/// Returns the text of the greatest uncertainty.
[[nodiscard]] base::FixedString<15> full_uncertainty_text(const scene::AttributeEntry& attribute,
                                                          base::DisplayUnits units) noexcept;

/// Returns the shortest title that names what is shown: "GUST".
[[nodiscard]] base::FixedString<31> attribute_title(const scene::AttributeEntry& attribute) noexcept;

/// Returns the entry of the uncertainty itself, a value 0..1, in its unit: "GUST ±".
[[nodiscard]] draw::DataLegend uncertainty_legend_of(const scene::Layer& layer, const scene::Attribute& attribute,
                                                     const flight::FlightTime& time,
                                                     const design::DesignSettings& design) noexcept;

/// Returns the legend's text for a member of an ensemble: "MEMBER 3/9".
[[nodiscard]] base::FixedString<15> member_text(std::uint32_t member, std::uint32_t count) noexcept;

/// Adds an entry unless the list has one with the same content. A full list counts what it refuses.
void add_legend(const draw::DataLegend& entry, draw::DataLegends& legends) noexcept;

/// Returns true where a palette states a unit other than the attribute's.
[[nodiscard]] bool is_in_another_unit(const design::Palette& palette, const scene::AttributeEntry& attribute) noexcept;

/// Adds the entry of the colours on the ground, where they are shown.
void add_ground_legend(const SpatialData& data, const SpatialDataPlan& plan, const design::DesignSettings& design,
                       const flight::FlightTime& time, draw::DataLegends& legends) noexcept;

}  // namespace tedavis::display
