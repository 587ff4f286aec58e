#include "host_sim/contract/contract_meter.hpp"

#include <algorithm>

#include "host_sim/contract/picture_readings.hpp"
#include "host_sim/evaluation/picture_file.hpp"
#include "host_sim/measure/symbology_palette_check.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/load_design.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

std::vector<std::optional<ColorGap>> gaps_of(const design::DesignSettings& design, const Contract& contract) {
    std::vector<std::optional<ColorGap>> gaps;
    for (const ContractCondition& condition : contract.conditions)
        gaps.push_back(condition.between.empty() ? std::nullopt : least_color_gap(design, condition.between, condition.light));
    return gaps;
}

DesignGaps gaps_of_run(const Contract& contract, const FlightRun& run) {
    const bool is_asked = std::any_of(contract.conditions.begin(), contract.conditions.end(),
                                      [](const ContractCondition& condition) { return !condition.between.empty(); });
    if (!is_asked) return {};
    if (run.design.empty())
        throw UserError(run.folder + "/summary.json: names no design, of which " + contract.path +
                        " compares colours; replay the run again");
    PictureOptions options;
    options.design = run.design;
    const std::unique_ptr<LoadedDesigns> designs = load_designs(options);
    DesignGaps gaps;
    gaps.emplace(designs->design.name.view(), gaps_of(designs->design, contract));
    for (std::size_t place = 1; place <= designs->phases.size(); ++place)
        gaps.emplace(designs->phases.at(place).name.view(), gaps_of(designs->phases.at(place), contract));
    return gaps;
}

ContractReading picture_reading(const ContractCondition& condition, const MeasuredFrame& frame) {
    switch (condition.measure) {
        case ContractMeasure::clutter: return clutter_reading(condition, frame);
        case ContractMeasure::saliency_share:
        case ContractMeasure::saliency_over_area: return saliency_reading(condition, frame);
        case ContractMeasure::luminance_contrast: return contrast_reading(condition, frame);
        case ContractMeasure::obstacle_rank: return obstacle_reading(condition, frame);
        case ContractMeasure::color_difference:
        case ContractMeasure::symbology_contrast:
        case ContractMeasure::symbology_difference: break;
    }
    return {};
}

bool is_of_palette(const ContractCondition& condition) {
    return condition.measure == ContractMeasure::symbology_contrast || condition.measure == ContractMeasure::symbology_difference;
}

std::optional<RunPalette> palette_of_run(const Contract& contract, const FlightRun& run) {
    if (std::none_of(contract.conditions.begin(), contract.conditions.end(), is_of_palette)) return std::nullopt;
    PictureOptions options;
    options.palette = run.palette;
    const std::string name = run.palette.empty() ? "standard" : run.palette;
    return RunPalette{load_symbology_palettes(options), name};
}

std::optional<design::SymbologyLight> symbology_light(const FlightFrame& frame) {
    const auto& names = design::kSymbologyLightNames;
    const auto light = std::find(names.begin(), names.end(), frame.light);
    if (light == names.end()) return std::nullopt;
    return static_cast<design::SymbologyLight>(light - names.begin());
}

/// Empty where the run has what the condition is measured by.
std::string lacking(const ContractCondition& condition, const FlightFrame& frame, bool has_mask) {
    if (needs_layers(condition) && !has_mask) return "no layer mask lies beside the picture; replay the run again with --layers";
    if (condition.measure == ContractMeasure::obstacle_rank && !frame.obstacles)
        return "the record does not say where obstacles are; replay the run again with --layers";
    return {};
}

}  // namespace

EvaluationSettings settings_of(const Contract& contract) {
    EvaluationSettings settings;
    settings.saliency_start_level = kFlightStartLevel;
    if (contract.canny) settings.canny = *contract.canny;
    return settings;
}

ContractMeter::ContractMeter(const Contract& contract, const FlightRun& run)
    : contract_(contract), gaps_(gaps_of_run(contract, run)), palette_(palette_of_run(contract, run)) {}

std::vector<ContractReading> ContractMeter::readings(PictureMeter& meter, const FlightFrame& frame) const {
    const RgbaPicture picture = read_picture(frame.picture);
    const auto mask = read_layer_mask(frame.picture, frame.layers, picture.width, picture.height);
    return readings(meter, frame, picture, mask ? &*mask : nullptr);
}

std::vector<ContractReading> ContractMeter::readings(PictureMeter& meter, const FlightFrame& frame, const RgbaPicture& picture,
                                                     const LayerMask* mask) const {
    const PictureMeasures measures = meter.measure(picture, frame.picture, mask, {});
    const MeasuredFrame measured{frame, picture, mask, measures, meter};
    std::vector<ContractReading> readings;
    for (std::size_t n = 0; n < contract_.conditions.size(); ++n) {
        const ContractCondition& condition = contract_.conditions[n];
        if (!applies_in(condition, frame.phase)) {
            readings.emplace_back();
        } else if (const std::string why = lacking(condition, frame, mask != nullptr); !why.empty()) {
            readings.push_back(missing_reading(why));
        } else {
            readings.push_back(condition.measure == ContractMeasure::color_difference ? color_reading(n, frame)
                               : is_of_palette(condition)                             ? symbology_reading(condition, measured)
                                                                                      : picture_reading(condition, measured));
        }
    }
    return readings;
}

ContractReading ContractMeter::symbology_reading(const ContractCondition& condition, const MeasuredFrame& frame) const {
    const std::optional<design::SymbologyLight> light = symbology_light(frame.frame);
    if (!palette_ || !light)
        return missing_reading("the run does not say in which light its symbology was drawn; replay the run again");
    if (condition.measure == ContractMeasure::symbology_contrast)
        return role_contrast_reading(condition, frame, palette_->palettes.of(*light));
    const RoleGap gap = least_role_gap(palette_->palettes, *light);
    return {ReadingState::measured, gap.difference, {}, "palette " + palette_->name, gap.words};
}

ContractReading ContractMeter::color_reading(std::size_t condition, const FlightFrame& frame) const {
    const auto design = gaps_.find(frame.design);
    if (design == gaps_.end())
        return missing_reading("the run's design no longer has one called '" + frame.design + "'; replay the run again");
    const std::optional<ColorGap>& gap = design->second[condition];
    if (!gap) return {};
    return {ReadingState::measured, gap->difference, {}, "design " + frame.design, gap->words};
}

}  // namespace tedavis::host_sim
