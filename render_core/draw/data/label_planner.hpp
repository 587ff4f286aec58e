/// Which signs have a marker and a name, on which side, decided anew at every interval of the source's time and kept between
/// them: of all that are offered those of the highest rank, without overlaps, and calmly.
///
///   start(arena) · each interval: begin(interval, ...), add_group() and offer() for all features, settle(shapes) · labels()
///
/// Those that nobody may miss (is_protected) come first, then those of higher rank; who stands already counts kHeldBonus more,
/// and keeps level and side for the dwell time as long as there is room. What would overlap by then leaves at once; all other
/// changes in view spend of a number a second, and wait where it is spent. New places need kMargin of room round them, so that
/// the way between two intervals seldom brings two labels together. Markers of protected features neither wait nor leave.
///
/// What is decided is a function of what was offered, in any order, and of the labels before: who replays a flight brings these
/// along (keep(), restore()), or begins at its start. Work is bounded by kMax, whatever is offered; what is not among the best
/// kMax is counted.
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

/// Order is what an element shows at least.
enum class LabelLevel : std::uint8_t { none, marker, name };

/// Of a feature in one of up to 32 groups, which are an element and a layer each.
using LabelKey = std::uint32_t;
inline constexpr std::uint32_t kMaxLabelGroups = 32, kLabelFeatureBits = 24;
[[nodiscard]] constexpr LabelKey label_key(std::uint32_t group, std::uint32_t feature) {
    return group << kLabelFeatureBits | (feature & ((1u << kLabelFeatureBits) - 1));
}
[[nodiscard]] constexpr std::uint32_t group_of(LabelKey key) { return key >> kLabelFeatureBits; }
[[nodiscard]] constexpr std::uint32_t feature_of(LabelKey key) { return key & ((1u << kLabelFeatureBits) - 1); }

/// Order is rank: of two the first has the room.
struct Label {
    LabelKey key = 0;
    LabelLevel level = LabelLevel::none;
    LabelLevel wanted = LabelLevel::none;  ///< more than its level where it has no room, or waits
    SignSide side = SignSide::right;
    std::uint8_t stem = 0;
    std::uint8_t age = 0;   ///< intervals since its last change, as far as a byte counts
    bool is_seen = false;   ///< in the picture at this interval
    std::uint8_t look = 0;  ///< of the last frame, by note(); goes along from interval to interval
};

/// How a group's features are labelled.
struct LabelGroup {
    bool is_protected = false;  ///< has its markers whatever its interest
    double named_share = 1;     ///< of the offered ones: those of the highest rank may have names
    bool only_named = false;    ///< the others have no marker either
    double most = 1e9;          ///< so many of such a group at most
};

/// Where the sign of a feature would stand.
struct LabelShape {
    SignBox box;
    bool is_known = false;   ///< it has a place in the picture's plane
    std::uint8_t stems = 1;  ///< so many lengths of them a name may be put on
};
class LabelShapes {
public:
    virtual ~LabelShapes() = default;
    /// Asked once for each of the best.
    [[nodiscard]] virtual LabelShape shape(LabelKey key) = 0;

protected:
    LabelShapes() = default;
    LabelShapes(const LabelShapes&) = default;
    LabelShapes& operator=(const LabelShapes&) = default;
};

struct LabelHistory {
    std::int64_t number = 0;
    Rect screen;  ///< that boxes lie within
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
    /// The next interval places all at once; until then there is nothing.
    void forget() { has_memory_ = false; }
    /// A frame showed none of them.
    void rest();
    /// Whether this interval is still to be decided.
    [[nodiscard]] bool is_due(std::int64_t interval) const { return !has_memory_ || interval != interval_.number; }

    /// Whether there is an interval that was settled, not skipped.
    [[nodiscard]] bool is_decided() const { return has_memory_ && !was_skipped_; }

    /// An interval without labels; the next one places all at once.
    void skip(std::int64_t interval);
    /// An interval that is not one of the next kMaxGap forgets what stood.
    void begin(const LabelHistory& interval, const design::LabelSettings& settings);
    /// The groups in their order; a number beyond kMaxLabelGroups is refused.
    [[nodiscard]] bool add_group(const LabelGroup& group);
    /// Both 0..1: `interest` decides on marker and name, `rank` on who comes first; what is no number is left out.
    void offer(LabelKey key, double interest, double rank);
    void settle(LabelShapes& shapes);
    /// Round what is placed anew, so that the way between two intervals seldom brings two labels together.
    [[nodiscard]] static Rect with_margin(const Rect& box, float text_px) { return box.shrunk(-kMargin * text_px); }

    [[nodiscard]] base::Span<const Label> labels() const { return {labels_.data(), has_memory_ ? count_ : 0}; }
    /// Features of a group in view that have a name which is not shown; of those that are not among the best kMax all that are
    /// offered.
    [[nodiscard]] std::uint32_t suppressed(std::uint32_t group) const {
        return group < suppressed_.size() ? suppressed_[group] : 0;
    }
    /// What a frame shows of a label, by a number that tells looks apart (0: nothing). True where that has changed.
    bool note(std::size_t label, std::uint8_t look);
    /// How many labels went that the frame before had, since this was asked last.
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

    LabelHistory interval_;
    design::LabelSettings settings_;
    base::FixedVector<LabelGroup, kMaxLabelGroups> groups_;
    std::array<std::uint32_t, kMaxLabelGroups> offered_{}, visited_{}, shown_{}, suppressed_{};
    base::Span<Label> labels_, held_;  ///< in order of rank; the interval's before, by key
    base::Span<Candidate> candidates_;
    std::size_t count_ = 0, held_count_ = 0, candidate_count_ = 0;
    double changes_left_ = 0;
    std::uint32_t gone_ = 0;
    std::uint8_t elapsed_ = 1;  ///< intervals since the one before
    bool has_memory_ = false, was_skipped_ = false, is_first_ = true;
};

/// All that one frame leaves to the next. Plain data.
struct LabelMemory {
    std::int64_t interval = 0;
    double changes_left = 0;
    std::array<std::uint32_t, kMaxLabelGroups> suppressed{};
    bool has_memory = false, was_skipped = false;
    std::uint32_t gone = 0;  ///< labels that a frame has not counted yet
    base::FixedVector<Label, LabelPlanner::kMax> labels;
};

}  // namespace tedavis::draw
