/// How spatial data and their uncertainty are shown: colours on the ground (section [data.ground] of a design), elements above
/// it (data_element.hpp) and adjacent views (adjacent_view.hpp).
///
/// Values are in the unit of the scene's attribute.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>

#include "render_core/base/config_reader.hpp"
#include "render_core/design/adjacent_view.hpp"
#include "render_core/design/data_element.hpp"
#include "render_core/design/data_scale.hpp"

namespace tedavis::design {

/// Intrinsic uncertainty, shown in the colours themselves (thesis 4.2.3); the effect grows with the level.
enum class IntrinsicUncertainty : std::uint8_t {
    none,
    transparency,  ///< the ground shows through
    saturation,    ///< towards grey of the same lightness
    noise,         ///< grains of the ground's colour
    strokes,       ///< stripes of the ground's colour, wider apart the more certain the value is
    bivariate,     ///< blends towards the ground's plain colour, in classes of uncertainty
    bump,          ///< a rough relief in the shading, rougher the less certain the value is
    blur,          ///< colours are blurred over up to four posts
};
inline constexpr std::size_t kIntrinsicUncertainties = 8;
extern const std::array<std::string_view, kIntrinsicUncertainties> kIntrinsicUncertaintyNames;

struct GroundUncertainty {
    IntrinsicUncertainty technique = IntrinsicUncertainty::none;
    double strength = 0.85;    ///< 0..1: effect on the least certain values
    std::uint32_t levels = 0;  ///< number of distinct gradations, 2 .. 16; 0: continuous
};

/// Extrinsic uncertainty, shown by something added to the colours (thesis 4.2.3, figure 4.17); unknown is shown like the least
/// certain.
enum class UncertaintyOverlay : std::uint8_t {
    none,
    fog,      ///< soft clouds hide uncertain values
    grid,     ///< a mesh of triangles on the ground whose width doubles with each gradation: fine means certain
    contour,  ///< a thick line round values less certain than the threshold
    halo,     ///< the same with a soft rim
};
inline constexpr std::size_t kUncertaintyOverlays = 5;
extern const std::array<std::string_view, kUncertaintyOverlays> kUncertaintyOverlayNames;

struct GroundOverlay {
    UncertaintyOverlay technique = UncertaintyOverlay::none;
    double strength = 0.85;      ///< 0..1: strength of fog over the least certain values, and of lines
    std::uint32_t levels = 0;    ///< gradations, 2 .. 16; 0: continuous, of a mesh five. A mesh has at most 8
    double threshold = 0.5;      ///< 0..1, uncertainty level of contour and halo
    double mesh_m = 256;         ///< width of the finest mesh: a power of two, so that it meets at every chunk's border
    Color color{196, 204, 212};  ///< lines use a dark shade of it over light ground; contour and halo have a dark rim
};

/// How a field that is the mean of an ensemble is shown.
enum class GroundMembers : std::uint8_t {
    mean,
    animated,  ///< one member after another, never the mean
};
inline constexpr std::size_t kGroundMembers = 2;
extern const std::array<std::string_view, kGroundMembers> kGroundMembersNames;

inline constexpr double kShowsAll = -1e12;

/// Colour of the ground by a field of the scene.
struct GroundData {
    bool is_shown = false;
    base::FixedString<31> layer, attribute;
    DataScale scale;
    double opacity = 0.85;          ///< 0..1, for the most certain values
    double shown_from = kShowsAll;  ///< lower values have no colour: radar without echo, calm
    /// Height of the slice in the layer's datum, for fields with several levels. NaN: the lowest level.
    double height_m = std::numeric_limits<double>::quiet_NaN();
    GroundMembers members = GroundMembers::mean;
    double member_s = 2;                              ///< time for which one member is shown
    std::uint32_t most_members = scene::kMaxMembers;  ///< most members shown; of a larger ensemble evenly spaced ones
    GroundUncertainty uncertainty;
    GroundOverlay overlay;
};

struct DataStyle {
    double stale_after_s = 1800;      ///< age beyond which data are marked stale
    Color missing{0xC0, 0x30, 0xC0};  ///< of missing values
    GroundData ground;
    AdjacentView adjacent;
    DataElementList elements;
};
static_assert(std::is_trivially_copyable_v<DataStyle>);

/// Reads the section [data]; absent keys leave `style` unchanged.
void read_data_style(base::ConfigSection data, PaletteSource& palettes, DataStyle& style);

/// The detail that a technique conveys, 0..1: log2(gradations) / 4, so that 16 gradations, the maximum, are 1, and one is 0.
/// Gradations are those that the technique can show: 16 for a continuous one, two for a contour, the number of widths for a
/// mesh. Whether viewers can distinguish them is not considered.
[[nodiscard]] double detail_of(const DataScale& scale) noexcept;
[[nodiscard]] double detail_of(const GroundUncertainty& uncertainty) noexcept;
[[nodiscard]] double detail_of(const GroundOverlay& overlay) noexcept;
/// Returns the detail of a number of gradations of an uncertainty; 0 gradations mean continuous.
[[nodiscard]] double detail_of_levels(std::uint32_t levels) noexcept;
/// Returns the detail of a number of members shown one after another or side by side, 1 .. scene::kMaxMembers.
[[nodiscard]] double detail_of_members(std::uint32_t members) noexcept;
/// Returns the style with at most `detail` 0..1 in each of its parts: fewer classes (see reduce_classes()), gradations and
/// members. Below two gradations the strength is 0, which needs no other shader programs, and one member remains. 1 changes
/// nothing.
[[nodiscard]] GroundData at_detail(const GroundData& ground, double detail) noexcept;
/// The same with a separate detail for the data's colours, for intrinsic and for extrinsic uncertainty.
struct GroundDetails {
    double data, intrinsic, extrinsic;
};
[[nodiscard]] GroundData at_detail(const GroundData& ground, const GroundDetails& details) noexcept;
/// Returns the gradations that remain of `levels` (0: continuous) at a detail; 1 means that nothing is distinguished.
[[nodiscard]] std::uint32_t levels_at_detail(std::uint32_t levels, double detail) noexcept;
/// Returns the view with fewer classes in the same way; a single map gets fewer cells, several maps fewer members.
[[nodiscard]] AdjacentView at_detail(const AdjacentView& view, double detail) noexcept;

/// True when two styles need the same shader programs.
[[nodiscard]] bool same_programs(const DataStyle& a, const DataStyle& b) noexcept;

}  // namespace tedavis::design
