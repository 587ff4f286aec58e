#include "host_sim/replay/load_design.hpp"

#include "host_sim/input_file.hpp"
#include "host_sim/options/asked_parameters.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/effects/design_effects.hpp"

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

void leave_out(ShownAspects shown, design::DesignSettings& design) {
    if (shown == ShownAspects::all) return;
    design.symbology.legend = false;
    design.data.elements.clear();
    design.data.adjacent.is_shown = false;
    if (shown == ShownAspects::terrain) {
        design.data.ground.is_shown = false;
        return;
    }
    design.terrain.style = {};
    design.terrain.style.texture = design::TerrainTexture::plain;
    design.terrain.style.shade.technique = design::TerrainShade::none;
    design.sky.haze_distance_m = 0;
    design.sky.air.is_shown = false;
    design.data.ground.uncertainty = {};
    design.data.ground.overlay = {};
    design.data.ground.opacity = shown == ShownAspects::ground_data ? 1 : 0;  // by the same programs
}

void put_above(const PictureOptions& options, const std::string& path, design::DesignSettings& design) {
    if (const base::Error error = platform::put_parameters(asked_parameters(options), path, design))
        throw UserError(std::string(error.message.view()));
    if (options.detail) set_detail(design.data, *options.detail);
    leave_out(options.shown, design);
    for (std::size_t n = 0; n < effects::kEffectCount; ++n) {
        const auto effect = static_cast<effects::Effect>(n);
        if (options.with.has(effect)) design = effects::with_effect(design, effect);
        if (options.without.has(effect)) design = effects::without_effect(design, effect);
    }
    if (options.saliency) design.effects.saliency.view = *options.saliency;
    if (options.clutter) design.effects.clutter = *options.clutter;
    if (design.effects.saliency.view != design::SaliencyView::none && design.effects.clutter != design::ClutterView::none)
        throw UserError("--saliency, --clutter: one view lies over the other; leave one out");
    if (!options.symbology) design.symbology = without_instruments(design.symbology);
}

/// One design file, as the command line wants it.
design::DesignSettings load_file(const std::string& path, const PictureOptions& options, design::NamedPhases& phases,
                                 std::vector<ReadFile>* files) {
    DesignFiles named(options.design_folders);
    const std::string text = read_file(path);
    auto design = design::read_design_settings(text, path, named, &phases);
    if (files != nullptr) {
        files->insert(files->end(), named.files().begin(), named.files().end());
        files->push_back({path, text});
    }
    if (!design.ok()) throw UserError(std::string(design.error().message.view()));
    if (const auto order = effects::replacement_order(design.value().effects.instead); !order.ok())
        throw UserError(path + ": " + std::string(order.error().view()));
    put_above(options, path, design.value());
    return design.value();
}

}  // namespace

std::string design_path(const PictureOptions& options) { return resolve_config(options.design, "designs"); }

design::DesignSettings load_design(const PictureOptions& options, std::vector<ReadFile>* files) {
    if (files != nullptr) files->clear();
    design::NamedPhases phases;
    return load_file(design_path(options), options, phases, files);
}

std::unique_ptr<LoadedDesigns> load_designs(const PictureOptions& options, std::vector<ReadFile>* files) {
    if (files != nullptr) files->clear();
    auto loaded = std::make_unique<LoadedDesigns>();
    const std::string path = design_path(options);
    design::NamedPhases phases;
    loaded->design = load_file(path, options, phases, files);
    for (const design::NamedPhase& named : phases) {
        const std::string of_phase = named_design({named.design.view(), path}, options.design_folders);
        const design::DesignSettings* const known = loaded->phases.find(named.design);
        design::NamedPhases nested;
        const design::DesignSettings design = known != nullptr ? *known : load_file(of_phase, options, nested, files);
        if (!nested.empty())
            throw UserError(of_phase + ": " + path + " names it for a phase, so it has no table [phases]; remove it");
        if (!loaded->phases.add(named, design))
            throw UserError(path + ": more than " + std::to_string(design::kMaxPhaseDesigns) +
                            " different designs stand in [phases]; remove some");
    }
    return loaded;
}

}  // namespace tedavis::host_sim
