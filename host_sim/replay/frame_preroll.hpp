/// Plans the frames before a frame that is shown, so that the frame at an instant is the same however it is reached: in the whole
/// run or in a part of it, with any step, backwards too.
///
/// Which terrain is loaded depends on a short window of earlier frames, on a grid of times at the device's frame rate. Before a
/// frame that does not follow the last one on this grid, the window before it is planned again. Frames before the log's first
/// time are planned for that time.
///
/// During a design transition the picture contains the frame in which the transition began, so planning begins before that frame,
/// and the frame is drawn. The same holds for a saliency map that an earlier frame measured
/// (display/planner/saliency_schedule.hpp), and for the clutter of earlier frames, by which data are reduced
/// (display/planner/declutter_control.hpp).
///
/// With a deadline, the decisions of the governor depend on all frames since the log's start; so does the choice between
/// triangles and rays where costs are known and a design leaves it to the display. These frames are planned once, in order,
/// which takes time in a run that begins late. For each frame the quality level is stored in one byte, and for every
/// kKeepEvery-th the history of the decisions.
///
/// Labels and priority boosts depend on all decision intervals since the log's start (display/planner/element_labels.hpp,
/// policy/priority_boost.hpp). Each interval is decided once, for its first instant and with the design of the frame before,
/// without planning the frames between, in a planner memory of its own. Some results are stored (interval_track.hpp), also for
/// the next run (interval_store.hpp), so that a run that begins late decides only the intervals between the last stored one and
/// its first frame.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/flight_player.hpp"
#include "host_sim/replay/interval_track.hpp"

namespace tedavis::host_sim {

class FramePreroll {
public:
    FramePreroll(FlightPlayer& player, DisplaySession& session, double rate_hz)
        : player_(player), session_(session), display_(session.display()), rate_hz_(rate_hz) {}

    /// Called while many frames or intervals precede a frame, with the number that is done. Returning false ends the preroll.
    using Told = std::function<bool(std::uint64_t done, std::uint64_t total)>;
    void set_told(Told told) { told_ = std::move(told); }

    /// To be called before the frame at this time is drawn. Returns false if `told` ended the preroll: the frame would then
    /// differ from that of the whole run.
    [[nodiscard]] bool preroll(base::Time time);
    /// Number of intervals that have to be decided before a frame at this time.
    [[nodiscard]] std::int64_t undecided_before(base::Time time) const;
    /// Decides them one after the other while `goes_on` returns true, as a window does between its pictures.
    void decide_before(base::Time time, const std::function<bool()>& goes_on);
    /// Calls `told` with the begin and the terrain alert of each interval up to the one at `until`. Decides those whose alert is
    /// not known yet, and stores some. For the search for alerts before a run; does nothing where the display has no intervals.
    using ToldAlert = std::function<void(base::Time begin, policy::TerrainAhead alert)>;
    void look_ahead(base::Time until, const ToldAlert& told);
    /// Discards all results, since design, switches or camera have changed.
    void forget();
    /// To be called after frames were drawn without a preroll; the decided intervals stay valid.
    void leave();
    /// Takes the intervals of an earlier equal run; to be called before the first frame.
    void take_intervals(IntervalTrack intervals) { intervals_ = std::move(intervals); }
    [[nodiscard]] const IntervalTrack& intervals() const { return intervals_; }
    /// True after forget(): the intervals are no longer those of the run as it was started.
    [[nodiscard]] bool has_forgotten() const { return has_forgotten_; }

private:
    static constexpr std::int64_t kKeepEvery = 16;
    [[nodiscard]] base::Time grid_time(std::int64_t frame) const;
    [[nodiscard]] std::int64_t first_needed(std::int64_t frame, base::Time time);
    void preroll_frame(base::Time time);
    void plan(base::Time time);
    void reach(std::int64_t frame, std::int64_t needed);
    void learn(std::int64_t frame);
    void restore_quality_level(std::int64_t frame);
    [[nodiscard]] bool needs_history() const;
    void reach_interval(base::Time time);
    [[nodiscard]] std::int64_t interval_of(base::Time time) const;
    void approach_interval(std::int64_t wanted);
    [[nodiscard]] policy::TerrainAhead alert_of(std::int64_t interval);
    void restore_interval(std::int64_t interval);
    void decide_interval(std::int64_t interval);
    [[nodiscard]] flight::PhaseStatus phase_before(base::Time time);
    [[nodiscard]] bool is_told(std::int64_t done, std::int64_t total);

    FlightPlayer& player_;
    DisplaySession& session_;
    display::Display& display_;
    double rate_hz_;
    std::optional<std::int64_t> last_;  ///< frame of the grid that was drawn last
    // At the begin of each frame of the grid, from the log's first on.
    std::vector<std::uint8_t> quality_levels_;
    std::vector<effects::BudgetHistory> histories_;  ///< every kKeepEvery-th
    std::optional<std::int64_t> shown_interval_;     ///< interval of the display's priorities and labels
    std::optional<std::int64_t> interval_;           ///< interval of `decided_`
    display::PlannerMemory decided_;
    IntervalTrack intervals_;
    Told told_;
    bool is_given_up_ = false, has_forgotten_ = false;
};

}  // namespace tedavis::host_sim
