#include "host_sim/window/camera_tour.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <vector>

#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using base::radians;

enum Column : std::size_t { kTime, kLatitude, kLongitude, kAltitude, kHeading, kPitch, kRoll, kColumns };
using Row = std::array<double, kColumns>;

struct Range {
    const char* name;
    double low, high;
};
constexpr std::array<Range, kColumns> kRanges = {{{"time_s", 0, 1e9},
                                                  {"latitude_deg", -90, 90},
                                                  {"longitude_deg", -180, 180},
                                                  {"altitude_m", -1000, 100'000},
                                                  {"heading_deg", 0, 360},
                                                  {"pitch_deg", -90, 90},
                                                  {"roll_deg", -180, 180}}};
constexpr std::string_view kHeader = "time_s,latitude_deg,longitude_deg,altitude_m,heading_deg,pitch_deg,roll_deg";
constexpr std::size_t kMaxPoints = 1'000'000;

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

class TourReader {
public:
    explicit TourReader(const std::string& name) : name_(name) {}

    void read_line(std::string_view line) {
        ++line_number_;
        line = trimmed(line);
        if (line.empty() || line.front() == '#') return;
        if (header_seen_) return read_row(line);
        if (line != kHeader) refuse("the first line does not name the columns; write '" + std::string(kHeader) + "'");
        header_seen_ = true;
    }
    [[nodiscard]] std::vector<Row> finish() {
        if (rows_.empty()) refuse("no point is in the tour; write the line '" + std::string(kHeader) + "' and points below it");
        return std::move(rows_);
    }

private:
    void read_row(std::string_view line) {
        Row row{};
        for (std::size_t column = 0; column < kColumns; ++column) {
            const std::size_t comma = line.find(',');
            if ((comma == std::string_view::npos) != (column + 1 == kColumns))
                refuse("not 7 values between commas; correct the row");
            row[column] = number(trimmed(line.substr(0, comma)), kRanges[column]);
            line.remove_prefix(comma == std::string_view::npos ? line.size() : comma + 1);
        }
        if (!rows_.empty() && !(row[kTime] > rows_.back()[kTime])) refuse("time_s does not rise; sort the points by time");
        if (rows_.size() == kMaxPoints) refuse("more than 1,000,000 points; thin the tour");
        rows_.push_back(row);
    }
    [[nodiscard]] double number(std::string_view cell, const Range& range) const {
        double value = 0;
        const auto [end, fault] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
        if (fault == std::errc() && end == cell.data() + cell.size() && value >= range.low && value <= range.high) return value;
        char limits[80];
        std::snprintf(limits, sizeof limits, " from %.10g to %.10g", range.low, range.high);
        refuse(std::string(range.name) + " '" + std::string(cell.substr(0, 40)) + "' is not a number" + limits + "; correct it");
    }
    [[noreturn]] void refuse(const std::string& what) const {
        throw UserError(name_ + ":" + std::to_string(line_number_) + ": " + what);
    }

    const std::string& name_;
    std::vector<Row> rows_;
    std::uint64_t line_number_ = 0;
    bool header_seen_ = false;
};

std::vector<Row> rows_of(std::string_view text, const std::string& name) {
    TourReader reader(name);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        reader.read_line(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return reader.finish();
}

/// Angles without their jumps at +-180 degrees or at north, so that a curve through them takes the shorter way.
std::vector<double> unwrapped(const std::vector<Row>& rows, Column column) {
    std::vector<double> angles;
    for (const Row& row : rows) {
        const double angle = radians(row[column]);
        angles.push_back(angles.empty() ? angle : angles.back() + earth::angle_difference(angle, angles.back()));
    }
    return angles;
}

}  // namespace

CameraTour::CameraTour(std::string_view text, const std::string& name, const UndulationAt& undulation) {
    const std::vector<Row> rows = rows_of(text, name);
    std::vector<double> times, latitudes, heights, pitches;
    for (const Row& row : rows) {
        times.push_back(row[kTime]);
        latitudes.push_back(radians(row[kLatitude]));
        pitches.push_back(radians(row[kPitch]));
        const earth::GeoidUndulation geoid = undulation(latitudes.back(), earth::wrap_longitude(radians(row[kLongitude])));
        heights.push_back(earth::to_ellipsoid({row[kAltitude]}, geoid).m);
    }
    latitude_ = MonotoneCurve(times, latitudes);
    longitude_ = MonotoneCurve(times, unwrapped(rows, kLongitude));
    height_ = MonotoneCurve(times, heights);
    heading_ = MonotoneCurve(times, unwrapped(rows, kHeading));
    pitch_ = MonotoneCurve(times, pitches);
    roll_ = MonotoneCurve(times, unwrapped(rows, kRoll));
}

CameraPose CameraTour::at(double time_s) const {
    CameraPose pose;
    pose.position.latitude_rad = latitude_.at(time_s);
    pose.position.longitude_rad = earth::wrap_longitude(longitude_.at(time_s));
    pose.position.height.m = height_.at(time_s);
    pose.heading_rad = earth::wrap_heading(heading_.at(time_s));
    pose.pitch_rad = pitch_.at(time_s);
    pose.roll_rad = roll_.at(time_s);
    return pose;
}

}  // namespace tedavis::host_sim
