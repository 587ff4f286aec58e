#include "host_sim/scene_builder/flight_source.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <limits>

#include "host_sim/geoid_egm96.hpp"
#include "host_sim/importers/fix_cleaner.hpp"
#include "host_sim/importers/flight_importer.hpp"
#include "host_sim/importers/resampled_flight.hpp"
#include "host_sim/name_choices.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using flight::Signal;

constexpr double kNotStated = std::numeric_limits<double>::quiet_NaN();

bool is_named(const std::string& name, const std::string& asked) {
    return std::equal(name.begin(), name.end(), asked.begin(), asked.end(),
                      [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
}

/// Fifteen digits, which places and seconds since 1970 need.
std::string written(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.15g", number);
    return text;
}

class FlightReader {
public:
    FlightReader(const std::string& path, std::string aircraft)
        : path_(path), aircraft_(std::move(aircraft)), geoid_(GeoidEgm96::installed()) {}

    SourceFeatures read() {
        ImportedFile file = import_flight_file(path_);
        found_.notes = std::move(file.notes);
        std::vector<std::string> names;
        for (RecordedFlight& flight : file.flights) {
            names.push_back(flight.aircraft.empty() ? "one without a name" : flight.aircraft);
            if (!flight.callsign.empty()) names.back() += " (" + flight.callsign + ")";
            if (aircraft_.empty() || is_named(flight.aircraft, aircraft_) || is_named(flight.callsign, aircraft_))
                add(std::move(flight));
        }
        if (found_.features.empty())
            throw UserError(path_ + ": no aircraft '" + aircraft_ + "'; it holds " + name_choices(names) +
                            "; name one in 'aircraft'" + look_hint(path_));
        return std::move(found_);
    }

private:
    struct Sample {
        double height_m = kNotStated, ground_speed_mps = kNotStated, vertical_speed_mps = kNotStated, track_rad = kNotStated;
    };

    void note(const RecordedFlight& flight, const std::string& message) {
        const std::string& name = flight.callsign.empty() ? flight.aircraft : flight.callsign;
        found_.notes.push_back((name.empty() ? "" : name + ": ") + message);
    }

    void add(RecordedFlight flight) {
        add_cleaning_note(flight, clean_fixes(flight));
        std::optional<ResampledFlight> resampled;
        ResampleSettings settings;
        settings.assume_geometric = true;
        const double gap_s = gap_limit_s(flight);
        const auto is_joined = [&](const RecordedFix& from, const RecordedFix& to) {
            return (to.time - from.time).to_seconds() <= gap_s;
        };
        const auto joined = std::adjacent_find(flight.fixes.begin(), flight.fixes.end(), is_joined);
        if (joined != flight.fixes.end()) resampled.emplace(flight, settings, geoid_, path_);
        std::size_t first = 0, lines = 0;
        for (std::size_t n = 1; n <= flight.fixes.size(); ++n) {
            const bool ends = n == flight.fixes.size();
            if (!ends && is_joined(flight.fixes[n - 1], flight.fixes[n])) continue;
            add_line(flight, resampled, first, n);
            ++lines;
            first = n;
        }
        found_.features.back().fields["is_latest"] = "1";
        if (lines > 1)
            note(flight,
                 std::to_string(lines - 1) + (lines > 2 ? " gaps" : " gap") + " in the recording; nothing is shown there");
        add_heights_note(flight);
    }
    void add_cleaning_note(const RecordedFlight& flight, const CleaningCounts& counts) {
        const auto add_count_note = [&](std::size_t count, const char* what) {
            if (count > 0) note(flight, std::to_string(count) + " " + what);
        };
        add_count_note(counts.out_of_order, "fixes were earlier than the one before and have been sorted");
        add_count_note(counts.duplicates, "fixes had the time of another one and are left out");
        add_count_note(counts.position_jumps, "positions are impossible and are left out");
        add_count_note(counts.gnss_height_jumps + counts.pressure_jumps, "heights are impossible and are interpolated");
    }
    void add_heights_note(const RecordedFlight& flight) {
        const auto has = [&flight](std::optional<double> RecordedFix::*height) {
            return std::any_of(flight.fixes.begin(), flight.fixes.end(),
                               [height](const RecordedFix& fix) { return (fix.*height).has_value(); });
        };
        if (has(&RecordedFix::gnss_height_m)) return;
        note(flight, has(&RecordedFix::pressure_altitude_m)
                         ? "it has no GNSS heights; its pressure altitudes are taken for heights above sea level"
                         : "it has no heights and is shown on the ground");
    }

    void add_line(const RecordedFlight& flight, const std::optional<ResampledFlight>& resampled, std::size_t first,
                  std::size_t end) {
        std::vector<Sample> samples;
        for (std::size_t n = first; n < end; ++n) samples.push_back(sample_of(flight, flight.fixes[n], resampled));
        close_heights(flight, samples, first);
        SourceFeature line;
        line.shape = scene::LayerShape::lines;
        for (std::size_t n = 0; n < samples.size(); ++n) {
            const RecordedFix& fix = flight.fixes[first + n];
            SourcePoint point{base::degrees(fix.latitude_rad), base::degrees(fix.longitude_rad), {}, fix.time.ns};
            if (!std::isnan(samples[n].height_m)) point.height_m = samples[n].height_m;
            line.points.push_back(point);
            line.point_values["ground_speed"].push_back(samples[n].ground_speed_mps);
            line.point_values["vertical_speed"].push_back(samples[n].vertical_speed_mps);
            line.point_values["track"].push_back(samples[n].track_rad);
        }
        set_fields(flight, samples.back(), line);
        found_.features.push_back(std::move(line));
    }
    [[nodiscard]] Sample sample_of(const RecordedFlight& flight, const RecordedFix& fix,
                                   const std::optional<ResampledFlight>& resampled) const {
        if (resampled)
            if (const std::optional<SignalSample> at = resampled->at(fix.time))
                return {(*at)[Signal::true_altitude], (*at)[Signal::ground_speed], (*at)[Signal::vertical_speed],
                        (*at)[Signal::true_track]};
        return {height_of(flight, fix), fix.ground_speed_mps.value_or(kNotStated), fix.vertical_speed_mps.value_or(kNotStated),
                fix.true_track_rad.value_or(kNotStated)};
    }
    /// Of a fix that stands alone.
    [[nodiscard]] double height_of(const RecordedFlight& flight, const RecordedFix& fix) const {
        if (!fix.gnss_height_m) return fix.pressure_altitude_m.value_or(kNotStated);
        if (flight.gnss_datum == HeightDatum::msl_egm96) return *fix.gnss_height_m;
        return *fix.gnss_height_m - fix.geoid_separation_m.value_or(geoid_.undulation(fix.latitude_rad, fix.longitude_rad).m);
    }
    /// A point without a height would lie on the ground: it gets one between those of its neighbours in time.
    void close_heights(const RecordedFlight& flight, std::vector<Sample>& samples, std::size_t first) const {
        const auto time_s = [&](std::size_t n) { return (flight.fixes[first + n].time - flight.fixes[first].time).to_seconds(); };
        std::optional<std::size_t> before;
        for (std::size_t n = 0; n < samples.size(); ++n) {
            if (std::isnan(samples[n].height_m)) continue;
            for (std::size_t gap = before ? *before + 1 : 0; gap < n; ++gap) {
                const double share = before ? (time_s(gap) - time_s(*before)) / (time_s(n) - time_s(*before)) : 1;
                const double from_m = before ? samples[*before].height_m : samples[n].height_m;
                samples[gap].height_m = from_m + share * (samples[n].height_m - from_m);
            }
            before = n;
        }
        if (!before) return;
        for (std::size_t n = *before + 1; n < samples.size(); ++n) samples[n].height_m = samples[*before].height_m;
    }

    static void set_fields(const RecordedFlight& flight, const Sample& last, SourceFeature& line) {
        const auto set = [&line](const char* name, double number) {
            if (!std::isnan(number)) line.fields[name] = written(number);
        };
        const SourcePoint& point = line.points.back();
        if (!flight.aircraft.empty()) line.fields["aircraft"] = flight.aircraft;
        if (!flight.callsign.empty()) line.fields["callsign"] = flight.callsign;
        const std::string& name = flight.callsign.empty() ? flight.aircraft : flight.callsign;
        if (!name.empty()) line.fields["name"] = name;
        set("last_time", static_cast<double>(*point.time_ns / 1'000'000) / 1e3);  // NOLINT(bugprone-integer-division)
        set("last_latitude_deg", point.latitude_deg);
        set("last_longitude_deg", point.longitude_deg);
        set("last_height", last.height_m);
        set("last_ground_speed", last.ground_speed_mps);
        set("last_vertical_speed", last.vertical_speed_mps);
        set("last_track", last.track_rad);
        line.fields["is_latest"] = "0";
    }

    const std::string path_, aircraft_;
    const GeoidEgm96 geoid_;
    SourceFeatures found_;
};

AttributeRecipe quantity(const char* name, const char* title, const char* unit) {
    AttributeRecipe recipe;
    recipe.name = recipe.variable = name;
    recipe.title = title;
    recipe.unit = unit;
    return recipe;
}

}  // namespace

SourceFeatures read_flight_file(const std::string& path, const std::string& aircraft) {
    return FlightReader(path, aircraft).read();
}

std::vector<AttributeRecipe> usual_attributes_of_flights() {
    return {quantity("ground_speed", "GROUND SPEED", "m/s"), quantity("vertical_speed", "VERTICAL SPEED", "m/s"),
            quantity("track", "TRACK", "rad")};
}

}  // namespace tedavis::host_sim
