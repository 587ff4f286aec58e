#include "host_sim/replay/ghost_track.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host_sim/calendar_time.hpp"
#include "host_sim/comparison/alignment.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"
#include "render_core/earth/wgs84.hpp"

namespace tedavis::host_sim {
namespace {

/// As `compare` takes it, so that both align alike.
ComparedRun run_of(const ScannedFlight& flight) {
    ComparedRun run;
    run.folder = flight.log;
    for (const ScannedPlace& place : flight.places) {
        ComparedFrame frame;
        frame.time_s = (place.time - flight.first).to_seconds();
        frame.has_place = true;
        frame.latitude_deg = base::degrees(place.latitude_rad);
        frame.longitude_deg = base::degrees(place.longitude_rad);
        run.frames.push_back(frame);
        if (place.joins_next) continue;
        frame.has_place = false;  // a gap
        frame.time_s += 0.5;
        run.frames.push_back(frame);
    }
    return run;
}

std::optional<base::Time> takeoff_of(const ScannedFlight& flight) {
    const ComparedRun run = run_of(flight);
    const std::optional<std::size_t> frame = takeoff_frame(run);
    if (!frame) return std::nullopt;
    return flight.first + base::Duration::from_seconds(run.frames[*frame].time_s);
}

/// Nothing where there is no such alignment: from the ghost's time to that of the own log.
std::optional<base::Duration> log_shift(const ScannedFlight& own, const ScannedFlight& ghost, GhostAlign align) {
    if (align == GhostAlign::takeoff) {
        const std::optional<base::Time> of_own = takeoff_of(own), of_ghost = takeoff_of(ghost);
        if (!of_own || !of_ghost) return std::nullopt;
        return *of_own - *of_ghost;
    }
    if (own.is_dated != ghost.is_dated) return std::nullopt;
    return own.is_dated ? ghost.ahead - own.ahead : own.first - ghost.first;
}

bool has_leg(const std::vector<ScannedPlace>& places) {
    for (std::size_t n = 0; n + 1 < places.size(); ++n)
        if (places[n].joins_next) return true;
    return false;
}

/// Empty where no leg of it lies within the own log.
std::vector<ScannedPlace> shifted(const ScannedFlight& own, const ScannedFlight& ghost, base::Duration shift) {
    std::vector<ScannedPlace> places = ghost.places;
    for (ScannedPlace& place : places) place.time = place.time + shift;
    bool meets = false;
    for (std::size_t n = 0; n + 1 < places.size(); ++n)
        meets = meets || (places[n].joins_next && places[n].time <= own.last && places[n + 1].time >= own.first);
    return meets ? places : std::vector<ScannedPlace>();
}

/// Between two places of the ghost.
ScannedPlace place_between(const ScannedPlace& from, const ScannedPlace& to, double share, base::Time time) {
    ScannedPlace place = from;
    place.time = time;
    place.latitude_rad += share * (to.latitude_rad - from.latitude_rad);
    place.longitude_rad =
        earth::wrap_longitude(from.longitude_rad + share * earth::wrap_longitude(to.longitude_rad - from.longitude_rad));
    place.height_m += share * (to.height_m - from.height_m);
    place.joins_next = true;
    return place;
}

/// Indices of places, of the frames that run_of() makes of a flight; a gap has that of the place before it.
std::vector<std::size_t> places_of_frames(const ScannedFlight& flight) {
    std::vector<std::size_t> places;
    for (std::size_t n = 0; n < flight.places.size(); ++n) {
        places.push_back(n);
        if (!flight.places[n].joins_next) places.push_back(n);
    }
    return places;
}

/// Empty where the flights are nowhere near one another. A gap in either one, and a stretch where they are not, ends a line.
std::vector<ScannedPlace> beside(const ScannedFlight& own, const ScannedFlight& ghost) {
    const ComparedRun a = run_of(own), b = run_of(ghost);
    if (!has_leg(own.places) || !has_leg(ghost.places)) return {};
    AlignedRuns runs;
    try {
        runs = aligned(a, b, {Alignment::place, kGhostWithin_m});
    } catch (const UserError&) {
        return {};
    }
    const std::vector<std::size_t> of_own = places_of_frames(own), of_ghost = places_of_frames(ghost);
    std::vector<ScannedPlace> places;
    std::size_t usual = std::numeric_limits<std::size_t>::max(), before = 0;
    for (std::size_t n = 1; n < runs.instants.size(); ++n) usual = std::min(usual, runs.instants[n].a - runs.instants[n - 1].a);
    for (const AlignedInstant& instant : runs.instants) {
        const auto first = static_cast<std::size_t>(instant.b);
        const ScannedPlace &from = ghost.places[of_ghost[first]],
                           &to = ghost.places[of_ghost[std::min(first + 1, of_ghost.size() - 1)]];
        const base::Time time = own.places[of_own[instant.a]].time;
        if (!places.empty() && time <= places.back().time) continue;
        if (!places.empty() && instant.a - before > usual) places.back().joins_next = false;
        before = instant.a;
        places.push_back(place_between(from, to, instant.b - static_cast<double>(first), time));
    }
    return places;
}

std::vector<ScannedPlace> places_by(const ScannedFlight& own, const ScannedFlight& ghost, GhostAlign align) {
    if (align == GhostAlign::place) return beside(own, ghost);
    const std::optional<base::Duration> shift = log_shift(own, ghost, align);
    return shift ? shifted(own, ghost, *shift) : std::vector<ScannedPlace>();
}

std::string others_words(const ScannedFlight& own, const ScannedFlight& ghost, GhostAlign align) {
    std::string words;
    for (const GhostAlign other : {GhostAlign::time, GhostAlign::place, GhostAlign::takeoff})
        if (other != align && has_leg(places_by(own, ghost, other)))
            words += (words.empty() ? "" : " or ") + std::string(name_of(other));
    return words.empty() ? "no other --ghost-align aligns them either; name another log"
                         : "--ghost-align " + words + " aligns them";
}

std::string span_words(const ScannedFlight& flight) {
    const auto utc = [&](base::Time time) { return utc_text(time + flight.ahead); };
    return utc(flight.first) + " to " + utc(flight.last);
}

/// Why no moment of the ghost belongs to one of the own flight.
std::string fault_words(const ScannedFlight& own, const ScannedFlight& ghost, GhostAlign align) {
    switch (align) {
        case GhostAlign::place:
            return "it comes nowhere within " + std::to_string(std::lround(kGhostWithin_m)) + " m of " + own.log;
        case GhostAlign::takeoff:
            if (!takeoff_of(own)) return own.log + " shows no take-off";
            if (!takeoff_of(ghost)) return "it shows no take-off";
            return "it has no place while " + own.log + " flies, when both take off together";
        case GhostAlign::time: break;
    }
    if (own.is_dated != ghost.is_dated)
        return (own.is_dated ? "it" : own.log) + " does not know the date, so that the flights share no time";
    std::string words = "it shares no time with " + own.log;
    if (own.is_dated) words += ", which is from " + span_words(own) + ", and it from " + span_words(ghost);
    return words;
}

}  // namespace

GhostTrack ghost_track(const ScannedFlight& own, const ScannedFlight& ghost, GhostAlign align) {
    if (!has_leg(ghost.places))
        throw UserError("--ghost " + ghost.log + ": it has no position; name a log of a flight with positions");
    GhostTrack track{places_by(own, ghost, align), {}};
    if (!has_leg(track.places))
        throw UserError("--ghost " + ghost.log + ": " + fault_words(own, ghost, align) + "; " + others_words(own, ghost, align));
    if (align == GhostAlign::place) return track;
    const base::Duration shift = *log_shift(own, ghost, align);
    const bool knows_utc = own.is_dated && ghost.is_dated;
    track.shift_s = (knows_utc ? shift + own.ahead - ghost.ahead : shift).to_seconds();
    return track;
}

}  // namespace tedavis::host_sim
