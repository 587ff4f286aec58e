#include "render_core/draw/data/label_planner.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/flight/decision_interval.hpp"

namespace tedavis::draw {
namespace {

constexpr double kInterval_s = 0.5;
static_assert(flight::kDecisionInterval.ns == static_cast<std::int64_t>(kInterval_s * 1e9));
constexpr double kMaxDebt_s = 2;  // of changes that could not wait
constexpr std::uint8_t kOldest = 255;

bool has_smaller_key(const Label& a, const Label& b) { return a.key < b.key; }

bool looks_alike(const Label& a, const Label& b) {
    return a.level == b.level && (a.level != LabelLevel::name || (a.side == b.side && a.stem == b.stem));
}

}  // namespace

bool LabelPlanner::start(base::Arena& arena) {
    labels_ = arena.allocate_array<Label>(kMax);
    held_ = arena.allocate_array<Label>(kMax);
    candidates_ = arena.allocate_array<Candidate>(kMax);
    return !labels_.empty() && !held_.empty() && !candidates_.empty();
}

void LabelPlanner::rest() {
    for (std::size_t n = 0; n < count_; ++n) labels_[n].look = 0;
    gone_ = 0;
}

void LabelPlanner::begin(const LabelInterval& interval, const design::LabelSettings& settings) {
    const std::int64_t elapsed = interval.number - interval_.number;
    is_first_ = !has_memory_ || was_skipped_ || elapsed < 1 || elapsed > kMaxGap;
    elapsed_ = static_cast<std::uint8_t>(is_first_ ? 1 : elapsed);
    interval_ = interval;
    settings_ = settings;
    held_count_ = count_;
    std::copy_n(labels_.data(), held_count_, held_.data());
    std::sort(held_.data(), held_.data() + held_count_, has_smaller_key);
    const double more = settings.most_changes * kInterval_s * elapsed_;
    changes_left_ = is_first_ ? 0 : std::min(changes_left_ + more, std::max(settings.most_changes, 1.0));
    groups_.clear();
    offered_ = visited_ = shown_ = suppressed_ = {};
    count_ = candidate_count_ = 0;
}

void LabelPlanner::skip(std::int64_t interval) {
    interval_.number = interval;
    for (std::size_t n = 0; n < count_; ++n) gone_ += labels_[n].look != 0 ? 1 : 0;
    count_ = 0;
    suppressed_ = {};
    has_memory_ = was_skipped_ = true;
}

bool LabelPlanner::add_group(const LabelGroup& group) { return groups_.try_push_back(group); }

const Label* LabelPlanner::held(LabelKey key) const {
    Label wanted;
    wanted.key = key;
    const Label *const first = held_.data(), *const end = first + held_count_;
    const Label* const found = std::lower_bound(first, end, wanted, has_smaller_key);
    return found != end && found->key == key ? found : nullptr;
}

bool LabelPlanner::comes_first(const Candidate& a, const Candidate& b) const {
    const bool a_is_protected = groups_[group_of(a.key)].is_protected, b_is_protected = groups_[group_of(b.key)].is_protected;
    if (a_is_protected != b_is_protected) return a_is_protected;
    return a.rank > b.rank || (a.rank == b.rank && a.key < b.key);
}

/// A heap with the last one on top: a better one takes its place.
void LabelPlanner::offer(LabelKey key, double interest, double rank) {
    if (group_of(key) >= groups_.size() || !std::isfinite(interest) || !std::isfinite(rank)) return;
    ++offered_[group_of(key)];
    const Label* const before = held(key);
    const bool stands = !is_first_ && before != nullptr && before->level != LabelLevel::none;
    const Candidate candidate{key, static_cast<float>(rank + (stands ? kHeldBonus : 0)), static_cast<float>(interest)};
    const auto first_of = [this](const Candidate& a, const Candidate& b) { return comes_first(a, b); };
    Candidate* const all = candidates_.data();
    if (candidate_count_ == kMax) {
        const bool is_better = comes_first(candidate, all[0]);
        ++suppressed_[group_of(is_better ? all[0].key : key)];
        if (!is_better) return;
        std::pop_heap(all, all + candidate_count_--, first_of);
    }
    all[candidate_count_++] = candidate;
    std::push_heap(all, all + candidate_count_, first_of);
}

void LabelPlanner::settle(LabelShapes& shapes) {
    Candidate* const all = candidates_.data();
    std::sort_heap(all, all + candidate_count_, [this](const Candidate& a, const Candidate& b) { return comes_first(a, b); });
    LabelRoom taken(interval_.screen);
    for (std::size_t n = 0; n < candidate_count_; ++n) {
        const LabelShape shape = shapes.shape(all[n].key);
        const Label label = decide(all[n], shape, taken);
        const bool takes_room = label.is_seen && label.level != LabelLevel::none;
        if (takes_room) taken.take(room_of(label, shape.box));
        if (label.is_seen && shape.box.name_width_px > 0 && label.level != LabelLevel::name) ++suppressed_[group_of(label.key)];
        if (takes_room) ++shown_[group_of(label.key)];
        labels_[count_++] = label;
    }
    has_memory_ = true;
    was_skipped_ = false;
    count_gone();
}

/// Those of the interval before that are not here any more; held_ is theirs until the next one.
void LabelPlanner::count_gone() {
    for (std::size_t n = 0; n < count_; ++n) {
        const Label* const before = held(labels_[n].key);
        if (before == nullptr) continue;
        labels_[n].look = before->look;
        held_[static_cast<std::size_t>(before - held_.data())].look = 0;
    }
    for (std::size_t n = 0; n < held_count_; ++n) gone_ += held_[n].look != 0 ? 1 : 0;
}

bool LabelPlanner::note(std::size_t label, std::uint8_t look) {
    const bool has_changed = labels_[label].look != look;
    labels_[label].look = look;
    return has_changed;
}

std::uint32_t LabelPlanner::take_gone() {
    const std::uint32_t gone = gone_;
    gone_ = 0;
    return gone;
}

/// What stands keeps its level a little below the limits.
LabelLevel LabelPlanner::wanted(const Candidate& candidate, const Label* before, bool has_name) {
    const std::uint32_t number = group_of(candidate.key);
    const LabelGroup& group = groups_[number];
    const double named = std::ceil(group.named_share * offered_[number]);
    const bool may_be_named = visited_[number]++ < named;
    if (group.only_named && (!may_be_named || shown_[number] >= group.most)) return LabelLevel::none;
    const auto interest = static_cast<double>(candidate.interest);
    const auto limit = [&](LabelLevel level, double above) {
        return before != nullptr && before->level >= level ? above - kHeldBonus : above;
    };
    if (has_name && may_be_named && interest >= limit(LabelLevel::name, settings_.name_above)) return LabelLevel::name;
    const bool has_marker = group.is_protected || interest >= limit(LabelLevel::marker, settings_.marker_above);
    return has_marker ? LabelLevel::marker : LabelLevel::none;
}

Rect LabelPlanner::room_of(const Label& label, const SignBox& box) const {
    return label.level == LabelLevel::name ? box.raised(label.stem, interval_.text_px).with(label.side)
                                           : box.with(SignSide::none);
}

bool LabelPlanner::has_room(const Label& label, const SignBox& box, const LabelRoom& taken, bool stands) const {
    const Rect room = room_of(label, box);
    return interval_.screen.contains(room) && taken.is_free(stands ? room : with_margin(room, interval_.text_px));
}

/// Of the name: where it stands, as long as there is room.
bool LabelPlanner::find_side(Label& label, const Label* before, const LabelShape& shape, const LabelRoom& taken) const {
    label.level = LabelLevel::name;
    if (before != nullptr && before->level == LabelLevel::name) {
        label.side = before->side;
        label.stem = before->stem;
        if (has_room(label, shape.box, taken, true)) return true;
    }
    for (label.stem = 0; label.stem < shape.stems; ++label.stem)
        for (const SignSide side : kNameSides) {
            label.side = side;
            if (has_room(label, shape.box, taken, false)) return true;
        }
    return false;
}

/// The largest requested level that has room.
Label LabelPlanner::fit(const Label& asked, const Label* before, const LabelShape& shape, const LabelRoom& taken) const {
    const bool stands = before != nullptr && before->level != LabelLevel::none;
    Label fitted = asked;
    if (asked.wanted == LabelLevel::name && find_side(fitted, before, shape, taken)) return fitted;
    fitted = asked;
    if (asked.wanted == LabelLevel::none) return fitted;
    fitted.level = LabelLevel::marker;
    const bool is_protected = groups_[group_of(asked.key)].is_protected;
    if (!is_protected && !has_room(fitted, shape.box, taken, stands)) fitted.level = LabelLevel::none;
    return fitted;
}

bool LabelPlanner::may_change(const Label* before) const {
    const bool has_dwelt = before == nullptr || before->age * kInterval_s >= settings_.dwell_s;
    return has_dwelt && changes_left_ >= 1;
}

/// As it stood, that much later.
Label LabelPlanner::before_now(const Label& asked, const Label* before) const {
    Label kept = asked;
    kept.age = kOldest;
    if (before == nullptr) return kept;
    kept.level = before->level;
    kept.side = before->side;
    kept.stem = before->stem;
    kept.age = static_cast<std::uint8_t>(std::min(before->age + elapsed_, int{kOldest}));
    return kept;
}

Label LabelPlanner::decide(const Candidate& candidate, const LabelShape& shape, const LabelRoom& taken) {
    const Label* const before = is_first_ ? nullptr : held(candidate.key);
    Label asked;
    asked.key = candidate.key;
    asked.wanted = wanted(candidate, before, shape.box.name_width_px > 0);
    asked.is_seen = shape.is_known && interval_.screen.contains(shape.box.with(SignSide::none));
    if (!asked.is_seen) {
        // The change is not visible.
        asked.level = asked.wanted;
        if (before != nullptr) asked.side = before->side, asked.stem = before->stem;
        asked.age = kOldest;
        return asked;
    }
    Label next = fit(asked, before, shape, taken);
    if (is_first_) return next;
    Label kept = before_now(asked, before);
    if (looks_alike(next, kept)) return next.age = kept.age, next;
    if (!may_change(before)) {
        // Only protected markers are shown at once; their names wait like all others.
        const bool is_protected = groups_[group_of(asked.key)].is_protected, is_new = kept.level == LabelLevel::none;
        if (is_protected && is_new) return next.level = LabelLevel::marker, next;
        if (is_new || has_room(kept, shape.box, taken, true)) return kept;
    }
    changes_left_ = std::max(changes_left_ - 1, -kMaxDebt_s * settings_.most_changes);
    return next;
}

void LabelMemory::keep_looks(const LabelMemory& shown) {
    for (Label& label : labels) label.look = 0;
    gone = shown.gone;
    for (const Label& before : shown.labels) {
        const auto stays =
            std::find_if(labels.begin(), labels.end(), [&](const Label& label) { return label.key == before.key; });
        if (stays != labels.end())
            stays->look = before.look;
        else if (before.look != 0)
            ++gone;
    }
}

void LabelPlanner::keep(LabelMemory& memory) const {
    memory.interval = interval_.number;
    memory.changes_left = changes_left_;
    memory.suppressed = suppressed_;
    memory.has_memory = has_memory_;
    memory.was_skipped = was_skipped_;
    memory.gone = gone_;
    memory.labels.clear();
    for (const Label& label : labels()) static_cast<void>(memory.labels.try_push_back(label));
}

void LabelPlanner::restore(const LabelMemory& memory) {
    interval_.number = memory.interval;
    changes_left_ = memory.changes_left;
    suppressed_ = memory.suppressed;
    has_memory_ = memory.has_memory;
    was_skipped_ = memory.was_skipped;
    gone_ = memory.gone;
    count_ = memory.labels.size();
    std::copy_n(memory.labels.data(), count_, labels_.data());
}

}  // namespace tedavis::draw
