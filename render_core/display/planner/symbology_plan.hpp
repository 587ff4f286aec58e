/// Plans the symbology of a frame before the signs of the data: legends are placed by the layout, and signs where the symbology
/// leaves the picture free, so that neither covers the other. Pure functions; any thread.
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

/// Returns the height of a display's ordinary text, without what legends request.
[[nodiscard]] double text_px(const FrameContext& frame, std::uint32_t width, std::uint32_t height);

/// Fills the batch, and flags in the record what should be there and has no room, or no data.
MapsBeside plan_symbology(const SymbologyFrame& planned, draw::QuadBatch& batch, FrameStatement& record);

}  // namespace tedavis::display
