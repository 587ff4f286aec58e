/// An element of the data aspect: a layer of the scene with the technique, colours and sizes that show it. Read from the tables
/// [[data.element]] of a design, and drawn in their order.
///
///     [[data.element]] layer = "no_go" a layer of the scene, or role = "obstacle" all its layers of a role
///     (scene::kLayerRoleNames), or own = "trail" the own ship's flight trail; "wind": the winds that it measured technique =
///     "prism" a name of kDataTechniqueNames color = "#e05020" without a scale attribute = "intensity" what the colour says, with
///     palette = "data_radar" and `classes` or `breaks` second_attribute = "..." of tubes: on every other side, with
///     second_palette size_attribute = "..." what the size says: size_m is that of its largest value size_m = 300 radius of tubes
///     and spheres, width of a pathway's frames, length of arrows, height of bars and markers heights_m = [1500, 3000] of slices
///     through a field, in its own datum, or heights_over_ground = true they are above the ground levels = [30, 40] of
///     isosurfaces opacity = 0.5 0..1 ghost = 0.25 what terrain before it leaves of the opacity, 0..1 halo_px = 1.5 dark rim, 0
///     for none grid = true the surface grid's lines on it, of what is a surface (design_settings.hpp) link = true a line down to
///     the ground, of signs, diagrams and glyphs that float detail = 0.7 0..1: what the technique is to convey of its most
///     [data.element.uncertainty] technique = "widening" a name of kElementUncertaintyNames strength = 0.8 levels = 4
///     [data.element.cues] of lines that float (element_cues.hpp)
#pragma once

#include <array>

#include "render_core/design/data_scale.hpp"
#include "render_core/design/element_cues.hpp"
#include "render_core/scene/sdb_format.hpp"

namespace tedavis::design {

enum class DataTechnique : std::uint8_t {
    tube,        ///< trajectories and routes: a tube round the path
    pathway,     ///< trajectories: frames to fly through, ahead of the own ship
    space_time,  ///< trajectories whose height is time
    prism,       ///< areas from their floor to their ceiling
    solid,       ///< obstacles, cables, runways, buildings and models as solids
    ribbon,      ///< lines on the ground
    billboard,   ///< icons and names that face the viewer
    diagram,     ///< small diagrams that face the viewer
    arrows,      ///< wind, one glyph per site
    flat_arrows,
    barbs,
    spheres,
    bars,
    isosurface,
    uncertainty_only,  ///< the uncertainty of sites, by glyphs; their data are shown by another element
    count
};
inline constexpr std::size_t kDataTechniques = static_cast<std::size_t>(DataTechnique::count);
extern const std::array<std::string_view, kDataTechniques> kDataTechniqueNames;

enum class ElementUncertainty : std::uint8_t {
    none,
    transparency,  ///< less certain data are more transparent
    saturation,    ///< less certain data are greyer
    widening,      ///< tubes, pathways and prisms are widened by the accuracy of their positions (95 %)
    ellipsoid,     ///< an ellipsoid of possible positions round a point
    circles,       ///< glyphs for the level, redundantly by size and colour
    triangles,
    tetrahedra,
    dashed_rim,  ///< round a sign, with longer gaps the less certain it is; nothing fades
    count
};
inline constexpr std::size_t kElementUncertainties = static_cast<std::size_t>(ElementUncertainty::count);
extern const std::array<std::string_view, kElementUncertainties> kElementUncertaintyNames;

/// Data of the own aircraft, shown instead of a layer.
enum class OwnData : std::uint8_t { none, trail, wind };

inline constexpr std::size_t kMaxDataElements = 12;
inline constexpr std::size_t kMaxElementHeights = 8;
inline constexpr std::size_t kMaxElementLevels = 4;

using DataName = base::FixedString<31>;

/// Colour by an attribute.
struct ColorEncoding {
    DataName attribute;  ///< empty: the plain colour
    DataScale scale;

    [[nodiscard]] bool is_used() const { return !attribute.view().empty(); }
};

struct DataElement {
    DataName layer;  ///< empty: by role, or own data
    scene::LayerRole role = scene::LayerRole::count;
    OwnData own = OwnData::none;
    DataTechnique technique = DataTechnique::solid;
    Color color{255, 255, 255, 255};
    ColorEncoding by_color, by_second_color;
    DataName size_attribute;
    double size_m = 0;  ///< 0: the technique's default
    base::FixedVector<double, kMaxElementHeights> heights_m;
    bool heights_over_ground = false;
    base::FixedVector<double, kMaxElementLevels> levels;
    double opacity = 1;
    double ghost = 0;
    double halo_px = 0;
    bool grid = false;
    bool link = false;
    double detail = 1;
    ElementUncertainty uncertainty = ElementUncertainty::none;
    double uncertainty_strength = 0.85;
    std::uint32_t uncertainty_levels = 0;  ///< 0: continuous
    ElementCues cues;
};
static_assert(std::is_trivially_copyable_v<DataElement>);

using DataElementList = base::FixedVector<DataElement, kMaxDataElements>;

/// Returns the name used in records: a layer, a role, or "own trail".
[[nodiscard]] DataName subject_of(const DataElement& element) noexcept;

[[nodiscard]] bool asks_for_own(const DataElementList& elements) noexcept;
/// True where an element shows the role `traffic`; received traffic is shown without a scene too.
[[nodiscard]] bool asks_for_traffic(const DataElementList& elements) noexcept;
/// True where an element has the surface grid's lines.
[[nodiscard]] bool asks_for_grid(const DataElementList& elements) noexcept;

/// Reads the elements; `data` is the section [data].
void read_data_elements(base::ConfigSection& data, PaletteSource& palettes, DataElementList& elements);

}  // namespace tedavis::design
