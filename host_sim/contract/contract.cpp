#include "host_sim/contract/contract.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host_sim/contract/color_groups.hpp"
#include "host_sim/evaluation/evaluated_flight.hpp"
#include "host_sim/evaluation/read_canny.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/user_error.hpp"
#include "render_core/base/config_reader.hpp"
#include "render_core/display/planner/picture_layer.hpp"
#include "render_core/flight/flight_phase.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::size_t kMaxWords = 16;
constexpr int kMinRolePixels = 12;
constexpr perception::RegionGrid kThirds{3, 3};

std::vector<std::string> read_words(base::ConfigSection& section, std::string_view key) {
    std::array<std::string_view, kMaxWords> words;
    const std::size_t count = section.texts(key, {words.data(), words.size()});
    return {words.begin(), words.begin() + static_cast<std::ptrdiff_t>(std::min(count, kMaxWords))};
}

bool is_layer_name(std::string_view name) {
    const auto& layers = display::kPictureLayerNames;
    return std::find(layers.begin(), layers.end(), name) != layers.end();
}

void read_phases(base::ConfigSection& section, ContractCondition& condition) {
    condition.phases = read_words(section, "phases");
    for (const std::string& phase : condition.phases)
        if (!flight::phase_from_name(phase).ok)
            section.fault("phases", "'phases' names phases such as takeoff, cruise or approach.final");
}

void read_condition_limit(base::ConfigSection& section, bool is_most, double low, double high, ContractCondition& condition) {
    condition.limit.is_most = is_most;
    condition.limit.limit = section.number(is_most ? "most" : "least", low, high);
}

/// One of the nine thirds; false where the name is none of theirs.
bool take_third(std::string_view name, ContractCondition& condition) {
    for (int row = 0; row < kThirds.rows; ++row)
        for (int column = 0; column < kThirds.columns; ++column) {
            if (region_name(kThirds, column, row) != name) continue;
            condition.region = ClutterRegion::cell;
            condition.grid = kThirds;
            condition.column = column;
            condition.row = row;
            return true;
        }
    return false;
}

void read_cell(base::ConfigSection& section, ContractCondition& condition) {
    std::array<double, 2> cell{1, 1};
    section.numbers("cell", 1, perception::RegionGrid::kMax, {cell.data(), 2});
    condition.region = ClutterRegion::cell;
    condition.column = static_cast<int>(cell[0]) - 1;
    condition.row = static_cast<int>(cell[1]) - 1;
    if (cell[0] != std::floor(cell[0]) || cell[1] != std::floor(cell[1]) || condition.column >= condition.grid.columns ||
        condition.row >= condition.grid.rows)
        section.fault("cell", "'cell' is no column and row of the grid; count both from 1 at the upper left");
}

void read_clutter_region(base::ConfigSection& section, ContractCondition& condition) {
    std::array<double, 2> grid{8, 6};
    section.numbers("grid", 1, perception::RegionGrid::kMax, {grid.data(), 2});
    if (grid[0] != std::floor(grid[0]) || grid[1] != std::floor(grid[1]))
        section.fault("grid", "'grid' counts columns and rows: whole numbers");
    condition.grid = {static_cast<int>(grid[0]), static_cast<int>(grid[1])};
    if (section.has("cell")) return read_cell(section, condition);
    const std::string_view region = section.text("region", "picture");
    if (region == "every") {
        condition.region = ClutterRegion::every;
    } else if (region != "picture" && !take_third(region, condition)) {
        section.fault("region", "'region' must be picture, every, or a third such as \"upper left\" or \"middle centre\"");
    } else if (section.has("grid")) {
        section.fault("grid", "'grid' belongs to region = \"every\" or to a cell; remove it");
    }
}

void read_condition_layer(base::ConfigSection& section, ContractCondition& condition, bool may_be_prioritized) {
    const std::string_view layer = may_be_prioritized ? section.text("layer", "prioritized") : section.text("layer");
    if (may_be_prioritized && layer == "prioritized") return;
    condition.layer = layer;
    if (!is_layer_name(layer))
        section.fault("layer", may_be_prioritized ? "'layer' must be prioritized, terrain, data, uncertainty, labels or symbology"
                                                  : "'layer' must be terrain, data, uncertainty, labels or symbology");
}

void read_left_out_layers(base::ConfigSection& section, ContractCondition& condition) {
    condition.without = read_words(section, "without");
    for (const std::string& layer : condition.without)
        if (!is_layer_name(layer) || layer == condition.layer)
            section.fault("without", "'without' names other layers: terrain, data, uncertainty, labels, symbology");
}

