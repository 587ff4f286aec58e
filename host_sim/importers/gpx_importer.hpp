/// GPX 1.1 tracks (Topografix GPX 1.1 schema; `speed` and `course` of 1.0 are read too).
#pragma once

#include <string>
#include <string_view>

#include "host_sim/importers/recorded_flight.hpp"

namespace tedavis::host_sim {

/// One flight per `trk`, named after its `name` or its number from 1. `ele` is height above mean sea level (EGM96);
/// with `geoidheight` the recorder's own separation is used. Points without a time are counted and skipped. Throws
/// UserError when the text is no GPX or holds no timed track point.
[[nodiscard]] ImportedFile import_gpx(std::string_view text, const std::string& name);

}  // namespace tedavis::host_sim
