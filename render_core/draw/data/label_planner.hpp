/// Plans which signs have a marker and a name, and on which side: decided once for each decision interval, for the highest
/// ranks among the offered ones, without overlaps and with few changes.
///
///   start(arena) · each interval: begin(interval, ...), add_group() and offer() for all features, settle(shapes) · labels()
///
/// Protected features (is_protected) come first, then higher ranks; the rank of a label already shown is raised by kHeldBonus,
/// and it keeps level and side for the dwell time as long as there is room. A label that would overlap is removed at once; the
/// number of all other changes in view per second is limited, and further ones wait. New labels need a margin of kMargin, so
/// that motion between two intervals seldom makes labels overlap. Markers of protected features neither wait nor are removed.
///
/// The result is a function of the offered features, in any order, and of the previous labels; a replay therefore restores
/// these (keep(), restore()) or starts at the beginning of the flight. Work is bounded by kMax; offered features beyond the best
/// kMax are only counted.
///
/// Memory  from an arena, once. Thread  one. No clock: an interval is a number that grows with the source's time.
#pragma once

#include <array>

#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/memory_budget.hpp"
#include "render_core/base/time.hpp"
#include "render_core/design/label_settings.hpp"
#include "render_core/draw/data/label_room.hpp"
#include "render_core/draw/data/sign_box.hpp"

namespace tedavis::draw {

/// The values are in ascending order of what is shown.
enum class LabelLevel : std::uint8_t { none, marker, name };

/// Identifies a feature in one of up to 32 groups; a group is an element with a layer.
using LabelKey = std::uint32_t;
inline constexpr std::uint32_t kMaxLabelGroups = 32, kLabelFeatureBits = 24;
[[nodiscard]] constexpr LabelKey label_key(std::uint32_t group, std::uint32_t feature) {
    return group << kLabelFeatureBits | (feature & ((1u << kLabelFeatureBits) - 1));
}
[[nodiscard]] constexpr std::uint32_t group_of(LabelKey key) { return key >> kLabelFeatureBits; }
[[nodiscard]] constexpr std::uint32_t feature_of(LabelKey key) { return key & ((1u << kLabelFeatureBits) - 1); }

/// A label; the order of labels is their rank.
struct Label {
    LabelKey key = 0;
    LabelLevel level = LabelLevel::none;
    LabelLevel wanted = LabelLevel::none;  ///< above `level` where there is no room, or the change waits
    SignSide side = SignSide::right;
    std::uint8_t stem = 0;
    std::uint8_t age = 0;   ///< intervals since its last change, as far as a byte counts
    bool is_seen = false;   ///< in the picture at this interval
    std::uint8_t look = 0;  ///< look in the last frame, set by note(); kept across intervals
};

/// How the features of a group are labelled.
struct LabelGroup {
    bool is_protected = false;  ///< markers are shown regardless of interest
    double named_share = 1;     ///< share of the offered features, by rank, that may have names
    bool only_named = false;    ///< the others have no marker either
    double most = 1e9;          ///< largest number of labels of the group
};

/// The room that a feature's sign would take.
struct LabelShape {
    SignBox box;
    bool is_known = false;   ///< it has a place in the picture's plane
    std::uint8_t stems = 1;  ///< number of stem lengths for the name
};
class LabelShapes {
public:
    virtual ~LabelShapes() = default;
    /// Called once for each of the best candidates.
    [[nodiscard]] virtual LabelShape shape(LabelKey key) = 0;

protected:
    LabelShapes() = default;
    LabelShapes(const LabelShapes&) = default;
    LabelShapes& operator=(const LabelShapes&) = default;
};

struct LabelInterval {
    std::int64_t number = 0;
    Rect screen;  ///< bounds of all boxes
    float text_px = 16;
};

struct LabelMemory;

class LabelPlanner {
public:
    static constexpr std::size_t kMax = 255;
    static constexpr std::int64_t kMaxGap = 4;
    static constexpr double kHeldBonus = 0.04;
    static constexpr float kMargin = 0.3f;  ///< of the text's size

    [[nodiscard]] bool start(base::Arena& arena);
    /// Clears all labels; the next interval places all at once.
    void forget() { has_memory_ = false; }
    /// To be called when a frame showed no labels.
    void rest();
    /// True where this interval has not been decided.
    [[nodiscard]] bool is_due(std::int64_t interval) const { return !has_memory_ || interval != interval_.number; }

