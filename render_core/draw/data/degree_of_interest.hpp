/// The degree of interest of a feature (thesis 5.2.3), which decides on its sign: 0..1, the weighted mean of criteria 0..1:
///
///   distance       1 at the eye, 0 from kFarthestBillboard_m on: 1 - ln(1 + d / 1 km) / ln(1 + farthest / 1 km), with the
///                  distance d scaled to a field of view of 60 degrees
///   population     of places: the attribute "population", 0 up to 100 people, 1 from a million on, by the logarithm; where the
///                  layer has none, its ordinal attribute "kind", from its first class to its last
///   height         the attribute "height", else "elevation" (m), as a share of the largest in the layer
///   runway_length  of runways: the attribute "length" (m), as a share of kLongRunway_m
///   relevance      of the feature's role, as the design of the flight phase states it
///
/// A criterion that the layer does not have does not count for its features; a missing value counts 0.5. Pure; any thread.
#pragma once

#include "render_core/design/label_settings.hpp"
#include "render_core/scene/scene.hpp"

namespace tedavis::draw {

inline constexpr double kFarthestBillboard_m = 80'000;
inline constexpr double kLongRunway_m = 3000;

class DegreeOfInterest {
public:
    /// Layer and settings must outlive the object.
    DegreeOfInterest(const scene::Layer& layer, const design::LabelSettings& settings);
    /// `distance_m`: BillboardSheet::seen_distance_m().
    [[nodiscard]] double of(std::uint32_t feature, double distance_m) const;

    /// The criterion `distance`.
    [[nodiscard]] static double nearness(double distance_m);

private:
    [[nodiscard]] double population(std::uint32_t feature) const;

    const design::LabelWeights& weights_;
    double relevance_ = 0;
    const scene::Attribute *population_ = nullptr, *kind_ = nullptr, *height_ = nullptr, *length_ = nullptr;
};

}  // namespace tedavis::draw
