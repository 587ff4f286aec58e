/// The moments of a flight that `tedavis sheet gallery` shows. They are defined by phases, so that they exist in any flight with
/// these phases.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render_core/base/time.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::host_sim {

/// The position of a picture in README.md: large at its top, in the row below, or none.
enum class ReadmePlace : std::uint8_t { nowhere, large, row };

struct GalleryMoment {
    const char* group;    ///< heading of the group on the sheet
    const char* name;     ///< of the picture's file, without ".png"
    const char* title;    ///< up to 60 characters
    const char* caption;  ///< a plain sentence
    flight::FlightPhase phase;
    std::size_t turn;  ///< the flight is in this phase's scenario for the turn-th time, from 0
    /// 0 to 1, fraction of the first span of this phase there, or of the whole scenario where no source states the sub-phase.
    double share;
    ReadmePlace readme = ReadmePlace::nowhere;
};
/// In order of the flight; moments of a group follow each other.
[[nodiscard]] const std::vector<GalleryMoment>& gallery_moments();

/// An uninterrupted time in one phase.
struct PhaseSpan {
    flight::FlightPhase phase;
    base::Time begin, end;
};
/// Adds the phase at a time to `spans`; to be called in order of time.
void add_to_spans(flight::FlightPhase phase, base::Time time, std::vector<PhaseSpan>& spans);
/// Returns the time of a moment. Throws UserError with the scenario where the flight is in it fewer times. `log` is the log's
/// name in messages.
[[nodiscard]] base::Time instant_of(const GalleryMoment& moment, const std::vector<PhaseSpan>& spans, const std::string& log);

}  // namespace tedavis::host_sim
