/// Which effects a frame computes: those that are asked for, that the scene and the view call for, and that the device can do.
/// Everything else is replaced or left out, each for a reason that the frame's record tells. So is what the time does not suffice
/// for.
///
/// Pure. Thread  any. Memory  none; the plan is of fixed size.
#pragma once

#include <limits>
#include <type_traits>

#include "render_core/effects/replacement_order.hpp"

namespace tedavis::effects {

/// What scene, view and data say to one effect.
struct EffectRequest {
    enum class Kind : std::uint8_t {
        not_asked_for,  ///< by the design; the plan leaves it out and does not speak of it
        applicable,
        not_applicable,  ///< nothing in scene or view is changed by it
        no_input,        ///< what it shows is not there
    };
    Kind kind = Kind::not_asked_for;
    std::string_view why;  ///< static storage; of the two last kinds. Of `applicable`: why it runs, or empty
    /// Upper bound of its visible contribution in this frame, in the unit of its Contribution.
    double bound = std::numeric_limits<double>::infinity();
};

enum class PlanState : std::uint8_t { not_asked_for, run, replaced, skipped };

struct PlannedEffect {
    PlanState state = PlanState::not_asked_for;
    std::string_view reason;              ///< static storage
    Effect replaced_by = Effect::count_;  ///< where it is replaced
    double bound = 0;                     ///< where it is skipped for being unseen: what is not seen
};

/// Effects that may not run, whatever the device can do.
class EffectSet {
public:
    void add(const EffectSet& effects) { bits_ |= effects.bits_; }
    void remove(Effect effect) { bits_ &= ~(1u << static_cast<unsigned>(effect)); }
    void add(Effect effect) { bits_ |= 1u << static_cast<unsigned>(effect); }
    [[nodiscard]] bool has(Effect effect) const { return (bits_ >> static_cast<unsigned>(effect) & 1u) != 0; }

private:
    std::uint32_t bits_ = 0;
    static_assert(kEffectCount <= 32);
};

struct PlanInput {
    std::array<EffectRequest, kEffectCount> requests{};
    EffectSet forbidden;   ///< by the device's file
    EffectSet too_costly;  ///< for the frame's deadline; replaced by what is in reserve, or left out
    EffectSet in_reserve;  ///< what can take another's place within a running display: its programs are there
    ReplacementOrder order;
    bool is_forced = false;  ///< nothing is left out for being unseen: what a picture without this planner would cost

    [[nodiscard]] EffectRequest& operator[](Effect effect) { return requests[static_cast<std::size_t>(effect)]; }
};

class FramePlan {
public:
    [[nodiscard]] const PlannedEffect& operator[](Effect effect) const { return effects_[static_cast<std::size_t>(effect)]; }
    /// Whether it is computed: asked for by itself, or in another's place.
    [[nodiscard]] bool runs(Effect effect) const;
    /// Sum of the bounds of what changes colours and is left out.
    [[nodiscard]] double unseen_color() const;

private:
    friend FramePlan plan_effects(const PlanInput& input, const DeviceCapability& device) noexcept;
    std::array<PlannedEffect, kEffectCount> effects_{};
};
static_assert(std::is_trivially_copyable_v<FramePlan>);

[[nodiscard]] FramePlan plan_effects(const PlanInput& input, const DeviceCapability& device) noexcept;

/// What stands for `effect` on a device: itself, its first replacement that is possible there, or count_ for none.
[[nodiscard]] Effect possible_effect(Effect effect, const EffectSet& forbidden, const DeviceCapability& device,
                                     const ReplacementOrder& order) noexcept;

}  // namespace tedavis::effects
