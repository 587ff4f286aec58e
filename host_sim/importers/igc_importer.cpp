#include "host_sim/importers/igc_importer.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <map>
#include <optional>

#include "host_sim/calendar_time.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kBasicFixLength = 35;

/// Columns of an extension of the B record, counted from 1 as the I record states them, both included.
struct Columns {
    std::size_t first = 0, last = 0;
};

std::optional<int> digits(std::string_view text, std::size_t offset, std::size_t count) {
    if (text.size() < offset + count) return std::nullopt;
    int value = 0;
    for (std::size_t i = offset; i < offset + count; ++i) {
        if (std::isdigit(static_cast<unsigned char>(text[i])) == 0) return std::nullopt;
        value = value * 10 + (text[i] - '0');
    }
    return value;
}

/// Five characters, the first may be a minus sign.
std::optional<double> altitude(std::string_view text, std::size_t offset) {
    const bool negative = text[offset] == '-';
    const auto value = digits(text, offset + (negative ? 1 : 0), negative ? 4 : 5);
    if (!value) return std::nullopt;
    return negative ? -static_cast<double>(*value) : static_cast<double>(*value);
}

class IgcReader {
public:
    explicit IgcReader(const std::string& name) : name_(name) {
        file_.format = "IGC";
        file_.flights.resize(1);
    }

    void read_line(std::string_view line) {
        ++line_number_;
        if (line.empty()) return;
        if (line[0] == 'H') read_header(line);
        if (line[0] == 'I') read_extensions(line);
        if (line[0] == 'B') read_fix(line);
    }

    ImportedFile finish() {
        RecordedFlight& flight = file_.flights[0];
        if (flight.fixes.empty()) throw UserError(name_ + ": no usable B record (fix) was found; give an IGC flight");
        drop_absent_altitudes(flight);
        if (!datum_stated_)
            file_.notes.emplace_back(
                "no HFALG record: GNSS heights are taken as above the WGS84 ellipsoid, the rule of the format");
        note(malformed_, "B records are malformed and were skipped");
        note(out_of_order_, "B records step back in time and were skipped");
        note(without_3d_, "fixes have no 3D validity; their GNSS heights were dropped");
        flight.gnss_datum = above_geoid_ ? HeightDatum::msl_egm96 : HeightDatum::wgs84_ellipsoid;
        return std::move(file_);
    }

private:
    void read_header(std::string_view line) {
        const std::string_view key = line.size() >= 5 ? line.substr(2, 3) : std::string_view();
        const std::string_view value = line.size() > 5 ? line.substr(5) : std::string_view();
        if (key == "DTE") read_date(line);
        if (key == "ALG") {
            datum_stated_ = true;
            above_geoid_ = value.find("GEO") != std::string_view::npos || value.find("MSL") != std::string_view::npos;
            gnss_height_present_ = value.find("NIL") == std::string_view::npos;
        }
        if (key == "ALP") {
            pressure_present_ = value.find("NIL") == std::string_view::npos && value.find("MSL") == std::string_view::npos;
        }
        const std::size_t colon = value.find(':');
        if ((key == "GID" || key == "CID") && colon != std::string_view::npos) {
            (key == "GID" ? file_.flights[0].aircraft : file_.flights[0].callsign) = std::string(value.substr(colon + 1));
        }
    }

    /// "HFDTE200319" or "HFDTEDATE:200319,01".
    void read_date(std::string_view line) {
        const std::size_t at = line.find_first_of("0123456789");
        const std::string_view number = at == std::string_view::npos ? std::string_view() : line.substr(at);
        const auto day = digits(number, 0, 2), month = digits(number, 2, 2), year = digits(number, 4, 2);
        const auto midnight = day && month && year ? midnight_of(*year + (*year < 80 ? 2000 : 1900), *month, *day) : std::nullopt;
        if (!midnight) throw UserError(where() + ": the date record is not a date DDMMYY; correct it");
        if (!midnight_) midnight_ = midnight;  // a later one only repeats it or follows midnight, which the fixes show themselves
    }

    void read_extensions(std::string_view line) {
        const auto count = digits(line, 1, 2);
        for (int i = 0; count && i < *count; ++i) {
            const std::size_t offset = 3 + 7 * static_cast<std::size_t>(i);
            const auto first = digits(line, offset, 2), last = digits(line, offset + 2, 2);
            if (!first || !last || line.size() < offset + 7 || *first < 36 || *last < *first) return;
            extensions_[std::string(line.substr(offset + 4, 3))] = {static_cast<std::size_t>(*first),
                                                                    static_cast<std::size_t>(*last)};
        }
    }

    [[nodiscard]] std::optional<int> extension(std::string_view line, const char* code) const {
        const auto found = extensions_.find(code);
        if (found == extensions_.end()) return std::nullopt;
        return digits(line, found->second.first - 1, std::min<std::size_t>(found->second.last - found->second.first + 1, 9));
    }

