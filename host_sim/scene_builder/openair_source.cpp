#include "host_sim/scene_builder/openair_source.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <vector>

#include "host_sim/number_list.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using base::degrees;
using base::radians;

constexpr double kStepOfArc_deg = 10;  // a chord of it lies 0.4 % of the radius inside the arc
constexpr double kMeanRadius_m = 6371008.8;
constexpr double kFlightLevel_m = 100 * base::kMetresPerFoot;
constexpr double kUnlimited_m = 100000;

struct Place {
    double latitude_deg = 0, longitude_deg = 0;
};

/// On the mean sphere: within 0.5 % of the radius of the ellipsoid's.
Place reached(const Place& from, double bearing_deg, double distance_m) {
    const double angle = distance_m / kMeanRadius_m, lat = radians(from.latitude_deg), bearing = radians(bearing_deg);
    const double sine = std::sin(lat) * std::cos(angle) + std::cos(lat) * std::sin(angle) * std::cos(bearing);
    const double east = std::atan2(std::sin(bearing) * std::sin(angle) * std::cos(lat), std::cos(angle) - std::sin(lat) * sine);
    return {degrees(std::asin(std::clamp(sine, -1.0, 1.0))), from.longitude_deg + degrees(east)};
}

struct Polar {
    double bearing_deg = 0, distance_m = 0;
};
Polar polar_of(const Place& centre, const Place& place) {
    const double a = radians(centre.latitude_deg), b = radians(place.latitude_deg),
                 east = radians(place.longitude_deg - centre.longitude_deg);
    const double x = std::cos(a) * std::sin(b) - std::sin(a) * std::cos(b) * std::cos(east), y = std::sin(east) * std::cos(b);
    const double along = std::sin(a) * std::sin(b) + std::cos(a) * std::cos(b) * std::cos(east);
    return {degrees(std::atan2(y, x)), kMeanRadius_m * std::atan2(std::hypot(x, y), along)};
}

std::string trimmed(std::string_view text) {
    const auto is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
    while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    return std::string(text);
}

std::string upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

