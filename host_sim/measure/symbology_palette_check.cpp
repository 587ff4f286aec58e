#include "host_sim/measure/symbology_palette_check.hpp"

#include <cstdio>
#include <limits>

#include "host_sim/measure/color_vision.hpp"
#include "render_core/design/color_difference.hpp"
#include "render_core/perception/contrast_ratio.hpp"

namespace tedavis::host_sim {
namespace {

using design::SymbologyLight;
using design::SymbologyPalettes;
using design::SymbolRole;

constexpr std::array<SymbologyLight, 2> kSymbologyLights = {SymbologyLight::day, SymbologyLight::night};

std::string role_name(std::size_t role) { return std::string(design::kSymbolRoleNames[role]); }

std::string in_light(SymbologyLight light) {
    return " by " + std::string(design::kSymbologyLightNames[static_cast<std::size_t>(light)]);
}

std::string two_decimals(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", value);
    return text;
}

double role_difference(design::Color first, design::Color second, ColorVision vision) {
    return color_difference(lab_of(seen_with(vision, linear_rgb(first))), lab_of(seen_with(vision, linear_rgb(second))));
}

void check_roles_apart(const SymbologyPalettes& palettes, SymbologyLight light, const std::string& name,
                       std::vector<std::string>& faults) {
    const RoleGap gap = least_role_gap(palettes, light);
    if (gap.difference >= kMinRoleDifference) return;
    faults.push_back(name + ": " + gap.words + in_light(light) + " differ by " + two_decimals(gap.difference) +
                     " (CIEDE2000) and need " + two_decimals(kMinRoleDifference) +
                     "; choose another color, or state in [[told_apart]] what else tells them apart");
}

/// Of a ground over white, where it darkens least.
double shown_luminance(design::Color color) {
    const double share = color.alpha / 255.0;
    color.alpha = 255;
    return relative_luminance(design::blended({255, 255, 255}, color, share));
}

/// Signs have the rim around them, or stand on the ground of readouts without one.
void check_contrast(const SymbologyPalettes& palettes, SymbologyLight light, SymbolRole behind, const std::string& name,
                    std::vector<std::string>& faults) {
    const design::SymbologyPalette& palette = palettes.of(light);
    double least = std::numeric_limits<double>::infinity();
    std::size_t worst = 0;
    for (std::size_t role = 0; role < design::kSignRoleCount; ++role) {
        const double ratio =
            perception::contrast_ratio(relative_luminance(palette.colors[role]), shown_luminance(palette.color(behind)));
        if (ratio < least) least = ratio, worst = role;
    }
    if (least >= kMinRimContrast) return;
    faults.push_back(name + ": " + role_name(worst) + in_light(light) + " has a contrast of " + two_decimals(least) + " with " +
                     role_name(static_cast<std::size_t>(behind)) + " and needs " + two_decimals(kMinRimContrast) +
                     "; choose a lighter color, or a darker " + role_name(static_cast<std::size_t>(behind)));
}

void check_night(const SymbologyPalettes& palettes, const std::string& name, std::vector<std::string>& faults) {
    for (std::size_t role = 0; role < design::kSymbolRoleCount; ++role) {
        const double by_day = shown_luminance(palettes.of(SymbologyLight::day).colors[role]),
                     by_night = shown_luminance(palettes.of(SymbologyLight::night).colors[role]);
        const bool is_sign = role < design::kSignRoleCount;
        if (by_night < by_day || (by_night == by_day && !is_sign)) continue;
        faults.push_back(name + ": " + role_name(role) +
                         " is not darker by night than by day; choose a darker color for [night]");
        return;
    }
}

}  // namespace

RoleGap least_role_gap(const SymbologyPalettes& palettes, SymbologyLight light) {
    const auto& colors = palettes.of(light).colors;
    RoleGap least{std::numeric_limits<double>::infinity(), {}};
    for (std::size_t first = 0; first < design::kSignRoleCount; ++first)
        for (std::size_t second = first + 1; second < design::kSignRoleCount; ++second) {
            if (palettes.are_told_apart(static_cast<SymbolRole>(first), static_cast<SymbolRole>(second))) continue;
            for (const ColorVision vision : kColorVisions) {
                const double difference = role_difference(colors[first], colors[second], vision);
                if (difference >= least.difference) continue;
                least = {difference, role_name(first) + " and " + role_name(second) + " in " + to_string(vision)};
            }
        }
    return least;
}

std::vector<std::string> symbology_palette_faults(const SymbologyPalettes& palettes, const std::string& name) {
    std::vector<std::string> faults;
    for (const SymbologyLight light : kSymbologyLights) {
        check_roles_apart(palettes, light, name, faults);
        for (const SymbolRole behind : {SymbolRole::rim, SymbolRole::readout_ground})
            check_contrast(palettes, light, behind, name, faults);
    }
    check_night(palettes, name, faults);
    return faults;
}

}  // namespace tedavis::host_sim
