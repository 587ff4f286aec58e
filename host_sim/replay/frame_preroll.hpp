/// Plans the frames before a frame that is shown, so that the frame at an instant is the same however it is reached: in the whole
/// run or in a part of it, with any step, backwards too.
///
/// Which terrain has arrived depends on a short window of earlier frames, on a grid of instants at the device's frame rate.
/// Before a frame that does not follow the last one on this grid, the window before it is planned again. Before the log's first
/// instant, that instant is used.
///
/// During a design transition the picture contains the frame in which it began: planning begins before that frame, and it is
/// drawn. The same is done for a saliency map that an earlier frame measured (display/planner/saliency_schedule.hpp), and for the
/// clutter of earlier frames, by which data are reduced (display/planner/declutter_control.hpp).
///
/// Where a deadline is held, what the governor decides follows from all frames since the log's start: those are planned once, in
/// order, as far as they have not been; a run that begins late takes the time for it. Of each it keeps a byte, and the governor
/// every kKeepEvery frames.
///
/// Which labels stand, and how much hazards raise the weights of aspects, follows from all intervals of half a second since the
/// log's start (display/planner/element_labels.hpp, policy/priority_boost.hpp): each is decided once, by the instant at which it
/// begins and the design of the frame before, without the frames between, on a memory of the planner that no frame is planned
/// from. Some of them are kept (interval_track.hpp), also from one run to the next (interval_store.hpp): a run that begins late
/// decides those between the last one kept and its first frame.
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

    /// Told while much lies before a frame: how much of it has been decided or planned. Returning false gives it up.
    using Told = std::function<bool(std::uint64_t done, std::uint64_t total)>;
    void set_told(Told told) { told_ = std::move(told); }

    /// Call before the frame of this instant is drawn. False where it was given up: the frame would be another one than that of
    /// the whole run.
    [[nodiscard]] bool preroll(base::Time time);
    /// Intervals that have to be decided before a frame of this instant.
    [[nodiscard]] std::int64_t undecided_before(base::Time time) const;
    /// Decides those, one after the other, as long as `goes_on` says so: what a window does between its pictures.
    void decide_before(base::Time time, const std::function<bool()>& goes_on);
    /// Tells `told` the beginning of each interval up to the one of this instant and whether the terrain alert is on in it.
    /// Decides those of which it is not known yet, and keeps some of them in passing. For a look ahead before a run; nothing
    /// where the display has no intervals.
    using ToldAlert = std::function<void(base::Time begin, policy::TerrainAhead alert)>;
    void look_ahead(base::Time until, const ToldAlert& told);
    /// What was decided holds no more: design, switches or camera are others.
    void forget();
    /// Frames were drawn that were not prerolled; what was decided still holds.
    void leave();
    /// Intervals that a run like this one has decided before; before the first frame.
    void take_intervals(IntervalTrack intervals) { intervals_ = std::move(intervals); }
    [[nodiscard]] const IntervalTrack& intervals() const { return intervals_; }
    /// True once the intervals are not those of the run as it was started.
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
    // Before the frames of the grid, from the log's first on.
    std::vector<std::uint8_t> quality_levels_;
    std::vector<effects::FrameGovernor> governors_;  ///< every kKeepEvery-th
    std::optional<std::int64_t> shown_interval_;     ///< that the display's weights and labels are of
    std::optional<std::int64_t> interval_;           ///< that `decided_` is of
    display::PlannerMemory decided_;
    IntervalTrack intervals_;
    Told told_;
    bool is_given_up_ = false, has_forgotten_ = false;
};

}  // namespace tedavis::host_sim
