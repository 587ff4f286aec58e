/// The legend of spatial data: one entry per scale in use, with units, uncertainty, time and source.
///
/// The owners of data fill the entries; the builder draws them in the layout's areas. Where there is too little room all
/// entries are shortened equally (LegendDetail); then the last ones are left out, and the legend states their number. Pure: no
/// GL, no clock, no heap. Thread any.
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
    cut_stripes,  ///< unknown uncertainty
    question,     ///< a question mark on it: the same of signs
    cut_grid,     ///< interpolated
    dots,         ///< missing
    grains,
    strokes,
    rough,   ///< bumps in the shading
    washed,  ///< an edge of colours run into each other
    mesh,    ///< lines; `share` 0 narrow, 1 wide
    rim,     ///< a line around
    margin,  ///< what it is, within where it may reach as well
    icon,    ///< on `under`
    crossed_icon,
    dashed_rim,  ///< round nothing; `share` of the dashes
    words,       ///< no sample: the text alone, over the whole row
};

/// A sample box that looks like the technique, with its meaning.
struct LegendSample {
    base::FixedString<23> text;
    design::Color color;  ///< of the data
    design::Color under;  ///< what shows where data are cut away; of lines and rims their colour
    SampleLook look = SampleLook::plain;
    double share = 0;  ///< 0..1 of the data that is taken away, or of the effect
    Icon icon = Icon::generic;
};

/// Text of the sample of unknown uncertainty; "?" where there is little room.
inline constexpr std::string_view kUnknownText = "UNKNOWN";
inline constexpr std::size_t kUncertaintySamples = 3;
inline constexpr std::size_t kMaxLegendSamples = 10;

struct DataLegend {
    bool has_scale = true;  ///< false: signs alone, which stand last and are the first to be left out
    base::FixedString<31> title;
    base::FixedString<15> part;  ///< what of it is shown: "MEMBER 3/9"; empty: all
    base::FixedString<15> unit;  ///< as written; empty: a plain number or a class
    design::DataScale scale;
    double factor = 1;  ///< written number of one of the scale's
    double offset = 0;  ///< written number of the scale's 0
    /// Nominal and ordinal: class n has the scale's colour at value n. Empty: numbers.
    base::FixedVector<base::FixedString<23>, design::kMaxClasses> class_names;
    /// Samples of certain data, of uncertain data and of data with unknown uncertainty, in this order; empty: uncertainty is not
    /// shown.
    base::FixedVector<LegendSample, kUncertaintySamples> uncertainty;
    base::FixedVector<LegendSample, kMaxLegendSamples> signs;  ///< missing, interpolated, and whatever else
    bool has_time = false, has_age = false, is_stale = false;
    std::int64_t data_time_ns = 0;  ///< UTC; of a forecast when it was made, while the flight is within its times
    base::Duration age;             ///< negative: so long until the first of its times
    bool is_forecast = false;       ///< the data are those of now, and the age is how far ahead they were said
    base::FixedString<23> source;
};
inline constexpr std::size_t kMaxDataLegends = 5;
using DataLegends = base::FixedVector<DataLegend, kMaxDataLegends>;
static_assert(std::is_trivially_copyable_v<DataLegends>);

/// Levels of detail of a legend, from the most to the least; the scale is never left out.
enum class LegendDetail : std::uint8_t {
    whole,             ///< the scale upright
    flat,              ///< the scale lying
    without_source,    ///< and
    without_signs,     ///< and
    uncertainty_line,  ///< what the uncertainty looks like in one line
    scales_alone,      ///< and without the entry that has none
    scale_and_time,    ///< and
    scale,             ///< title, part in its row, unit and scale; a stale one's title is amber
};
inline constexpr std::size_t kLegendDetails = 8;

/// In texts, with the gap to the next one; 0 of what has no place at this detail.
[[nodiscard]] float data_legend_height(const DataLegend& legend, LegendDetail detail) noexcept;
/// Returns the room that all entries need together, for the layout.
[[nodiscard]] DataLegendNeed data_legend_need(const DataLegends& legends) noexcept;

/// The placement of the first `shown` entries.
struct DataLegendPlan {
    LegendDetail detail = LegendDetail::whole;
    std::size_t shown = 0, cut = 0;
    std::array<Rect, kMaxDataLegends> boxes{};
};
[[nodiscard]] DataLegendPlan plan_data_legends(const DataLegends& legends, const Layout& layout) noexcept;

class Painter;
void build_data_legends(const Painter& painter, const DataLegends& legends);

/// "13:00Z 12 MIN", "13:00Z +62 MIN" of a forecast, "13:00Z IN 40 MIN", "13:00Z AGE ?"; minutes to 99, hours to 48, then days.
/// Empty without a time.
[[nodiscard]] base::FixedString<31> time_and_age(const DataLegend& legend) noexcept;

}  // namespace tedavis::draw
