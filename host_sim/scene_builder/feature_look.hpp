/// Examines the content of a table, a map or a recorded flight, with the names that a scene file uses.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/scene_builder/feature_source.hpp"
#include "host_sim/scene_builder/grid_look.hpp"

namespace tedavis::host_sim {

enum class ColumnKind : std::uint8_t { number, time, text };

/// A field that the file states for features, or for each of their points.
struct ColumnLook {
    std::string name;  ///< for `variable` of an attribute, or `name_variable`, `time_variable`, `height_variable`
    ColumnKind kind = ColumnKind::text;
    bool is_of_points = false;
    std::size_t stated = 0;           ///< features (or points) that state it
    std::optional<ValueRange> range;  ///< of numbers
    std::string first, last;          ///< of times in order, as the file writes them
    std::vector<std::string> texts;   ///< different texts in order, at most kMaxTextsLooked
    std::size_t different_texts = 0;
};
inline constexpr std::size_t kMaxTextsLooked = 16;

struct FeatureLook {
    std::string format, system;
    std::size_t points = 0, lines = 0, areas = 0;
    std::size_t places = 0;                                           ///< points of all features
    double west_deg = 0, south_deg = 0, east_deg = 0, north_deg = 0;  ///< extent of these points; east may be beyond 180
    std::optional<ValueRange> height_m;                               ///< heights of these points, where the format states them
    std::optional<std::int64_t> first_ns, last_ns;                    ///< times of these points, or of the whole file
    std::vector<ColumnLook> columns;
    std::vector<std::string> aircraft;  ///< of recorded flights: names for `aircraft`
    std::vector<std::string> notes;     ///< features that the reader leaves out, for the user
    std::vector<AttributeRecipe> usual_attributes;
    scene::HeightDatum height_datum = scene::HeightDatum::msl;
};

[[nodiscard]] FeatureLook look_at_features(const FeatureSource& source);

}  // namespace tedavis::host_sim
