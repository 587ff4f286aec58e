/// What one frame showed and why, as plain data: the log, the reports, the GUI and the tests all read this one struct.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/stamped.hpp"
#include "render_core/base/time.hpp"
#include "render_core/design/design_settings.hpp"
#include "render_core/design/symbology_palette.hpp"
#include "render_core/display/planner/distortion.hpp"
#include "render_core/effects/clutter_budget.hpp"
#include "render_core/effects/effect_planner.hpp"
#include "render_core/flight/aircraft_state.hpp"
#include "render_core/flight/flight_phase.hpp"
#include "render_core/flight/legend_show.hpp"
#include "render_core/policy/display_decisions.hpp"
#include "render_core/policy/obstacle_alerts.hpp"
#include "render_core/policy/terrain_alert_zone.hpp"
#include "render_core/policy/terrain_light.hpp"

namespace tedavis::display {

using Name = base::FixedString<47>;

enum class EffectState : std::uint8_t { run, replaced, skipped };

struct EffectRecord {
    Name name;
    EffectState state = EffectState::run;
    base::FixedString<95> reason;
    Name replaced_by;
    double bound = 0;                     ///< upper bound of its visible contribution, 0..1 of full scale
    std::uint32_t draws = 0, passes = 0;  ///< without work that it shares with other effects
    std::uint64_t bytes = 0;              ///< uploaded to the GPU, counted likewise
};

struct AspectRecord {
    base::FixedString<95> technique;  ///< all that show it, joined by "+"; empty: nothing does
    double detail = 0;                ///< 0..1
    double weight = 0;
};

struct WeightRecord {
    Name aspect;
    double weight = 1;  ///< 0..1, of the frame
    double stated = 1;  ///< by the design; `weight` is larger where it was raised
};

struct TerrainRecord {
    double tau_px = 0;          ///< requested
    double worst_error_px = 0;  ///< upper bound reached over all drawn chunks
    base::FixedString<31> worst_chunk;
    double tau_reached_px = 0;  ///< what the frame guarantees
    Name limit;                 ///< what prevented tau: "met", "triangles", "not_arrived" ...
    std::uint32_t triangles = 0;
    std::uint32_t chunks = 0;
    std::uint32_t pending = 0;              ///< wanted but not there yet; their coarser parents are drawn
    Name renderer;                          ///< what draws it; empty where none is drawn
    base::FixedString<63> renderer_reason;  ///< why it is not the one that the design names, or why it was chosen
    double triangles_ms = 0, rays_ms = 0;   ///< modelled costs between which it was chosen; 0: no choice, or unknown
};

struct ViewRecord {
    design::ViewMode mode = design::ViewMode::perspective;  ///< that the design requests
    double transition = 1;                                  ///< share of the transition to it; 1: it is complete
};

struct ByteRecord {
    std::uint64_t cpu = 0, gpu = 0, cpu_budget = 0, gpu_budget = 0, uploaded = 0;
};

/// Features of one type, by the role of their layer.
struct DataRecord {
    Name type;
    std::uint32_t drawn = 0;
    std::uint32_t aggregated = 0;  ///< shown by a symbol that represents several
    std::uint32_t hidden = 0;
    std::uint32_t out_of_view = 0;  ///< prisms, paths and solids that are built, but wholly out of the view
};

/// A layer of the picture that was measured longer ago than the design's limit.
struct StaleRecord {
    base::FixedString<31> layer;
    double age_s = 0;
};

/// The legend, which explains the colours of the picture.
struct LegendRecord {
    flight::LegendShow show = flight::LegendShow::key;
    std::uint32_t entries = 0, left_out = 0;  ///< scales that are explained, and those for which there is no room
};

/// The numbers of icons and names; only names are placed and suppressed.
struct LabelRecord {
    std::uint32_t placed = 0, suppressed = 0, changed = 0, decluttered = 0;  ///< display::LabelCounts
};

/// Values of an attribute that lie in a focus of space.
struct FocusValuesRecord {
    base::FixedString<31> layer, attribute;
    double low = 0, high = 0;
    std::uint32_t count = 0;  ///< 0: none lies there
};
inline constexpr std::size_t kMaxFocusValues = 4;

struct FocusRecord {
    base::FixedString<23> name;
    base::FixedString<15> shape;
    bool is_shown = false;
    base::FixedString<63> reason;                ///< why it is not, or how it is
    double latitude_rad = 0, longitude_rad = 0;  ///< of its first point
    double radius_m = 0;
    std::uint32_t points = 0;
    std::uint32_t in_focus = 0, intermediate = 0, context = 0;     ///< elements of the data that are shown
    double low = 0, high = -1;                                     ///< of a data focus; low > high: no value
    base::FixedVector<FocusValuesRecord, kMaxFocusValues> values;  ///< of a focus of space
    base::FixedString<15> sight;                                   ///< "seen", "behind terrain" ...
    double distance_m = 0;                                         ///< from the own ship
    bool has_cue = false;                                          ///< that leads there
};

/// How the frame's deadline was held (effects::BudgetReport).
struct GovernorRecord {
    double deadline_ms = 0;           ///< 0: none is held
    double predicted_ms = 0;          ///< modelled cost of the frame; 0: not known
    std::uint32_t quality_level = 0;  ///< of the calibration file's levels; 0: the design's own picture
    bool changed = false;             ///< with this frame
    base::FixedString<63> why;
    double tau_factor = 1, detail_factor = 1;  ///< of the level (effects::QualityLevel)
    effects::EffectSet given_up;
};

/// How the budget of clutter was held (display/planner/declutter_control.hpp).
struct ClutterRecord {
    double budget = 1;                  ///< 1: none is held
    effects::ClutterMeasures measured;  ///< the newest measurement that the frame uses
    effects::ClutterMap reached;        ///< with the detail that this interval chose; unknown where nothing is reduced
    scene::DetailRegions left;          ///< detail that each region keeps
    std::uint32_t roles = 0;            ///< of the layers that are reduced; a bit for each scene::LayerRole
};

/// The alerts of the frame, and the values from which they are decided.
struct AlertRecord {
    policy::TerrainAhead terrain = policy::TerrainAhead::none;
    policy::TerrainAhead obstacle = policy::TerrainAhead::none;
    policy::ObstacleAlerts obstacles;   ///< that are in the way; empty without an alert
    bool is_watching = false;           ///< false: there is no terrain alert whatever is ahead (standing, at a runway)
    double clearance_m = 0;             ///< height above the ground that the predicted track must keep
    double height_above_terrain_m = 0;  ///< of the own ship now; NaN: unknown
};

/// What the plan of a frame states for its record.
struct FrameStatement {
    std::uint64_t frame = 0;
    base::Time time;
    flight::FlightTime flight_time;  ///< for which data are valid and have an age
    flight::PhaseStatus phase;
    flight::OwnShipEstimate own_ship;
    double altitude_msl_m = 0;
    double heading_rad = 0, pitch_rad = 0, roll_rad = 0;
    std::array<base::SignalState, flight::kSignalCount> signals{};
    base::FixedVector<Name, 80> flags;
    ViewRecord view;
    DistortionRecords distortion;
    policy::TerrainLight light;
    design::SymbologyLight symbology_light = design::SymbologyLight::day;
    design::BandWidening bands;  ///< of the warning colours; 0 in frames without
    TerrainRecord terrain;
    AlertRecord alerts;
    policy::TerrainAlertZone alert_zone;       ///< the ground that the predicted track comes too close to, which is coloured
    std::uint64_t scene_revision = 0;          ///< of the scene database that is shown; 0: none
    base::FixedVector<StaleRecord, 16> stale;  ///< with the flag data.stale
    LegendRecord legend;
    LabelRecord labels;
    base::FixedVector<FocusRecord, scene::kMaxFoci> foci;
    base::FixedString<47> design;  ///< that the phase has
    double earlier_share = 0;      ///< of the design before it, which fades out
};

struct FrameRecord : FrameStatement {
    std::array<policy::ElementShow, policy::kElementCount> elements{};  ///< of the symbology; a design may still leave one out
    base::FixedVector<DataRecord, 16> data;
    ByteRecord bytes;
    GovernorRecord governor;
    base::FixedVector<EffectRecord, 32> effects;
    AspectRecord terrain_aspect, data_aspect, uncertainty_aspect;
    base::FixedVector<WeightRecord, design::kMaxAspects> weights;
    ClutterRecord clutter;
};
static_assert(std::is_trivially_copyable_v<FrameRecord>);

}  // namespace tedavis::display
