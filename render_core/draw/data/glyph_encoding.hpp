/// Encodes selected glyphs as instances of shapes: values and uncertainties as direction, size and colour.
///
/// Wind arrows point where the wind blows to, by the exact direction or by the nearest of a few (thesis 4.2.2.2, figure 4.15);
/// their speed is in length and colour alike (4.1.2). What has no direction or no value has a sign of its own, upright and
/// facing the eye: a ring for calm, a crossed ring for variable wind and for classes that differ, a cross for what is missing.
/// Uncertainty is shown by size and colour together (4.2.3), for solids that stand on their position by height; unknown is as
/// large as the least certain level, in a separate colour.
///
/// Glyphs above the ground may have a link to it, in their colour. The link of an aggregate ends at the mean ground height
/// below its members.
///
/// Outside a focus glyphs are smaller, greyer and darker as its look states. At less than full detail there they have plain
/// shapes; below kMinDetailOfValues arrows only show the wind's direction, with equal size and colour.
///
/// Glyphs below kPlainBelow_px have plain shapes. Transparent ones are sorted from far to near. Pure, apart from the batch; any
/// thread.
#pragma once

#include "render_core/design/data_style.hpp"
#include "render_core/draw/data/frame_foci.hpp"
#include "render_core/draw/data/glyph_batch.hpp"
#include "render_core/scene/glyph_selection.hpp"

namespace tedavis::draw {

enum class GlyphForm : std::uint8_t { arrow, flat_arrow, sphere, bar, cone, tetrahedron, circle, triangle, puff };
/// What glyphs show; for wind `value` is the speed, with arrows also the direction.
enum class GlyphSubject : std::uint8_t { value, uncertainty };
enum class GlyphSizing : std::uint8_t {
    alike,
    continuous,
    classes,  ///< by the class of the colour scale; the same as continuous where it has none
};

struct GlyphStyle {
    GlyphForm form = GlyphForm::arrow;
    GlyphSubject subject = GlyphSubject::value;
    GlyphSizing sizing = GlyphSizing::continuous;
    GlyphFacing facing = GlyphFacing::up;    ///< of flat forms and arrows
    double least_value = 0, full_value = 1;  ///< values with the smallest and the full size; for uncertainty 0..1
    double least_share = 0.35;               ///< smallest size as a share of the full one
    double opacity = 1;
    double fading = 0;             ///< 0..1: loss of opacity of the least certain
    double greying = 0;            ///< 0..1: loss of saturation of the least certain, at equal lightness
    std::uint32_t directions = 0;  ///< number of arrow directions, evenly spaced from north; 0: exact directions
    bool is_colored = true;
    design::Color plain{235, 235, 235};  ///< of signs, and of all glyphs without a colour by value
    design::Color missing{150, 150, 150};
    design::Color unknown{255, 0, 255};  ///< colour of unknown uncertainty
    /// For links to the ground, with a mark at their foot: the width of a pixel at a distance of 1; 0: no links.
    double link_per_px = 0;
    const FrameFoci* foci = nullptr;  ///< null: everything is in the focus
};

inline constexpr double kPlainBelow_px = 28;
inline constexpr double kMinDetailOfValues = 0.5;
inline constexpr std::uint32_t kLinkParts = 2;  ///< number of instances of a link

/// `eye` is that of the selection. Returns the number of glyphs for which the batch had no room.
std::uint32_t encode_glyphs(base::Span<const scene::SelectedGlyph> glyphs, scene::GlyphValues values, const GlyphStyle& style,
                            const design::DataScale& scale, const earth::Ecef& eye, GlyphBatch& batch);

}  // namespace tedavis::draw
