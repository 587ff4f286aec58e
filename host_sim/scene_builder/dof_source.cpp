#include "host_sim/scene_builder/dof_source.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "host_sim/calendar_time.hpp"
#include "host_sim/scene_builder/stated_number.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::string_view kDateLine = "CURRENCY DATE =";
constexpr std::size_t kMinRecord = 101;  // up to the code of vertical accuracy, behind which nothing is needed
constexpr double kFullTolerance_m = 500 * base::kMetresPerFoot;
/// Of horizontal codes 1 to 8 and of vertical codes A to H, either way.
constexpr std::array<double, 8> kHorizontal_m = {
    20 * base::kMetresPerFoot,  50 * base::kMetresPerFoot,   100 * base::kMetresPerFoot,         250 * base::kMetresPerFoot,
    500 * base::kMetresPerFoot, 1000 * base::kMetresPerFoot, 0.5 * base::kMetresPerNauticalMile, base::kMetresPerNauticalMile};
constexpr std::array<double, 8> kVertical_m = {3 * base::kMetresPerFoot,   10 * base::kMetresPerFoot,  20 * base::kMetresPerFoot,
                                               50 * base::kMetresPerFoot,  125 * base::kMetresPerFoot, 250 * base::kMetresPerFoot,
                                               500 * base::kMetresPerFoot, 1000 * base::kMetresPerFoot};

struct Column {
    std::size_t first, length;  ///< the first one counts from 0
};
constexpr Column kIdent{0, 9}, kStatus{10, 1}, kCountry{12, 2}, kState{15, 2}, kCity{18, 16}, kLatitude{35, 12},
    kLongitude{48, 13}, kKind{62, 18}, kQuantity{81, 1}, kAboveGround{83, 5}, kAboveSea{89, 5}, kLighting{95, 1},
    kHorizontal{97, 1}, kVertical{99, 1}, kMarking{101, 1}, kAction{118, 1};

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// "08-025404 O".
bool is_record(std::string_view line) {
    if (line.size() < 11 || line[2] != '-' || line[9] != ' ' || (line[10] != 'O' && line[10] != 'U')) return false;
    return std::all_of(line.begin() + 3, line.begin() + 9, is_digit);
}

