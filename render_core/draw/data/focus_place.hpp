/// Where the foci of space are in a frame.
///
///   own_ship      below the own ship, as the display has it
///   destination   the runway that the design names; else of the scene's runways the one nearest the last point of the planned
///   way,
///                 else the one nearest the own ship; its middle
///   flight_path   along the planned way, from the place on it that the flight's time says, else the nearest one; without a way
///                 straight on by the velocity over the ground
///   place         the feature of that name: of layers of places before all others, then in the scene's order; of lines and areas
///                 the middle of their points
///   position      as stated
///
/// The planned way is the trajectory of the scene that passes nearest to the own ship, within kFarthestWay_m. Where it has more
/// corners than a region has points, those that are farthest from the way between the others are kept.
///
/// A focus by the own ship's place is nowhere while that is not known, and says so. Pure but for the ground, which is asked; the
/// same answer whatever came before. Bounded: the scene's points of the roles it looks at. Thread  the ground's.
#pragma once

#include "render_core/design/focus_settings.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/flight/aircraft_state.hpp"
#include "render_core/scene/focus_region.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::draw {

inline constexpr double kFarthestWay_m = 5000;
inline constexpr double kMinSpeed_mps = 1;  ///< slower, nobody knows where it goes

enum class FocusState : std::uint8_t {
    shown,
    position_stale,  ///< shown, where the own ship was seen last
    no_position,
    no_motion,
    no_such_place,
    no_runway,
    no_hazard,
    no_such_data,  ///< no layer of that name or role with that attribute holds now
    no_such_value,
};
/// For records: "the own ship's position is not known".
[[nodiscard]] const char* reason_of(FocusState state) noexcept;
[[nodiscard]] constexpr bool is_shown(FocusState state) noexcept { return state <= FocusState::position_stale; }

/// What a frame knows.
struct FocusFrame {
    const flight::OwnShipEstimate& own_ship;
    double own_height_m = 0;              ///< over the ellipsoid
    const scene::Scene* scene = nullptr;  ///< null: there is none
    flight::FlightTime time;
    scene::Ground& ground;
    const earth::Geodetic* hazard = nullptr;  ///< where the first one on the way is met; null: there is none
};

struct FocusPlace {
    FocusState state = FocusState::no_position;
    scene::FocusRegion region;  ///< not valid where it is not shown
    double height_m = 0;        ///< of the thing itself over the ellipsoid; NaN where no ground is known
};

/// Of a focus of space; those of data are in focus_values.hpp.
[[nodiscard]] FocusPlace place_of(const design::FocusSettings& focus, const FocusFrame& frame);

}  // namespace tedavis::draw
