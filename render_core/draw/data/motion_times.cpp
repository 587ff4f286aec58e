#include "render_core/draw/data/motion_times.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "render_core/draw/data/area_prisms.hpp"
#include "render_core/draw/data/cell_motion.hpp"
#include "render_core/draw/data/layer_foci.hpp"
#include "render_core/draw/font_atlas.hpp"
#include "render_core/draw/text_size.hpp"

namespace tedavis::draw {
namespace {

constexpr float kTimeSize = 0.85f, kTimeGap = 0.4f;  // of the text's size; the gap is from the barb to the text
constexpr float kTimeHalo_px = 1.5f;
constexpr design::Color kTimeColor{244, 246, 250, 255};  // on cells of any color, however much of the sky they let through
constexpr std::size_t kMaxTimeVertices = 4 * 2 * 31;

/// The best place first.
struct Rooms {
    Rect boxes[4];
};
Rooms rooms_at(Point at, float width, float height, float gap) {
    return {{{at.x - 0.5f * width, at.y + gap, width, height},
             {at.x - 0.5f * width, at.y - gap - height, width, height},
             {at.x + gap, at.y - 0.5f * height, width, height},
             {at.x - gap - width, at.y - 0.5f * height, width, height}}};
}

bool add_time(BillboardSheet& sheet, const LastBarb& barb) {
    const BillboardSheet::Spot spot = sheet.spot(barb.place);
    if (!spot.is_ahead || !sheet.has_room(kMaxTimeVertices, 0)) return false;
    char text[16];
    std::snprintf(text, sizeof text, "%d MIN", static_cast<int>(std::lround(barb.after_s / 60)));
    const float size_px = std::max(kTimeSize * sheet.text_px(), kMinText_px);
    const float width = text_width_px(text, size_px) + 2 * kTimeHalo_px;
    for (const Rect& box : rooms_at(spot.at, width, size_px, kTimeGap * sheet.text_px()).boxes) {
        if (!sheet.claim(box, barb.place)) continue;
        const TextStyle style{size_px, kTimeColor, kTimeHalo_px, {0, 0, 0, 255}};
        static_cast<void>(sheet.signs().text(text, box.center(), TextAnchor::center, style));
        return true;
    }
    return false;
}

}  // namespace

std::uint32_t add_motion_times(BillboardSheet& sheet, SolidMesh& mesh, const ElementInput& input) {
    std::uint32_t added = 0;
    if (!prisms_move(input.layer)) return added;
    for (std::uint32_t feature = 0; feature < input.layer.entry->feature_count; ++feature) {
        if (!has_motion(input, feature) || look_of_feature(input, feature).is_hidden) continue;
        const LastBarb barb = last_barb(input, feature, cell_front(mesh, input, feature));
        if (barb.after_s > 0 && add_time(sheet, barb)) ++added;
    }
    return added;
}

}  // namespace tedavis::draw
