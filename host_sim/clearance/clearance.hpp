/// The distances of an aircraft from the ground of a terrain database, and their uncertainty.
///
/// Distances are from the own ship's position to the true surface. Uncertainties are half widths of 95 % intervals: figures of
/// merit of the position as the aircraft states them, and the database's LE90, scaled to 95 % for a normal distribution (1.960 /
/// 1.645). Only GNSS heights have one; a pressure height has none.
#pragma once

#include <optional>
#include <vector>

#include "host_sim/clearance/nearest_ground.hpp"
#include "render_core/flight/aircraft_state.hpp"
#include "render_core/terrain/height_query.hpp"

namespace tedavis::host_sim {

/// The own ship's position, with heights above the ellipsoid and above MSL.
struct OwnShipPlace {
    earth::Geodetic place;
    double height_msl_m = 0;
    bool is_geometric = false;  ///< false: the height is from pressure
};

/// m, 95 %; nothing where it is not stated.
struct ClearanceUncertainty {
    std::optional<double> position_m;  ///< horizontal
    std::optional<double> height_m, terrain_m;

    /// Of the height above terrain: the root of the sum of squares of height and terrain.
    [[nodiscard]] std::optional<double> height_above_terrain_m() const;
};

/// The nearest ground that is no lower than the own ship, in sectors of 90 degrees about its track; nothing where there is none
/// within kLevelReach_m.
struct LevelClearance {
    std::optional<GroundPlace> ahead, left, right;
    bool is_whole = false;  ///< false: the ground within kLevelReach_m is not known completely
};

struct Clearance {
    double height_above_terrain_m = 0;
    ClearanceUncertainty uncertainty;
    GroundPlace nearest;
    double nearest_off_track_rad = 0;  ///< (-pi, pi], positive to the right of the track
    bool nearest_is_whole = false;     ///< false: unknown ground may be nearer
    LevelClearance level;
};

class ClearanceMeter {
public:
    static constexpr double kLevelReach_m = 10'000;

    /// The database must outlive the object.
    explicit ClearanceMeter(const terrain::TerrainDatabase& database);

    /// Nothing where the position is not valid.
    [[nodiscard]] std::optional<OwnShipPlace> place_of(const flight::OwnShipEstimate& own_ship) const;
    /// Height of the own ship above the true surface below; NaN where that is not known.
    [[nodiscard]] double height_above_terrain_m(const OwnShipPlace& own);
    /// The nearest ground in any direction, where the ground below is known.
    [[nodiscard]] std::optional<GroundPlace> nearest(const OwnShipPlace& own);
    [[nodiscard]] ClearanceUncertainty uncertainty_of(const flight::AircraftState& state, base::Time now) const;

    /// Measures all; nothing where the position is not valid or the ground below is not known. Sectors are relative to the track,
    /// or to the heading where the aircraft hardly moves.
    [[nodiscard]] std::optional<Clearance> measure(const flight::AircraftState& state, base::Time now, double heading_rad);

    [[nodiscard]] const terrain::TerrainDatabase& database() const { return database_; }

private:
    [[nodiscard]] LevelClearance level(const OwnShipPlace& own, double track_rad);

    const terrain::TerrainDatabase& database_;
    std::vector<std::uint8_t> memory_;
    base::Arena arena_;
    terrain::HeightQuery heights_;
    NearestGround ground_;
};

}  // namespace tedavis::host_sim
