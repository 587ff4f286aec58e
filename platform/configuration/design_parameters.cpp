#include "platform/configuration/design_parameters.hpp"

namespace tedavis::platform {
namespace {

base::Error put_weight(const AspectWeight& asked, std::string_view design_name, design::PrioritySettings& priority) {
    std::size_t aspect = 0;
    while (aspect < priority.count() && priority.name_of(aspect) != asked.aspect.view()) ++aspect;
    if (aspect < priority.count()) {
        priority.weights.of[aspect] = asked.weight;
        priority.is_stated = true;
        return {};
    }
    base::Error error = base::make_error(design_name, ": has no aspect '", asked.aspect.view(), "' to weigh; it has ");
    for (std::size_t n = 0; n < priority.count(); ++n) {
        if (n > 0) error.message.append(", ");
        error.message.append(priority.name_of(n));
    }
    return error;
}

base::Error put_foci(const DesignParameters& parameters, std::string_view design_name, design::FocusList& foci) {
    const design::FocusList own = foci;
    foci.clear();
    bool has_room = true;
    for (const auto& line : parameters.foci) {
        const auto focus = design::read_focus(line.view());
        if (!focus.ok())
            return base::make_error(
                focus.error().message.view(), "; it is '", line.view(),
                "', and should be keys of [[focus]] with commas between, such as 'at = \"place\", place = \"DAVOS\"'");
        has_room = foci.try_push_back(focus.value()) && has_room;
    }
    for (const design::FocusSettings& focus : own) has_room = foci.try_push_back(focus) && has_room;
    if (has_room) return {};
    return base::make_error(design_name, ": ", kTooManyFoci);
}

}  // namespace

base::Error put_parameters(const DesignParameters& parameters, std::string_view design_name, design::DesignSettings& design) {
    if (base::Error error = put_foci(parameters, design_name, design.foci)) return error;
    if (parameters.tau_px) design.terrain.tau_px = *parameters.tau_px;
    for (const AspectWeight& asked : parameters.weights)
        if (base::Error error = put_weight(asked, design_name, design.priority)) return error;
    return {};
}

}  // namespace tedavis::platform
