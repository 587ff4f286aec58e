#include "platform/runtime/design_warmer.hpp"

#include <optional>

#include "render_core/design/phase_designs.hpp"

namespace tedavis::platform {
namespace {

/// A phase that has the design at this place; nothing where none has it, as the first one where every phase has its own.
std::optional<flight::FlightPhase> phase_of(const display::FramePlanner& planner, std::size_t place) {
    if (planner.place_of({}) == place) return flight::FlightPhase();
    for (unsigned code = 0; code < 256; ++code) {
        const flight::ParsedPhase phase = flight::phase_from_code(static_cast<std::uint8_t>(code));
        if (phase.ok && planner.place_of(phase.phase) == place) return phase.phase;
    }
    return std::nullopt;
}

bool is_changing(const display::DesignTransition& transition) {
    return transition.keeps || transition.fades_next || transition.fade_lasts;
}

}  // namespace

void DesignWarmer::begin(const display::FramePlanner& planner) {
    has_begun_ = true;
    waiting_ = 0;
    for (std::size_t place = 0; place < planner.design_count(); ++place)
        if (phase_of(planner, place)) waiting_ |= 1u << place;
    fade_waits_ = planner.fades() && (waiting_ & (waiting_ - 1)) != 0;
}

std::size_t DesignWarmer::take_first() {
    std::size_t place = 0;
    while ((waiting_ >> place & 1u) == 0) ++place;
    waiting_ &= waiting_ - 1;
    return place;
}

bool DesignWarmer::draw_next(display::Display& display, base::Surface& surface, const flight::FrameInput& input) {
    if (is_done() || !has_begun_ || is_changing(display.memory().transition)) return false;
    kept_ = display.memory();
    if (waiting_ != 0) {
        draw_design(display, surface, input);
    } else {
        draw_fade(display, surface, input);
        fade_waits_ = false;
    }
    display.memory() = kept_;
    display.memory().saliency.forget();  // its maps lie with the painter
    return true;
}

void DesignWarmer::draw_design(display::Display& display, base::Surface& surface, flight::FrameInput input) {
    input.phase.presented = *phase_of(display.planner(), take_first());
    display.memory().cut();
    display.plan(input);
    display.draw(surface);
}

/// The design that is shown into one that another phase has: the first frame is kept, the second one fades.
void DesignWarmer::draw_fade(display::Display& display, base::Surface& surface, const flight::FrameInput& input) const {
    for (std::size_t place = 0; place < display.planner().design_count(); ++place) {
        const std::optional<flight::FlightPhase> phase = phase_of(display.planner(), place);
        if (place == kept_.shown || !phase) continue;
        flight::FrameInput faded = input;
        faded.phase.presented = *phase;
        for (int frame = 0; frame < 2; ++frame) {
            display.plan(faded);
            display.draw(surface);
        }
        return;
    }
}

}  // namespace tedavis::platform
