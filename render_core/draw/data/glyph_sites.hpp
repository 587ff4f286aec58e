/// The places of a layer that have glyphs, with their values at a time, handed to a field in bounded steps.
///
/// Grids have a site a post and height: at the element's heights, else on the first level, else kOverGround_m over the ground.
/// Points have one each. Wind comes from the attributes "east" and "north" of layers of that role; else the value is that of the
/// element's colour, of its size, or of the layer's first attribute.
///
/// `detail`: the share of the heights that have sites, the first ones; at least one.
///
/// Elements with link lines ask the ground how far below each site it is.
///
/// Pure but for the ground that is asked. Memory  none. Thread  the ground's.
#pragma once

#include "render_core/draw/data/element_input.hpp"
#include "render_core/scene/glyph_field.hpp"
#include "render_core/scene/grid_field.hpp"

namespace tedavis::draw {

inline constexpr double kOverGround_m = 150;
inline constexpr double kPointGlyph_m = 400;     ///< across, of points, where the design says nothing
inline constexpr double kShareOfSpacing = 0.85;  ///< the same of grids: of the distance of posts, at most kMaxGridGlyph_m
inline constexpr double kMaxGridGlyph_m = 8000;

/// Which attribute glyphs show; of points without any one that is the same everywhere, and as unsure as can be; null where the
/// layer has none for them.
[[nodiscard]] const scene::Attribute* glyph_attribute(const design::DataElement& element, const scene::Layer& layer);
[[nodiscard]] scene::GlyphValues glyph_values(const scene::Layer& layer, const scene::Attribute& attribute);
/// True when values or uncertainties are others at another time.
[[nodiscard]] bool glyphs_change(const scene::Layer& layer, const scene::Attribute& attribute);

/// How many sites the element has over the layer.
[[nodiscard]] std::uint32_t glyph_count(const design::DataElement& element, const scene::Layer& layer);

class GlyphSites {
public:
    /// Begins the field anew. False, and nothing changes, where the layer has no glyphs.
    bool begin(const ElementInput& input, std::int64_t time_ns, scene::GlyphField& field);
    /// Adds so many sites at most; true when all have been.
    bool step(scene::Ground& ground, scene::GlyphField& field, std::uint32_t most_sites);

private:
    [[nodiscard]] scene::GlyphFrame frame_of(const ElementInput& input);
    [[nodiscard]] scene::GlyphSite post(const ElementInput& input, std::uint32_t n) const;
    [[nodiscard]] scene::GlyphSite point(const ElementInput& input, std::uint32_t n) const;
    [[nodiscard]] scene::FieldValue value_of_point(const scene::Attribute& attribute, std::uint32_t n) const;

    const design::DataElement* element_ = nullptr;
    const scene::Layer* layer_ = nullptr;
    const scene::Attribute* attribute_ = nullptr;  ///< of wind, towards east
    const scene::Attribute* north_ = nullptr;      ///< of wind alone
    std::int64_t time_ns_ = 0;
    std::uint32_t next_ = 0, all_ = 0, posts_ = 0;
    float size_m_ = 0;
};

}  // namespace tedavis::draw