void read_color_groups(base::ConfigSection& section, ContractCondition& condition) {
    condition.between = read_words(section, "between");
    if (condition.between.empty()) section.fault("between", "'between' must name groups of colours, such as warnings and ground");
    for (const std::string& group : condition.between)
        if (!is_color_group(group))
            section.fault("between", "'between' names warnings, ground, sea, unknown, or roles of data such as obstacle");
    if (condition.between.size() == 1 && condition.between[0] != kWarningsGroup)
        section.fault("between", "'between' needs a second group; only warnings are told apart from each other");
    condition.light = section.number("light", 0.05, 1, 1);
}

void read_measure_keys(base::ConfigSection& section, ContractCondition& condition) {
    switch (condition.measure) {
        case ContractMeasure::clutter:
            read_condition_limit(section, true, 0, 1, condition);
            return read_clutter_region(section, condition);
        case ContractMeasure::saliency_share:
        case ContractMeasure::saliency_over_area:
            read_condition_limit(section, false, 0, condition.measure == ContractMeasure::saliency_share ? 1 : 1000, condition);
            read_condition_layer(section, condition, true);
            return read_left_out_layers(section, condition);
        case ContractMeasure::obstacle_rank:
            read_condition_limit(section, true, 1, static_cast<double>(perception::kMaxSalientPlaces), condition);
            condition.focus_share = section.number("focus", 0.01, 0.5, perception::kFocusShare);
            return read_left_out_layers(section, condition);
        case ContractMeasure::luminance_contrast:
            read_condition_limit(section, false, 1, 21, condition);
            condition.least_px = static_cast<int>(section.integer("least_px", 1, 100000, condition.least_px));
            return read_condition_layer(section, condition, false);
        case ContractMeasure::color_difference:
            read_condition_limit(section, false, 0, 100, condition);
            return read_color_groups(section, condition);
        case ContractMeasure::symbology_contrast:
            read_condition_limit(section, false, 1, 21, condition);
            condition.least_px = static_cast<int>(section.integer("least_px", 1, 100000, kMinRolePixels));
            return;
        case ContractMeasure::symbology_difference: return read_condition_limit(section, false, 0, 100, condition);
    }
}

std::string plain_name(const ContractCondition& condition) {
    std::string name(kContractMeasureNames[static_cast<std::size_t>(condition.measure)]);
    for (char& c : name)
        if (c == '_') c = ' ';
    if (!condition.layer.empty()) name += " of " + condition.layer;
    for (std::size_t n = 0; n < condition.phases.size(); ++n) name += (n == 0 ? " in " : ", ") + condition.phases[n];
    return name;
}

ContractCondition read_condition(base::ConfigSection section) {
    ContractCondition condition;
    if (!section.has("measure")) {
        section.fault("measure", "'measure' is missing; say what the condition measures, such as clutter");
        return {};
    }
    section.choose("measure", kContractMeasureNames, condition.measure);
    condition.limit.for_s = section.number("for_s", 0, 3600, 0);
    condition.is_optional = section.boolean("optional", false);
    read_phases(section, condition);
    read_measure_keys(section, condition);
    condition.name = section.text("name", "");
    if (condition.name.empty()) condition.name = plain_name(condition);
    return condition;
}

void require_different_names(const Contract& contract) {
    const auto& all = contract.conditions;
    for (std::size_t n = 1; n < all.size(); ++n)
        for (std::size_t before = 0; before < n; ++before)
            if (all[n].name == all[before].name)
                throw UserError(contract.path + ": two conditions are called \"" + all[n].name + "\"; give one another name");
}

}  // namespace

bool applies_in(const ContractCondition& condition, std::string_view phase) {
    if (condition.phases.empty()) return true;
    return std::any_of(condition.phases.begin(), condition.phases.end(), [phase](const std::string& named) {
        return phase == named ||
               (phase.size() > named.size() && phase.substr(0, named.size()) == named && phase[named.size()] == '.');
    });
}

bool needs_layers(const ContractCondition& condition) {
    switch (condition.measure) {
        case ContractMeasure::saliency_share:
        case ContractMeasure::saliency_over_area:
        case ContractMeasure::luminance_contrast:
        case ContractMeasure::symbology_contrast: return true;
        case ContractMeasure::obstacle_rank: return !condition.without.empty();
        case ContractMeasure::clutter:
        case ContractMeasure::color_difference:
        case ContractMeasure::symbology_difference: break;
    }
    return false;
}

Contract read_contract(const std::string& path) {
    const std::string text = read_file(path);
    base::ConfigReader reader(text, path);
    base::ConfigSection root = reader.root();
    Contract contract;
    contract.path = path;
    contract.title = root.text("title", "");
    contract.canny = read_canny(root);
    const std::size_t count = root.table_count("condition");
    for (std::size_t n = 0; n < count; ++n) contract.conditions.push_back(read_condition(root.table_at("condition", n)));
    if (!reader.finish()) throw UserError(std::string(reader.error().message.view()));
    if (contract.conditions.empty()) throw UserError(path + ": has no [[condition]]; state one");
    require_different_names(contract);
    return contract;
}

}  // namespace tedavis::host_sim
