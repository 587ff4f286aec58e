#include "host_sim/scene_builder/layer_block.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>

#include "host_sim/calendar_time.hpp"
#include "host_sim/name_choices.hpp"
#include "host_sim/scene_builder/block_text.hpp"
#include "host_sim/scene_builder/grid_layer.hpp"
#include "host_sim/scene_builder/kept_unit.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kLongestLayer = 31, kLongestAttribute = 23, kLongestClass = 23;  // bytes of names in a database
constexpr std::size_t kMaxBoundColumns = 8;
constexpr double kGravity_mps2 = 9.80665;

void begin_layer(BlockText& block, const std::string& file, const std::string& crs, const char* role, const std::string& others) {
    block.line("[[layer]]");
    block.text("name", plain_name(std::filesystem::path(file).stem().string(), kLongestLayer));
    std::error_code ignored;
    const std::filesystem::path whole = std::filesystem::absolute(file, ignored);
    block.text("source", whole.empty() ? file : whole.lexically_normal().string());
    block.line(std::string("role = \"") + role + "\"" + (others.empty() ? "" : "   # or " + others));
    if (!crs.empty()) block.text("crs", crs);
}

void bind_unit(BlockText& block, const std::string& stated) {
    const KeptUnit kept = kept_unit(stated);
    if (!kept.unit.empty()) block.text("unit", kept.unit);
    if (kept.factor != 1) block.number("factor", kept.factor);
    if (kept.offset != 0) block.number("offset", kept.offset);
}

// ---- grids

bool have_like_axes(const VariableLook& a, const VariableLook& b) {
    return a.places.columns == b.places.columns && a.places.rows == b.places.rows && a.levels == b.levels &&
           a.times_ns == b.times_ns && a.is_whole == b.is_whole && a.fullest_level == b.fullest_level;
}

const VariableLook* variable_named(const GridLook& look, std::initializer_list<const char*> names) {
    for (const char* const name : names)
        for (const VariableLook& variable : look.variables)
            if (variable.name == name) return &variable;
    return nullptr;
}
struct WindPair {
    const VariableLook *east = nullptr, *north = nullptr;
};
WindPair wind_in(const GridLook& look) {
    const WindPair pair{variable_named(look, {"u", "U", "UGRD", "10u", "u10", "eastward_wind"}),
                        variable_named(look, {"v", "V", "VGRD", "10v", "v10", "northward_wind"})};
    const bool is_wind = pair.east != nullptr && pair.north != nullptr && have_like_axes(*pair.east, *pair.north) &&
                         kept_unit(pair.east->unit).unit == "m/s" && kept_unit(pair.north->unit).unit == "m/s";
    return is_wind ? pair : WindPair();
}

bool is_geopotential(const VariableLook& variable) { return kept_unit(variable.unit).unit == "m2/s2"; }
const VariableLook* geopotential_like(const GridLook& look, const VariableLook& shown) {
    for (const VariableLook& variable : look.variables)
        if (is_geopotential(variable) && have_like_axes(variable, shown)) return &variable;
    return nullptr;
}
/// The first that is no geopotential and has values, else the first.
const VariableLook& shown_variable(const GridLook& look) {
    for (const VariableLook& variable : look.variables)
        if (!is_geopotential(variable) && variable.range) return variable;
    return look.variables.front();
}

/// Height of a pressure in the international standard atmosphere, within its lowest 20 km.
double standard_height_m(double pressure_hPa) {
    constexpr double kSea_hPa = 1013.25, kTropopause_hPa = 226.3206, kTropopause_m = 11000;
    if (pressure_hPa >= kTropopause_hPa) return 44330.77 * (1 - std::pow(pressure_hPa / kSea_hPa, 0.1902632));
    return kTropopause_m + 6341.62 * std::log(kTropopause_hPa / pressure_hPa);
}

class GridBlock {
public:
    GridBlock(const GridLook& look)
        : look_(look), wind_(wind_in(look)), shown_(wind_.east != nullptr ? *wind_.east : shown_variable(look)) {}

