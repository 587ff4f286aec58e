#include "render_core/draw/trace_state.hpp"

#include "render_core/draw/traced_ground.hpp"
#include "render_core/raytrace/space/trace_ground.hpp"

namespace tedavis::draw {

std::string_view reason_of(TraceState state) {
    constexpr std::string_view kReasons[] = {"",
                                             "",
                                             "light shafts alone, blur round a focus or magnified foci",
                                             "the ground is drawn flat",
                                             "the device's lane is es2",
                                             "the device has no room for it",
                                             "the database is larger than the device's memory for it",
                                             "the database goes round the Earth or over a pole",
                                             "the database is damaged",
                                             "the eye is too close to a pole",
                                             "triangles were chosen"};
    return kReasons[static_cast<std::size_t>(state)];
}

TraceState trace_state_of(const DrawnDesign& design) {
    if (!design::may_trace(design.design->terrain)) return TraceState::not_asked_for;
    if (design.design->view.reference == design::Reference::flat) return TraceState::not_flat;
    if (design.output == TerrainOutput::code || design.is_deferred) return TraceState::traced;
    const bool is_by_style = has_shafts_only(*design.design) || blurs_context(design) || design::magnifies(*design.design);
    if (is_by_style) return TraceState::not_by_style;
    return design.on_es3 ? TraceState::not_on_device : TraceState::not_on_lane;
}

bool can_trace(const terrain::TerrainDatabase& database, const terrain::View& view) {
    return raytrace::can_trace({database, TracedGround::all_of(database.lattice()), 1.0}, view);
}

}  // namespace tedavis::draw