class DofReader {
public:
    DofReader(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

    SourceFeatures read() {
        found_.height_datum = scene::HeightDatum::ground;
        while (!text_.empty()) {
            const std::size_t end = std::min(text_.find('\n'), text_.size());
            line_ = text_.substr(0, end);
            text_.remove_prefix(std::min(end + 1, text_.size()));
            if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
            ++number_;
            read_line();
        }
        if (dismantled_ > 0) found_.notes.push_back(std::to_string(dismantled_) + " dismantled obstacles are not shown");
        return std::move(found_);
    }

private:
    [[noreturn]] void refuse(const std::string& what) const {
        throw UserError(name_ + ":" + std::to_string(number_) + ": " + what + "; get a whole copy of the file");
    }

    void read_line() {
        if (const std::size_t at = line_.find(kDateLine); at != std::string_view::npos) return read_date(at + kDateLine.size());
        if (is_record(line_)) return read_record();
        if (!found_.features.empty() && line_.find_first_not_of(" \t") != std::string_view::npos) refuse("this is no record");
        // Before the first record stand titles of columns.
    }
    /// "09/27/26": month, day, year of this century.
    void read_date(std::size_t at) {
        const std::string date = cell({line_.find_first_not_of(' ', at), 8});
        const auto number = [&date](std::size_t first) {
            return date.size() == 8 ? static_cast<int>(stated_number(date.substr(first, 2)).value_or(0)) : 0;
        };
        const std::optional<base::Time> midnight = midnight_of(2000 + number(6), number(0), number(3));
        if (!midnight) refuse("'" + date + "' is no date");
        found_.data_time_ns = midnight->ns;
    }

    [[nodiscard]] std::string cell(Column column) const {
        if (column.first >= line_.size()) return "";
        std::string_view text = line_.substr(column.first, column.length);
        text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
        text = text.substr(0, text.find_last_not_of(' ') + 1);
        return std::string(text);
    }
    [[nodiscard]] double feet_as_metres(Column column) const {
        const std::optional<double> feet = stated_number(cell(column));
        if (!feet) refuse("'" + cell(column) + "' is no height in feet");
        return *feet * base::kMetresPerFoot;
    }
    /// "37 00 26.20N", degrees of two or three digits.
    [[nodiscard]] double angle_deg(Column column, char negative, char positive, double most_deg) const {
        const std::string text = cell(column);
        const std::size_t minutes = text.find(' '), seconds = text.find(' ', minutes + 1);
        if (minutes == std::string::npos || seconds == std::string::npos) refuse("'" + text + "' is no place");
        const auto d = stated_number(text.substr(0, minutes)), m = stated_number(text.substr(minutes, seconds - minutes)),
                   s = stated_number(text.substr(seconds, text.size() - 1 - seconds));
        const char side = text.back();
        if (!d || !m || !s || (side != negative && side != positive)) refuse("'" + text + "' is no place");
        const double angle = *d + *m / 60 + *s / 3600;
        if (!(*d >= 0 && *m >= 0 && *s >= 0 && angle <= most_deg)) refuse("'" + text + "' is no place");
        return side == negative ? -angle : angle;
    }

    void read_record() {
        if (line_.size() < kMinRecord) refuse("this record is cut");
        if (cell(kAction) == "D") return void(++dismantled_);
        SourceFeature obstacle;
        const double height_m = feet_as_metres(kAboveGround);
        obstacle.points = {{angle_deg(kLatitude, 'S', 'N', 90), angle_deg(kLongitude, 'W', 'E', 180), height_m, {}}};
        const auto set = [&obstacle](const char* field, const std::string& text) {
            if (!text.empty()) obstacle.fields[field] = text;
        };
        set("ident", cell(kIdent));
        set("kind", cell(kKind));
        set("name", cell(kKind));
        set("city", cell(kCity));
        set("country", cell(kCountry));
        set("state", cell(kState));
        set("quantity", cell(kQuantity));
        set("lighting", cell(kLighting));
        set("marking", cell(kMarking));
        set("status", cell(kStatus) == "O" ? "verified" : "unverified");
        set("height_m", std::to_string(height_m));
        set("top_m", std::to_string(feet_as_metres(kAboveSea)));
        set_tolerance("horizontal_m", line_[kHorizontal.first], '1', kHorizontal_m, obstacle);
        set_tolerance("vertical_m", line_[kVertical.first], 'A', kVertical_m, obstacle);
        found_.features.push_back(std::move(obstacle));
    }
    static void set_tolerance(const char* field, char code, char first, const std::array<double, 8>& tolerances,
                              SourceFeature& obstacle) {
        const int place = code - first;
        if (place >= 0 && place < 8) obstacle.fields[field] = std::to_string(tolerances[static_cast<std::size_t>(place)]);
    }

    std::string_view text_, line_;
    const std::string name_;
    SourceFeatures found_;
    std::size_t number_ = 0, dismantled_ = 0;
};

}  // namespace

bool is_dof(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) return false;
    const std::string_view line = text.substr(first, text.find('\n', first) - first);
    return line.substr(0, kDateLine.size()) == kDateLine || is_record(line);
}

SourceFeatures read_dof(std::string_view text, const std::string& name) { return DofReader(text, name).read(); }

std::vector<AttributeRecipe> usual_attributes_of_dof() {
    AttributeRecipe height;
    height.name = "height";
    height.variable = "height_m";
    height.title = "HEIGHT";
    height.unit = "m";
    height.uncertainty.kind = scene::UncertaintyKind::interval;
    height.uncertainty.variable = "vertical_m";
    height.uncertainty.full = kFullTolerance_m;
    AttributeRecipe place;
    place.name = "position";
    place.variable = "horizontal_m";
    place.title = "POSITION +-";
    place.unit = "m";
    return {height, place};
}

}  // namespace tedavis::host_sim
