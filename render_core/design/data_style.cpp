#include "render_core/design/data_style.hpp"

#include <algorithm>
#include <cmath>

#include "render_core/design/config_values.hpp"

namespace tedavis::design {
namespace {

using base::ConfigSection;

constexpr std::uint32_t kMaxMeshWidths = 8, kOrdinaryMeshWidths = 5;

/// Of a number of gradations, 1 .. kMaxClasses.
double detail_of_gradations(double gradations) { return std::log2(gradations) / std::log2(double{kMaxClasses}); }
/// The other way round; at least one.
std::size_t gradations_of_detail(double detail) {
    const double kept = detail > 0 ? std::fmin(detail, 1) : 0;
    return static_cast<std::size_t>(std::exp2(kept * std::log2(double{kMaxClasses})) + 1e-9);
}

void read_uncertainty(ConfigSection section, GroundUncertainty& uncertainty) {
    section.choose("technique", kIntrinsicUncertaintyNames, uncertainty.technique);
    uncertainty.strength = section.number("strength", 0, 1, uncertainty.strength);
    uncertainty.levels = static_cast<std::uint32_t>(section.integer("levels", 0, kMaxClasses, uncertainty.levels));
    if (uncertainty.levels == 1) fault_of(section, "levels", "must be 0 for continuous, or 2 to 16");
    if (uncertainty.technique == IntrinsicUncertainty::bivariate && uncertainty.levels == 0) uncertainty.levels = 4;
}

void read_overlay(ConfigSection section, GroundOverlay& overlay) {
    section.choose("technique", kUncertaintyOverlayNames, overlay.technique);
    overlay.strength = section.number("strength", 0, 1, overlay.strength);
    const std::uint32_t most = overlay.technique == UncertaintyOverlay::grid ? kMaxMeshWidths : kMaxClasses;
    overlay.levels = static_cast<std::uint32_t>(section.integer("levels", 0, most, overlay.levels));
    if (overlay.levels == 1) fault_of(section, "levels", "must be 0 for continuous, or 2 and more");
    overlay.threshold = section.number("threshold", 0, 1, overlay.threshold);
    overlay.mesh_m = section.number("mesh_m", 1, 1024, overlay.mesh_m);
    if (std::exp2(std::round(std::log2(overlay.mesh_m))) != overlay.mesh_m)
        fault_of(section, "mesh_m", "must be a power of two: 64, 128, 256 ...");
    if (section.has("color")) overlay.color = required_color(section, "color");
}

void read_ground(ConfigSection section, PaletteSource& palettes, GroundData& ground) {
    if (!section.present()) return;
    ground.is_shown = section.boolean("enabled", true);
    ground.layer = section.text("layer");
    ground.attribute = section.text("attribute");
    if (ground.layer.cut()) fault_of(section, "layer", "is longer than 31 bytes; no layer has such a name");
    if (ground.attribute.cut()) fault_of(section, "attribute", "is longer than 31 bytes; no attribute has such a name");
    read_scale(section, palettes, ground.scale);
    ground.opacity = section.number("opacity", 0, 1, ground.opacity);
    ground.shown_from = section.number("shown_from", -1e12, 1e12, ground.shown_from);
    if (section.has("height_m")) ground.height_m = section.number("height_m", -1000, 100'000);
    section.choose("members", kGroundMembersNames, ground.members);
    ground.member_s = section.number("member_seconds", 0.5, 60, ground.member_s);
    read_uncertainty(section.section("uncertainty"), ground.uncertainty);
    if (ground.scale.palette.is_nominal() && ground.uncertainty.technique == IntrinsicUncertainty::blur)
        fault_of(section, "palette", "is nominal, and blur would mix its colours; choose another technique of uncertainty");
    read_overlay(section.section("overlay"), ground.overlay);
}

}  // namespace

const std::array<std::string_view, kIntrinsicUncertainties> kIntrinsicUncertaintyNames{
    "none", "transparency", "saturation", "noise", "strokes", "bivariate", "bump", "blur"};
const std::array<std::string_view, kGroundMembers> kGroundMembersNames{"mean", "animated"};
const std::array<std::string_view, kUncertaintyOverlays> kUncertaintyOverlayNames{"none", "fog", "grid", "contour", "halo"};

void read_data_style(ConfigSection data, PaletteSource& palettes, DataStyle& style) {
    if (!data.present()) return;
    read_color(data, "missing_color", style.missing);
    style.stale_after_s = 60 * data.number("stale_after_min", 1, 100'000, style.stale_after_s / 60);
    read_ground(data.section("ground"), palettes, style.ground);
    read_adjacent_view(data.section("adjacent"), palettes, style.adjacent);
    read_data_elements(data, palettes, style.elements);
}

double detail_of(const DataScale& scale) noexcept {
    if (scale.palette.is_nominal()) return detail_of_gradations(static_cast<double>(scale.palette.stops.size()));
    return scale.breaks.empty() ? 1 : detail_of_gradations(static_cast<double>(scale.breaks.size() + 1));
}

double detail_of(const GroundUncertainty& uncertainty) noexcept {
    if (uncertainty.technique == IntrinsicUncertainty::none || uncertainty.strength <= 0) return 0;
    return detail_of_levels(uncertainty.levels);
}

double detail_of(const GroundOverlay& overlay) noexcept {
    if (overlay.strength <= 0) return 0;
    switch (overlay.technique) {
        case UncertaintyOverlay::none: return 0;
        case UncertaintyOverlay::fog: return detail_of_levels(overlay.levels);
        case UncertaintyOverlay::grid: return detail_of_gradations(overlay.levels == 0 ? kOrdinaryMeshWidths : overlay.levels);
        case UncertaintyOverlay::contour:
        case UncertaintyOverlay::halo: return detail_of_gradations(2);
    }
    return 0;
}

double detail_of_levels(std::uint32_t levels) noexcept { return levels == 0 ? 1 : detail_of_gradations(levels); }

double detail_of_members(std::uint32_t members) noexcept { return detail_of_gradations(std::max(members, 1u)); }

std::uint32_t levels_at_detail(std::uint32_t levels, double detail) noexcept {
    const auto most = static_cast<std::uint32_t>(gradations_of_detail(detail));
    if (most < 2) return 1;
    return most < kMaxClasses && (levels == 0 || levels > most) ? most : levels;
}

GroundData at_detail(const GroundData& ground, const GroundDetails& details) noexcept {
    GroundData reduced = ground;
    if (!ground.is_shown) return reduced;
    const std::size_t most = gradations_of_detail(details.data);
    reduced.most_members = std::min(reduced.most_members, static_cast<std::uint32_t>(most));
    if (detail_of(ground.scale) > details.data) reduce_classes(reduced.scale, std::max<std::size_t>(most, 2));
    const auto intrinsic = static_cast<std::uint32_t>(gradations_of_detail(details.intrinsic));
    const auto extrinsic = static_cast<std::uint32_t>(gradations_of_detail(details.extrinsic));
    if (intrinsic < 2) reduced.uncertainty.strength = 0;
    if (extrinsic < 2) reduced.overlay.strength = 0;
    if (detail_of(reduced.uncertainty) > details.intrinsic) reduced.uncertainty.levels = intrinsic;
    if (detail_of(reduced.overlay) > details.extrinsic) reduced.overlay.levels = extrinsic;
    return reduced;
}

GroundData at_detail(const GroundData& ground, double detail) noexcept { return at_detail(ground, {detail, detail, detail}); }

AdjacentView at_detail(const AdjacentView& view, double detail) noexcept {
    AdjacentView reduced = view;
    const double kept = detail > 0 ? std::fmin(detail, 1) : 0;
    if (view.is_shown && detail_of(view.scale) > kept)
        reduce_classes(reduced.scale, std::max<std::size_t>(gradations_of_detail(kept), 2));
    if (view.shows == AdjacentShows::members)
        reduced.most_members = std::min(view.most_members, static_cast<std::uint32_t>(gradations_of_detail(kept)));
    else
        reduced.cells = std::max(kMinCells, static_cast<std::uint32_t>(kept * static_cast<double>(view.cells)));
    return reduced;
}

bool same_programs(const DataStyle& a, const DataStyle& b) noexcept {
    return a.ground.is_shown == b.ground.is_shown &&
           (!a.ground.is_shown || (a.ground.uncertainty.technique == b.ground.uncertainty.technique &&
                                   a.ground.overlay.technique == b.ground.overlay.technique));
}

}  // namespace tedavis::design
