/// Collects the positions of a run's frames, their terrain errors and alerts, and the age of their data; findings are derived at
/// the end.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "host_sim/reports/alert_tally.hpp"
#include "host_sim/reports/geo_extent.hpp"
#include "host_sim/reports/run_findings.hpp"
#include "render_core/display/planner/frame_record.hpp"

namespace tedavis::host_sim {

class FlightTally {
public:
    explicit FlightTally(base::Time origin) : origin_(origin) {}

    /// `height_above_terrain_m` may be NaN.
    void add(const display::FrameRecord& record, double height_above_terrain_m);

    /// Frames that show terrain.
    [[nodiscard]] std::uint64_t frames_with_terrain() const { return with_terrain_; }
    /// Of these frames, the number without a height of the ground below.
    [[nodiscard]] std::uint64_t frames_over_void() const { return terrain_over_void_; }
    /// Upper bound of the terrain's error, pixels, in all frames except those at a start.
    [[nodiscard]] double worst_error_px() const { return worst_error_px_; }
    /// The same for the frames at a start: the first ones with terrain, or with terrain again, while chunks are still loaded, for
    /// two seconds at most and only where chunks can be read.
    [[nodiscard]] double worst_start_error_px() const { return worst_start_error_px_; }

    /// The region in which the own ship was; empty where its position was never known.
    [[nodiscard]] const GeoExtent& extent() const { return extent_; }

    [[nodiscard]] TerrainAlertCounts terrain_alerts() const { return alerts_.counts(); }

    /// `terrain`: as the user named it; `database`: null where there is none.
    [[nodiscard]] Findings findings(const std::string& terrain, const terrain::TerrainDatabase* database) const;

private:
    /// Times of consecutive frames inside the terrain; descending in a run that goes backwards.
    struct Span {
        double first_s = 0, last_s = 0;
    };

    void add_place(const display::FrameRecord& record, double time_s);
    void add_stale(const display::FrameRecord& record);
    void add_error(const display::FrameRecord& record, double time_s);
    [[nodiscard]] std::string inside_words() const;
    /// "6 of 10 frames lie".
    [[nodiscard]] std::string frames_of(std::uint64_t count) const;
    void find_stale(Findings& findings) const;
    void find_places(const std::string& terrain, const terrain::TerrainDatabase& database, Findings& findings) const;

    struct StaleLayer {
        std::uint64_t frames = 0;
        double oldest_s = 0;
    };

    base::Time origin_;
    std::map<std::string, StaleLayer> stale_;  ///< by the layer's name
    std::uint64_t frames_ = 0, with_terrain_ = 0, without_height_ = 0, terrain_over_void_ = 0, without_position_ = 0,
                  outside_ = 0, below_ = 0, coarse_starts_ = 0;
    std::uint64_t spans_in_all_ = 0;
    std::vector<Span> spans_;  ///< the first of them
    bool was_inside_ = false, is_starting_ = true;
    GeoExtent extent_;
    AlertTally alerts_;
    double start_s_ = 0, first_below_s_ = 0, deepest_m_ = 0, first_coarse_s_ = 0;
    double worst_error_px_ = 0, worst_start_error_px_ = 0, worst_coarse_px_ = 0;
};

}  // namespace tedavis::host_sim
