#include "host_sim/replay/frame_preroll.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/display/preroll.hpp"
#include "render_core/flight/decision_interval.hpp"

namespace tedavis::host_sim {
namespace {

const std::int64_t kWindow = terrain::StoreSettings().window_frames;
constexpr std::int64_t kUntold = 60;  ///< intervals or frames that take no time to speak of
constexpr base::Duration kLongestFade = base::Duration::from_seconds(design::kLongestFade_s);

}  // namespace

base::Time FramePreroll::grid_time(std::int64_t frame) const {
    return player_.first() + base::Duration::from_seconds(static_cast<double>(frame) / rate_hz_);
}

bool FramePreroll::needs_history() const {
    const effects::FrameBudget& budget = display_.memory().budget;
    return budget.is_held() || (budget.knows_rays() && display_.planner().chooses_renderer());
}

bool FramePreroll::preroll(base::Time time) {
    is_given_up_ = false;
    preroll_frame(time);
    reach_interval(time);
    if (is_given_up_) leave();
    return !is_given_up_;
}

/// Asked again after it was given up, it stays so until the next frame.
bool FramePreroll::is_told(std::int64_t done, std::int64_t total) {
    if (told_ && !is_given_up_ && total > kUntold)
        is_given_up_ = !told_(static_cast<std::uint64_t>(done), static_cast<std::uint64_t>(total));
    return !is_given_up_;
}

void FramePreroll::preroll_frame(base::Time time) {
    const auto frame = static_cast<std::int64_t>(std::llround((time - player_.first()).to_seconds() * rate_hz_));
    const base::Duration off_grid = time - grid_time(frame);
    const bool is_on_grid = std::abs(off_grid.ns) <= 1;
    const bool follows = is_on_grid && last_ && frame == *last_ + 1;
    last_ = is_on_grid ? std::optional<std::int64_t>(frame) : std::nullopt;
    const bool is_governed = needs_history();
    if (follows && is_governed) learn(frame);
    if (follows) return;
    display_.memory().cut();
    const std::int64_t needed = first_needed(frame, time);
    if (is_governed) reach(std::max<std::int64_t>(frame, 0), std::max<std::int64_t>(needed, 0));
    if (is_given_up_ || (is_governed && is_on_grid)) return;
    if (is_governed) display_.memory().cut();
    const effects::BudgetHistory history = display_.memory().budget.history();
    for (std::int64_t planned = needed - kWindow; planned < frame && !is_given_up_; ++planned) {
        const base::Time grid = grid_time(std::max<std::int64_t>(planned, 0));
        if (is_governed) restore_quality_level(planned);
        plan(is_on_grid ? grid : std::max(grid + off_grid, player_.first()));
    }
    if (is_governed) display_.memory().budget.restore(history);
}

/// The frame itself, or the one that measured what it shows, or the last one before the phase's design began to take its place.
std::int64_t FramePreroll::first_needed(std::int64_t frame, base::Time time) {
    const auto frames_since = [&](base::Time since) {
        return static_cast<std::int64_t>(std::floor((time - since).to_seconds() * rate_hz_ + 1e-6));
    };
    const std::int64_t measured = frame - frames_since(display_.memory().needed_since(time));
    const base::Time since = player_.at(time).phase.presented_since;
    if (!display_.planner().fades() || since > time || time - since > kLongestFade) return measured;
    return std::min(measured, frame - frames_since(since) - 1);
}

/// Plans the frames of the grid before this one, from the last one on whose governor is known, but not after the one needed.
void FramePreroll::reach(std::int64_t frame, std::int64_t needed) {
    effects::FrameBudget& budget = display_.memory().budget;
    if (quality_levels_.empty()) {
        budget.restore(effects::BudgetHistory());
        learn(0);
    }
    const std::int64_t kept = std::min<std::int64_t>(needed, static_cast<std::int64_t>(quality_levels_.size()) - 1) / kKeepEvery;
    for (std::int64_t planned = kept * kKeepEvery - kWindow; planned < kept * kKeepEvery; ++planned) {
        restore_quality_level(planned);
        plan(grid_time(std::max<std::int64_t>(planned, 0)));
    }
    budget.restore(histories_[static_cast<std::size_t>(kept)]);
    const std::int64_t begin = kept * kKeepEvery;
    for (std::int64_t planned = begin; planned < frame && is_told(planned - begin, frame - begin); ++planned) {
        plan(grid_time(planned));
        if (!is_given_up_) learn(planned + 1);
    }
}

/// The display has planned every frame before this one.
void FramePreroll::learn(std::int64_t frame) {
    if (frame != static_cast<std::int64_t>(quality_levels_.size())) return;
    const effects::BudgetHistory& history = display_.memory().budget.history();
    quality_levels_.push_back(static_cast<std::uint8_t>(history.governor.quality_level()));
    if (frame % kKeepEvery == 0) histories_.push_back(history);
}

/// Which terrain a frame requests follows from the quality level before it; nothing else of the history matters to it.
void FramePreroll::restore_quality_level(std::int64_t frame) {
    const auto known = static_cast<std::size_t>(std::max<std::int64_t>(frame, 0));
    display_.memory().budget.restore({effects::FrameGovernor(quality_levels_[known]), {}});
}

void FramePreroll::plan(base::Time time) {
    reach_interval(time);
    if (is_given_up_) return;
    display::preroll(display_, player_.at(time));
    if (display_.memory().must_be_drawn()) session_.draw();
}

/// The log's first one stands for those before it.
std::int64_t FramePreroll::interval_of(base::Time time) const {
    return flight::decision_interval_of(std::max(time, player_.first()));
}

/// To the nearest one that is known, at or before the one that is wanted.
void FramePreroll::approach_interval(std::int64_t wanted) {
    const std::int64_t known = intervals_.last_by(wanted).value_or(interval_of(player_.first()) - 1);
    if (!interval_ || wanted < *interval_ || *interval_ < known) restore_interval(known);
}

/// What the display shows of an interval's labels remains its own from one interval to the next.
void FramePreroll::reach_interval(base::Time time) {
    if (!display_.planner().has_intervals()) return;
    const std::int64_t wanted = interval_of(time);
    if (shown_interval_ == wanted) return;
    approach_interval(wanted);
    const std::int64_t begin = *interval_;
    while (*interval_ < wanted && is_told(*interval_ - begin, wanted - begin)) decide_interval(*interval_ + 1);
    if (is_given_up_) return;
    display_.memory().take_interval(decided_);
    shown_interval_ = wanted;
}

/// With a deadline an interval follows from the governor of its time, which only the frames before it have.
void FramePreroll::decide_before(base::Time time, const std::function<bool()>& goes_on) {
    if (!display_.planner().has_intervals() || display_.memory().budget.is_held()) return;
    const std::int64_t wanted = interval_of(time);
    approach_interval(wanted);
    while (*interval_ < wanted && goes_on()) decide_interval(*interval_ + 1);
}

std::int64_t FramePreroll::undecided_before(base::Time time) const {
    if (!display_.planner().has_intervals() || display_.memory().budget.is_held()) return 0;
    const std::int64_t wanted = interval_of(time);
    const std::int64_t known = intervals_.last_by(wanted).value_or(interval_of(player_.first()) - 1);
    return wanted - (interval_ && *interval_ <= wanted ? std::max(known, *interval_) : known);
}

void FramePreroll::look_ahead(base::Time until, const ToldAlert& told) {
    if (!display_.planner().has_intervals()) return;
    const std::int64_t first = flight::decision_interval_of(player_.first()), last = flight::decision_interval_of(until);
    for (std::int64_t interval = first; interval <= last; ++interval)
        told(std::max(base::Time{interval * flight::kDecisionInterval.ns}, player_.first()), alert_of(interval));
    if (display_.memory().budget.is_held()) forget();  // an interval follows from the governor of its time, which was not planned
}

policy::TerrainAhead FramePreroll::alert_of(std::int64_t interval) {
    if (const std::optional<policy::TerrainAhead> known = intervals_.alert(interval)) return *known;
    approach_interval(interval);
    while (*interval_ < interval) decide_interval(*interval_ + 1);
    return decided_.boost.terrain_ahead();
}

/// Before the log's first interval there are none.
void FramePreroll::restore_interval(std::int64_t interval) {
    decided_ = intervals_.last_by(interval) == interval ? intervals_.restore(interval) : display::PlannerMemory();
    interval_ = interval;
}

/// What the deadline leaves, and terrain that has failed, are as in the frames.
void FramePreroll::decide_interval(std::int64_t interval) {
    const base::Time begins = std::max(base::Time{interval * flight::kDecisionInterval.ns}, player_.first());
    const flight::PhaseStatus phase = phase_before(begins);  // first, so that the log is read in order
    flight::FrameInput input = player_.at(begins);
    input.phase = phase;
    input.trail = nullptr;  // nothing that an interval decides reads it
    decided_.budget = display_.memory().budget;
    decided_.terrain_failed = display_.memory().terrain_failed;
    display_.planner().decide_interval(input, decided_);
    intervals_.keep(interval, decided_);
    interval_ = interval;
}

/// Of the last frame of the grid before this time: what it is told the next frame shows.
flight::PhaseStatus FramePreroll::phase_before(base::Time time) {
    const auto frame = static_cast<std::int64_t>(std::ceil((time - player_.first()).to_seconds() * rate_hz_ - 1e-6)) - 1;
    return player_.at(std::max(grid_time(frame), player_.first())).phase;
}

void FramePreroll::leave() {
    last_.reset();
    shown_interval_.reset();
}

void FramePreroll::forget() {
    has_forgotten_ = true;
    leave();
    intervals_.clear();
    interval_.reset();
    quality_levels_.clear();
    histories_.clear();
}

}  // namespace tedavis::host_sim
