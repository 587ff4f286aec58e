/// Adds the sites of a layer that have glyphs, with their values at a time, to a field in bounded steps.
///
/// Grids have one site per post and height: at the element's heights, else at the first level, else kOverGround_m above the
/// ground. Points have one each. Wind comes from the attributes "east" and "north" of layers of that role; else the value is
/// that of the element's colour, of its size, or of the layer's first attribute.
///
/// `detail`: the share of the heights that have sites, the first ones; at least one.
///
/// For elements with links, the ground's height below each site is queried.
///
/// Pure, apart from queries to the ground. Memory  none. Thread  the ground's.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/scene/glyph_field.hpp"
#include "render_core/scene/grid_field.hpp"

namespace tedavis::draw {

inline constexpr double kOverGround_m = 150;
inline constexpr double kPointGlyph_m = 400;     ///< size of points' glyphs across, where the design states none
inline constexpr double kShareOfSpacing = 0.85;  ///< the same for grids: share of the post spacing, at most kMaxGridGlyph_m
inline constexpr double kMaxGridGlyph_m = 8000;

/// Returns the attribute that glyphs show. For points without attributes it is a constant with the greatest uncertainty. Null
/// where the layer has no suitable attribute.
[[nodiscard]] const scene::Attribute* glyph_attribute(const design::DataElement& element, const scene::Layer& layer);
[[nodiscard]] scene::GlyphValues glyph_values(const scene::Layer& layer, const scene::Attribute& attribute);
/// True where values or uncertainties depend on the time.
[[nodiscard]] bool glyphs_change(const scene::Layer& layer, const scene::Attribute& attribute);

/// Number of sites of the element over the layer.
[[nodiscard]] std::uint32_t glyph_count(const design::DataElement& element, const scene::Layer& layer);

class GlyphSites {
public:
    /// Begins a new field. Returns false, and changes nothing, where the layer has no glyphs.
    bool begin(const ElementInput& input, std::int64_t time_ns, scene::GlyphField& field);
    /// Adds at most `most_sites` sites; returns true when all have been added.
    bool step(scene::Ground& ground, scene::GlyphField& field, std::uint32_t most_sites);

private:
    [[nodiscard]] scene::GlyphFrame frame_of(const ElementInput& input);
    [[nodiscard]] scene::GlyphSite post(const ElementInput& input, std::uint32_t n) const;
    [[nodiscard]] scene::GlyphSite point(const ElementInput& input, std::uint32_t n) const;
    [[nodiscard]] scene::FieldValue value_of_point(const scene::Attribute& attribute, std::uint32_t n) const;

    const design::DataElement* element_ = nullptr;
    const scene::Layer* layer_ = nullptr;
    const scene::Attribute* attribute_ = nullptr;  ///< wind: component towards east
    const scene::Attribute* north_ = nullptr;      ///< wind only
    std::int64_t time_ns_ = 0;
    std::uint32_t next_ = 0, all_ = 0, posts_ = 0;
    float size_m_ = 0;
};

}  // namespace tedavis::draw
