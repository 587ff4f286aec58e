#include "render_core/display/planner/foci_plan.hpp"

#include <algorithm>
#include <limits>

#include "render_core/earth/wgs84.hpp"

namespace tedavis::display {
namespace {

/// The border between the intermediate context and the context.
double least_degree(const design::FocusList& foci) {
    double least = 1;
    for (const design::FocusSettings& focus : foci)
        least = std::min(least, focus.context.levels == 0 ? 0 : 1.0 / (focus.context.levels + 1));
    return least;
}

/// Records the values of the attribute by which an element is coloured, each attribute once; for wind those of the speed.
void record_values(const scene::FocusRegion& region, const ElementReport& report, const flight::FlightTime& time,
                   FocusRecord& record) {
    const scene::Layer& layer = *report.layer;
    const std::string_view name =
        layer.entry->role == scene::LayerRole::wind ? std::string_view("speed") : report.element->by_color.attribute.view();
    if (name.empty() || !draw::LayerValues::has(layer, name)) return;
    for (const FocusValuesRecord& other : record.values)
        if (other.layer.view() == layer.entry->name && other.attribute.view() == name) return;
    const draw::LayerValues values(layer, name, draw::shown_time_ns(layer, time));
    const draw::DerivedInterval found = draw::values_in(region, values, layer);
    static_cast<void>(record.values.try_push_back({layer.entry->name, name, found.low, found.high, found.count}));
}

void record_all_values(const scene::FocusRegion& region, const ElementReports& reports, const flight::FlightTime& time,
                       FocusRecord& record) {
    for (const ElementReport& report : reports)
        if (region.is_valid && report.state == ElementState::shown) record_values(region, report, time, record);
}

void record_region(const scene::FocusRegion& region, FocusRecord& record) {
    record.is_shown = region.is_valid;
    if (!region.is_valid) return;
    const glm::dvec2 first = region.points[0];
    const earth::Geodetic place = earth::from_ecef(region.anchor + region.east * first.x + region.north * first.y);
    record.latitude_rad = place.latitude_rad;
    record.longitude_rad = place.longitude_rad;
    record.radius_m = region.radius_m;
    record.points = region.point_count;
}

}  // namespace

FociPlan plan_foci(const design::FocusList& foci, const draw::FocusFrame& frame) {
    FociPlan plan;
    plan.foci.foci = &foci;
    plan.foci.look = design::data_of_context(foci);
    plan.foci.least_degree = least_degree(foci);
    plan.foci.has_own_ship = frame.own_ship.state == base::SignalState::valid || frame.own_ship.state == base::SignalState::stale;
    const earth::Geodetic& own = frame.own_ship.position;
    plan.foci.own_ship = earth::to_ecef({own.latitude_rad, own.longitude_rad, {frame.own_height_m}});
    for (std::size_t n = 0; n < foci.size(); ++n) {
        scene::FocusRegion region;
        plan.heights_m[n] = std::numeric_limits<double>::quiet_NaN();
        if (foci[n].shape == design::FocusShape::data) {
            const draw::FoundData found = draw::data_of(foci[n], frame);
            plan.states[n] = found.state;
            plan.foci.ranges[n] = found.range;
            region = found.region;
        } else {
            const draw::FocusPlace place = draw::place_of(foci[n], frame);
            plan.states[n] = place.state;
            plan.heights_m[n] = place.height_m;
            region = place.region;
        }
        if (region.is_valid) plan.foci.maps[n] = scene::FocusMap(region);
        static_cast<void>(plan.foci.regions.try_push_back(region));
    }
    return plan;
}

void record_foci(const FociPlan& plan, const ElementPlanner& elements, const ElementFrame& frame, FrameStatement& record) {
    const draw::FrameFoci& foci = plan.foci;
    for (std::size_t n = 0; n < foci.regions.size(); ++n) {
        const design::FocusSettings& focus = (*foci.foci)[n];
        FocusRecord one;
        one.name = focus.name;
        one.shape = design::kFocusShapeNames[static_cast<std::size_t>(focus.shape)];
        one.reason = draw::reason_of(plan.states[n]);
        record_region(foci.regions[n], one);
        if (draw::is_shown(plan.states[n])) {
            const draw::FocusCounts counts = elements.count_in_focus(frame, n);
            one.in_focus = counts.in_focus;
            one.intermediate = counts.intermediate;
            one.context = counts.context;
            if (focus.shape != design::FocusShape::data)
                record_all_values(foci.regions[n], elements.reports(), frame.time, one);
            else
                one.low = foci.ranges[n].low, one.high = foci.ranges[n].high;
        }
        const draw::FocusCue& cue = elements.focus_cues()[n];
        one.sight = draw::name_of(cue.sight);
        one.distance_m = cue.distance_m;
        one.has_cue = cue.is_drawn;
        static_cast<void>(record.foci.try_push_back(one));
    }
}

}  // namespace tedavis::display
