/// All attribute maps of a tile of posts.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "host_sim/terrain_builder/attributes/attribute_tile.hpp"
#include "host_sim/terrain_builder/attributes/far_horizons.hpp"
#include "render_core/terrain/attribute_map.hpp"

namespace tedavis::host_sim {

/// Values before they are coded, inner posts row by row, in the units of AttributeChannel. Posts that are void or outside have
/// the values of level open ground: upright normal, sky view 1, openness 90°, no relief.
struct AttributeFields {
    int columns = 0, rows = 0;
    std::array<std::vector<float>, terrain::kAttributeChannels> channel;  ///< that of post_class holds the code
    /// Sine of the horizon's elevation, not below 0, of every second post along rows and columns: a plane per direction.
    std::array<std::vector<float>, terrain::kHorizonDirections> horizon_sine;

    [[nodiscard]] int horizon_columns() const { return (columns + terrain::kHorizonPostStep - 1) / terrain::kHorizonPostStep; }
    [[nodiscard]] int horizon_rows() const { return (rows + terrain::kHorizonPostStep - 1) / terrain::kHorizonPostStep; }
    [[nodiscard]] float at(terrain::AttributeChannel wanted, int column, int row) const {
        return channel[static_cast<std::size_t>(wanted)][index_of(column, row, columns)];
    }
};

/// Values as coded by terrain/attribute_map.hpp.
struct AttributeMaps {
    int columns = 0, rows = 0;
    std::array<std::vector<std::uint8_t>, terrain::kAttributeMaps> rgba;         ///< 4 bytes a post, row by row
    std::array<std::vector<std::uint8_t>, terrain::kHorizonDirections> horizon;  ///< as AttributeFields::horizon_sine
};

[[nodiscard]] AttributeFields measure_attributes(const HeightPlanes& planes, const FixedLight& light, const FarView& above);
[[nodiscard]] AttributeMaps encode_attributes(const AttributeFields& fields);

/// Both steps in one call. The result does not depend on the tiling: two neighbouring tiles give the values of one tile over
/// both.
struct TileAttributes {
    AttributeMaps maps;
    std::optional<FarHorizons> far;  ///< for the next finer level; nothing where none follows
};
[[nodiscard]] TileAttributes make_attributes(const AttributeTile& tile, const FixedLight& light, const FarView& above,
                                             bool level_below_follows);

}  // namespace tedavis::host_sim
