/// Accumulates the values of several glyphs in double and returns their summary. Pure; any thread.
#pragma once

#include "render_core/scene/glyph_summary.hpp"

namespace tedavis::scene {

class GlyphSums {
public:
    GlyphSums() = default;
    explicit GlyphSums(GlyphValues values) : values_(values) {}

    /// Adds one site, or the summary of several.
    void add(const GlyphSummary& part);
    /// Adds other sums of the same kind of values.
    void add(const GlyphSums& other);
    /// Clamps the members' bounding box to a box that is known to contain them. An axis on which their mean lies outside is
    /// left unchanged.
    void keep_within(const glm::dvec3& low, const glm::dvec3& high);
    /// Returns the summary; empty where there are no members.
    [[nodiscard]] GlyphSummary summary() const;

private:
    void add_class(const GlyphSums& other);

    GlyphValues values_ = GlyphValues::number;
    double place_[3] = {}, over_ground_ = 0, value_ = 0, north_ = 0, speed_ = 0;
    std::uint64_t uncertainty_ = 0;
    glm::vec3 low_{0}, high_{0};  ///< bounding box of the positions
    float size_m_ = 0, class_ = 0;
    std::uint32_t members_ = 0, missing_ = 0;
    bool is_unknown_ = false, is_interpolated_ = false, is_mixed_ = false;
};

}  // namespace tedavis::scene
