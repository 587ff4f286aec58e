/// Points, lines and areas of tables and maps: CSV with columns of places, GeoJSON, and what else GDAL reads as vectors.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "host_sim/scene_builder/source_feature.hpp"

namespace tedavis::host_sim {

/// The treatment of holes in areas.
enum class Holes : std::uint8_t {
    left_out,  ///< left out, with a note
    joined,  ///< the outer ring is extended to each hole, round it and back the same way, so that only even-odd rules find holes
};

/// Parts of multipart geometries become features of their own. The coordinates of a CSV are in columns whose names begin with lon
/// or x, and with lat or y. Throws UserError where GDAL cannot read the file, or a feature has no position.
[[nodiscard]] SourceFeatures read_vector_file(const std::string& file, const std::string& crs, Holes holes = Holes::left_out);
/// Returns the rows of a CSV, each as texts by column. Throws UserError where the file is no CSV.
[[nodiscard]] std::vector<std::map<std::string, std::string>> read_table_file(const std::string& file);

}  // namespace tedavis::host_sim
