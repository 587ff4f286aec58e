/// Collects the report's data during a run, in memory that does not grow with its length.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "host_sim/png_file.hpp"
#include "host_sim/reports/frame_record_json.hpp"

namespace tedavis::host_sim {

class RunStory {
public:
    /// A point of the curves.
    struct Sample {
        double time_s = 0, altitude_msl_m = 0, height_above_terrain_m = 0, ground_speed_mps = 0, total_ms = 0;
        bool position_valid = false, height_above_terrain_known = false;
        double latitude_deg = 0, longitude_deg = 0;  ///< where the position is valid
    };
    /// Consecutive frames of one phase from one source.
    struct PhaseSpan {
        double begin_s = 0, end_s = 0;
        std::string phase, source;
        std::string design, first;  ///< the design that the display showed, and the aspect with the highest priority in it
    };
    /// UTC at the first and the last frame that knew it; `is_confirmed`: the bus stated it then.
    struct Utc {
        bool is_known = false, is_confirmed = true;
        base::Time begin, end;
        base::Duration from_run;  ///< UTC minus the run's own seconds, at the first frame that knew it
    };
    struct FlagSpan {
        double first_s = 0, last_s = 0;
        std::uint64_t frames = 0;
    };
    struct Thumbnail {
        std::uint64_t frame = 0;
        double time_s = 0;
        std::string phase, png;
    };
    /// A frame of a design with the whole legend, in the size of the display.
    struct Legend {
        std::string design;
        bool is_whole = true;  ///< false: the display is too small for more than the key
        std::uint64_t frame = 0;
        double time_s = 0;
        std::string phase, png;
    };

    explicit RunStory(base::Time origin) : origin_(origin) {}

    /// Adds a frame. `height_above_terrain_m` may be NaN. Returns true if the picture of this frame is to be given to
    /// add_picture().
    [[nodiscard]] bool add(const FrameResult& result, double height_above_terrain_m, double ground_speed_mps);
    void add_picture(const FrameResult& result, const RgbaView& view);
    void add_legend(const std::string& design, bool is_whole, const FrameResult& result, const RgbaView& view);

    [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }
    [[nodiscard]] const Utc& utc() const { return utc_; }
    [[nodiscard]] const std::vector<PhaseSpan>& phases() const { return phases_; }
    [[nodiscard]] const std::map<std::string, FlagSpan>& flags() const { return flags_; }
    [[nodiscard]] const std::vector<Thumbnail>& thumbnails() const { return thumbnails_; }
    [[nodiscard]] const std::vector<Legend>& legends() const { return legends_; }

private:
    void add_phase(const display::FrameRecord& record, double time_s);
    void add_utc(const flight::FlightTime& time, double time_s);

    base::Time origin_;
    Utc utc_;
    std::vector<Sample> samples_;
    std::uint64_t frames_ = 0, sample_stride_ = 1, picture_stride_ = 1;
    std::vector<PhaseSpan> phases_;
    std::map<std::string, FlagSpan> flags_;
    std::vector<Thumbnail> thumbnails_;
    std::vector<Legend> legends_;
};

}  // namespace tedavis::host_sim
