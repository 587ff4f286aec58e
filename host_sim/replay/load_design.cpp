#include "host_sim/replay/load_design.hpp"

#include "host_sim/input_file.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/display/effect_calls.hpp"

namespace tedavis::host_sim {
namespace {

/// What says how to read the picture stays: the legend, and the map's own ship and scale.
design::SymbologySettings without_instruments(design::SymbologySettings shown) {
    for (bool design::SymbologySettings::*part :
         {&design::SymbologySettings::attitude, &design::SymbologySettings::heading, &design::SymbologySettings::airspeed,
          &design::SymbologySettings::altitude, &design::SymbologySettings::vertical_speed,
          &design::SymbologySettings::flight_path, &design::SymbologySettings::baro_setting,
          &design::SymbologySettings::ground_height, &design::SymbologySettings::phase})
        shown.*part = false;
    return shown;
}

void set_detail(design::DataStyle& data, double detail) {
    for (design::DataElement& element : data.elements) element.detail = detail;
    data.ground = design::at_detail(data.ground, detail);
    data.adjacent = design::at_detail(data.adjacent, detail);
}

}  // namespace

std::string design_path(const PictureOptions& options) { return resolve_config(options.design, "designs"); }

design::DesignSettings load_design(const PictureOptions& options, std::vector<ReadFile>* files) {
    const std::string path = design_path(options);
    PaletteFiles palettes(path);
    const std::string text = read_file(path);
    auto design = design::read_design_settings(text, path, palettes);
    if (files != nullptr) {
        *files = palettes.files();
        files->push_back({path, text});
    }
    if (!design.ok()) throw UserError(std::string(design.error().sentence.view()));
    if (const auto order = effects::replacement_order(design.value().effects.instead); !order.ok())
        throw UserError(path + ": " + std::string(order.error().view()));
    if (options.tau_px) design.value().terrain.tau_px = *options.tau_px;
    if (options.detail) set_detail(design.value().data, *options.detail);
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) {
        const auto effect = static_cast<effects::Effect>(n);
        if (options.with.has(effect)) design.value() = display::with_effect(design.value(), effect);
        if (options.without.has(effect)) design.value() = display::without_effect(design.value(), effect);
    }
    if (!options.symbology) design.value().symbology = without_instruments(design.value().symbology);
    return design.value();
}

}  // namespace tedavis::host_sim
