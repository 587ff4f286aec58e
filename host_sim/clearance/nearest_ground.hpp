/// The ground of a terrain database that is nearest to a place, in three dimensions: its true surface, at full resolution.
///
/// Chunks are searched in the order of the distances of their bounding boxes until none can be nearer, so that no summit beside
/// the place is missed. Distances are Euclidean in ECEF (WGS84), in double.
/// Memory  chunks and directory pages that were read, up to about 40 MB. Thread  one.
#pragma once

#include <optional>
#include <unordered_map>

#include "host_sim/clearance/ground_chunk.hpp"

namespace tedavis::host_sim {

/// A place of the ground, with distance and direction from another place.
struct GroundPlace {
    double distance_m = 0;
    double bearing_rad = 0;    ///< true, [0, 2 pi)
    double elevation_rad = 0;  ///< negative below the horizontal
    earth::Geodetic place;
    double height_msl_m = 0;
};

class NearestGround {
public:
    /// The database must outlive the object.
    explicit NearestGround(const terrain::TerrainDatabase& database) : database_(database) {}

    /// Returns the nearest known ground within a distance, m; nothing where there is none. The region is in metres north, east
    /// and down of the place.
    [[nodiscard]] std::optional<GroundPlace> find(const earth::Geodetic& from, double within_m, const Region& region = {});
    /// Whether ground within a horizontal distance may be unknown: void, or outside the database. True for every place after a
    /// part of the database could not be read.
    [[nodiscard]] bool may_be_unknown(const earth::Geodetic& from, double within_m);

private:
    struct Search;
    void search(Search& search);
    [[nodiscard]] const terrain::ChunkEntry* entry_of(const terrain::ChunkKey& key);
    [[nodiscard]] const GroundChunk* chunk_of(const terrain::ChunkEntry& entry);
    [[nodiscard]] bool is_beside_end(const earth::Geodetic& from, double within_m) const;
    [[nodiscard]] bool has_void(const terrain::ChunkKey& key, const glm::dvec3& eye, double within_m);

    const terrain::TerrainDatabase& database_;
    std::unordered_map<std::uint32_t, std::unique_ptr<terrain::DirectoryPage>> pages_;
    std::unordered_map<std::uint64_t, std::unique_ptr<GroundChunk>> chunks_;  ///< null: it is damaged
    bool is_damaged_ = false;
};

}  // namespace tedavis::host_sim
