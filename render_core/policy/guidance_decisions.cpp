#include "render_core/policy/guidance_decisions.hpp"

namespace tedavis::policy {
namespace {

using flight::NavigationSource;
using flight::Scenario;
using flight::Signal;

constexpr Element kOfNavigationSource[] = {Element::course, Element::lateral_deviation, Element::vertical_deviation};

struct ElementGroup {
    Element element;
    SignalGroup group;
};
/// Elements that depend on one group alone.
constexpr ElementGroup kPlainElements[] = {
    {Element::slip, SignalGroup::slip},
    {Element::turn_rate, SignalGroup::turn_rate},
    {Element::flaps, SignalGroup::flaps},
    {Element::waypoint_bearing, SignalGroup::waypoint_bearing},
    {Element::selected_altitude, SignalGroup::selected_altitude},
    {Element::selected_heading, SignalGroup::selected_heading},
    {Element::selected_airspeed, SignalGroup::selected_airspeed},
    {Element::selected_vertical_speed, SignalGroup::selected_vertical_speed},
    {Element::navigation_source, SignalGroup::navigation_source},
};

/// A bus that does not state the source has at most one receiver: the first.
NavigationSource navigation_source(const GroupDecisions& groups) {
    if (groups.state_of(Signal::navigation_source) == base::SignalState::missing) return NavigationSource::radio1;
    const double code = groups.value(Signal::navigation_source);
    if (!(code >= 0 && code <= flight::kMaxNavigationSource)) return NavigationSource::none;
    return static_cast<NavigationSource>(static_cast<std::uint8_t>(code));
}

/// A glide path is flown on approaches only; an unknown phase may be one.
ElementDecision path_reference(const GroupDecisions& groups, Scenario scenario) {
    if (scenario != Scenario::approach && scenario != Scenario::unknown) return {ElementShow::absent, Signal::count_};
    return groups.decision(SignalGroup::selected_glidepath);
}

/// Of a receiver.
struct ReceiverGroups {
    SignalGroup course, lateral, vertical;
};

/// A deviation is as good as the statement which receiver it comes from.
void decide_deviations(const GroupDecisions& groups, const ReceiverGroups& receiver, DisplayDecisions& decisions) {
    decisions[Element::course] = groups.decision(receiver.course);
    decisions[Element::lateral_deviation] = groups.decision(receiver.lateral);
    decisions[Element::vertical_deviation] = groups.decision(receiver.vertical);
    const ElementShow source = decisions[Element::navigation_source].show;
    if (source != ElementShow::flagged && source != ElementShow::failed) return;
    for (const Element element : kOfNavigationSource) {
        ElementDecision& decided = decisions[element];
        if (decided.show == ElementShow::absent || decided.show >= source) continue;
        decided.show = source;
        if (source == ElementShow::failed) decided.source = Signal::count_;
    }
}

void decide_navigation(const GroupDecisions& groups, DisplayDecisions& decisions) {
    decisions.navigation_source = navigation_source(groups);
    switch (decisions.navigation_source) {
        case NavigationSource::none: break;
        case NavigationSource::radio1:
            return decide_deviations(
                groups, {SignalGroup::radio_course, SignalGroup::radio1_lateral, SignalGroup::radio1_vertical}, decisions);
        case NavigationSource::radio2:
            return decide_deviations(
                groups, {SignalGroup::radio_course, SignalGroup::radio2_lateral, SignalGroup::radio2_vertical}, decisions);
        case NavigationSource::gnss:
            return decide_deviations(groups, {SignalGroup::gnss_course, SignalGroup::gnss_lateral, SignalGroup::gnss_vertical},
                                     decisions);
    }
    const bool has_failed = decisions[Element::navigation_source].show == ElementShow::failed;
    for (const Element element : kOfNavigationSource)
        decisions[element].show = has_failed ? ElementShow::failed : ElementShow::absent;
}

/// In the air, and on an approach or in a descent of an unknown phase: before take-off every aircraft is below its minimum.
bool may_approach(const GroupDecisions& groups, Scenario scenario, const DisplayDecisions& decisions) {
    if (decisions.is_on_ground) return false;
    const bool descends = groups.valid(Signal::vertical_speed) && groups.value(Signal::vertical_speed) < 0;
    return scenario == Scenario::approach || (scenario == Scenario::unknown && descends);
}

MinimumsState minimum_state(const GroupDecisions& groups, Signal height, Signal minimum) {
    const double above_m = groups.value(height) - groups.value(minimum);
    if (above_m > kNearMinimum_m) return MinimumsState::above;
    return above_m > 0 ? MinimumsState::near : MinimumsState::at_or_below;
}

/// A minimum in the ground below the own ship is wrong, wherever it is near enough to matter.
bool is_in_ground(const GroupDecisions& groups, const ElementDecision& minimum, const ElementDecision& ground) {
    constexpr double kNear_m = 100;
    if (minimum.source == Signal::count_ || ground.show != ElementShow::normal || !groups.valid(Signal::baro_altitude))
        return false;
    const double height_m = groups.value(ground.source);
    return height_m < kNear_m && groups.value(minimum.source) < groups.value(Signal::baro_altitude) - height_m;
}

}  // namespace

bool counts_for_guidance(const GroupDecisions& groups, SignalGroup group) noexcept {
    const NavigationSource source = navigation_source(groups);
    switch (group) {
        case SignalGroup::radio1_lateral:
        case SignalGroup::radio1_vertical: return source == NavigationSource::radio1;
        case SignalGroup::radio2_lateral:
        case SignalGroup::radio2_vertical: return source == NavigationSource::radio2;
        case SignalGroup::radio_course: return source == NavigationSource::radio1 || source == NavigationSource::radio2;
        case SignalGroup::gnss_lateral:
        case SignalGroup::gnss_vertical:
        case SignalGroup::gnss_course: return source == NavigationSource::gnss;
        default: return true;
    }
}

void decide_guidance(const GroupDecisions& groups, Scenario scenario, DisplayDecisions& decisions) noexcept {
    for (const ElementGroup& plain : kPlainElements) decisions[plain.element] = groups.decision(plain.group);
    decisions[Element::flight_path_reference] = path_reference(groups, scenario);
    decisions[Element::flight_director] = groups.worse_of(SignalGroup::director_pitch, SignalGroup::director_roll);
    decide_navigation(groups, decisions);
}

bool decide_minimums(const GroupDecisions& groups, Scenario scenario, DisplayDecisions& decisions) noexcept {
    const ElementDecision& radio = decisions[Element::radio_minimum] = groups.decision(SignalGroup::radio_minimum);
    ElementDecision& baro = decisions[Element::baro_minimum] = groups.decision(SignalGroup::baro_minimum);
    if (!may_approach(groups, scenario, decisions)) return false;
    const bool is_removed = is_in_ground(groups, baro, decisions[Element::ground_height]);
    if (is_removed) baro = {ElementShow::failed, Signal::count_};
    if (radio.show == ElementShow::normal && groups.valid(Signal::radio_height))
        decisions.radio_minimum = minimum_state(groups, Signal::radio_height, Signal::decision_height);
    if (baro.show == ElementShow::normal && groups.valid(Signal::baro_altitude))
        decisions.baro_minimum = minimum_state(groups, Signal::baro_altitude, Signal::minimum_altitude);
    return is_removed;
}

}  // namespace tedavis::policy
