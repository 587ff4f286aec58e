/// Sums of what several glyphs stand for, in double, and the summary that they give. Pure; any thread.
#pragma once

#include "render_core/scene/glyph_summary.hpp"

namespace tedavis::scene {

class GlyphSums {
public:
    GlyphSums() = default;
    explicit GlyphSums(GlyphValues values) : values_(values) {}

    /// One place, or several that were put together before.
    void add(const GlyphSummary& part);
    /// Of the same kind of values.
    void add(const GlyphSums& other);
    /// Known of all members: their places are in this box. Along an axis on which their mean is not, nothing changes.
    void keep_within(const glm::dvec3& low, const glm::dvec3& high);
    /// An empty one of no members.
    [[nodiscard]] GlyphSummary summary() const;

private:
    void add_class(const GlyphSums& other);

    GlyphValues values_ = GlyphValues::number;
    double place_[3] = {}, over_ground_ = 0, value_ = 0, north_ = 0, speed_ = 0;
    std::uint64_t uncertainty_ = 0;
    glm::vec3 low_{0}, high_{0};  ///< of the places
    float size_m_ = 0, class_ = 0;
    std::uint32_t members_ = 0, missing_ = 0;
    bool is_unknown_ = false, is_interpolated_ = false, is_mixed_ = false;
};

}  // namespace tedavis::scene