    std::string write(const std::string& file, const std::string& crs) {
        const bool is_wind = wind_.east != nullptr;
        begin_layer(block_, file, crs, is_wind ? "wind" : "field", is_wind ? "" : "land_cover for classes of the ground");
        if (shown_.most_members > 1) write_members();
        write_levels();
        write_times();
        write_region();
        if (is_wind) {
            write_attribute("east", *wind_.east);
            write_attribute("north", *wind_.north);
        } else {
            write_attribute(plain_name(shown_.name, kLongestAttribute), shown_);
        }
        write_others();
        return block_.str();
    }

private:
    void write_members() {
        block_.line("members = \"bands\"   # the " + std::to_string(shown_.most_members) +
                    " grids of one time and level are an ensemble: the value is their mean");
        if (shown_.least_members == shown_.most_members)
            block_.comment("keep_members = 9   # keeps these beside the mean, 2 to 16");
    }
    void write_levels() {
        levels_ = std::max<std::size_t>(shown_.levels.size(), 1);
        if (levels_ == 1) return;
        if (!shown_.is_whole) return keep_level(shown_.fullest_level, "not every level has every time");
        if (const VariableLook* const heights = geopotential_like(look_, shown_)) {
            block_.text("height_variable", heights->name);
            block_.line("height_factor = " + BlockText::number_text(1 / kGravity_mps2) + "   # geopotential to metres");
        } else if (shown_.level_unit == "hPa" && shown_.levels.front() > 0) {
            std::vector<double> heights_m;
            for (const double level : shown_.levels) heights_m.push_back(std::round(standard_height_m(level)));
            block_.comment("Heights of the levels in the standard atmosphere; replace them by better ones.");
            block_.numbers("heights_m", heights_m);
        } else if (shown_.level_unit == "m" && shown_.levels.front() >= -1000 && shown_.levels.back() <= 100000) {
            block_.numbers("heights_m", shown_.levels);
        } else {
            keep_level(shown_.levels.front(), "the file states no heights; heights_m can give one for each level");
        }
    }
    void keep_level(double level, const char* why) {
        levels_ = 1;
        block_.line("levels = [" + BlockText::number_text(level) + "]   # " + why);
    }
    void write_times() {
        if (shown_.times_ns.size() < 2) return;
        const std::string first = utc_text({shown_.times_ns.front()}), last = utc_text({shown_.times_ns.back()});
        const std::uint64_t posts = posts_of_level() * levels_;
        if (posts * shown_.times_ns.size() > kMaxGridPosts) {
            block_.line("until = \"" + first + "\"   # all times are too many for a scene; the last is " + last);
            return;
        }
        block_.comment("from = \"" + first + "\"   # these two choose fewer times");
        block_.comment("until = \"" + last + "\"");
    }
    void write_region() {
        if (posts_of_level() * levels_ <= kMaxGridPosts) return;
        constexpr double kHalf = 500;  // posts
        const GridPlaces& p = shown_.places;
        const double middle_lon = p.west_deg + p.step_lon_deg * p.columns / 2,
                     middle_lat = p.north_deg - p.step_lat_deg * p.rows / 2;
        block_.line("[layer.prepare.region]   # the whole grid is too large for a scene; this is its middle");
        block_.number("west_deg", middle_lon - kHalf * p.step_lon_deg);
        block_.number("south_deg", std::max(middle_lat - kHalf * p.step_lat_deg, -90.0));
        block_.number("east_deg", middle_lon + kHalf * p.step_lon_deg);
        block_.number("north_deg", std::min(middle_lat + kHalf * p.step_lat_deg, 90.0));
    }
    void write_attribute(const std::string& name, const VariableLook& variable) {
        block_.line("[[layer.attribute]]");
        block_.text("name", name);
        block_.text("variable", variable.name);
        if (variable.unit.empty()) block_.comment("unit = \"...\"   # the file states none");
        bind_unit(block_, variable.unit);
        if (!variable.special.empty()) block_.numbers("missing", variable.special);
        if (variable.undetected) {
            block_.number("undetected", *variable.undetected);
            block_.line("undetected_value = " + BlockText::number_text(variable.range ? variable.range->least : 0) +
                        "   # the least value of the first grid; replace it by what \"nothing detected\" means");
        }
        if (variable.least_members > 1) write_spread(variable);
    }
    void write_spread(const VariableLook& variable) {
        const double spread = variable.first_spread * std::abs(kept_unit(variable.unit).factor);
        const double digit = spread > 0 ? std::pow(10, std::floor(std::log10(spread))) : 1;
        block_.line("[layer.attribute.uncertainty]");
        block_.text("kind", "standard_deviation");
        block_.line("is_spread = true");
        block_.line("full = " + BlockText::number_text(spread > 0 ? std::ceil(spread / digit) * digit : 1) +
                    "   # the spread that counts as fully uncertain" +
                    (spread > 0 ? "; the largest at the first time is " + printed("%.3g", spread) : ""));
    }
    void write_others() {
        std::vector<std::string> names;
        for (const VariableLook& variable : look_.variables)
            if (&variable != &shown_ && &variable != wind_.north && have_like_axes(variable, shown_))
                names.push_back(variable.name);
        if (!names.empty()) block_.comment("On the same grid, each for another [[layer.attribute]]: " + name_choices(names));
    }
    [[nodiscard]] std::uint64_t posts_of_level() const {
        return static_cast<std::uint64_t>(shown_.places.columns) * static_cast<std::uint64_t>(shown_.places.rows);
    }

    const GridLook& look_;
    const WindPair wind_;
    const VariableLook& shown_;
    std::size_t levels_ = 1;
    BlockText block_;
};

// ---- features

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}
bool begins_with(const std::string& text, const char* start) { return text.rfind(start, 0) == 0; }

/// Of a table, in which GDAL finds places by such names.
bool is_position(const ColumnLook& column) {
    const std::string name = lower(column.name);
    return begins_with(name, "lon") || begins_with(name, "lat") || name == "x" || name == "y";
}

class FeatureBlock {
public:
    FeatureBlock(SourceKind kind, const FeatureLook& look) : kind_(kind), look_(look) {}

