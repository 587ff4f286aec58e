/// The parts of a feature's billboard before room is allocated for it: position, icon and lines, in pixels of a view. Pure,
/// apart from one query to the ground. Bounded.
#pragma once

#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/units.hpp"
#include "render_core/draw/data/billboard_look.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/sign_box.hpp"
#include "render_core/draw/data/sign_view.hpp"

namespace tedavis::draw {

inline constexpr double kIconSize_m = 80;
/// Runways' signs fade in between these distances from the eye.
inline constexpr double kRunwaySignFrom_m = 1.8 * base::kMetresPerNauticalMile,
                        kRunwaySignWhole_m = 1.9 * base::kMetresPerNauticalMile;
/// Size of icons, in text sizes.
inline constexpr float kMinIcon = 1.0f, kGreatestIcon = 2.2f;

/// The lines beside the icon: the name, and below it the vertical limits.
class SignText {
public:
    void add(const BillboardText& line) {
        if (!line.empty()) static_cast<void>(lines_.try_push_back(line));
    }
    void drop_first();
    [[nodiscard]] bool empty() const { return lines_.empty(); }
    [[nodiscard]] std::size_t size() const { return lines_.size(); }
    [[nodiscard]] std::string_view line(std::size_t n) const { return lines_[n].view(); }
    [[nodiscard]] float width_px(float size_px) const;

private:
    base::FixedVector<BillboardText, 2> lines_;
};

struct BillboardShape {
    scene::ScenePoint anchor{};
    Placed place;
    SignSpot spot;
    BillboardLook look;
    SignText text;
    SignBox box;  ///< its box on the short stem
    float text_px = 16;

    [[nodiscard]] float line_px() const;
    /// Returns the box without a stem, at the feature's position.
    [[nodiscard]] SignBox on_the_spot() const;
    /// Sets the box's size for these lines.
    void set_lines(const SignText& lines);
};

/// Makes the shape; returns false where the feature has no position ahead of the eye point, and for a runway that is near.
[[nodiscard]] bool billboard_shape(const ElementInput& input, std::uint32_t feature, const SignView& view, bool with_name,
                                   BillboardShape& shape);

}  // namespace tedavis::draw
