#include "host_sim/replay/terrain_span.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/clearance/clearance.hpp"
#include "host_sim/reports/frame_record_json.hpp"
#include "host_sim/reports/geo_extent.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kSpansNamed = 8;
constexpr double kNear_deg = 0.02;  // what the filter of positions may add

GeoExtent extent_of_places(const std::vector<OutlinePlace>& places) {
    GeoExtent extent;
    for (const OutlinePlace& place : places)
        extent.include(base::degrees(place.latitude_rad), base::degrees(place.longitude_rad));
    return extent;
}

std::string never_over(const std::string& name, const std::vector<OutlinePlace>& asked, const terrain::TerrainDatabase& database,
                       const std::string& how = "is never over it") {
    if (asked.empty()) return name + ": no position of the flight is known; leave out --over-terrain";
    return name + ": the flight " + how + ": it covers " + extent_of(database).words() + ", the flight " +
           extent_of_places(asked).words() + "; give terrain of that region";
}

/// Of two fixes and the curve between them, which may lead round by as much again.
GeoExtent around(const OutlinePlace& a, const OutlinePlace& b) {
    GeoExtent box = extent_of_places({a, b});
    const double high_deg = box.north_deg - box.south_deg + kNear_deg, wide_deg = box.east_deg - box.west_deg + kNear_deg;
    return {box.south_deg - high_deg, box.north_deg + high_deg, box.west_deg - wide_deg, box.east_deg + wide_deg};
}

/// From the first to the last place of each span with known ground below; a span without one goes.
TimeRanges with_known_ground(const TimeRanges& spans, const std::vector<OutlinePlace>& places,
                             const terrain::TerrainDatabase& database) {
    ClearanceMeter meter(database);
    TimeRanges known;
    for (const TimeRange& span : spans) {
        const std::size_t before = known.size();
        for (const OutlinePlace& place : places) {
            if (place.time < span.from || place.time > span.to) continue;
            const OwnShipPlace own{{place.latitude_rad, place.longitude_rad, {}}, 0, true};
            if (std::isnan(meter.height_above_terrain_m(own))) continue;
            if (known.size() == before) known.push_back({place.time, place.time});
            known.back().to = place.time;
        }
    }
    return known;
}

}  // namespace

TimeRanges spans_over(const std::vector<OutlinePlace>& places, const terrain::Lattice& lattice) {
    TimeRanges spans;
    bool was_inside = false;
    for (const OutlinePlace& place : places) {
        const bool is_inside = lattice.point(place.latitude_rad, place.longitude_rad).inside;
        if (is_inside && !was_inside) spans.push_back({place.time, place.time});
        if (is_inside) spans.back().to = place.time;
        was_inside = is_inside;
    }
    return spans;
}

TimeRanges terrain_spans(const ReplayOptions& options, const FlightOutline& outline, base::Time first,
                         const terrain::TerrainDatabase* database) {
    if (database == nullptr) throw UserError("--over-terrain: there is no terrain; name a database with --terrain");
    std::vector<OutlinePlace> asked;
    for (const OutlinePlace& place : outline.places()) {
        const double time_s = (place.time - first).to_seconds();
        if (time_s >= options.from_s.value_or(time_s) && time_s <= options.to_s.value_or(time_s)) asked.push_back(place);
    }
    const TimeRanges inside = spans_over(asked, database->lattice());
    if (asked.empty() && (options.from_s || options.to_s))
        throw UserError(options.picture.terrain +
                        ": no position of the flight is known between --from and --to; choose other times");
    if (inside.empty()) throw UserError(never_over(options.picture.terrain, asked, *database));
    TimeRanges spans = with_known_ground(inside, asked, *database);
    if (spans.empty())
        throw UserError(never_over(options.picture.terrain, asked, *database, "is over it only where it has no heights"));
    return spans;
}

void require_near_terrain(const std::vector<OutlinePlace>& fixes, const std::string& name,
                          const terrain::TerrainDatabase& database) {
    const GeoExtent ground = extent_of(database);
    if (ground.east_deg > 180 || ground.west_deg < -180) return;  // places have two names there
    for (std::size_t n = 0; n < fixes.size(); ++n)
        if (!are_apart(around(fixes[n > 0 ? n - 1 : 0], fixes[n]), ground, 0)) return;
    throw UserError(never_over(name, fixes, database));
}

std::string words_of_spans(const TimeRanges& spans, base::Time first, const std::string& terrain) {
    std::string words = "frames are drawn where the flight is over " + terrain + ": ";
    const std::size_t named = std::min(spans.size(), kSpansNamed);
    for (std::size_t n = 0; n < named; ++n)
        words += (n > 0 ? ", " : "") + decimal((spans[n].from - first).to_seconds(), 1) + " - " +
                 decimal((spans[n].to - first).to_seconds(), 1) + " s";
    if (named < spans.size())
        words += ", and " + counted(spans.size() - named, "further span") + ", the last until " +
                 decimal((spans.back().to - first).to_seconds(), 1) + " s";
    return words;
}

}  // namespace tedavis::host_sim
