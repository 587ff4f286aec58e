/// The heights of a terrain database for the tracer: in memory, or paged where they do not fit.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/verify_database.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/raytrace/ground/ground_reader.hpp"
#include "render_core/raytrace/picture/trace_settings.hpp"
#include "render_core/raytrace/space/ground_space.hpp"

namespace tedavis::host_sim {

/// The memory allowed for heights and for the data prepared from them for pictures with `settings`.
struct GroundMemory {
    std::uint64_t bytes = std::numeric_limits<std::uint64_t>::max();
    std::vector<raytrace::TraceSettings> settings;
};

class TracedGround {
public:
    /// Reads every post of the database, or none where they need more than the allowed memory; then is_paged() is true. Throws
    /// UserError where the database is damaged, too large, or extends round the Earth or to a pole.
    TracedGround(const std::string& path, base::Workers& workers, GroundMemory memory = {});
    TracedGround(const TracedGround&) = delete;
    TracedGround& operator=(const TracedGround&) = delete;

    [[nodiscard]] const terrain::TerrainDatabase& database() const { return open_.database(); }
    [[nodiscard]] const raytrace::GroundSpace& space() const { return space_; }
    [[nodiscard]] const std::string& path() const { return path_; }
    /// True: no heights are in memory; chunks of them are read for each picture.
    [[nodiscard]] bool is_paged() const { return is_paged_; }
    [[nodiscard]] const GroundMemory& memory() const { return memory_; }
    /// False: there are too many posts for the tracer in memory, independent of the allowed memory.
    [[nodiscard]] bool can_be_in_memory() const {
        return std::uint64_t{columns()} * rows() <= raytrace::HeightGrid<float>::kMaxInAll;
    }
    /// Bytes of heights and of the data prepared from them; for paged ground those that they would need.
    [[nodiscard]] std::uint64_t bytes_in_memory() const { return bytes_in_memory_; }
    /// All heights are whole metres, and lie in 16 bits. False for paged ground.
    [[nodiscard]] bool is_whole() const { return !whole_.empty(); }
    /// The grid of heights; `Height` must be int16 where is_whole(), else float. Not for paged ground.
    template <class Height>
    [[nodiscard]] raytrace::HeightGrid<Height> grid() const;
    /// Lowest and highest post, metres above MSL.
    [[nodiscard]] double lowest_m() const { return database().header().min_height_m; }
    [[nodiscard]] double highest_m() const { return database().header().max_height_m; }
    [[nodiscard]] const terrain::PostRange& window() const { return space_.window(); }
    [[nodiscard]] std::uint32_t columns() const { return window().i1 - window().i0 + 1; }
    [[nodiscard]] std::uint32_t rows() const { return window().j1 - window().j0 + 1; }
    [[nodiscard]] std::uint64_t bytes() const;                              ///< of heights in memory
    [[nodiscard]] std::uint64_t void_posts() const { return void_posts_; }  ///< 0 for paged ground, where it is not known
    /// Metres above MSL of the post next to a place of space(); nothing where there is none, or it has no height.
    [[nodiscard]] std::optional<double> height_near(const glm::dvec3& place) const;

private:
    template <class Height>
    [[nodiscard]] bool fits();
    template <class Height>
    [[nodiscard]] raytrace::GroundReading read(const terrain::PostRange& window, std::vector<Height>& posts,
                                               base::Workers& workers) const;

    std::string path_;
    GroundMemory memory_;
    OpenDatabase open_;
    raytrace::GroundSpace space_;
    bool is_paged_ = false;
    std::uint64_t bytes_in_memory_ = 0;
    std::vector<std::int16_t> whole_;
    std::vector<float> metres_;
    std::uint64_t void_posts_ = 0;
};

}  // namespace tedavis::host_sim
