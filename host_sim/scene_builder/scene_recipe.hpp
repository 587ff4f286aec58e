/// The content of a scene file (`configs/scenes/*.toml`, see configs/scenes/README.md): sources, and the binding of their
/// attributes.
///
/// Units of the file are converted where it is read: SI and radians inside, texts of units are for legends only.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/scene_builder/scene_draft.hpp"

namespace tedavis::host_sim {

/// Degrees; west may be greater than east, over the antimeridian.
struct RegionRecipe {
    double west_deg = -180, south_deg = -90, east_deg = 180, north_deg = 90;
};

/// A stated uncertainty: a number for all, or a variable of the source.
struct UncertaintyRecipe {
    scene::UncertaintyKind kind = scene::UncertaintyKind::none;
    scene::UncertaintyScope scope = scene::UncertaintyScope::value;
    std::string variable;  ///< empty: `value` holds
    std::string source;    ///< another file with it; empty: the layer's
    std::optional<double> value;
    std::vector<std::string> classes;  ///< of a variable in words: from certain to wholly unsure
    bool is_quality = false;           ///< the variable says how sure, 0..1, instead of how unsure
    bool is_spread = false;            ///< the standard deviation of the ensemble's members
    double full = 1;                   ///< what counts as 1, in the attribute's unit (percent: of 100)
    double growth_per_hour = 0;
};

struct AttributeRecipe {
    std::string name, title, unit;
    std::string variable;  ///< of a raster its variable or "band 2"; of a table its column; empty: the name
    scene::AttributeScale scale = scene::AttributeScale::quantitative;
    std::vector<std::string> classes;
    std::vector<double> class_values;   ///< what the source states for each of them; empty: their numbers from 0
    double factor = 1, offset = 0;      ///< value = factor * stated + offset
    std::vector<double> missing;        ///< stated values that mean there is none
    std::optional<double> undetected;   ///< stated where there was a look and nothing was found ...
    double undetected_value = 0;        ///< ... which is this stated value
    std::optional<double> least, most;  ///< stated values beyond them mean the same
    UncertaintyRecipe uncertainty;
};

struct PreparationRecipe {
    std::optional<RegionRecipe> region;
    double fill_cells = 0;          ///< gaps up to so many cells wide are interpolated
    double fill_uncertainty = 0.5;  ///< level that a cell of interpolation adds
    double smooth_cells = 0;        ///< standard deviation of the Gaussian
    std::string keep_attribute;     ///< features whose value lies in [keep_least, keep_most]; empty: all
    double keep_least = 0, keep_most = 0;
};

struct LayerRecipe {
    std::string name, title, source, licence;
    scene::LayerRole role = scene::LayerRole::field;
    std::optional<scene::HeightDatum> height_datum;
    std::uint8_t importance = 128;
    std::optional<std::int64_t> data_time_ns, from_ns, until_ns;  ///< from and until choose times of the source
    double valid_hours = 0;                                       ///< after the data's last time; 0: for ever
    double position_accuracy_m = 0, height_accuracy_m = 0;
    std::string crs;                     ///< of sources that do not state theirs
    std::string aircraft;                ///< of a flight: the only one that is shown; empty: all
    std::string name_variable = "name";  ///< of a table its column of names
    std::string time_variable;           ///< of a table the column of instants; empty: those that the format states
    std::string height_variable;  ///< of a raster the geopotential or height of its levels; of a table the column of heights
    double height_factor = 1;
    double raster_m = 0;            ///< of areas: they become a grid of posts so far apart; 0: they stay areas
    std::vector<double> levels;     ///< of a raster those that are wanted, as it states them (pressures in hPa); empty: all
    std::vector<double> heights_m;  ///< of a raster's levels, where no variable gives them
    std::string model;              ///< of points: the file of the 3D model that stands at them; empty: none
    std::string wind_layer;         ///< of lines: the grid that derived wind is taken from
    std::optional<std::int64_t> wind_time_ns;  ///< at this time; else at the points' own
    std::string members;                       ///< "bands": bands of one time are members of an ensemble
    std::size_t keep_members = 0;              ///< so many of them stay beside their mean: 0, or 2 .. kMaxMembers
    PreparationRecipe prepare;
    std::vector<AttributeRecipe> attributes;
};

struct SceneRecipe {
    std::string name, origin;
    std::vector<LayerRecipe> layers;
};

/// Return the names used in scene files and reports.
[[nodiscard]] std::string_view shape_name(scene::LayerShape shape);
[[nodiscard]] std::string_view scale_name(scene::AttributeScale scale);
[[nodiscard]] std::string_view kind_name(scene::UncertaintyKind kind);
[[nodiscard]] std::string_view scope_name(scene::UncertaintyScope scope);

/// Throws UserError with file and line.
[[nodiscard]] SceneRecipe parse_scene(std::string_view text, const std::string& file_name);

}  // namespace tedavis::host_sim
