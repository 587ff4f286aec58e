#include "host_sim/importers/adsb_json_importer.hpp"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "host_sim/calendar_time.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::json;

Json parse_json(std::string_view text, const std::string& name) {
    try {
        return Json::parse(text);
    } catch (const Json::parse_error& error) {
        throw UserError(name + ": no valid JSON from byte " + std::to_string(error.byte) + " on; fetch or export the file again");
    } catch (const Json::exception& error) {
        throw UserError(name + ": holds a value that cannot be read (" + error.what() + "); fetch or export the file again");
    }
}

/// One row of either layout. Columns of a column table are sparse: a row may lack in some.
class Row {
public:
    explicit Row(const Json& record) : record_(&record) {}
    Row(const Json& table, std::string key) : table_(&table), key_(std::move(key)) {}

    [[nodiscard]] const Json* find(const char* column) const {
        const Json& place = record_ != nullptr ? *record_ : *table_;
        const auto found = place.find(column);
        if (found == place.end()) return nullptr;
        if (record_ != nullptr) return found->is_null() ? nullptr : &*found;
        const auto cell = found->find(key_);
        return cell == found->end() || cell->is_null() ? nullptr : &*cell;
    }
    [[nodiscard]] std::optional<double> number(const char* column) const {
        const Json* cell = find(column);
        if (cell == nullptr || !cell->is_number()) return std::nullopt;
        const double value = cell->get<double>();
        return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
    }
    [[nodiscard]] std::optional<double> scaled(const char* column, double factor) const {
        const auto value = number(column);
        return value ? std::optional<double>(*value * factor) : std::nullopt;
    }
    [[nodiscard]] std::string text(const char* column) const {
        const Json* cell = find(column);
        return cell != nullptr && cell->is_string() ? cell->get<std::string>() : std::string();
    }
    /// Milliseconds where the number is too large for seconds, else seconds, else ISO 8601; none beyond the year 2191.
    [[nodiscard]] std::optional<base::Time> time(const char* column) const {
        const Json* cell = find(column);
        if (cell == nullptr) return std::nullopt;
        if (cell->is_string()) return parse_iso8601(cell->get<std::string>());
        const auto value = number(column);
        constexpr double kMaxSeconds = 7e9;
        if (!value || *value < 0 || *value > kMaxSeconds * 1000) return std::nullopt;
        const double unit_ns = *value <= kMaxSeconds ? 1e9 : 1e6, whole = std::floor(*value);
        return base::Time{static_cast<std::int64_t>(whole) * static_cast<std::int64_t>(unit_ns) +
                          std::llround((*value - whole) * unit_ns)};
    }

private:
    const Json* record_ = nullptr;
    const Json* table_ = nullptr;
    std::string key_;
};

std::vector<Row> rows_of(const Json& document, const std::string& name) {
    std::vector<Row> rows;
    if (document.is_array()) {
        for (const Json& record : document) {
            if (!record.is_object())
                throw UserError(name + ": entry " + std::to_string(rows.size()) +
                                " of the list is no record; give a list of objects");
            rows.emplace_back(record);
        }
        return rows;
    }
    const auto timestamps = document.find("timestamp");
    if (!document.is_object() || timestamps == document.end() || !timestamps->is_object()) {
        throw UserError(name +
                        ": neither a list of records nor a table of columns with `timestamp`; lay it out as "
                        "host_sim/importers/README.md describes under \"ADS-B tables\"");
    }
    for (const auto& item : timestamps->items()) rows.emplace_back(document, item.key());
    return rows;
}

struct RowCounts {
    std::size_t without_position = 0, without_time = 0, repeated = 0;
};

RecordedFix fix_of(const Row& row, base::Time time) {
    RecordedFix fix;
    fix.time = time;
    fix.latitude_rad = base::radians(row.number("latitude").value_or(0));
    fix.longitude_rad = base::radians(row.number("longitude").value_or(0));
    fix.gnss_height_m = row.scaled("geoaltitude", base::kMetresPerFoot);
    fix.pressure_altitude_m = row.scaled("altitude", base::kMetresPerFoot);
    fix.ground_speed_mps = row.scaled("groundspeed", base::kMpsPerKnot);
    fix.true_track_rad = row.scaled("track", base::kRadiansPerDegree);
    fix.true_heading_rad = row.scaled("heading", base::kRadiansPerDegree);
    fix.pitch_rad = row.scaled("pitch", base::kRadiansPerDegree);
    fix.roll_rad = row.scaled("roll", base::kRadiansPerDegree);
    fix.vertical_speed_mps = row.scaled("vertical_rate", base::kMpsPerFootPerMinute);
    if (const Json* ground = row.find("onground"); ground != nullptr && ground->is_boolean()) fix.on_ground = ground->get<bool>();
    return fix;
}

bool has_position(const Row& row) {
    const auto latitude = row.number("latitude"), longitude = row.number("longitude");
    return latitude && longitude && std::abs(*latitude) <= 90 && std::abs(*longitude) <= 180;
}

/// A receiver repeats the last position until the next one comes; `last_position` tells when it was really received.
void append_row(const Row& row, RecordedFlight& flight, RowCounts& counts) {
    const auto time = row.time("last_position").has_value() ? row.time("last_position") : row.time("timestamp");
    if (!time) {
        ++counts.without_time;
    } else if (!flight.fixes.empty() && flight.fixes.back().time == *time) {
        ++counts.repeated;
    } else {
        flight.fixes.push_back(fix_of(row, *time));
    }
}

}  // namespace

ImportedFile import_adsb_json(std::string_view text, const std::string& name) {
    const Json document = parse_json(text, name);
    ImportedFile file;
    file.format = "ADS-B JSON";
    RowCounts counts;
    std::map<std::string, std::size_t> place_of;
    for (const Row& row : rows_of(document, name)) {
        if (!has_position(row)) {
            ++counts.without_position;
            continue;
        }
        const std::string aircraft = row.text("icao24");
        const auto [place, is_new] = place_of.emplace(aircraft, file.flights.size());
        if (is_new) file.flights.push_back({aircraft, row.text("callsign"), HeightDatum::wgs84_ellipsoid, {}});
        RecordedFlight& flight = file.flights[place->second];
        if (flight.callsign.empty()) flight.callsign = row.text("callsign");
        append_row(row, flight, counts);
    }
    if (file.flights.empty()) {
        throw UserError(name + ": none of its " + std::to_string(counts.without_position) +
                        " rows has a latitude and a longitude; give a recording with positions");
    }
    const auto note = [&](std::size_t count, const char* what) {
        if (count > 0) file.notes.push_back(std::to_string(count) + " " + what);
    };
    note(counts.without_position, "rows have no position and were skipped");
    note(counts.without_time, "rows have no time and were skipped");
    note(counts.repeated, "rows repeat the position of the row before and were skipped");
    return file;
}

}  // namespace tedavis::host_sim
