/// Foci of data and foci of space, each from the other (thesis, 5.2.2): which values a data focus means now and where they are;
/// what values lie in a focus of space.
///
/// Where the data are: the layers' extent is parted into kFocusCells by kFocusCells cells; of those with a value in focus each
/// is the box round its places. Of at most kMaxFocusPoints boxes the middles are the region's points, of more those that are
/// farthest from each other (Gonzalez, "Clustering to minimize the maximum intercluster distance", 1985), with a radius by which
/// they hold all the places, plus the design's. So no place is left out; what lies between some may be held too.
///
/// Pure. Bounded: a few looks at each value. Any thread. The minute that the time lies in counts (scene/data_time.hpp).
#pragma once

#include "render_core/draw/data/focus_place.hpp"
#include "render_core/draw/data/frame_foci.hpp"
#include "render_core/draw/data/layer_values.hpp"

namespace tedavis::draw {

inline constexpr std::size_t kFocusCells = 16;

struct FoundData {
    FocusState state = FocusState::no_such_data;
    scene::FocusValueRange range;
    scene::FocusRegion region;  ///< not valid where it is not shown
};

/// `focus`: of data. Layers that do not hold now are left out.
[[nodiscard]] FoundData data_of(const design::FocusSettings& focus, const FocusFrame& frame);

/// The time at which a layer's values are shown.
[[nodiscard]] std::int64_t shown_time_ns(const scene::Layer& layer, const flight::FlightTime& time) noexcept;
/// Whether a layer is valid now; without a date all are.
[[nodiscard]] bool holds_now(const scene::Layer& layer, const flight::FlightTime& time) noexcept;

/// Of the values of places in the focus, whatever their heights.
struct DerivedInterval {
    double low = 0, high = -1;  ///< low > high: no value lies there
    std::uint32_t count = 0;
};
[[nodiscard]] DerivedInterval values_in(const scene::FocusRegion& region, const LayerValues& values, const scene::Layer& layer);

}  // namespace tedavis::draw
