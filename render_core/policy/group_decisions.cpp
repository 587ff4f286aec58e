#include "render_core/policy/group_decisions.hpp"

namespace tedavis::policy {

using base::SignalState;
using flight::Signal;

bool GroupDecisions::turns_view(Signal heading) const {
    return valid(heading) && (heading != Signal::magnetic_heading || valid(Signal::magnetic_variation));
}

Signal GroupDecisions::first_in(SignalGroup group, SignalState wanted) const {
    const SourceChain& chain = source_chain(group);
    for (std::size_t i = 0; i < chain.count; ++i)
        if (state_of(chain.sources[i]) == wanted) return chain.sources[i];
    return Signal::count_;
}

bool GroupDecisions::has_valid(SignalGroup group) const {
    if (group != SignalGroup::view_heading) return first_in(group, SignalState::valid) != Signal::count_;
    return turns_view(Signal::true_heading) || turns_view(Signal::magnetic_heading) || turns_view(Signal::true_track);
}

ElementDecision GroupDecisions::decision(SignalGroup group) const {
    const SourceChain& chain = source_chain(group);
    const Signal source = first_in(group, SignalState::valid);
    for (std::size_t i = 0; i < chain.count; ++i)
        if (chain.sources[i] == source) return {i < chain.equals ? ElementShow::normal : ElementShow::substituted, source};
    const Signal stale = first_in(group, SignalState::stale);
    if (stale != Signal::count_) return {ElementShow::flagged, stale};
    return {(consequences_of(group) & kFailElement) != 0 ? ElementShow::failed : ElementShow::absent, Signal::count_};
}

ElementDecision GroupDecisions::worse_of(SignalGroup a, SignalGroup b) const {
    const ElementDecision first = decision(a), second = decision(b);
    if (first.show == ElementShow::failed) return first;
    if (second.show == ElementShow::failed) return second;
    return first.show < second.show ? second : first;
}

}  // namespace tedavis::policy
