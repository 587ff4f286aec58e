/// Height of the true surface at a place: exact posts, two triangles a cell with the fixed diagonal.
///
/// Keeps the posts of the last few level-0 chunks it was asked about. Memory  from the arena at start(). Thread  one.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/terrain/terrain_database.hpp"

namespace tedavis::terrain {

enum class HeightStatus : std::uint8_t { land, sea, void_, outside, damaged };

struct HeightAnswer {
    HeightStatus status = HeightStatus::outside;
    earth::MslHeight height;  ///< only for land and sea
    earth::GeoidUndulation undulation;
};

class HeightQuery {
public:
    static constexpr std::uint32_t kKept = 4;

    [[nodiscard]] bool start(const TerrainDatabase& database, base::Arena& arena);
    [[nodiscard]] HeightAnswer at(double latitude_rad, double longitude_rad);
    [[nodiscard]] static std::uint64_t bytes_needed();

private:
    struct Kept {
        ChunkIndex chunk = kNoChunk;
        std::uint64_t asked = 0;
    };
    [[nodiscard]] const std::uint8_t* posts_of(ChunkIndex chunk);

    const TerrainDatabase* database_ = nullptr;
    Kept kept_[kKept];
    base::Span<std::uint8_t> posts_;
    base::Span<std::uint8_t> payload_;
    std::uint64_t asked_ = 0;
};

}  // namespace tedavis::terrain
