// What of the display plans the data elements and the foci.
#include "render_core/display/display.hpp"
#include "render_core/display/symbology_plan.hpp"
#include "render_core/display/terrain_ground.hpp"

namespace tedavis::display {

/// Where they are, whatever is shown of them.
void Display::plan_foci() {
    foci_ = {};
    if (settings_.design.foci.empty() || !terrain_.is_started()) return;
    TerrainGround ground(terrain_, eye_.view);
    const double own_height_m = aircraft_msl_m_ + undulation_m(state_.own_ship.position);
    foci_ = display::plan_foci(
        settings_.design.foci,
        {state_.own_ship, own_height_m, data_.has_scene() ? &data_.scene() : nullptr, record_.flight_time, ground});
}

ElementFrame Display::element_frame(draw::Ground& ground, const terrain::View& view, const flight::FlownWay* way) const {
    return {ground,
            view,
            settings_.design.terrain.unknown,
            record_.flight_time,
            {way, &state_, record_.time},
            frame_budget_.detail_factor(),
            foci_.foci.regions.empty() ? nullptr : &foci_.foci};
}

/// Symbology first, then the signs in the room that it leaves.
void Display::plan_elements(const flight::FlownWay* way) {
    TerrainGround ground(terrain_, seen_);
    if (shows_elements())
        elements_.plan(element_frame(ground, seen_, way));
    else
        elements_.rest();
    conditions_.data_are_out_of_date =
        data_plan_.ground == GroundDataState::out_of_date || any_is_out_of_date(elements_.reports());
    if (conditions_.data_are_out_of_date) decide_again();
    put_symbology();
    way_ = way;
    // Of a picture for each eye they are planned with the eye.
    if (shows_elements() && !stereo_.is_started()) plan_signs(eye_, {});
    if (!foci_.foci.regions.empty()) note_foci(foci_, elements_, element_frame(ground, seen_, way), record_);
}

void Display::plan_signs(const Eye& eye, SignFrame signs) {
    TerrainGround ground(terrain_, eye.view);
    terrain::DrawnSight sight = terrain_.sight(eye.view);
    signs.text_px = text_px(context(), settings_.width_px, settings_.height_px);
    signs.sight = &sight;
    signs.is_metric = settings_.design.symbology.legend_unit == design::HeightUnit::metres;
    signs.symbology = free_view_active_ ? nullptr : &quad_drawer_.batch();
    elements_.plan_signs(element_frame(ground, eye.view, way_), signs);
}

}  // namespace tedavis::display
