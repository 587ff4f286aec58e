/// Selects the points of a layer's lines that a tube passes through, and their positions.
///
/// The number of kept points depends on detail and room: tolerances begin at a tenth of the tube's radius at full detail and at
/// ten radii at none, and grow by 2^(1/4) until all lines together fit. A point that is left out is no farther from the tube's
/// middle than the tolerance (polyline_weights.hpp), and neither are its values, where the range of an attribute counts like
/// kRadiiOfRange radii. Lines are processed in windows of kTubeWindow points, whose ends are kept, as are points beside gaps
/// and where time runs back.
///
/// In space-time the height is replaced by the time since the layer's first point: `size_m` (1000 m) per hour above the highest
/// ground below the lines. A point without a time then has no position.
///
/// For other aircraft (role `traffic`) points after the frame's time have no position.
///
/// Memory  from an arena, once. Thread  the ground's. Bounded: two visits of a point, each as polyline_weights.hpp says of a
/// window.
#pragma once

#include "render_core/base/memory_budget.hpp"
#include "render_core/draw/data/element_input.hpp"
#include "render_core/draw/data/polyline_weights.hpp"
#include "render_core/scene/trajectory_tube.hpp"

namespace tedavis::draw {

inline constexpr std::uint32_t kTubeWindow = 512;
inline constexpr double kRadiiOfRange = 5;
inline constexpr double kDefaultTubeRadius_m = 40;
inline constexpr double kDefaultTimeHeight_m = 1000;
/// Least radius of a tube with a size attribute, as a share of the largest.
inline constexpr double kThinnestTube = 0.1;

/// A point of a line for the tube.
struct TubePlace {
    glm::dvec3 place{0};  ///< ECEF; NaN: it has none
    std::int64_t time_ns = scene::kNoTime;
    float weight_m = 0;
    std::uint32_t number = 0;  ///< of the layer's points

    [[nodiscard]] bool is_known() const;
};

/// The points of one line that the tube passes through. A point without a position stands for a gap.
class TubeLine {
public:
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t points);
    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t points);

    [[nodiscard]] base::Span<const scene::TubePoint> points() const { return {points_.data(), count_}; }
    /// The number of each of these points in the layer.
    [[nodiscard]] base::Span<const std::uint32_t> numbers() const { return {numbers_.data(), count_}; }
    [[nodiscard]] bool ends_in_gap() const;
    [[nodiscard]] std::uint32_t capacity() const { return static_cast<std::uint32_t>(points_.size()); }
    std::uint32_t left_out = 0;  ///< points within the tolerance

    void clear() { count_ = left_out = 0; }
    /// Adds a point; returns false when the line is full.
    bool add(const scene::TubePoint& point, std::uint32_t number);

private:
    base::Span<scene::TubePoint> points_;
    base::Span<std::uint32_t> numbers_;
    std::uint32_t count_ = 0;
};

class TubePath {
public:
    [[nodiscard]] static std::uint64_t bytes_needed();
    [[nodiscard]] bool start(base::Arena& arena);

    /// Chooses the tolerance for all lines of the input's layer so that at most `most_points` are kept, if a tolerance achieves
    /// that. The input must stay valid until the next call.
    void plan(const ElementInput& input, std::uint32_t most_points);
    [[nodiscard]] double tolerance_m() const { return tolerance_m_; }
    [[nodiscard]] double radius_m() const { return radius_m_; }
    [[nodiscard]] bool is_space_time() const;

    void read(std::uint32_t feature, TubeLine& line);

private:
    template <class Visitor>
    void visit(std::uint32_t feature, Visitor visitor);
    /// Number of points from `first` on without a gap, at most one window.
    std::uint32_t fill(std::uint32_t feature, std::uint32_t first, std::uint32_t end);
    [[nodiscard]] glm::dvec3 place_of(const scene::ScenePoint& point) const;
    [[nodiscard]] double value_in_metres(const scene::Attribute* attribute, std::uint32_t feature, std::uint32_t point) const;
    [[nodiscard]] double radius_of(std::uint32_t feature, std::uint32_t point) const;
    void take_reference();

    base::Span<PolylineVertex> window_;
    base::Span<float> weights_;
    base::Span<PolylineStretch> waiting_;
    const ElementInput* input_ = nullptr;
    const scene::Attribute* shown_[3] = {};
    double tolerance_m_ = 0, radius_m_ = 0;
    std::int64_t first_time_ns_ = scene::kNoTime;
    double reference_m_ = 0, metres_per_ns_ = 0;
};

}  // namespace tedavis::draw
