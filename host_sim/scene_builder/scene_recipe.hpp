/// The content of a scene file (`configs/scenes/*.toml`): its sources, and how their variables become attributes. The keys are
/// explained in configs/scenes/README.md.
///
/// Values are converted to SI units and radians when the file is read; the text of a unit is only used for legends. The recipe
/// owns all its texts and lists. Thread  any.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/scene_builder/scene_draft.hpp"

namespace tedavis::host_sim {

/// A region in degrees; west is greater than east if the region crosses the antimeridian.
struct RegionRecipe {
    double west_deg = -180, south_deg = -90, east_deg = 180, north_deg = 90;
};

/// The uncertainty of an attribute: one number for all values, or a variable of the source.
struct UncertaintyRecipe {
    scene::UncertaintyKind kind = scene::UncertaintyKind::none;
    scene::UncertaintyScope scope = scene::UncertaintyScope::value;
    std::string variable;  ///< variable with the uncertainty; empty: `value` is used
    std::string source;    ///< file with this variable; empty: the layer's own source
    std::optional<double> value;
    std::vector<std::string> classes;  ///< for a variable with named classes: the names, from certain to fully uncertain
    bool is_quality = false;           ///< the variable states the certainty, 0..1, instead of the uncertainty
    bool is_spread = false;            ///< the uncertainty is the standard deviation of the ensemble's members
    double full = 1;                   ///< uncertainty with the level 1, in the attribute's unit (for percent: of 100)
    double growth_per_hour = 0;        ///< increase of the uncertainty for each hour of age, in the same unit
};

struct AttributeRecipe {
    std::string name, title, unit;
    std::string variable;  ///< variable or "band 2" of a raster, column of a table; empty: the name
    scene::AttributeScale scale = scene::AttributeScale::quantitative;
    std::vector<std::string> classes;   ///< names of the classes of nominal and ordinal data
    std::vector<double> class_values;   ///< value in the source for each class; empty: 0, 1, 2 ...
    double factor = 1, offset = 0;      ///< value = factor * stated + offset
    std::vector<double> missing;        ///< values in the source that mean "no value"
    std::optional<double> undetected;   ///< value in the source where the sensor detected nothing ...
    double undetected_value = 0;        ///< ... and the value that replaces it
    std::optional<double> least, most;  ///< values in the source outside these limits mean "no value"
    UncertaintyRecipe uncertainty;
};

/// How the values of a grid or the features of a layer are prepared.
struct PreparationRecipe {
    std::optional<RegionRecipe> region;
    double fill_cells = 0;          ///< distance from known values up to which missing ones are interpolated, in cells
    double fill_uncertainty = 0.5;  ///< level of uncertainty that is added for each interpolated cell
    double smooth_cells = 0;        ///< standard deviation of the Gaussian filter, in cells
    std::string keep_attribute;     ///< features whose value of it lies in [keep_least, keep_most] are kept; empty: all
    double keep_least = 0, keep_most = 0;
};

/// One layer of the scene.
struct LayerRecipe {
    std::string name, title, source, licence;
    scene::LayerRole role = scene::LayerRole::field;
    std::optional<scene::HeightDatum> height_datum;
    std::uint8_t importance = 128;
    std::optional<std::int64_t> data_time_ns, from_ns, until_ns;  ///< UTC; from and until select times of the source
    double valid_hours = 0;                                       ///< validity after the last time of the data; 0: unlimited
    double position_accuracy_m = 0, height_accuracy_m = 0;
    std::string crs;                     ///< coordinate system of a source that does not state one
    std::string aircraft;                ///< for flights: the only aircraft that is shown; empty: all
    std::string name_variable = "name";  ///< for tables: column of names
    std::string time_variable;           ///< for tables: column of times; empty: the times that the format states
    std::string height_variable;         ///< for rasters: geopotential or height of the levels; for tables: column of heights
    double height_factor = 1;
    double raster_m = 0;            ///< for areas: spacing of the grid into which they are converted, m; 0: they remain areas
    std::vector<double> levels;     ///< for rasters: levels to be read, in the source's unit (pressures in hPa); empty: all
    std::vector<double> heights_m;  ///< for rasters: heights of the levels, if no variable states them
    std::string model;              ///< for points: file of the 3D model that is drawn at each; empty: none
    std::string wind_layer;         ///< for lines: grid layer from which derived wind is taken
    std::optional<std::int64_t> wind_time_ns;  ///< UTC of that wind; else the time of each point
    std::string members;                       ///< "bands": the bands of one time are the members of an ensemble
    std::size_t keep_members = 0;              ///< number of members that are kept beside their mean: 0, or 2 .. kMaxMembers
    PreparationRecipe prepare;
    std::vector<AttributeRecipe> attributes;
};

/// A whole scene file.
struct SceneRecipe {
    std::string name, origin;
    std::vector<LayerRecipe> layers;
};

/// Return the names used in scene files and reports.
[[nodiscard]] std::string_view shape_name(scene::LayerShape shape);
[[nodiscard]] std::string_view scale_name(scene::AttributeScale scale);
[[nodiscard]] std::string_view kind_name(scene::UncertaintyKind kind);
[[nodiscard]] std::string_view scope_name(scene::UncertaintyScope scope);

/// Parses a scene file. Throws UserError with one sentence that names file and line.
[[nodiscard]] SceneRecipe parse_scene(std::string_view text, const std::string& file_name);

}  // namespace tedavis::host_sim
