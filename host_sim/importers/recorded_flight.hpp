/// A recorded flight: fixes with the values of the file, without derived or resampled ones.
///
/// SI and radians. An absent value is an empty optional, never a special number.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render_core/base/time.hpp"

namespace tedavis::host_sim {

enum class HeightDatum : std::uint8_t { wgs84_ellipsoid, msl_egm96 };

struct RecordedFix {
    base::Time time;  ///< since the Unix epoch, UTC
    double latitude_rad = 0;
    double longitude_rad = 0;
    std::optional<double> gnss_height_m;        ///< in the flight's `gnss_datum`
    std::optional<double> geoid_separation_m;   ///< geoid above ellipsoid, where the recorder states its own
    std::optional<double> pressure_altitude_m;  ///< at 1013.25 hPa
    std::optional<double> ground_speed_mps;
    std::optional<double> true_track_rad;
    std::optional<double> vertical_speed_mps;
    std::optional<double> pitch_rad;
    std::optional<double> roll_rad;
    std::optional<double> true_heading_rad;
    std::optional<bool> on_ground;
};

struct RecordedFlight {
    std::string aircraft;  ///< identity as the file states it; may be empty
    std::string callsign;  ///< second name by which the user may choose it
    HeightDatum gnss_datum = HeightDatum::wgs84_ellipsoid;
    std::vector<RecordedFix> fixes;
};

/// The result of an importer: one flight per aircraft, and notes for the user (what was skipped and why).
struct ImportedFile {
    std::string format;  ///< "IGC", "GPX", "ADS-B JSON", "CSV"
    std::vector<RecordedFlight> flights;
    std::vector<std::string> notes;
};

}  // namespace tedavis::host_sim
