/// A feature of a file in any format: its points, its fields, and the fields of each point.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "render_core/scene/sdb_format.hpp"

namespace tedavis::host_sim {

struct SourcePoint {
    double latitude_deg = 0, longitude_deg = 0;
    std::optional<double> height_m;
    std::optional<std::int64_t> time_ns;
};

struct SourceFeature {
    scene::LayerShape shape = scene::LayerShape::points;  ///< points, lines or areas
    std::vector<SourcePoint> points;
    std::map<std::string, std::string> fields;                ///< as the file writes them; absent: not stated
    std::map<std::string, std::vector<double>> point_values;  ///< one a point; NaN: not stated
};

/// The features of a file, and notes for the user on what was left out and why.
struct SourceFeatures {
    std::vector<SourceFeature> features;
    std::set<std::string> columns;  ///< names of the columns, also of empty ones; formats without columns have none
    scene::HeightDatum height_datum = scene::HeightDatum::msl;
    std::optional<std::int64_t> data_time_ns;  ///< of a file that states one for all of it
    std::vector<std::string> notes;
    std::string file;    ///< path of the file; empty: not from a file
    std::string format;  ///< GDAL's name of it; empty: a format that GDAL does not read here
    std::string system;  ///< reference system as the file states it; empty: none, or a format that is always in degrees
};

}  // namespace tedavis::host_sim
