/// How spatial data and their uncertainty are shown: colours on the ground, read from the section [data.ground] of a design, and
/// elements over it (data_element.hpp), and views beside it (adjacent_view.hpp).
///
/// Values are in the unit of the scene's attribute; an attribute in SI has SI values.
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

/// Uncertainty in the colours themselves (thesis 4.2.3): what each of them takes away grows with the level.
enum class IntrinsicUncertainty : std::uint8_t {
    none,
    transparency,  ///< the ground shows through
    saturation,    ///< towards grey of the same lightness
    noise,         ///< grains of ground
    strokes,       ///< stripes of ground, wider apart the surer
    bivariate,     ///< towards the ground's plain colour, in classes of uncertainty
    bump,          ///< a rough relief in the shading, the rougher the less sure
    blur,          ///< colours run into each other over as much as four posts
};
inline constexpr std::size_t kIntrinsicUncertainties = 8;
extern const std::array<std::string_view, kIntrinsicUncertainties> kIntrinsicUncertaintyNames;

struct GroundUncertainty {
    IntrinsicUncertainty technique = IntrinsicUncertainty::none;
    double strength = 0.85;    ///< 0..1: what the least sure loses
    std::uint32_t levels = 0;  ///< gradations that are told apart, 2 .. 16; 0: continuous
};

/// Uncertainty beside the colours, by something added to them (thesis 4.2.3, figure 4.17); of unknown it is the least sure's.
enum class UncertaintyOverlay : std::uint8_t {
    none,
    fog,      ///< soft clouds hide what is unsure
    grid,     ///< a mesh of triangles on the ground, twice as wide from one gradation to the next: fine is sure
    contour,  ///< a thick line round what is less sure than the threshold
    halo,     ///< the same with a soft rim
};
inline constexpr std::size_t kUncertaintyOverlays = 5;
extern const std::array<std::string_view, kUncertaintyOverlays> kUncertaintyOverlayNames;

struct GroundOverlay {
    UncertaintyOverlay technique = UncertaintyOverlay::none;
    double strength = 0.85;      ///< 0..1: of fog over the least sure, of lines
    std::uint32_t levels = 0;    ///< gradations, 2 .. 16; 0: continuous, of a mesh five. A mesh has at most 8
    double threshold = 0.5;      ///< 0..1, level of contour and halo
    double mesh_m = 256;         ///< width of the finest mesh: a power of two, so that it meets at every chunk's border
    Color color{196, 204, 212};  ///< lines are a dark shade of it over light ground, and contour and halo have a dark rim
};

/// Of a field that is the mean of an ensemble.
enum class GroundMembers : std::uint8_t {
    mean,
    animated,  ///< one member after the other, and never the mean
};
inline constexpr std::size_t kGroundMembers = 2;
extern const std::array<std::string_view, kGroundMembers> kGroundMembersNames;

inline constexpr double kShowsAll = -1e12;

/// Colour on the ground by a field of the scene.
struct GroundData {
    bool is_shown = false;
    base::FixedString<31> layer, attribute;
    DataScale scale;
    double opacity = 0.85;          ///< 0..1, of the surest
    double shown_from = kShowsAll;  ///< lower values have no colour: radar without echo, calm
    /// Of the slice, in the layer's datum; only fields with several levels ask for it. NaN: the lowest level.
    double height_m = std::numeric_limits<double>::quiet_NaN();
    GroundMembers members = GroundMembers::mean;
    double member_s = 2;                              ///< how long one is shown
    std::uint32_t most_members = scene::kMaxMembers;  ///< of more, so many evenly spaced ones
    GroundUncertainty uncertainty;
    GroundOverlay overlay;
};

struct DataStyle {
    double stale_after_s = 1800;  ///< data older than this are said to be stale
    GroundData ground;
    AdjacentView adjacent;
    DataElementList elements;
};
static_assert(std::is_trivially_copyable_v<DataStyle>);

/// `data` is the section [data]; absent keys keep what `style` has.
void read_data_style(base::ConfigSection data, PaletteSource& palettes, DataStyle& style);

/// How much a technique conveys, 0..1: log2(gradations) / 4, so that 16, the most that any may have, is 1, and one is 0.
/// Gradations are what its construction can show: continuous ones the most, a contour two (sure and unsure), a mesh its widths.
/// What people tell apart is another matter.
[[nodiscard]] double detail_of(const DataScale& scale) noexcept;
[[nodiscard]] double detail_of(const GroundUncertainty& uncertainty) noexcept;
[[nodiscard]] double detail_of(const GroundOverlay& overlay) noexcept;
/// Of so many gradations of an uncertainty, 0 for a continuous one.
[[nodiscard]] double detail_of_levels(std::uint32_t levels) noexcept;
/// Of so many members one after the other or side by side, 1 .. scene::kMaxMembers.
[[nodiscard]] double detail_of_members(std::uint32_t members) noexcept;
/// The same look with no more than `detail` 0..1 in any of them: fewer classes (every second limit, and so on; equal steps where
/// there were none), gradations and members; below two gradations a strength of 0, which needs no other programs, and one member.
/// 1 changes nothing.
[[nodiscard]] GroundData at_detail(const GroundData& ground, double detail) noexcept;
/// The same with one for each part of the look: the data's colours, the uncertainty in them, and what is added to them.
struct GroundDetails {
    double data, intrinsic, extrinsic;
};
[[nodiscard]] GroundData at_detail(const GroundData& ground, const GroundDetails& details) noexcept;
/// Of so many gradations (0: continuous) those that are left; 1: none can be told apart.
[[nodiscard]] std::uint32_t levels_at_detail(std::uint32_t levels, double detail) noexcept;
/// Fewer classes likewise; of one map fewer cells, of several fewer members.
[[nodiscard]] AdjacentView at_detail(const AdjacentView& view, double detail) noexcept;

/// True when two styles need the same shader programs.
[[nodiscard]] bool same_programs(const DataStyle& a, const DataStyle& b) noexcept;

}  // namespace tedavis::design