    std::string write(const std::string& file, const std::string& crs) {
        const Role role = this->role();
        begin_layer(block_, file, crs, role.name, role.others);
        if (kind_ == SourceKind::flight) write_aircraft();
        if (kind_ == SourceKind::vector) {
            write_columns();
        } else {
            std::vector<std::string> names;
            for (const AttributeRecipe& attribute : look_.usual_attributes) names.push_back(attribute.name);
            block_.comment("Without an [[layer.attribute]] the layer has " + name_choices(names));
        }
        return block_.str();
    }

private:
    struct Role {
        const char *name, *others;
    };
    [[nodiscard]] Role role() const {
        switch (kind_) {
            case SourceKind::flight: return {"trajectory", "traffic"};
            case SourceKind::runways: return {"runway", ""};
            case SourceKind::openair: return {"airspace", "no_go"};
            case SourceKind::dof: return {"obstacle", ""};
            default: break;
        }
        if (look_.points >= look_.lines && look_.points >= look_.areas)
            return has_numbers() ? Role{"sample", "obstacle, place, model"} : Role{"place", "obstacle, sample, model"};
        if (look_.lines >= look_.areas) return {"road", "river, runway, trajectory, traffic, obstacle for cables"};
        return {"land_cover", "airspace, no_go, storm_cell, building"};
    }
    [[nodiscard]] bool has_numbers() const {
        return std::any_of(look_.columns.begin(), look_.columns.end(),
                           [](const ColumnLook& column) { return column.kind == ColumnKind::number && !is_position(column); });
    }
    void write_aircraft() {
        if (look_.aircraft.size() < 2) return;
        block_.comment("aircraft = " + json_text(nlohmann::json(look_.aircraft.front())) + "   # only one of " +
                       std::to_string(look_.aircraft.size()));
    }
    void write_columns() {
        write_words();
        std::size_t bound = 0;
        std::set<std::string> names;
        std::vector<std::string> others;
        for (const ColumnLook& column : look_.columns) {
            if (is_position(column) || lower(column.name) == "name" || column.name == time_variable_ || column.stated == 0)
                continue;
            const UnitSuffix parts = unit_suffix(column.name);
            const std::string name = plain_name(column.kind == ColumnKind::number ? parts.name : column.name, kLongestAttribute);
            if (bound == kMaxBoundColumns || !can_be_bound(column) || !names.insert(name).second) {
                others.push_back(column.name);
                continue;
            }
            ++bound;
            write_attribute(name, column, parts.unit);
        }
        if (!others.empty()) block_.comment("Not used here: " + name_choices(others));
    }
    /// Columns that say what the points are called, and where and when they are.
    void write_words() {
        for (const ColumnLook& column : look_.columns) {
            const std::string name = lower(column.name);
            if (name == "name" && column.name != "name") block_.text("name_variable", column.name);
            const bool is_height = begins_with(name, "height") || begins_with(name, "alt") || begins_with(name, "elev");
            if (is_height && column.kind == ColumnKind::number && !look_.height_m)
                block_.comment("height_variable = " + json_text(nlohmann::json(column.name)) +
                               "   # if it is the height of the points, above height_datum = \"msl\" or \"ground\"");
            if (column.kind != ColumnKind::time || !time_variable_.empty()) continue;
            time_variable_ = column.name;
            block_.text("time_variable", column.name);
        }
    }
    [[nodiscard]] static bool can_be_bound(const ColumnLook& column) {
        if (column.kind == ColumnKind::number) return true;
        if (column.kind == ColumnKind::time || column.different_texts > scene::kMaxClasses || column.texts.empty()) return false;
        std::set<std::string> names;  // their case does not tell them apart
        for (const std::string& text : column.texts)
            if (text.size() > kLongestClass || !names.insert(lower(text)).second) return false;
        return true;
    }
    void write_attribute(const std::string& name, const ColumnLook& column, const std::string& unit) {
        block_.line("[[layer.attribute]]");
        block_.text("name", name);
        if (name != column.name) block_.text("variable", column.name);
        if (column.kind == ColumnKind::number) return bind_unit(block_, unit);
        block_.text("scale", "nominal");
        block_.texts("classes", column.texts);
    }

    const SourceKind kind_;
    const FeatureLook& look_;
    std::string time_variable_;
    BlockText block_;
};

}  // namespace

std::string plain_name(const std::string& text, std::size_t longest) {
    std::string name;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool is_plain = byte < 128 && std::isalnum(byte) != 0;
        if (is_plain) name += static_cast<char>(std::tolower(byte));
        if (!is_plain && !name.empty() && name.back() != '_') name += '_';
    }
    name = name.substr(0, longest);
    while (!name.empty() && name.back() == '_') name.pop_back();
    return name.empty() ? "unnamed" : name;
}

std::string grid_block(const std::string& file, const std::string& crs, const GridLook& look) {
    return GridBlock(look).write(file, crs);
}

std::string feature_block(const std::string& file, const std::string& crs, SourceKind kind, const FeatureLook& look) {
    return FeatureBlock(kind, look).write(file, crs);
}

}  // namespace tedavis::host_sim