    /// Degrees of one coordinate: whole degrees, thousandths of minutes, and extra digits where recorded.
    std::optional<double> coordinate(std::string_view line, std::size_t offset, std::size_t degree_digits, const char* extra) {
        const auto whole = digits(line, offset, degree_digits);
        const auto minutes = digits(line, offset + degree_digits, 5);
        const char side = line[offset + degree_digits + 5];
        if (!whole || !minutes || *minutes >= 60'000) return std::nullopt;
        double thousandths = *minutes;
        if (const auto more = extension(line, extra)) {
            double scale = 1;
            for (std::size_t i = extensions_[extra].first; i <= extensions_[extra].last; ++i) scale /= 10;
            thousandths += *more * scale;
        }
        const double value = *whole + thousandths / 60'000.0;
        if (side == 'N' || side == 'E') return value;
        if (side == 'S' || side == 'W') return -value;
        return std::nullopt;
    }

    void read_fix(std::string_view line) {
        if (!midnight_) throw UserError(where() + ": a fix comes before the date record (HFDTE); export the flight again");
        if (line.size() < kBasicFixLength || !append_fix(line)) ++malformed_;
    }

    bool append_fix(std::string_view line) {
        const auto hours = digits(line, 1, 2), minutes = digits(line, 3, 2), seconds = digits(line, 5, 2);
        const auto latitude = coordinate(line, 7, 2, "LAD");
        const auto longitude = coordinate(line, 15, 3, "LOD");
        const char validity = line[24];
        const auto pressure = altitude(line, 25), gnss = altitude(line, 30);
        const bool sane = hours && minutes && seconds && *hours < 24 && *minutes < 60 && *seconds < 60 && latitude && longitude &&
                          *latitude >= -90 && *latitude <= 90 && *longitude >= -180 && *longitude <= 180 &&
                          (validity == 'A' || validity == 'V') && pressure && gnss;
        if (!sane) return false;
        const std::int64_t second_of_day = *hours * 3600 + *minutes * 60 + *seconds;
        if (!advance_clock(second_of_day)) return true;
        RecordedFix fix;
        fix.time = *midnight_ + base::Duration::seconds(day_ * base::kSecondsPerDay + second_of_day);
        fix.latitude_rad = base::radians(*latitude);
        fix.longitude_rad = base::radians(*longitude);
        if (pressure_present_) fix.pressure_altitude_m = pressure;
        if (validity == 'V') ++without_3d_;
        if (gnss_height_present_ && validity == 'A') fix.gnss_height_m = gnss;
        add_extensions(line, fix);
        file_.flights[0].fixes.push_back(fix);
        return true;
    }

    /// False when the fix steps back in time.
    bool advance_clock(std::int64_t second_of_day) {
        if (second_of_day + base::kSecondsPerDay / 2 < last_second_) {
            ++day_;
        } else if (second_of_day < last_second_) {
            ++out_of_order_;
            return false;
        }
        last_second_ = second_of_day;
        return true;
    }

    void add_extensions(std::string_view line, RecordedFix& fix) const {
        if (const auto track = extension(line, "TRT"); track && *track <= 360) fix.true_track_rad = base::radians(*track);
        if (const auto heading = extension(line, "HDT"); heading && *heading <= 360)
            fix.true_heading_rad = base::radians(*heading);
        if (const auto speed = extension(line, "GSP")) {
            const Columns columns = extensions_.at("GSP");  // km/h; digits beyond the third are decimals
            double scale = 1;
            for (std::size_t i = columns.first + 3; i <= columns.last; ++i) scale /= 10;
            fix.ground_speed_mps = *speed * scale / 3.6;
        }
    }

    /// Recorders without a sensor write zeros.
    void drop_absent_altitudes(RecordedFlight& flight) {
        const auto all_zero = [&](auto member) {
            return std::all_of(flight.fixes.begin(), flight.fixes.end(),
                               [&](const RecordedFix& fix) { return !(fix.*member).has_value() || *(fix.*member) == 0.0; });
        };
        for (auto member : {&RecordedFix::pressure_altitude_m, &RecordedFix::gnss_height_m}) {
            if (!all_zero(member)) continue;
            for (RecordedFix& fix : flight.fixes) (fix.*member).reset();
        }
    }

    [[nodiscard]] std::string where() const { return name_ + ":" + std::to_string(line_number_); }
    void note(std::uint64_t count, const char* what) {
        if (count > 0) file_.notes.push_back(std::to_string(count) + " " + what);
    }

    const std::string& name_;
    ImportedFile file_;
    std::uint64_t line_number_ = 0, malformed_ = 0, out_of_order_ = 0, without_3d_ = 0;
    std::optional<base::Time> midnight_;
    std::int64_t day_ = 0, last_second_ = -1;
    bool datum_stated_ = false, above_geoid_ = false, gnss_height_present_ = true, pressure_present_ = true;
    std::map<std::string, Columns> extensions_;
};

}  // namespace

ImportedFile import_igc(std::string_view text, const std::string& name) {
    IgcReader reader(name);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        reader.read_line(line);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return reader.finish();
}

}  // namespace tedavis::host_sim
