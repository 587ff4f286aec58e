/// Relates data foci and spatial foci (thesis, 5.2.2): the current values of a data focus and their positions, and the values
/// in a spatial focus.
///
/// Positions of data: the layers' extent is divided into kFocusCells x kFocusCells cells; each cell with a value in focus gives
/// the box round its positions. The centres of up to kMaxFocusPoints boxes are the region's points; of more boxes those
/// farthest from each other are chosen (Gonzalez, "Clustering to minimize the maximum intercluster distance", 1985), with a
/// radius that contains all positions, plus the design's radius. So no position is left out; areas between them may be
/// included.
///
/// Pure. Bounded: each value is read a few times. Any thread. Times are rounded to minutes (scene/data_time.hpp).
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

/// `focus` is a data focus. Layers that are not valid now are left out.
[[nodiscard]] FoundData data_of(const design::FocusSettings& focus, const FocusFrame& frame);

/// Returns the time for which a layer's values are shown.
[[nodiscard]] std::int64_t shown_time_ns(const scene::Layer& layer, const flight::FlightTime& time) noexcept;
/// True where a layer is valid now; without a date all layers are.
[[nodiscard]] bool holds_now(const scene::Layer& layer, const flight::FlightTime& time) noexcept;

/// The interval of the values at positions in the focus, at any height.
struct DerivedInterval {
    double low = 0, high = -1;  ///< low > high: there are no values
    std::uint32_t count = 0;
};
[[nodiscard]] DerivedInterval values_in(const scene::FocusRegion& region, const LayerValues& values, const scene::Layer& layer);

}  // namespace tedavis::draw
