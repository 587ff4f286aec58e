/// How spatial data and their uncertainty are shown: colours on the ground, read from the section [data.ground] of a design, and
/// elements over it (data_element.hpp).
///
/// Values are in the unit of the scene's attribute; an attribute in SI has SI values.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "render_core/base/config_reader.hpp"
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
};
inline constexpr std::size_t kIntrinsicUncertainties = 6;
extern const std::array<std::string_view, kIntrinsicUncertainties> kIntrinsicUncertaintyNames;

struct GroundUncertainty {
    IntrinsicUncertainty technique = IntrinsicUncertainty::none;
    double strength = 0.85;    ///< 0..1: what the least sure loses
    std::uint32_t levels = 0;  ///< gradations that are told apart, 2 .. 16; 0: continuous
};

/// Colour on the ground by a field of the scene.
struct GroundData {
    bool is_shown = false;
    base::FixedString<31> layer, attribute;
    DataScale scale;
    double opacity = 0.85;  ///< 0..1, of the surest
    double height_m = 0;    ///< of the slice, in the layer's datum; only fields with several levels ask for it
    GroundUncertainty uncertainty;
};

struct DataStyle {
    double stale_after_s = 1800;  ///< data older than this are said to be stale
    GroundData ground;
    DataElementList elements;
};
static_assert(std::is_trivially_copyable_v<DataStyle>);

/// `data` is the section [data]; absent keys keep what `style` has.
void read_data_style(base::ConfigSection data, PaletteSource& palettes, DataStyle& style);

/// True when two styles need the same shader programs.
[[nodiscard]] bool same_programs(const DataStyle& a, const DataStyle& b) noexcept;

}  // namespace tedavis::design
