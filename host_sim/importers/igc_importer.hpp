/// IGC flight recorder files (FAI, Technical Specification for GNSS Flight Recorders, appendix A: A, H, I and B records).
#pragma once

#include <string>
#include <string_view>

#include "host_sim/importers/recorded_flight.hpp"

namespace tedavis::host_sim {

/// Reads the B records. Fix validity "V" (no 3D fix) keeps the position and drops the GNSS height; a time of day that
/// falls back by more than half a day is the next day; a smaller step back is skipped and counted. GNSS heights are on
/// the WGS84 ellipsoid unless HFALG states GEO (above the geoid) or NIL; pressure altitudes are dropped where HFALP
/// states MSL or NIL, or where every one is 0. Extra digits of LAD and LOD, GSP, TRT and HDT of the I record are used.
/// `name` is how messages call the file. Throws UserError when there is no date or no usable fix.
[[nodiscard]] ImportedFile import_igc(std::string_view text, const std::string& name);

}  // namespace tedavis::host_sim
