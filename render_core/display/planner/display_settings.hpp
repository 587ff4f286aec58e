/// What a display is started with.
#pragma once

#include "render_core/base/ports/program_store.hpp"
#include "render_core/design/aircraft_settings.hpp"
#include "render_core/design/phase_designs.hpp"
#include "render_core/design/symbology_palette.hpp"
#include "render_core/effects/device.hpp"
#include "render_core/flight/legend_show.hpp"
#include "render_core/policy/database_dates.hpp"

namespace tedavis::display {

struct DisplaySettings {
    effects::DeviceSettings device;
    design::DesignSettings design;                 ///< where no phase has another
    const design::PhaseDesigns* phases = nullptr;  ///< null: none has; copied at start()
    design::AircraftSettings aircraft;             ///< not stated: no speeds are known, and the eye point is the antenna
    design::SymbologyPalettes symbology = design::standard_symbology_palettes();
    design::SymbologyLight light = design::SymbologyLight::day;  ///< may change between frames
    std::uint32_t width_px = 0, height_px = 0;
    flight::LegendShow legend = flight::LegendShow::key;  ///< where neither the panel nor the bus asks for another
    bool generated_flight = false;                        ///< the display says so
    policy::DatabaseDates database_dates;                 ///< of terrain and scene; the display says that they are out of date
    bool expects_scene = false;                           ///< a scene may come later, by take_scene()
    bool terrain_failed_at_start = false;                 ///< start() is given no terrain because it failed: the display says so
    base::ProgramStore* programs = nullptr;  ///< of a device without a compiler, or to be filled; must outlive start()

    /// Whether one of the designs requests terrain that is traced by rays: workers make it faster (TerrainInput).
    [[nodiscard]] bool asks_for_rays() const;
};

}  // namespace tedavis::display
