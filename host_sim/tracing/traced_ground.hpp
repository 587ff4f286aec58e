/// The heights of a terrain database in memory, as the tracer reads them.
#pragma once

#include <string>
#include <vector>

#include "host_sim/terrain_builder/verify_database.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/raytrace/ground/ground_reader.hpp"
#include "render_core/raytrace/space/ground_space.hpp"

namespace tedavis::host_sim {

class TracedGround {
public:
    /// Reads every post of the database. Throws UserError: it is damaged, too large, or goes round the Earth or to a pole.
    TracedGround(const std::string& path, base::Workers& workers);
    TracedGround(const TracedGround&) = delete;
    TracedGround& operator=(const TracedGround&) = delete;

    [[nodiscard]] const terrain::TerrainDatabase& database() const { return open_.database(); }
    [[nodiscard]] const raytrace::GroundSpace& space() const { return space_; }
    /// All heights are whole metres, and lie in 16 bits.
    [[nodiscard]] bool is_whole() const { return !whole_.empty(); }
    /// Of what it is: int16 where is_whole(), else float.
    template <class Height>
    [[nodiscard]] raytrace::HeightGrid<Height> grid() const;
    /// Metres above MSL, of posts that have a height.
    [[nodiscard]] double lowest_m() const { return database().header().min_height_m; }
    [[nodiscard]] double highest_m() const { return database().header().max_height_m; }
    [[nodiscard]] const terrain::PostRange& window() const { return space_.window(); }
    [[nodiscard]] std::uint32_t columns() const { return window().i1 - window().i0 + 1; }
    [[nodiscard]] std::uint32_t rows() const { return window().j1 - window().j0 + 1; }
    [[nodiscard]] std::uint64_t bytes() const;
    [[nodiscard]] std::uint64_t void_posts() const { return void_posts_; }

private:
    template <class Height>
    [[nodiscard]] raytrace::GroundReading read(std::vector<Height>& posts, base::Workers& workers) const;

    OpenDatabase open_;
    raytrace::GroundSpace space_;
    std::vector<std::int16_t> whole_;
    std::vector<float> metres_;
    std::uint64_t void_posts_ = 0;
};

}  // namespace tedavis::host_sim
