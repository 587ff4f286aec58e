/// Positions of the spatial foci in a frame.
///
///   own_ship      below the displayed position of the own ship
///   destination   the middle of a runway: the one that the design names; else, of the scene's runways, the one nearest the last
///                 point of the planned path; else the one nearest the own ship
///   flight_path   along the planned path, from the position on it at the flight's time, else from the nearest one; without a
///                 path, straight ahead along the velocity over the ground
///   place         the feature of that name, first in layers of places, then in the scene's order; for lines and areas the mean
///                 of their points
///   position      the stated one
///
/// The planned path is the trajectory of the scene that passes nearest to the own ship, within kFarthestTrack_m. Where it has
/// more corners than a region has points, the corner farthest from the line through the corners kept so far is kept next.
///
/// A focus that depends on the own ship's position is empty while that is unknown, with a reason. Pure, apart from queries to
/// the ground; independent of earlier frames. Bounded: the scene's points of the roles concerned. Thread  the ground's.
#pragma once

#include "render_core/design/focus_settings.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/flight/aircraft_state.hpp"
#include "render_core/scene/focus_region.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::draw {

inline constexpr double kFarthestTrack_m = 5000;
inline constexpr double kMinSpeed_mps = 1;  ///< below this speed the direction is unknown

enum class FocusState : std::uint8_t {
    shown,
    position_stale,  ///< shown at the own ship's last position
    no_position,
    no_motion,
    no_such_place,
    no_runway,
    no_hazard,
    no_such_data,  ///< no valid layer of that name or role has that attribute
    no_such_value,
};
/// Returns the text for records: "the own ship's position is not known".
[[nodiscard]] const char* reason_of(FocusState state) noexcept;
[[nodiscard]] constexpr bool is_shown(FocusState state) noexcept { return state <= FocusState::position_stale; }

/// The frame's data that foci depend on.
struct FocusFrame {
    const flight::OwnShipEstimate& own_ship;
    double own_height_m = 0;              ///< over the ellipsoid
    const scene::Scene* scene = nullptr;  ///< null: there is none
    flight::FlightTime time;
    scene::Ground& ground;
    const earth::Geodetic* hazard = nullptr;  ///< where the track reaches the first hazard; null: none
};

struct FocusPlace {
    FocusState state = FocusState::no_position;
    scene::FocusRegion region;  ///< not valid where the focus is not shown
    double height_m = 0;        ///< height of the object above the ellipsoid; NaN where the ground is unknown
};

/// Returns the position of a spatial focus; for data foci see focus_values.hpp.
[[nodiscard]] FocusPlace place_of(const design::FocusSettings& focus, const FocusFrame& frame);

}  // namespace tedavis::draw
