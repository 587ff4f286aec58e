/// Which aspect comes first, beyond one of three (thesis 5.1, table 5.1): a weight for each aspect of the picture, and how much
/// of its most a technique conveys at a weight.
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
/// Plain data, read from a design; a design without the section shows everything as it says.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "render_core/base/config_reader.hpp"
#include "render_core/base/fixed_string.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::design {

/// The three of the thesis; the parts of the data that have weights of their own follow them.
inline constexpr std::size_t kTerrainAspect = 0, kDataAspect = 1, kUncertaintyAspect = 2, kMainAspects = 3;
inline constexpr std::size_t kMaxDataParts = 5, kMaxAspects = kMainAspects + kMaxDataParts;
inline constexpr std::array<std::string_view, kMainAspects> kMainAspectNames{"terrain", "data", "uncertainty"};

/// 0..1 each, by aspect.
struct AspectWeights {
    std::array<double, kMaxAspects> of{1, 1, 1, 1, 1, 1, 1, 1};
    bool operator==(const AspectWeights& other) const { return of == other.of; }
};

/// Piece-wise linear, level before the first knot and after the last one.
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
    std::uint32_t roles = 0;  ///< a bit for each scene::LayerRole
    bool is_hazard = false;

    [[nodiscard]] bool has(scene::LayerRole role) const { return (roles >> static_cast<unsigned>(role) & 1u) != 0; }
};

struct PrioritySettings {
    bool is_stated = false;  ///< false: nothing else counts
    AspectWeights weights;
    base::FixedVector<DataPart, kMaxDataParts> parts;
    DetailCurve shading, data, intrinsic, extrinsic;
    DetailCurve sketch;           ///< empty: always whole
    double least_difference = 8;  ///< CIEDE2000 that neighbouring classes on the ground keep in its darkest shade, where they can
    double hazard_weight = 1;     ///< to which what is a hazard raises its aspect's
    double hazard_ahead_s = 90;   ///< flight in which a hazard begins to count; from half of it on it counts in full
    double hazard_within_m = 500;    ///< aside of the way, and above and below it a third
    double clutter_budget = 1;       ///< of a region of the picture, 0..1; 1: none. Never spent on what comes first
    double stale_uncertainty = 0.6;  ///< weight that stale data raise the uncertainty's to

    /// That is held: where no weights are stated nothing comes before anything.
    [[nodiscard]] double held_clutter() const { return is_stated ? clutter_budget : 1; }
    [[nodiscard]] std::size_t count() const { return kMainAspects + parts.size(); }
    /// Of an element of the data: that of the first part that has its role, else the data's.
    [[nodiscard]] std::size_t aspect_of(scene::LayerRole role) const noexcept;
    /// Of these weights: nothing has a larger one.
    [[nodiscard]] bool is_first(std::size_t aspect, const AspectWeights& weighed) const noexcept;
    [[nodiscard]] std::string_view name_of(std::size_t aspect) const;
};
static_assert(std::is_trivially_copyable_v<PrioritySettings>);

void read_priority(base::ConfigSection section, PrioritySettings& priority);

}  // namespace tedavis::design
