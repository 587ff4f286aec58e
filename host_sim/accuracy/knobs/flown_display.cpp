#include "host_sim/accuracy/knobs/flown_display.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/input_file.hpp"
#include "host_sim/replay/index_key.hpp"
#include "host_sim/replay/load_design.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"
#include "platform/surface_factory.hpp"
#include "render_core/base/units.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint32_t kTriedSurface_px = 16;

PictureOptions options_of(const FlownDisplay& display) {
    PictureOptions options;
    options.design = display.design;
    options.device = display.device;
    return options;
}

/// Errors are measured through one grid, whatever the phase of a pose. `name`: as a message begins with it.
void require_same_view(const std::string& name, const design::DesignSettings& design, double field_of_view_rad) {
    if (design.view.mode != design::ViewMode::perspective)
        throw UserError(name + " shows a map, and errors are measured on a perspective view; name a design with the view \"3d\"");
    if (design.view.horizontal_field_of_view_rad != field_of_view_rad)
        throw UserError(name +
                        " has another field of view, and errors are measured with one for all phases; name a design "
                        "whose phases have the same horizontal_field_of_view_deg");
}

double field_of_view_rad(const FlownDisplay& display) {
    const std::unique_ptr<LoadedDesigns> designs = load_designs(options_of(display));
    const double of_design_rad = designs->design.view.horizontal_field_of_view_rad;
    const std::string name = "--design " + display.design + ":";
    require_same_view(name, designs->design, of_design_rad);
    for (std::size_t n = 1; n <= designs->phases.size(); ++n) {
        const design::DesignSettings& of_phase = designs->phases.at(n);
        require_same_view(name + " its phase's design '" + std::string(of_phase.name.view()) + "'", of_phase, of_design_rad);
    }
    return of_design_rad;
}

}  // namespace

PictureSize FlownDisplay::share(double of_side) const {
    const auto part = [of_side](std::uint32_t whole) { return static_cast<std::uint32_t>(std::lround(of_side * whole)); };
    return {part(size.width), part(size.height)};
}

std::string size_word(const PictureSize& size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

std::string size_text(const PictureSize& size) { return std::to_string(size.width) + " x " + std::to_string(size.height); }

SeenGrid seen_grid(const FlownDisplay& display, std::uint32_t across) {
    const double shape = static_cast<double>(display.size.height) / display.size.width;
    return {across, static_cast<std::uint32_t>(std::max(1L, std::lround(shape * across))),
            base::degrees(field_of_view_rad(display))};
}

double pixel_scale(const FlownDisplay& display) {
    const double focal_px = display.size.width / std::tan(0.5 * field_of_view_rad(display));
    const double usual_px = kFlownSize.width / std::tan(0.5 * base::radians(SeenGrid().field_of_view_deg));
    return std::max(1.0, focal_px / usual_px);
}

std::uint64_t identity_of(const FlownDisplay& display) {
    std::vector<ReadFile> files;
    static_cast<void>(load_designs(options_of(display), &files));
    std::string all = size_text(display.size) + read_file(resolve_config(display.device, "devices"));
    for (const ReadFile& file : files) all += file.text;
    return text_identity(all);
}

GlChoice offered_gl() {
    const bool has_osmesa = platform::make_surface("osmesa", {kTriedSurface_px, kTriedSurface_px}).ok();
    return has_osmesa ? GlChoice::osmesa : GlChoice::egl;
}

}  // namespace tedavis::host_sim
