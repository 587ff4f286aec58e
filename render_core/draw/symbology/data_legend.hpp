/// The legend of spatial data: one entry per scale in use, with units, uncertainty, time and source.
///
/// The owners of data fill the entries; the builder draws them in the layout's areas. Where there is too little room all
/// entries are shortened equally (LegendDetail); then the last ones are left out, and the legend states their number. Pure: no
/// GL, no clock, no heap. May be called from any thread.
#pragma once

#include <array>
#include <string_view>
#include <type_traits>

#include "render_core/base/time.hpp"
#include "render_core/design/data_style.hpp"
#include "render_core/draw/data/icons.hpp"
#include "render_core/draw/symbology/layout.hpp"

namespace tedavis::draw {

/// How a sample is filled; all except `plain` look as the shaders draw them.
enum class SampleLook : std::uint8_t {
    plain,
    cut_stripes,   ///< unknown uncertainty
    question,      ///< a question mark on the sample: unknown uncertainty of symbols
    cut_grid,      ///< interpolated
    dots,          ///< missing
    grains,        ///< noise
    strokes,       ///< strokes that are wider where data are more uncertain
    rough,         ///< bumps in the shading
    washed,        ///< colours that blend at an edge
    mesh,          ///< a mesh of lines; its spacing grows with `share`
    rim,           ///< a line around the sample
    margin,        ///< the object within the area that it may also occupy
    icon,          ///< an icon on the colour `under`
    crossed_icon,  ///< the same with a line across it
    dashed_rim,    ///< a dashed ring; `share` of it is drawn
    words,         ///< text over the whole row, without a sample
};

/// A sample box that looks like the technique, and the text that states its meaning.
struct LegendSample {
    base::FixedString<23> text;
    design::Color color;  ///< colour of the data
    design::Color under;  ///< colour where data are cut away, or behind an icon, a margin or a dashed ring; else of the lines
    SampleLook look = SampleLook::plain;
    double share = 0;  ///< 0..1: strength of the look, such as the share that is cut away; for `dashed_rim` the share drawn
    Icon icon = Icon::generic;
};

/// Text of the sample for unknown uncertainty; it is shortened to "?" where there is little room.
inline constexpr std::string_view kUnknownText = "UNKNOWN";
inline constexpr std::size_t kUncertaintySamples = 3;
inline constexpr std::size_t kMaxLegendSamples = 10;

/// One entry of the legend. Numbers are written as factor * value + offset, in `unit`.
struct DataLegend {
    bool has_scale = true;  ///< false: an entry with symbols only, which stands last and is the first to be left out
    base::FixedString<31> title;
    base::FixedString<15> part;  ///< the part of the data that is shown, such as "MEMBER 3/9"; empty: all
    base::FixedString<15> unit;  ///< unit as it is displayed; empty: a dimensionless number or a class
    design::DataScale scale;
    double factor = 1;  ///< displayed units per unit of the scale
    double offset = 0;  ///< displayed number for 0 of the scale
    /// Names of the classes of nominal and ordinal data: class n has the scale's colour at value n. Empty: the data are numbers.
    base::FixedVector<base::FixedString<23>, design::kMaxClasses> class_names;
    /// Samples of certain data, of uncertain data and of data with unknown uncertainty, in this order; empty: uncertainty is not
    /// shown.
    base::FixedVector<LegendSample, kUncertaintySamples> uncertainty;
    base::FixedVector<LegendSample, kMaxLegendSamples> signs;  ///< samples of missing and interpolated data, and other symbols
    bool has_time = false, has_age = false, is_stale = false;
    std::int64_t data_time_ns = 0;  ///< UTC, for which the data are valid; for a forecast: when it was computed
    base::Duration age;             ///< negative: time until the first time of the data
    bool is_forecast = false;       ///< the data are valid now; `age` is the lead time: from the computation to now
    base::FixedString<23> source;
};
inline constexpr std::size_t kMaxDataLegends = 5;
using DataLegends = base::FixedVector<DataLegend, kMaxDataLegends>;
static_assert(std::is_trivially_copyable_v<DataLegends>);

/// Levels of detail of a legend, from the most to the least; the scale is never left out.
enum class LegendDetail : std::uint8_t {
    whole,             ///< everything, with a vertical scale
    flat,              ///< a horizontal scale; at most 8 class names
    without_source,    ///< also without the source of the data
    without_signs,     ///< also without the `signs` of entries that have a scale
    uncertainty_line,  ///< also with the samples of uncertainty in one line, and at most 3 class names
    scales_alone,      ///< also without the entry that has no scale
    scale_and_time,    ///< only title, part, scale and time
    scale,             ///< title, part in its row, unit and scale; the title of stale data is amber
};
inline constexpr std::size_t kLegendDetails = 8;

/// Returns the height as a multiple of the text size, with the gap to the next entry; 0 for an entry left out at this detail.
[[nodiscard]] float data_legend_height(const DataLegend& legend, LegendDetail detail) noexcept;
/// Returns the room that all entries need together, for the layout.
[[nodiscard]] DataLegendNeed data_legend_need(const DataLegends& legends) noexcept;

/// The placement of the first `shown` entries; the last `cut` are left out. Boxes are in pixels.
struct DataLegendPlan {
    LegendDetail detail = LegendDetail::whole;
    std::size_t shown = 0, cut = 0;
    std::array<Rect, kMaxDataLegends> boxes{};
};
/// Returns the plan with the largest detail at which all entries fit, or else the last detail with as many as fit.
[[nodiscard]] DataLegendPlan plan_data_legends(const DataLegends& legends, const Layout& layout) noexcept;

class Painter;
/// Draws the entries as plan_data_legends places them.
void build_data_legends(const Painter& painter, const DataLegends& legends);

/// Returns the time of the data and their age: "13:00Z 12 MIN", "13:00Z STALE 62 MIN" for stale data, "13:00Z +62 MIN" for a
/// forecast, "13:00Z IN 40 MIN" for data that are not yet valid, "13:00Z AGE ?" without UTC. Ages are in minutes to 99, in hours
/// below 48, then in days. The text is empty without a time.
[[nodiscard]] base::FixedString<31> time_and_age(const DataLegend& legend) noexcept;

}  // namespace tedavis::draw
