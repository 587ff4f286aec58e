#include "host_sim/scene_builder/runway_source.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/scene_builder/stated_number.hpp"
#include "host_sim/scene_builder/vector_source.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

using Row = std::map<std::string, std::string>;

constexpr const char* kGlidePathColumn = "glide_path_deg";
constexpr double kMinGlidePath_deg = 1, kMaxGlidePath_deg = 10;

class RunwayReader {
public:
    explicit RunwayReader(const std::string& file) : file_(file) {}

    SourceFeatures read() {
        for (const Row& row : read_table_file(file_)) {
            ++row_;
            add(row);
        }
        add_count_note(closed_, "closed runways are not shown");
        add_count_note(without_place_, "runways state no place of both ends and are not shown");
        return std::move(found_);
    }

private:
    void add_count_note(std::size_t count, const char* what) {
        if (count > 0) found_.notes.push_back(std::to_string(count) + " " + what);
    }

    static std::string text(const Row& row, const std::string& column) {
        const auto cell = row.find(column);
        return cell == row.end() ? "" : cell->second;
    }
    static std::optional<double> metres(const Row& row, const std::string& column) {
        const std::optional<double> feet = stated_number(text(row, column));
        return feet ? std::optional(*feet * base::kMetresPerFoot) : std::nullopt;
    }
    [[nodiscard]] double angle_deg(const Row& row, const std::string& column, double most_deg) const {
        const std::optional<double> angle = stated_number(text(row, column));
        if (!angle || !(std::abs(*angle) <= most_deg))
            throw UserError(file_ + ": row " + std::to_string(row_) + ": '" + text(row, column) + "' is no " + column +
                            "; correct it");
        return *angle;
    }
    static bool has_place(const Row& row, const std::string& end) {
        return !text(row, end + "_latitude_deg").empty() && !text(row, end + "_longitude_deg").empty();
    }
    [[nodiscard]] SourcePoint end_of(const Row& row, const std::string& end) const {
        return {angle_deg(row, end + "_latitude_deg", 90),
                angle_deg(row, end + "_longitude_deg", 180),
                metres(row, end + "_elevation_ft"),
                {}};
    }

    /// Of the approach lights; empty: the file states none.
    [[nodiscard]] std::string glide_path(const Row& row) const {
        std::string stated = text(row, kGlidePathColumn);
        if (stated.empty()) return "";
        const std::optional<double> angle = stated_number(stated);
        if (!angle || *angle < kMinGlidePath_deg || *angle > kMaxGlidePath_deg)
            throw UserError(file_ + ": row " + std::to_string(row_) + ": '" + stated + "' is no " + kGlidePathColumn +
                            "; state degrees from 1 to 10");
        return stated;
    }

    void add(const Row& row) {
        if (text(row, "closed") == "1") return void(++closed_);
        if (!has_place(row, "le") || !has_place(row, "he")) return void(++without_place_);
        SourceFeature runway;
        runway.shape = scene::LayerShape::lines;
        runway.points = {end_of(row, "le"), end_of(row, "he")};
        if (!runway.points[0].height_m) runway.points[0].height_m = runway.points[1].height_m;
        if (!runway.points[1].height_m) runway.points[1].height_m = runway.points[0].height_m;
        set_fields(row, runway.fields);
        if (const std::string angle = glide_path(row); !angle.empty()) runway.fields[kGlidePathColumn] = angle;
        found_.features.push_back(std::move(runway));
    }
    static void set_fields(const Row& row, Row& fields) {
        const auto set = [&fields](const char* name, const std::string& value) {
            if (!value.empty()) fields[name] = value;
        };
        const auto set_metres = [&](const char* name, const char* column) {
            if (const std::optional<double> value = metres(row, column)) fields[name] = std::to_string(*value);
        };
        const std::string airport = text(row, "airport_ident"), ident = text(row, "le_ident") + "/" + text(row, "he_ident");
        set("airport", airport);
        set("ident", ident);
        set("name", (airport.empty() ? "" : airport + " ") + ident);
        set("surface", text(row, "surface"));
        set("lighted", text(row, "lighted"));
        set_metres("length_m", "length_ft");
        set_metres("width_m", "width_ft");
        set_metres("le_threshold_m", "le_displaced_threshold_ft");
        set_metres("he_threshold_m", "he_displaced_threshold_ft");
    }

    const std::string file_;
    SourceFeatures found_;
    std::size_t row_ = 0, closed_ = 0, without_place_ = 0;
};

AttributeRecipe metres_of(const char* name, const char* title) {
    AttributeRecipe recipe;
    recipe.name = name;
    recipe.variable = std::string(name) + "_m";
    recipe.title = title;
    recipe.unit = "m";
    return recipe;
}
AttributeRecipe glide_path_attribute() {
    AttributeRecipe recipe;
    recipe.name = "glide_path";
    recipe.variable = kGlidePathColumn;
    recipe.factor = base::radians(1);
    recipe.unit = "rad";
    return recipe;
}

}  // namespace

bool is_runway_table(std::string_view text) {
    const std::string_view names = text.substr(0, text.find('\n'));
    for (const char* const column : {"le_latitude_deg", "le_longitude_deg", "he_latitude_deg", "he_longitude_deg"})
        if (names.find(column) == std::string_view::npos) return false;
    return true;
}

SourceFeatures read_runway_file(const std::string& file) { return RunwayReader(file).read(); }

std::vector<AttributeRecipe> usual_attributes_of_runways(const SourceFeatures& runways) {
    std::vector<AttributeRecipe> usual = {metres_of("length", "LENGTH"), metres_of("width", "WIDTH")};
    const auto states_it = [](const SourceFeature& runway) { return runway.fields.count(kGlidePathColumn) > 0; };
    if (std::any_of(runways.features.begin(), runways.features.end(), states_it)) usual.push_back(glide_path_attribute());
    return usual;
}

}  // namespace tedavis::host_sim