class OpenAirReader {
public:
    OpenAirReader(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

    SourceFeatures read() {
        while (!text_.empty()) {
            const std::size_t end = text_.find('\n');
            const std::string_view line = text_.substr(0, end);
            text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
            ++line_;
            read_line(trimmed(line.substr(0, line.find('*'))));
        }
        end_airspace();
        if (airways_ > 0) found_.notes.push_back(name_ + ": " + std::to_string(airways_) + " airway segments (DY) are not shown");
        return std::move(found_);
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw UserError(name_ + ":" + std::to_string(line_) + ": " + what);
    }

    void read_line(const std::string& line) {
        if (line.size() < 2) return;
        const std::string command = upper(line.substr(0, 2)),
                          rest = trimmed(std::string_view(line).substr(line[1] == ' ' ? 1 : 2));
        if (command == "AC") {
            end_airspace();
            begin_airspace(rest);
        } else if (command == "AN" || command == "AY") {
            feature().fields[command == "AN" ? "name" : "type"] = rest;
        } else if (command == "AL" || command == "AH") {
            read_limit(rest, command == "AL" ? "floor" : "ceiling");
        } else if (command == "V ") {
            read_variable(rest);
        } else if (command[0] == 'D') {
            read_shape(command, rest);
        }
        // Others say how to draw, when it is active and whom to call.
    }
    SourceFeature& feature() {
        if (!is_open_) refuse("stands before any AC; begin each airspace with AC and its class");
        return current_;
    }

    void begin_airspace(const std::string& airspace_class) {
        current_ = {};
        current_.shape = scene::LayerShape::areas;
        current_.fields["class"] = airspace_class;
        is_open_ = true;
        is_clockwise_ = true;
        has_centre_ = false;
        first_line_ = line_;
    }
    void end_airspace() {
        if (!is_open_) return;
        is_open_ = false;
        std::vector<SourcePoint>& points = current_.points;
        if (points.size() > 1 && points.front().latitude_deg == points.back().latitude_deg &&
            points.front().longitude_deg == points.back().longitude_deg)
            points.pop_back();
        if (points.empty()) return;  // files have blocks that only name things
        if (points.size() < 3)
            throw UserError(name_ + ":" + std::to_string(first_line_) + ": this airspace has " + std::to_string(points.size()) +
                            " points; it needs three DP, or a DC");
        for (const char* const limit : {"floor", "ceiling"})
            if (current_.fields.count(limit) == 0)
                throw UserError(name_ + ":" + std::to_string(first_line_) + ": this airspace has no " + limit + "; give it " +
                                (limit[0] == 'f' ? "AL" : "AH"));
        found_.features.push_back(std::move(current_));
    }

    /// "FL145", "1000ft AMSL", "300m AGL", "GND", "UNL", "4500MSL". Feet where no unit stands.
    void read_limit(const std::string& text, const std::string& limit) {
        std::string words = upper(text);
        words.erase(std::remove(words.begin(), words.end(), ' '), words.end());
        double number = 0;
        int used = 0;
        std::string datum = "msl";
        if (words == "GND" || words == "SFC" || words == "0") {
            datum = "ground";
        } else if (words.rfind("UNL", 0) == 0) {
            number = kUnlimited_m;
        } else if (std::sscanf(words.c_str(), "FL%lf%n", &number, &used) == 1) {
            number *= kFlightLevel_m;
            datum = "standard";
        } else if (std::sscanf(words.c_str(), "%lf%n", &number, &used) == 1) {
            const std::string unit = words.substr(static_cast<std::size_t>(used));
            const bool is_metres = unit.rfind('M', 0) == 0 && unit.rfind("MSL", 0) != 0;
            number *= is_metres ? 1 : base::kMetresPerFoot;
            if (unit.find("AGL") != std::string::npos || unit.find("GND") != std::string::npos ||
                unit.find("SFC") != std::string::npos)
                datum = "ground";
            if (unit.find("STD") != std::string::npos) datum = "standard";
        } else {
            refuse("'" + text + "' is no height; write for instance 1500ft AMSL, FL100, GND");
        }
        feature().fields[limit] = std::to_string(number);
        feature().fields[limit + "_datum"] = datum;
    }

    void read_variable(const std::string& text) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos) refuse("'V " + text + "' sets nothing; write V X=... or V D=+");
        const std::string variable = upper(trimmed(text.substr(0, equals))), value = trimmed(text.substr(equals + 1));
        if (variable == "D") is_clockwise_ = value != "-";
        if (variable != "X") return;
        centre_ = place_of(value);
        has_centre_ = true;
    }

    void read_shape(const std::string& command, const std::string& rest) {
        if (command == "DP") return add(place_of(rest));
        if (command == "DY") return void(++airways_);
        if (command != "DC" && command != "DA" && command != "DB") return;
        if (!has_centre_) refuse(command + " needs a centre; write V X=... before it");
        if (command == "DC") {
            add_arc(0, 360, number_of(rest) * base::kMetresPerNauticalMile, true);
        } else if (command == "DA") {
            const std::vector<double> n = parse_number_list(rest, ',');
            if (n.size() != 3) refuse("DA needs radius, first and last bearing; write for instance DA 10, 270, 290");
            add_arc(n[1], n[2], n[0] * base::kMetresPerNauticalMile, false);
        } else {
            const std::size_t comma = rest.find(',');
            if (comma == std::string::npos) refuse("DB needs two places with a comma between them");
            const Place from = place_of(trimmed(rest.substr(0, comma))), to = place_of(trimmed(rest.substr(comma + 1)));
            const Polar a = polar_of(centre_, from), b = polar_of(centre_, to);
            add(from);
            add_arc(a.bearing_deg, b.bearing_deg, 0.5 * (a.distance_m + b.distance_m), false);
            add(to);
        }
    }
    double number_of(const std::string& text) const {
        const std::vector<double> numbers = parse_number_list(text, ',');
        if (numbers.size() != 1 || !(numbers[0] > 0)) refuse("'" + text + "' is no radius; write nautical miles");
        return numbers[0];
    }
    void add_arc(double from_deg, double to_deg, double radius_m, bool is_circle) {
        double turn_deg = is_circle ? 360 : std::fmod(to_deg - from_deg, 360);
        if (!is_circle && is_clockwise_ && turn_deg < 0) turn_deg += 360;
        if (!is_circle && !is_clockwise_ && turn_deg > 0) turn_deg -= 360;
        const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(turn_deg) / kStepOfArc_deg)));
        for (int n = 0; n <= steps - (is_circle ? 1 : 0); ++n) add(reached(centre_, from_deg + turn_deg * n / steps, radius_m));
    }
    void add(const Place& place) { feature().points.push_back({place.latitude_deg, place.longitude_deg, {}, {}}); }

    /// "53:47:06N 008:21:41E", "53:47.1 N 8:21.7 E", "53.78N 8.36E".
    [[nodiscard]] Place place_of(const std::string& text) const {
        const char* at = text.c_str();
        Place place;
        if (!read_angle(at, 'N', 'S', 90, place.latitude_deg) || !read_angle(at, 'E', 'W', 180, place.longitude_deg))
            refuse("'" + text + "' is no place; write for instance 46:47:30N 009:49:20E");
        return place;
    }
    static bool read_angle(const char*& at, char positive, char negative, double most_deg, double& angle_deg) {
        double part = 0, scale = 1;
        int used = 0, parts = 0;
        for (angle_deg = 0; parts < 3 && std::sscanf(at, "%lf%n", &part, &used) == 1; ++parts, scale *= 60) {
            if (!(part >= 0)) return false;
            angle_deg += part / scale;
            at += used;
            if (*at != ':') {
                ++parts;
                break;
            }
            ++at;
        }
        while (*at == ' ' || *at == '\t' || *at == ',') ++at;
        const char side = static_cast<char>(std::toupper(static_cast<unsigned char>(*at)));
        if (parts == 0 || (side != positive && side != negative) || !(angle_deg <= most_deg)) return false;
        ++at;
        if (side == negative) angle_deg = -angle_deg;
        return true;
    }

    std::string_view text_;
    const std::string name_;
    SourceFeatures found_;
    SourceFeature current_;
    Place centre_;
    bool is_open_ = false, is_clockwise_ = true, has_centre_ = false;
    int line_ = 0, first_line_ = 0, airways_ = 0;
};

}  // namespace

bool is_openair(std::string_view text) {
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        const std::string line = trimmed(text.substr(0, end));
        if (!line.empty() && line[0] != '*') return upper(line.substr(0, 3)) == "AC ";
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return false;
}

SourceFeatures read_openair(std::string_view text, const std::string& name) { return OpenAirReader(text, name).read(); }

}  // namespace tedavis::host_sim
