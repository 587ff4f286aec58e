/// Chooses between triangles and rays for a design that leaves the choice to the display (`renderer = "auto"`): the renderer that
/// draws the terrain of the frame in less time, by the costs that were measured on the device. Rays have no error. They are
/// therefore chosen at equal costs, and where triangles do not show the terrain as exactly as the design asks.
///
/// - Rays are never chosen where they alone, with what every frame costs, exceed the deadline, unless triangles show no terrain.
/// - A change must save a tenth of the present renderer's cost for the whole dwell. The first frame of a design is decided at
/// once,
///   and so is a frame that triangles cannot show.
/// - Without measured costs triangles are drawn, unless they show no terrain; no earlier frame matters then.
/// - It is deterministic: it uses the source's time and modelled costs and reads no clock.
///
/// Pure. Thread  any. Memory  none; the state is plain data of fixed size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "render_core/base/time.hpp"

namespace tedavis::effects {

/// The modelled costs of one frame's terrain by each renderer, ms.
struct RendererCosts {
    bool is_known = false;  ///< both were measured
    double triangles_ms = 0, rays_ms = 0;
    double frame_ms = 0;     ///< what every frame costs without terrain and effects
    double deadline_ms = 0;  ///< of the frame; 0: there is none
};

/// How triangles show the terrain of one frame.
enum class TriangleFit : std::uint8_t {
    exact_enough,  ///< within the error that the design asks for
    is_short,      ///< budgets, or chunks that have not arrived, leave a greater error
    none,          ///< so coarsely that the terrain would be removed
};

/// Why the renderer was chosen.
enum class RendererWhy : std::uint8_t {
    costs_unknown,    ///< no calibration states what rays cost: triangles
    costs_no_more,    ///< the chosen renderer, than the other one
    rays_too_late,    ///< triangles, because rays exceed the deadline
    waits,            ///< the other renderer is the better one, but not by enough or not for long enough
    triangles_short,  ///< rays, because triangles are not exact enough
    count_
};
/// Returns the text for records.
[[nodiscard]] std::string_view to_string(RendererWhy why) noexcept;

struct RendererDecision {
    bool by_rays = false;
    RendererWhy why = RendererWhy::costs_unknown;
    RendererCosts costs;
};

class RendererChoice {
public:
    static constexpr base::Duration kDwell = base::Duration::seconds(2);
    static constexpr double kLargestShare = 0.9;  ///< of the present renderer's cost, below which the other one must be

    /// Decides for the frame at `now` of the design at place `design`. The same time again decides the same frame anew, as if it
    /// had not been decided before; a time before the last one begins without history.
    RendererDecision decide(base::Time now, std::size_t design, const RendererCosts& costs, TriangleFit fit);
    /// Replaces decide() in a frame without a choice; the next one is then a first frame.
    void rest(base::Time now);

private:
    struct State {
        bool has_begun = false, by_rays = false;
        bool other_is_better = false;  ///< with better_since
        std::size_t design = 0;
        base::Time better_since;
    };
    void begin(base::Time now);

    State now_, before_;  ///< before_: the state before the frame of time_ was decided
    base::Time time_;
    bool has_time_ = false;
};
static_assert(std::is_trivially_copyable_v<RendererChoice>);

}  // namespace tedavis::effects
