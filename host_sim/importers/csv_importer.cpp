#include "host_sim/importers/csv_importer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "host_sim/calendar_time.hpp"
#include "host_sim/csv_cells.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

enum class Column {
    time,
    latitude,
    longitude,
    height_ellipsoid,
    height_msl,
    pressure_altitude,
    ground_speed,
    track,
    vertical_speed,
    pitch,
    roll,
    heading,
    on_ground,
    aircraft,
    ignored
};

const std::map<std::string_view, Column> kColumns = {{"time", Column::time},
                                                     {"latitude_deg", Column::latitude},
                                                     {"longitude_deg", Column::longitude},
                                                     {"height_ellipsoid_m", Column::height_ellipsoid},
                                                     {"height_msl_m", Column::height_msl},
                                                     {"pressure_altitude_m", Column::pressure_altitude},
                                                     {"ground_speed_mps", Column::ground_speed},
                                                     {"track_deg", Column::track},
                                                     {"vertical_speed_mps", Column::vertical_speed},
                                                     {"pitch_deg", Column::pitch},
                                                     {"roll_deg", Column::roll},
                                                     {"heading_deg", Column::heading},
                                                     {"on_ground", Column::on_ground},
                                                     {"aircraft", Column::aircraft}};

std::string name_of(Column column) {
    const auto found = std::find_if(kColumns.begin(), kColumns.end(), [&](const auto& entry) { return entry.second == column; });
    return found == kColumns.end() ? "this column" : std::string(found->first);
}

/// What no aircraft exceeds in either direction, in the column's unit.
double largest_of(Column column) {
    switch (column) {
        case Column::height_ellipsoid:
        case Column::height_msl:
        case Column::pressure_altitude: return 100'000;
        case Column::ground_speed: return 2000;
        case Column::vertical_speed: return 1000;
        case Column::pitch: return 90;
        case Column::on_ground: return 1;
        default: return 360;
    }
}

class CsvReader {
public:
    explicit CsvReader(const std::string& name) : name_(name) { file_.format = "CSV"; }

    void read_line(std::string_view line) {
        ++line_number_;
        line = trimmed_cell(line);
        if (line.empty() || line.front() == '#') return;
        if (columns_.empty()) {
            read_names(csv_cells(line));
        } else {
            read_row(csv_cells(line));
        }
    }

    ImportedFile finish() {
        if (file_.flights.empty())
            throw UserError(name_ +
                            ": no row with a fix was found; give it the columns that host_sim/importers/README.md lists under "
                            "\"Flights as CSV\"");
        return std::move(file_);
    }

private:
    void read_names(const std::vector<std::string_view>& names) {
        std::string ignored;
        for (const std::string_view column_name : names) {
            const auto found = kColumns.find(column_name);
            columns_.push_back(found == kColumns.end() ? Column::ignored : found->second);
            if (found == kColumns.end()) ignored += (ignored.empty() ? "" : ", ") + std::string(column_name);
        }
        for (const auto& [column_name, column] : kColumns) {
            const auto count = std::count(columns_.begin(), columns_.end(), column);
            const bool required = column == Column::time || column == Column::latitude || column == Column::longitude;
            if (count > 1) refuse("the column `" + std::string(column_name) + "` stands twice; keep one");
            if (required && count == 0)
                refuse("the column `" + std::string(column_name) +
                       "` is missing from the first line; name the columns as host_sim/importers/README.md lists them under "
                       "\"Flights as CSV\"");
        }
        if (has(Column::height_ellipsoid) && has(Column::height_msl))
            refuse("both `height_ellipsoid_m` and `height_msl_m` are given; keep the one that was measured");
        if (!ignored.empty()) file_.notes.push_back("columns that are not known were ignored: " + ignored);
    }

    void read_row(const std::vector<std::string_view>& cells) {
        if (cells.size() != columns_.size()) {
            refuse(std::to_string(cells.size()) + " cells, but the first line names " + std::to_string(columns_.size()) +
                   " columns; correct the row");
        }
        RecordedFix fix;
        std::string aircraft;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            if (columns_[i] == Column::aircraft) aircraft = std::string(cells[i]);
            if (columns_[i] == Column::time) fix.time = time_in(cells[i]);
            if (columns_[i] == Column::latitude) fix.latitude_rad = base::radians(required(cells[i], "latitude_deg", 90));
            if (columns_[i] == Column::longitude) fix.longitude_rad = base::radians(required(cells[i], "longitude_deg", 180));
            read_optional(columns_[i], cells[i], fix);
        }
        flight_of(aircraft).fixes.push_back(fix);
    }

    void read_optional(Column column, std::string_view cell, RecordedFix& fix) {
        if (cell.empty() || column == Column::aircraft || column == Column::ignored || column == Column::time) return;
        const double value = required(cell, name_of(column), largest_of(column));
        switch (column) {
            case Column::height_ellipsoid:
            case Column::height_msl: fix.gnss_height_m = value; break;
            case Column::pressure_altitude: fix.pressure_altitude_m = value; break;
            case Column::ground_speed: fix.ground_speed_mps = value; break;
            case Column::track: fix.true_track_rad = base::radians(value); break;
            case Column::vertical_speed: fix.vertical_speed_mps = value; break;
            case Column::pitch: fix.pitch_rad = base::radians(value); break;
            case Column::roll: fix.roll_rad = base::radians(value); break;
            case Column::heading: fix.true_heading_rad = base::radians(value); break;
            case Column::on_ground: fix.on_ground = value != 0; break;
            default: break;
        }
    }

    double required(std::string_view cell, const std::string& what, double limit) {
        const auto value = number_in(cell);
        if (!value) refuse("'" + std::string(cell) + "' is no number for " + what + "; correct it");
        if (std::abs(*value) > limit) refuse("'" + std::string(cell) + "' is out of range for " + what + "; correct it");
        return *value;
    }

    base::Time time_in(std::string_view cell) {
        if (const auto iso = parse_iso8601(cell)) return *iso;
        const auto seconds = parse_unix_seconds(cell);
        if (!seconds) refuse("'" + std::string(cell) + "' is no time; give seconds since 1970 UTC or ISO 8601");
        return *seconds;
    }

    RecordedFlight& flight_of(const std::string& aircraft) {
        for (RecordedFlight& flight : file_.flights) {
            if (flight.aircraft == aircraft) return flight;
        }
        const HeightDatum datum = has(Column::height_msl) ? HeightDatum::msl_egm96 : HeightDatum::wgs84_ellipsoid;
        file_.flights.push_back({aircraft, "", datum, {}});
        return file_.flights.back();
    }

    [[nodiscard]] bool has(Column column) const { return std::find(columns_.begin(), columns_.end(), column) != columns_.end(); }
    [[noreturn]] void refuse(const std::string& what) const {
        throw UserError(name_ + ":" + std::to_string(line_number_) + ": " + what);
    }

    const std::string& name_;
    ImportedFile file_;
    std::vector<Column> columns_;
    std::uint64_t line_number_ = 0;
};

}  // namespace

ImportedFile import_csv(std::string_view text, const std::string& name) {
    CsvReader reader(name);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        reader.read_line(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return reader.finish();
}

}  // namespace tedavis::host_sim
