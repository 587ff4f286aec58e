#include "host_sim/contract/color_groups.hpp"

#include <algorithm>
#include <cstdio>

#include "host_sim/measure/color_vision.hpp"
#include "render_core/design/color_difference.hpp"
#include "render_core/draw/alert_zone_look.hpp"

namespace tedavis::host_sim {
namespace {

using design::Color;

constexpr std::string_view kGroundGroup = "ground", kSeaGroup = "sea", kUnknownGroup = "unknown";
constexpr int kBetweenStops = 8;
constexpr std::size_t kNoBase = SIZE_MAX;

/// A colour of a group, and what lies below it, where that matters.
struct GroupColor {
    Color shown;
    std::size_t base = kNoBase;  ///< of the ground's colours, below a band or itself
    const design::WarningBand* band = nullptr;
};
using GroupColors = std::vector<GroupColor>;

std::vector<Color> ground_colors(const design::DesignSettings& design) {
    const design::TerrainSettings& terrain = design.terrain;
    const bool is_natural = terrain.style.texture == design::TerrainTexture::material;
    if (!design::colors_by_palette(terrain.style.texture) && !is_natural) return {terrain.style.plain};
    std::vector<Color> colors;
    const auto& stops = terrain.palette.stops;
    for (std::size_t n = 0; n + 1 < stops.size(); ++n)
        for (int step = 0; step < kBetweenStops; ++step)
            colors.push_back(design::blended(stops[n].color, stops[n + 1].color, static_cast<double>(step) / kBetweenStops));
    if (!stops.empty()) colors.push_back(stops[stops.size() - 1].color);
    if (!is_natural) return colors;
    for (std::size_t n = 0, tints = colors.size(); n < tints; ++n) colors.push_back(design::wooded(terrain.style, colors[n]));
    colors.push_back(terrain.style.rock);
    return colors;
}

/// The two colors of the terrain alert, over whatever ground.
const design::WarningBands& alert_bands() {
    static const design::WarningBands bands = [] {
        const draw::AlertColors alert;
        design::WarningBands made;
        static_cast<void>(made.try_push_back({0, 0, alert.warning, alert.strength}));
        static_cast<void>(made.try_push_back({0, 0, alert.caution, alert.strength}));
        return made;
    }();
    return bands;
}

/// Of the bands where the design has them, else of the alert.
GroupColors warning_colors(const design::DesignSettings& design) {
    GroupColors colors;
    const std::vector<Color> ground = ground_colors(design);
    for (const design::WarningBand& band : design.warning_colors ? design.warning_bands : alert_bands())
        for (std::size_t n = 0; n < ground.size(); ++n)
            colors.push_back({design::blended(ground[n], band.color, band.strength), n, &band});
    return colors;
}

GroupColors role_colors(const design::DesignSettings& design, std::string_view role) {
    GroupColors colors;
    for (const design::DataElement& element : design.data.elements)
        if (element.own == design::OwnData::none && element.layer.view().empty() && scene::name_of(element.role) == role &&
            !element.by_color.is_used())
            colors.push_back({element.color});
    return colors;
}

GroupColors colors_of_group(const design::DesignSettings& design, std::string_view group) {
    if (group == kWarningsGroup) return warning_colors(design);
    if (group == kSeaGroup) return {{design.terrain.sea}};
    if (group == kUnknownGroup) return {{design.terrain.unknown}};
    if (group != kGroundGroup) return role_colors(design, group);
    GroupColors colors;
    for (const Color color : ground_colors(design)) colors.push_back({color, colors.size()});
    return colors;
}

/// Bands of another hue; and where a band meets another one or the bare ground, the same ground lies below both.
bool are_compared(const GroupColor& first, const GroupColor& second) {
    if (first.band != nullptr && second.band != nullptr && first.band->color == second.band->color) return false;
    const bool has_band = first.band != nullptr || second.band != nullptr;
    return !has_band || first.base == kNoBase || second.base == kNoBase || first.base == second.base;
}

std::string hex_of(Color color) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", color.red, color.green, color.blue);
    return text;
}

class GapSearch {
public:
    explicit GapSearch(double light) : light_(light) {}

    void compare(const GroupColors& first, const std::string& first_name, const GroupColors& second,
                 const std::string& second_name) {
        for (const ColorVision vision : kColorVisions) {
            const std::vector<design::Lab> labs = seen(first, vision), others = seen(second, vision);
            for (std::size_t i = 0; i < first.size(); ++i)
                for (std::size_t j = 0; j < second.size(); ++j) {
                    if (!are_compared(first[i], second[j])) continue;
                    const double difference = design::color_difference(labs[i], others[j]);
                    if (least_ && difference >= least_->difference) continue;
                    least_ = ColorGap{difference, first_name + " (" + hex_of(first[i].shown) + ") and " + second_name + " (" +
                                                      hex_of(second[j].shown) + ") in " + to_string(vision)};
                }
        }
    }
    [[nodiscard]] const std::optional<ColorGap>& least() const { return least_; }

private:
    [[nodiscard]] std::vector<design::Lab> seen(const GroupColors& colors, ColorVision vision) const {
        std::vector<design::Lab> labs;
        for (const GroupColor& color : colors)
            labs.push_back(
                design::lab_of(seen_with(vision, design::linear_rgb(design::blended({0, 0, 0}, color.shown, light_)))));
        return labs;
    }

    double light_;
    std::optional<ColorGap> least_;
};

}  // namespace

bool is_color_group(std::string_view name) {
    if (name == kWarningsGroup || name == kGroundGroup || name == kSeaGroup || name == kUnknownGroup) return true;
    return std::find(scene::kLayerRoleNames.begin(), scene::kLayerRoleNames.end(), name) != scene::kLayerRoleNames.end();
}

std::optional<ColorGap> least_color_gap(const design::DesignSettings& design, const std::vector<std::string>& groups,
                                        double light) {
    GapSearch search(light);
    std::vector<GroupColors> colors;
    for (const std::string& group : groups) colors.push_back(colors_of_group(design, group));
    if (groups.size() == 1) search.compare(colors[0], groups[0], colors[0], groups[0]);
    for (std::size_t n = 0; n < groups.size(); ++n)
        for (std::size_t other = n + 1; other < groups.size(); ++other)
            search.compare(colors[n], groups[n], colors[other], groups[other]);
    return search.least();
}

}  // namespace tedavis::host_sim
