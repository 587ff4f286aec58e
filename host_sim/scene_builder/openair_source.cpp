#include "host_sim/scene_builder/openair_source.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
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
constexpr double kNoHeight_m = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargestCircle_m = 2000 * base::kMetresPerNauticalMile;

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

std::string without_spaces(std::string text) {
    text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
    return text;
}

void skip(std::string_view& text, std::string_view characters) {
    text.remove_prefix(std::min(text.find_first_not_of(characters), text.size()));
}

/// Takes a number from the front. "9E" is 9, for E is a side of the world there.
std::optional<double> number_at(std::string_view& text) {
    double number = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (fault != std::errc() || !std::isfinite(number)) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
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
        require_floor_below_ceiling();
        found_.features.push_back(std::move(current_));
    }

    /// Above the same level only: who knows where flight levels and the ground lie.
    void require_floor_below_ceiling() const {
        const auto& said = current_.fields;
        if (said.at("floor_datum") != said.at("ceiling_datum")) return;
        if (std::stod(said.at("floor")) <= std::stod(said.at("ceiling"))) return;
        throw UserError(name_ + ":" + std::to_string(line_of_limit_) +
                        ": the floor of this airspace lies above its ceiling; correct AL or AH");
    }

    /// "FL145", "1000ft AMSL", "300m AGL", "GND", "UNL", "4500MSL". Feet where no unit stands.
    void read_limit(const std::string& text, const std::string& limit) {
        const std::string words = upper(without_spaces(text));
        Limit found;
        if (words == "GND" || words == "SFC" || words == "0") {
            found = {0, "ground"};
        } else if (words.rfind("UNL", 0) == 0) {
            found = {kUnlimited_m, "msl"};
        } else {
            found = limit_in(words);
        }
        if (!(std::abs(found.height_m) <= kUnlimited_m))
            refuse("'" + text + "' is no height; write for instance 1500ft AMSL, FL100, GND");
        feature().fields[limit] = std::to_string(found.height_m);
        line_of_limit_ = line_;
        feature().fields[limit + "_datum"] = found.datum;
    }
    struct Limit {
        double height_m = kNoHeight_m;
        const char* datum = "msl";
    };
    /// Of a number with its unit, without spaces.
    static Limit limit_in(std::string_view words) {
        const bool is_level = words.substr(0, 2) == "FL";
        if (is_level) words.remove_prefix(2);
        const std::optional<double> number = number_at(words);
        if (!number || (is_level && !words.empty()) || !is_unit_of_height(std::string(words))) return {};
        if (is_level) return {*number * kFlightLevel_m, "standard"};
        const auto says = [words](const char* word) { return words.find(word) != std::string_view::npos; };
        const bool is_metres = !words.empty() && words[0] == 'M' && words.substr(0, 3) != "MSL";
        const char* const datum = says("AGL") || says("GND") || says("SFC") ? "ground" : says("STD") ? "standard" : "msl";
        return {*number * (is_metres ? 1 : base::kMetresPerFoot), datum};
    }
    static bool is_unit_of_height(std::string unit) {
        for (const char* const word : {"AMSL", "MSL", "AGL", "GND", "SFC", "STD", "FEET", "FT", "F", "M", "ALT"})
            if (const std::size_t at = unit.find(word); at != std::string::npos) unit.erase(at, std::string_view(word).size());
        return unit.empty();
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
            add_arc(0, 360, radius_of(rest), true);
        } else if (command == "DA") {
            const std::vector<double> n = parse_number_list(without_spaces(rest), ',');
            const double radius_m = n.size() == 3 ? n[0] * base::kMetresPerNauticalMile : 0;
            if (!(radius_m > 0 && radius_m <= kLargestCircle_m))
                refuse("DA needs radius, first and last bearing; write for instance DA 10, 270, 290");
            add_arc(n[1], n[2], radius_m, std::abs(n[2] - n[1]) == 360);
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
    double radius_of(const std::string& text) const {
        const std::vector<double> numbers = parse_number_list(text, ',');
        const double radius_m = numbers.size() == 1 ? numbers[0] * base::kMetresPerNauticalMile : 0;
        if (!(radius_m > 0 && radius_m <= kLargestCircle_m)) refuse("'" + text + "' is no radius; write nautical miles");
        return radius_m;
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
        std::string_view rest = text;
        Place place;
        if (!read_angle(rest, 'N', 'S', 90, place.latitude_deg) || !read_angle(rest, 'E', 'W', 180, place.longitude_deg) ||
            !rest.empty())
            refuse("'" + text + "' is no place; write for instance 46:47:30N 009:49:20E, minutes and seconds below 60");
        return place;
    }
    static bool read_angle(std::string_view& text, char positive, char negative, double most_deg, double& angle_deg) {
        double scale = 1;
        angle_deg = 0;
        for (int parts = 0; parts < 3; ++parts, scale *= 60) {
            skip(text, " \t,");
            const std::optional<double> part = number_at(text);
            if (!part || *part < 0 || (parts > 0 && *part >= 60)) return false;  // minutes and seconds
            angle_deg += *part / scale;
            if (text.empty() || text[0] != ':') break;
            text.remove_prefix(1);
        }
        skip(text, " \t,");
        const char side = text.empty() ? '?' : static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
        if ((side != positive && side != negative) || !(angle_deg <= most_deg)) return false;
        text.remove_prefix(1);
        if (side == negative) angle_deg = -angle_deg;
        return true;
    }

    std::string_view text_;
    const std::string name_;
    SourceFeatures found_;
    SourceFeature current_;
    Place centre_;
    bool is_open_ = false, is_clockwise_ = true, has_centre_ = false;
    int line_ = 0, first_line_ = 0, line_of_limit_ = 0, airways_ = 0;
};

AttributeRecipe limit_of(const char* name, const char* title) {
    AttributeRecipe recipe;
    recipe.name = recipe.variable = name;
    recipe.title = title;
    recipe.unit = "m";
    return recipe;
}

AttributeRecipe datum_of(const AttributeRecipe& limit) {
    AttributeRecipe recipe = limit_of((limit.name + "_datum").c_str(), (limit.title + " ABOVE").c_str());
    recipe.unit.clear();
    recipe.scale = scene::AttributeScale::nominal;
    recipe.classes = {"msl", "ground", "standard"};
    return recipe;
}

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

std::vector<AttributeRecipe> usual_attributes_of_airspaces() {
    const AttributeRecipe floor = limit_of("floor", "FLOOR"), ceiling = limit_of("ceiling", "CEILING");
    return {floor, datum_of(floor), ceiling, datum_of(ceiling)};
}

}  // namespace tedavis::host_sim
