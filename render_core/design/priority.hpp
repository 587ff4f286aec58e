/// Priorities of aspects (thesis 5.1, table 5.1): a weight for each aspect of the picture, and the share of its detail that a
/// technique conveys at a weight.
///
///     [priority]
///     terrain = 0.3                         0..1, as all of them; 1 where nothing is stated
///     data = 1.0
///     uncertainty = 0.3
///     [[priority.aspect]]                   a part of the data with a weight of its own
///     name = "obstacles"
///     roles = ["obstacle", "no_go"]
///     weight = 0.8
///     hazard = true                         it may raise its weight, as terrain does
///     [priority.detail]
///     shading = [0.3, 0, 0.7, 1]            weight, detail, weight, detail ...: linear between, level beyond
///
/// Plain data, read from a design; a design without the section shows everything in full detail.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "render_core/base/config_reader.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::design {

/// The three aspects of the thesis; parts of the data with separate weights follow them.
inline constexpr std::size_t kTerrainAspect = 0, kDataAspect = 1, kUncertaintyAspect = 2, kMainAspects = 3;
inline constexpr std::size_t kMaxDataParts = 5, kMaxAspects = kMainAspects + kMaxDataParts;
inline constexpr std::array<std::string_view, kMainAspects> kMainAspectNames{"terrain", "data", "uncertainty"};

/// Weights 0..1, by aspect.
struct AspectWeights {
    std::array<double, kMaxAspects> of{1, 1, 1, 1, 1, 1, 1, 1};
    bool operator==(const AspectWeights& other) const { return of == other.of; }
};

/// A piecewise linear curve, constant before the first knot and after the last one.
struct DetailCurve {
    struct Knot {
        double weight, detail;
    };
    static constexpr std::size_t kMaxKnots = 4;
    base::FixedVector<Knot, kMaxKnots> knots;  ///< ascending weights; empty: the detail is the weight

    [[nodiscard]] double at(double weight) const noexcept;
};

struct DataPart {
    base::FixedString<23> name;
    std::uint32_t roles = 0;  ///< one bit for each scene::LayerRole
    bool is_hazard = false;

    [[nodiscard]] bool has(scene::LayerRole role) const { return (roles >> static_cast<unsigned>(role) & 1u) != 0; }
};

struct PrioritySettings {
    bool is_stated = false;  ///< false: the design has no priorities, and the other members have no effect
    AspectWeights weights;
    base::FixedVector<DataPart, kMaxDataParts> parts;
    DetailCurve shading, data, intrinsic, extrinsic;
    DetailCurve sketch;              ///< empty: always full detail
    double least_difference = 8;     ///< least CIEDE2000 difference of neighbouring classes on the ground in its darkest shade
    double hazard_weight = 1;        ///< weight to which a hazard raises its aspect
    double hazard_ahead_s = 90;      ///< time ahead at which a hazard begins to count; it counts fully from half of it on
    double hazard_within_m = 500;    ///< lateral distance from the track; a third of it above and below
    double clutter_budget = 1;       ///< largest clutter of a region of the picture, 0..1; 1: no budget
    double stale_uncertainty = 0.6;  ///< weight to which stale data raise the aspect uncertainty

    /// True where neither data nor uncertainty has a larger weight, and where the design states no weights.
    [[nodiscard]] bool puts_terrain_first() const {
        return !is_stated || (weights.of[kTerrainAspect] >= weights.of[kDataAspect] &&
                              weights.of[kTerrainAspect] >= weights.of[kUncertaintyAspect]);
    }
    /// The budget that is held: none where the design states no weights, because no aspect then comes first.
    [[nodiscard]] double held_clutter() const { return is_stated ? clutter_budget : 1; }
    [[nodiscard]] std::size_t count() const { return kMainAspects + parts.size(); }
    /// Returns the aspect of an element of the data: the first part that has its role, else the data.
    [[nodiscard]] std::size_t aspect_of(scene::LayerRole role) const noexcept;
    /// True where no aspect has a larger weight.
    [[nodiscard]] bool is_first(std::size_t aspect, const AspectWeights& weighed) const noexcept;
    [[nodiscard]] std::string_view name_of(std::size_t aspect) const;
};
static_assert(std::is_trivially_copyable_v<PrioritySettings>);

void read_priority(base::ConfigSection section, PrioritySettings& priority);

}  // namespace tedavis::design