    /// True where the last interval was settled, not skipped.
    [[nodiscard]] bool is_decided() const { return has_memory_ && !was_skipped_; }

    /// An interval without labels; the next one places all at once.
    void skip(std::int64_t interval);
    /// Begins an interval. Previous labels are dropped where it is not one of the next kMaxGap intervals.
    void begin(const LabelInterval& interval, const design::LabelSettings& settings);
    /// Adds a group, in order; groups beyond kMaxLabelGroups are refused.
    [[nodiscard]] bool add_group(const LabelGroup& group);
    /// Offers a feature. `interest` 0..1 decides on marker and name, `rank` 0..1 on the order; NaN is left out.
    void offer(LabelKey key, double interest, double rank);
    void settle(LabelShapes& shapes);
    /// The box of a new label with its margin.
    [[nodiscard]] static Rect with_margin(const Rect& box, float text_px) { return box.shrunk(-kMargin * text_px); }

    [[nodiscard]] base::Span<const Label> labels() const { return {labels_.data(), has_memory_ ? count_ : 0}; }
    /// Number of a group's features in view whose name is not shown; features beyond the best kMax all count.
    [[nodiscard]] std::uint32_t suppressed(std::uint32_t group) const {
        return group < suppressed_.size() ? suppressed_[group] : 0;
    }
    /// Records the look of a label in a frame as a number (0: not shown). Returns true where it has changed.
    bool note(std::size_t label, std::uint8_t look);
    /// Number of labels that disappeared since the last call.
    [[nodiscard]] std::uint32_t take_gone();

    void keep(LabelMemory& memory) const;
    void restore(const LabelMemory& memory);

private:
    struct Candidate {
        LabelKey key;
        float rank, interest;
    };
    [[nodiscard]] bool comes_first(const Candidate& a, const Candidate& b) const;
    [[nodiscard]] const Label* held(LabelKey key) const;
    [[nodiscard]] LabelLevel wanted(const Candidate& candidate, const Label* before, bool has_name);
    [[nodiscard]] Label decide(const Candidate& candidate, const LabelShape& shape, const LabelRoom& taken);
    [[nodiscard]] Label fit(const Label& asked, const Label* before, const LabelShape& shape, const LabelRoom& taken) const;
    [[nodiscard]] bool find_side(Label& label, const Label* before, const LabelShape& shape, const LabelRoom& taken) const;
    [[nodiscard]] bool has_room(const Label& label, const SignBox& box, const LabelRoom& taken, bool stands) const;
    [[nodiscard]] Rect room_of(const Label& label, const SignBox& box) const;
    [[nodiscard]] bool may_change(const Label* before) const;
    [[nodiscard]] Label before_now(const Label& asked, const Label* before) const;
    void count_gone();

    LabelInterval interval_;
    design::LabelSettings settings_;
    base::FixedVector<LabelGroup, kMaxLabelGroups> groups_;
    std::array<std::uint32_t, kMaxLabelGroups> offered_{}, visited_{}, shown_{}, suppressed_{};
    base::Span<Label> labels_, held_;  ///< in order of rank; those of the previous interval, by key
    base::Span<Candidate> candidates_;
    std::size_t count_ = 0, held_count_ = 0, candidate_count_ = 0;
    double changes_left_ = 0;
    std::uint32_t gone_ = 0;
    std::uint8_t elapsed_ = 1;  ///< intervals since the one before
    bool has_memory_ = false, was_skipped_ = false, is_first_ = true;
};

/// The state that one frame passes to the next. Plain data.
struct LabelMemory {
    std::int64_t interval = 0;
    double changes_left = 0;
    std::array<std::uint32_t, kMaxLabelGroups> suppressed{};
    bool has_memory = false, was_skipped = false;
    std::uint32_t gone = 0;  ///< disappeared labels that have not been counted yet
    base::FixedVector<Label, LabelPlanner::kMax> labels;

    /// Copies the looks of these labels from those that a frame showed; counts in `gone` the labels that it showed and that are
    /// not among these.
    void keep_looks(const LabelMemory& shown);
};

}  // namespace tedavis::draw
