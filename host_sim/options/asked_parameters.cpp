#include "host_sim/options/asked_parameters.hpp"

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

platform::DesignParameters asked_parameters(const PictureOptions& options) {
    platform::DesignParameters asked;
    asked.tau_px = options.tau_px;
    for (const auto& [aspect, weight] : options.weights) {
        const platform::AspectWeight of_aspect{std::string_view(aspect), weight};
        if (of_aspect.aspect.cut() || !asked.weights.try_push_back(of_aspect))
            throw UserError("--weights: '" + aspect + "' is no aspect of a design, or one of more than 8; leave it out");
    }
    for (const std::string& line : options.foci) {
        const base::FixedString<1000> focus{std::string_view(line)};
        if (focus.cut()) throw UserError("--focus: is longer than a thousand bytes; leave something out");
        if (!asked.foci.try_push_back(focus)) throw UserError(std::string("--focus: ") + platform::kTooManyFoci);
    }
    return asked;
}

}  // namespace tedavis::host_sim
