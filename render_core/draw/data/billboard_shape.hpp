/// What a feature's billboard is made of before it has room: its place, icon and lines, in pixels of a view. Pure but for the
/// ground that is asked, once. Bounded.
#pragma once

#include "render_core/base/fixed_vector.hpp"
#include "render_core/draw/data/billboard_look.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/sign_box.hpp"
#include "render_core/draw/data/sign_view.hpp"

namespace tedavis::draw {

inline constexpr double kIconSize_m = 80;
/// Of the text's size.
inline constexpr float kMinIcon = 1.0f, kGreatestIcon = 2.2f;

/// Lines beside the icon: its name, and under it what it reaches from and to.
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
    SignBox box;  ///< on the short stem
    float text_px = 16;

    [[nodiscard]] float line_px() const;
    /// Without a stem.
    [[nodiscard]] SignBox on_the_spot() const;
    /// The box as it is with these lines.
    void set_lines(const SignText& lines);
};

/// False where it has no place that lies ahead.
[[nodiscard]] bool billboard_shape(const ElementInput& input, std::uint32_t feature, const SignView& view, bool with_name,
                                   BillboardShape& shape);

}  // namespace tedavis::draw
