/// The moments of a flight that `tedavis sheet gallery` shows, named by phases, so that they hold for any flight that has these.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render_core/base/time.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::host_sim {

/// Where README.md shows a picture: large at its top, in the row below, or not.
enum class ReadmePlace : std::uint8_t { nowhere, large, row };

struct GalleryMoment {
    const char* group;    ///< on the sheet
    const char* name;     ///< of the picture's file, without ".png"
    const char* title;    ///< up to 60 characters
    const char* caption;  ///< a plain sentence
    flight::FlightPhase phase;
    std::size_t turn;  ///< the flight is in this phase's scenario for the turn-th time, from 0
    double share;      ///< 0 to 1, of the phase's first time there; of the whole scenario where no source states the sub-phase
    ReadmePlace readme = ReadmePlace::nowhere;
};
/// In order of the flight; moments of a group follow each other.
[[nodiscard]] const std::vector<GalleryMoment>& gallery_moments();

/// A time without interruption in one phase.
struct PhaseSpan {
    flight::FlightPhase phase;
    base::Time begin, end;
};
/// Joins what was seen last to `spans`; call in order of time.
void add_to_spans(flight::FlightPhase phase, base::Time time, std::vector<PhaseSpan>& spans);
/// Throws UserError that names the scenario where the flight is not in it so often. `log`: as messages call it.
[[nodiscard]] base::Time instant_of(const GalleryMoment& moment, const std::vector<PhaseSpan>& spans, const std::string& log);

}  // namespace tedavis::host_sim
