/// Builds a scene's lines as tubes: trajectories and routes in space (technique `tube`), or with time as their height
/// (`space_time`).
///
/// Tubes are hexagonal. Beginning with the upper side, sides show in turn the element's scale and, where it has one, its second
/// scale. Values are those of points along the way, those of features for the whole line; what is missing has the
/// colour of missing data. size_m is the radius (kDefaultTubeRadius_m), of a size attribute that of its largest value; in
/// space-time metres an hour, and the radius is the default. A line of one point is an octahedron. With `link`, and always in
/// space-time, thin posts stand under both ends. An opaque tube may have a rim (`halo_px`), whose width is in pixels at every
/// distance. Uncertainty `widening` adds a translucent hull as wide as the position's accuracy: the attributes
/// "position_accuracy" and "height_accuracy" (m, 95 %) where the layer has them, else what the layer states as a whole, else
/// the worst of all points; a height accuracy that is not stated equals the position accuracy. Tubes and hulls are not visible
/// from inside, and end kNearRadii of their radii before the eye point, so that the own ship's path does not fill the view.
///
/// Counts are points of the layer, not lines: drawn are those that a ring stands at, aggregated those that the tube passes within
/// its tolerance (tube_path.hpp), hidden those without a place or without room. Tubes take at most half of the room that the
/// batch has left, so that elements after them find some.
#pragma once

#include "render_core/draw/data/tube_path.hpp"
#include "render_core/draw/data/tube_skin.hpp"

namespace tedavis::draw {

inline constexpr float kNearRadii = 8;

class TubeSolids {
public:
    /// Rings for batches of so many vertices.
    [[nodiscard]] static std::uint32_t rings_for(std::uint32_t batch_vertices);
    [[nodiscard]] static std::uint64_t bytes_needed(std::uint32_t rings);
    [[nodiscard]] bool start(base::Arena& arena, std::uint32_t rings);

    [[nodiscard]] ElementCount add(SolidBatch& batch, SolidMesh& mesh, const ElementInput& input);

private:
    struct Work {
        SolidBatch& batch;
        SolidMesh& mesh;
        const ElementInput& input;
        std::uint32_t feature;
        base::Span<const scene::TubeRing> rings;
        PlaceAccuracy worst;  ///< of the layer
    };
    enum class Layer : std::uint8_t { sides, rim, margin };
    [[nodiscard]] std::uint32_t most_points(const SolidBatch& batch, const ElementInput& input) const;
    std::uint32_t add_layer(const Work& work, Layer layer);
    [[nodiscard]] bool add_block(const Work& work, Layer layer, const TubeBlock& block);
    [[nodiscard]] RingColors colors_of(const Work& work, const scene::TubeRing& ring) const;
    [[nodiscard]] TubeMargin margin_of(const Work& work, const scene::TubeRing& ring) const;
    [[nodiscard]] float largest_radius_m(const Work& work, Layer layer) const;
    void add_posts(const Work& work);
    void add_post(const Work& work, const scene::TubeRing& ring);

    TubePath way_;
    TubeLine line_;
    TubeSkin skin_;
    base::Span<scene::TubeRing> rings_;
};

/// True for layers that can be shown as tubes.
[[nodiscard]] bool shows_tubes(const scene::Layer& layer);

}  // namespace tedavis::draw
