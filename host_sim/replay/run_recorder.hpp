/// Draws frames of a flight and writes the folder of a run: records, hashes, pictures, summary and report.
///
/// The batch replay and the window draw through this one class, so that both show the same pictures.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host_sim/options/replay_options.hpp"
#include "host_sim/replay/closest_finder.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/flight_player.hpp"
#include "host_sim/replay/legend_pictures.hpp"
#include "host_sim/replay/picture_writer.hpp"
#include "host_sim/replay/scene_findings.hpp"
#include "host_sim/replay/video_file.hpp"
#include "host_sim/reports/effect_tally.hpp"
#include "host_sim/reports/flight_tally.hpp"
#include "host_sim/reports/frame_record_writer.hpp"
#include "host_sim/reports/run_story.hpp"
#include "host_sim/reports/run_summary.hpp"

namespace tedavis::host_sim {

/// Returns the picture to keep instead of the session's, which is that of `result`; it may add to `result`.
using PictureOverlay = std::function<RgbaPicture(DisplaySession& session, FrameResult& result)>;

class RunRecorder {
public:
    /// Creates the folder and removes the pictures of an earlier run from it. All three arguments must outlive the recorder.
    /// Throws UserError where the folder cannot be written.
    RunRecorder(const ReplayOptions& options, DisplaySession& session, FlightPlayer& player);

    /// Draws over the pictures from now on. Hashes and records stay those of the picture without the overlay.
    void set_overlay(PictureOverlay overlay) { overlay_ = std::move(overlay); }

    /// The pictures that are kept from now on are added to the film, which finish() ends. It must outlive the recorder.
    void set_video(VideoFile& video) { video_ = &video; }
    /// Sets the times of frames that show a closest point, whose pictures go into the report.
    void set_closest(const std::vector<base::Time>& instants) { closest_.set_shown(instants); }

    /// Shows this legend from now on, overriding switches and bus.
    void ask_legend(flight::LegendShow legend) { legend_ = legend; }

    /// Plays the flight to `time`, plans and draws the frame, and reads the picture back.
    [[nodiscard]] const FrameResult& draw(base::Time time);
    /// The input of the frame drawn last.
    [[nodiscard]] const flight::FrameInput& input() const { return input_; }
    /// The frame drawn last.
    [[nodiscard]] const FrameResult& result() const { return result_; }
    /// Adds the frame drawn last to the run.
    void keep();
    /// Adds a sentence to the notes of the summary.
    void note(const std::string& message) { notes_.push_back(message); }
    [[nodiscard]] std::uint64_t kept() const { return records_.written(); }

    /// Writes the records, the summary and the report, and prints the command's result and findings. To be called once, at the
    /// end. Returns the exit code: kInterruptedExitCode, 2 where the terrain database failed during the run, 1 where a GL call
    /// was made that the device does not have, or where there are findings and --strict is given, else 0.
    [[nodiscard]] int finish(bool interrupted, Console& console);

private:
    [[nodiscard]] RunSummary summary(bool interrupted);
    void draw_watched(base::Time time);
    [[nodiscard]] RgbaView shown() const { return overlay_ ? view_of(overlaid_) : session_.pixels(); }

    const ReplayOptions& options_;
    DisplaySession& session_;
    FlightPlayer& player_;
    FrameRecordWriter records_;
    RunStory story_;
    flight::FrameInput input_;
    std::optional<flight::LegendShow> legend_;
    FrameResult result_;
    std::unique_ptr<ClearanceMeter> clearance_;  ///< null: there is no terrain
    PictureOverlay overlay_;
    VideoFile* video_ = nullptr;
    RgbaPicture overlaid_;  ///< the picture of `result_` with the overlay, if there is one
    std::vector<double> total_ms_;
    DeadlineTally deadline_;
    std::vector<std::string> notes_;
    FlightTally tally_;
    EffectTally effects_;
    ClosestFinder closest_;
    LegendPictures legends_;
    PictureWriter pictures_;
    GeoExtent scene_extent_;  ///< read before the run: afterwards the file may be another one
    std::vector<LayerTimes> scene_times_;
    std::uint64_t heap_allocations_ = 0;  ///< of the core, while it planned and drew
};

}  // namespace tedavis::host_sim
