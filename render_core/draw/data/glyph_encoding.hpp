/// From selected glyphs to instances of shapes: what of their values and uncertainties is shown by direction, size and colour.
///
/// Wind arrows point where the wind blows to, by the exact direction or by the nearest of a few (thesis 4.2.2.2, figure 4.15);
/// their speed is in length and colour alike (4.1.2). What has no direction or no value has a sign of its own, upright and facing
/// the eye: a ring for calm, a crossed ring for variable wind and for classes that differ, a cross for what is missing.
/// Uncertainty has size and colour alike (4.2.3), solids that stand on their place by their height; unknown is as large as the
/// least certain, in a colour that no level has.
///
/// What floats over the ground may have a link to it, in its own colour. Those of an aggregate lead to the mean height of the
/// ground below its members.
///
/// Beside a focus they are smaller, greyer and darker as its look says. With less than all detail there they have plain shapes;
/// with less than kMinDetailOfValues arrows say nothing but where the wind blows to: all are alike, without a colour by value.
///
/// Glyphs below kPlainBelow_px take plain shapes. Transparent ones are put in the order from far to near.
/// Pure but for the batch; any thread.
#pragma once

#include "render_core/design/data_style.hpp"
#include "render_core/draw/data/frame_foci.hpp"
#include "render_core/draw/data/glyph_batch.hpp"
#include "render_core/scene/glyph_selection.hpp"

namespace tedavis::draw {

enum class GlyphForm : std::uint8_t { arrow, flat_arrow, sphere, bar, cone, tetrahedron, circle, triangle, puff };
/// What is shown: of wind its speed, and by arrows its direction.
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
    double least_value = 0, full_value = 1;  ///< with the smallest size and the full one; levels of uncertainty are 0..1
    double least_share = 0.35;               ///< the smallest size, of the full one
    double opacity = 1;
    double fading = 0;             ///< 0..1: what the opacity of the least sure loses
    double greying = 0;            ///< 0..1: how grey the least sure is, as light as it was
    std::uint32_t directions = 0;  ///< of arrows, evenly round the compass from north on; 0: as they are
    bool is_colored = true;
    design::Color plain{235, 235, 235};  ///< of signs, and of all where there is no colour by value
    design::Color missing{150, 150, 150};
    design::Color unknown{255, 0, 255};  ///< of an uncertainty
    /// Of those that float: a line down to the ground below them and a mark where it stands, for which this is how wide a pixel
    /// is at a distance of 1; 0: none.
    double link_per_px = 0;
    const FrameFoci* foci = nullptr;  ///< null: everything is in the focus
};

inline constexpr double kPlainBelow_px = 28;
inline constexpr double kMinDetailOfValues = 0.5;
inline constexpr std::uint32_t kLinkParts = 2;  ///< instances of a link

/// `eye`: the one of the selection. The number of glyphs for which the batch had no room.
std::uint32_t encode_glyphs(base::Span<const scene::SelectedGlyph> glyphs, scene::GlyphValues values, const GlyphStyle& style,
                            const design::DataScale& scale, const earth::Ecef& eye, GlyphBatch& batch);

}  // namespace tedavis::draw
