/// Decides which effects a frame computes: those that are requested, applicable to scene and view, possible on the device and
/// within the deadline. The others are replaced or left out, each for a reason that the frame's record states.
///
/// Pure. Thread  any. Memory  none; the plan is of fixed size.
#pragma once

#include <limits>
#include <type_traits>

#include "render_core/effects/replacement_order.hpp"

namespace tedavis::effects {

/// The state of one effect for scene, view and data.
struct EffectRequest {
    enum class Kind : std::uint8_t {
        not_asked_for,  ///< not requested by the design; the plan leaves it out without a reason
        applicable,
        not_applicable,  ///< it would not change anything in scene or view
        no_input,        ///< its input is not available
    };
    Kind kind = Kind::not_asked_for;
    std::string_view why;  ///< static storage; for the last two kinds the reason. For `applicable`: why it runs, or empty
    /// Upper bound of its visible contribution in this frame, in the unit of its Contribution.
    double bound = std::numeric_limits<double>::infinity();
};

enum class PlanState : std::uint8_t { not_asked_for, run, replaced, skipped };

struct PlannedEffect {
    PlanState state = PlanState::not_asked_for;
    std::string_view reason;              ///< static storage
    Effect replaced_by = Effect::count_;  ///< its replacement, if any
    double bound = 0;                     ///< where it is skipped as invisible: the bound of its contribution
};

/// A set of effects.
class EffectSet {
public:
    void add(const EffectSet& effects) { bits_ |= effects.bits_; }
    void remove(Effect effect) { bits_ &= ~(1u << static_cast<unsigned>(effect)); }
    void add(Effect effect) { bits_ |= 1u << static_cast<unsigned>(effect); }
    [[nodiscard]] bool has(Effect effect) const { return (bits_ >> static_cast<unsigned>(effect) & 1u) != 0; }
    [[nodiscard]] bool has_all(const EffectSet& effects) const { return (effects.bits_ & ~bits_) == 0; }
    [[nodiscard]] bool is_empty() const { return bits_ == 0; }

private:
    std::uint32_t bits_ = 0;
    static_assert(kEffectCount <= 32);
};

struct PlanInput {
    std::array<EffectRequest, kEffectCount> requests{};
    EffectSet forbidden;   ///< by the device's file
    EffectSet too_costly;  ///< effects given up for the frame's deadline; replaced by one in reserve, or left out
    EffectSet in_reserve;  ///< effects that can replace others in a running display, because their programs are loaded
    ReplacementOrder order;
    bool is_forced = false;  ///< no effect is left out as invisible, to measure the cost without this planner

    [[nodiscard]] EffectRequest& operator[](Effect effect) { return requests[static_cast<std::size_t>(effect)]; }
};

class FramePlan {
public:
    [[nodiscard]] const PlannedEffect& operator[](Effect effect) const { return effects_[static_cast<std::size_t>(effect)]; }
    /// True where an effect is computed, requested or as a replacement.
    [[nodiscard]] bool runs(Effect effect) const;
    /// Returns the sum of the bounds of colour effects that are left out.
    [[nodiscard]] double unseen_color() const;

private:
    friend FramePlan plan_effects(const PlanInput& input, const DeviceCapability& device) noexcept;
    std::array<PlannedEffect, kEffectCount> effects_{};
};
static_assert(std::is_trivially_copyable_v<FramePlan>);

[[nodiscard]] FramePlan plan_effects(const PlanInput& input, const DeviceCapability& device) noexcept;

/// Returns the effect that a device shows for `effect`: itself, its first possible replacement, or count_ for none.
[[nodiscard]] Effect possible_effect(Effect effect, const EffectSet& forbidden, const DeviceCapability& device,
                                     const ReplacementOrder& order) noexcept;

}  // namespace tedavis::effects
