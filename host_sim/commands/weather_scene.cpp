#include "host_sim/commands/weather_scene.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "host_sim/calendar_time.hpp"
#include "host_sim/scene_builder/grid_variables.hpp"
#include "host_sim/toml_text.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

using Json = nlohmann::ordered_json;
using Variables = std::vector<GridVariable>;

constexpr const char* kEastward[] = {"eastward_wind", "UGRD", "u", "u10", "10u"};
constexpr const char* kNorthward[] = {"northward_wind", "VGRD", "v", "v10", "10v"};
constexpr double kNoEcho_dbz = -32;
constexpr double kMetresPerGeopotential = 0.101971621;  // 1 / 9.80665 m/s^2
constexpr base::Duration kBesideTheFlight = base::Duration::seconds(3600);

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

template <std::size_t count>
const GridVariable* find_quantity(const Variables& variables, const char* const (&names)[count]) {
    for (const GridVariable& variable : variables)
        for (const char* const name : names)
            if (variable.quantity == name || variable.name == name) return &variable;
    return nullptr;
}

bool is_reflectivity(const GridVariable& variable) {
    const std::string quantity = lower(variable.quantity);
    return lower(variable.unit) == "dbz" || quantity.find("reflectivity") != std::string::npos || quantity.rfind("dbz", 0) == 0;
}

std::string variable_words(const Variables& variables) {
    std::string words;
    for (const GridVariable& variable : variables) {
        words += (words.empty() ? "" : ", ") + variable.name;
        if (!variable.quantity.empty() && variable.quantity != variable.name) words += " (" + variable.quantity + ")";
    }
    return words;
}

/// Letters, digits and underlines, as designs name layers.
std::string layer_name(const std::string& text) {
    std::string name;
    for (const char c : lower(text)) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    return name.empty() ? "field" : name.substr(0, 24);
}

class WeatherLayers {
public:
    explicit WeatherLayers(const WeatherWindow& window) : window_(window) {}

    void add(const std::string& file) {
        const Variables variables = grid_variables(file);
        const GridVariable* const east = find_quantity(variables, kEastward);
        const GridVariable* const north = find_quantity(variables, kNorthward);
        const auto echo = std::find_if(variables.begin(), variables.end(), is_reflectivity);
        if (east != nullptr && north != nullptr) add_wind(file, variables, *east, *north);
        if (echo != variables.end()) add_radar(file, *echo);
        if ((east != nullptr && north != nullptr) || echo != variables.end()) return;
        if (variables.size() != 1)
            throw UserError(
                file + ": holds " + std::to_string(variables.size()) +
                " variables, none of which is known as wind or "
                "radar: " +
                variable_words(variables) +
                "; write a scene file that says what of it is shown (configs/scenes/README.md) and give it with --scene");
        add_field(file, variables.front());
    }
    [[nodiscard]] WeatherScene scene() && {
        return {toml_text(Json{{"name", "weather"}, {"origin", "files of --weather"}, {"layer", std::move(layers_)}}),
                std::move(notes_)};
    }

private:
    Json layer_of(const std::string& name, const std::string& file, const char* role, const GridVariable& variable) {
        std::string unique = name;
        for (int n = 2; !names_.insert(unique).second; ++n) unique = name + "_" + std::to_string(n);
        Json layer = {{"name", unique}, {"source", std::filesystem::absolute(file).lexically_normal().string()}, {"role", role}};
        if (!variable.first_ns || !window_.begin || !window_.end) return layer;
        const base::Time from = *window_.begin - kBesideTheFlight, until = *window_.end + kBesideTheFlight;
        const bool is_of_another_time = from.ns > *variable.last_ns || until.ns < *variable.first_ns;  // then all of it is kept
        if (is_of_another_time || *variable.first_ns == *variable.last_ns) return layer;
        layer["from"] = utc_text(from);
        layer["until"] = utc_text(until);
        return layer;
    }

    void add_layer(Json layer, Json attributes) {
        if (!window_.region.is_empty())
            layer["prepare"] = {{"region",
                                 {{"west_deg", window_.region.west_deg},
                                  {"south_deg", window_.region.south_deg},
                                  {"east_deg", window_.region.east_deg},
                                  {"north_deg", window_.region.north_deg}}}};
        layer["attribute"] = std::move(attributes);
        layers_.push_back(std::move(layer));
    }

    void add_wind(const std::string& file, const Variables& variables, const GridVariable& east, const GridVariable& north) {
        Json layer = layer_of("wind", file, "wind", east);
        layer["title"] = "WIND";
        if (east.has_levels) add_heights(file, variables, layer);
        add_layer(std::move(layer),
                  {{{"name", "east"}, {"variable", east.name}, {"unit", "m/s"}},
                   {{"name", "north"}, {"variable", north.name}, {"unit", "m/s"}},
                   {{"name", "speed"}, {"title", "WIND SPEED"}, {"variable", "derived:wind_speed"}, {"unit", "m/s"}}});
    }

    static void add_heights(const std::string& file, const Variables& variables, Json& layer) {
        static constexpr const char* kGeopotential[] = {"geopotential"};
        static constexpr const char* kHeight[] = {"geopotential_height", "HGT"};
        const GridVariable* const geopotential = find_quantity(variables, kGeopotential);
        const GridVariable* const height = find_quantity(variables, kHeight);
        if (geopotential == nullptr && height == nullptr)
            throw UserError(file +
                            ": its wind has several levels, and nothing says how high they are; write a scene file with "
                            "heights_m (configs/scenes/README.md) and give it with --scene");
        layer["height_variable"] = height != nullptr ? height->name : geopotential->name;
        layer["height_factor"] = height != nullptr ? 1.0 : kMetresPerGeopotential;
    }

    void add_radar(const std::string& file, const GridVariable& echo) {
        Json attribute = {{"name", "reflectivity"}, {"title", "RADAR"}, {"variable", echo.name}, {"unit", "dBZ"}};
        if (echo.undetected) {
            attribute["undetected"] = *echo.undetected;
            attribute["undetected_value"] = kNoEcho_dbz;
        }
        if (echo.missing) attribute["missing"] = Json::array({*echo.missing});
        Json layer = layer_of("radar", file, "field", echo);
        layer["title"] = "RADAR";
        add_layer(std::move(layer), Json::array({std::move(attribute)}));
    }

    void add_field(const std::string& file, const GridVariable& variable) {
        const bool is_nameless = variable.name.rfind("band ", 0) == 0;
        const std::string stated = !is_nameless                ? variable.name
                                   : variable.quantity.empty() ? std::filesystem::path(file).stem().string()
                                                               : variable.quantity;
        Json layer = layer_of(layer_name(stated), file, "field", variable);
        notes_.push_back(file + ": " + stated + " is the layer '" + layer["name"].get<std::string>() +
                         "', which no shipped design shows; name it in a design, given with --design");
        Json attribute = {{"name", layer["name"]}, {"variable", variable.name}};
        if (!variable.unit.empty()) attribute["unit"] = variable.unit;
        add_layer(std::move(layer), Json::array({std::move(attribute)}));
    }

    const WeatherWindow& window_;
    Json layers_ = Json::array();
    std::set<std::string> names_;
    std::vector<std::string> notes_;
};

}  // namespace

WeatherScene weather_scene(const std::vector<std::string>& files, const WeatherWindow& window) {
    WeatherLayers layers(window);
    for (const std::string& file : files) layers.add(file);
    return std::move(layers).scene();
}

}  // namespace tedavis::host_sim
