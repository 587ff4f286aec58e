/// Points, lines and areas of tables and maps: CSV with columns of places, GeoJSON, and what else GDAL reads as vectors.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "host_sim/scene_builder/source_feature.hpp"

namespace tedavis::host_sim {

/// What becomes of holes in areas.
enum class Holes : std::uint8_t {
    left_out,  ///< and noted
    joined,    ///< the ring goes to each, round it and back the same way: even-odd rules see holes, and nothing else may look
};

/// Parts of multipart geometries become features of their own. Places of a CSV stand in
/// columns whose names begin with lon or x, and with lat or y. Throws UserError where the file is none, or a feature has no
/// place.
[[nodiscard]] SourceFeatures read_vector_file(const std::string& file, const std::string& crs, Holes holes = Holes::left_out);
/// Rows of a CSV: what each states, by column. Throws UserError where the file is none.
[[nodiscard]] std::vector<std::map<std::string, std::string>> read_table_file(const std::string& file);

}  // namespace tedavis::host_sim
