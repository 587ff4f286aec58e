/// The symbology of a planned frame, put into its batch before the signs of the data look for room: legends stand where the
/// layout has them, and signs where the symbology leaves the picture free. So neither covers the other. Pure; any thread.
#pragma once

#include "render_core/design/symbology_palette.hpp"
#include "render_core/display/planner/element_planner.hpp"
#include "render_core/display/planner/frame_context.hpp"
#include "render_core/display/planner/symbology_data.hpp"
#include "render_core/draw/symbology/symbology_input.hpp"

namespace tedavis::display {

struct SymbologyFrame {
    const FrameContext& frame;
    const flight::AircraftState& state;
    const design::AircraftSettings& aircraft;
    const design::SymbologyPalette& palette;
    std::uint32_t width = 0, height = 0;
    draw::SymbolGround over = draw::SymbolGround::perspective;
    const SpatialData& data;
    const SpatialDataPlan& data_plan;
    const ElementReports& reports;
    flight::LegendShow legend = flight::LegendShow::key;
};

/// Ordinary text of a display, without what legends ask for.
[[nodiscard]] double text_px(const FrameContext& frame, std::uint32_t width, std::uint32_t height);

/// Fills the batch, and flags in the record what should be there and has no room, or no data.
MapsBeside plan_symbology(const SymbologyFrame& planned, draw::QuadBatch& batch, FrameStatement& record);

}  // namespace tedavis::display
