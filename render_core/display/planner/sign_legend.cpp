#include "render_core/display/planner/sign_legend.hpp"

#include <cmath>
#include <cstdio>

#include "render_core/base/units.hpp"
#include "render_core/display/planner/data_legends.hpp"
#include "render_core/draw/data/billboard_look.hpp"
#include "render_core/draw/data/diagrams.hpp"
#include "render_core/draw/data/isosurface_solids.hpp"
#include "render_core/draw/data/placement.hpp"
#include "render_core/draw/data/traffic_signs.hpp"
#include "render_core/draw/data/tube_path.hpp"

namespace tedavis::display {
namespace {

using design::Color;
using design::DataTechnique;
using design::ElementUncertainty;
using draw::LegendSample;
using draw::SampleLook;
using scene::LayerRole;

constexpr Color kUnderSigns{0, 0, 0};
/// As the hull of a tube and the margin of an area are drawn over the ground.
constexpr double kMarginShare = 0.35;
constexpr double kDashShare = 0.6;  // of the outer frame of a pathway

/// Signs over the picture find their room when the legends have theirs.
bool shows_nothing(const ElementReport& report) {
    const scene::LayerEntry& layer = *report.layer->entry;
    if (layer.shape != scene::LayerShape::grid && layer.feature_count == 0) return true;
    return !is_sign_technique(report.element->technique) && report.count.drawn + report.count.aggregated == 0;
}

using Words = base::FixedString<23>;

class Signs {
public:
    explicit Signs(const design::DesignSettings& design)
        : ground_(design.terrain.style.plain), units_(design.symbology.units), grid_(design.terrain.style.grid) {
        legend_.has_scale = false;
        legend_.title = "SYMBOLS";
    }

    void add(const ElementReport& report) {
        add_technique(report);
        add_lines(report);
        add_grid(report);
    }

    /// "12 LABELS HIDDEN".
    void add_suppressed(const ElementReports& reports) {
        unsigned count = 0;
        for (const ElementReport& report : reports) count += report.state == ElementState::shown ? report.suppressed_labels : 0;
        char text[24];
        std::snprintf(text, sizeof text, "%u LABELS HIDDEN", count);
        if (count > 0) add_words(text);
    }

    [[nodiscard]] const draw::DataLegend& legend() const { return legend_; }

private:
    void add_technique(const ElementReport& report) {
        const design::DataElement& element = *report.element;
        switch (element.technique) {
            case DataTechnique::prism: return add_area(report);
            case DataTechnique::tube:
            case DataTechnique::pathway:
            case DataTechnique::space_time: return add_tube(report);
            case DataTechnique::billboard: return add_billboard(report);
            case DataTechnique::solid: return add_margin(report, "POS", element.color);
            case DataTechnique::barbs: return add_words("BARB 10 KT"), add_words("PENNANT 50 KT");
            case DataTechnique::diagram: return add_diagram(report);
            case DataTechnique::isosurface: return add_isosurface(report);
            case DataTechnique::arrows:
            case DataTechnique::flat_arrows: return add_wind_signs(report);
            default: return;
        }
    }

    /// "LINES 0.5 NM": distances are told by them.
    void add_lines(const ElementReport& report) {
        if (report.cues[static_cast<std::size_t>(draw::Cue::vertical_lines)].drawn == 0) return;
        Words words("LINES ");
        add_words(append_spacing(report.element->cues.line_spacing_m, words).view());
    }

    /// "GRID 1 NM" or "GRID 1 MIN", "GRID VERT 500 FT".
    void add_grid(const ElementReport& report) {
        if (!report.element->grid || !grid_.is_shown()) return;
        Words level("GRID "), up("GRID VERT ");
        add_words(
            (grid_.is_angular() ? append_minutes(grid_.spacing_rad, level) : append_spacing(grid_.spacing_m, level)).view());
        if (grid_.height_spacing_m > 0) add_words(append_length(grid_.height_spacing_m, up).view());
    }

    /// "1 MIN", of latitude and longitude.
    static Words& append_minutes(double spacing_rad, Words& words) {
        char text[24];
        std::snprintf(text, sizeof text, "%.4g MIN", base::degrees(spacing_rad) * 60);
        words.append(text);
        return words;
    }

    /// "0.5 NM", "1000 M".
    static Words& append_spacing(double spacing_m, Words& words) {
        const double tenths_nm = 10 * spacing_m / base::kMetresPerNauticalMile;
        const bool is_miles = std::fabs(tenths_nm - std::round(tenths_nm)) < 1e-6;
        char text[24];
        std::snprintf(text, sizeof text, is_miles ? "%.4g NM" : "%.0f M", is_miles ? tenths_nm / 10 : spacing_m);
        words.append(text);
        return words;
    }

    void add_sample(const LegendSample& sample) {
        for (const LegendSample& known : legend_.signs)
            if (known.text == sample.text) return;
        static_cast<void>(legend_.signs.try_push_back(sample));
    }

    LegendSample& begin(std::string_view text, SampleLook look, Color color) {
        made_ = {};
        made_.text.append(text);
        made_.look = look;
        made_.color = color;
        made_.under = ground_;
        return made_;
    }

    void add_icon(std::string_view text, SampleLook look, draw::Icon icon, Color color) {
        begin(text, look, color).under = kUnderSigns;
        made_.icon = icon;
        add_sample(made_);
    }

    void add_words(std::string_view text) {
        begin(text, SampleLook::words, ground_);
        add_sample(made_);
    }

    /// "PATH 95 %", "LIMIT ± ?": the uncertainty of a position, where the element shows it.
    void add_margin(const ElementReport& report, std::string_view name, Color color) {
        const ElementUncertainty shown = report.element->uncertainty;
        if (shown != ElementUncertainty::widening && shown != ElementUncertainty::ellipsoid) return;
        base::FixedString<15> text(name);
        text.append(draw::states_accuracy(*report.layer) ? " 95 %" : " \xC2\xB1 ?");
        const bool is_outline = report.element->technique == DataTechnique::pathway;
        LegendSample& sample = begin(text.view(), is_outline ? SampleLook::dashed_rim : SampleLook::margin, color);
        if (is_outline)
            sample.share = kDashShare;
        else
            sample.under = blended(ground_, color, kMarginShare);
        add_sample(sample);
    }

    void add_area(const ElementReport& report) {
        const LayerRole role = report.layer->entry->role;
        if (report.element->by_color.is_used() || (role != LayerRole::no_go && role != LayerRole::airspace)) return;
        const Color color = report.element->color;
        add_sample(begin(role == LayerRole::no_go ? "NO-GO" : "AIRSPACE", SampleLook::plain, color));
        add_margin(report, "LIMIT", color);
    }

    void add_tube(const ElementReport& report) {
        const design::DataElement& element = *report.element;
        const Color color = element.by_color.is_used() ? Color{200, 200, 200} : element.color;
        if (!element.by_color.is_used()) add_sample(begin("TRAJECTORY", SampleLook::plain, color));
        add_margin(report, "PATH", color);
        if (element.technique == DataTechnique::space_time) {
            Words words("1 H: ");
            add_words(append_length(element.size_m > 0 ? element.size_m : draw::kDefaultTimeHeight_m, words).view());
            return;
        }
        const scene::Attribute* const size = report.layer->find(element.size_attribute.view());
        if (size == nullptr) return;
        Words title("WIDTH: ");
        title.append(attribute_title(*size->entry).view());
        add_words(title.view());
        Words scale;  // of the largest value; others are in proportion
        append_length(2 * (element.size_m > 0 ? element.size_m : draw::kDefaultTubeRadius_m), scale).append(": ");
        add_words(append_value(*size->entry, static_cast<double>(size->entry->maximum), scale).view());
    }

    /// "1312 FT".
    Words& append_length(double length_m, Words& words) const {
        const base::DisplayUnit unit = base::height_unit(units_);
        char text[24];
        std::snprintf(text, sizeof text, "%.0f ", unit.of(length_m));
        words.append(text);
        words.append(unit.text);
        return words;
    }

    /// "116 KT".
    Words& append_value(const scene::AttributeEntry& attribute, double value, Words& words) const {
        const ShownUnit unit = shown_unit(attribute, units_);
        char text[24];
        std::snprintf(text, sizeof text, "%.3g", value * unit.factor + unit.offset);
        words.append(text);
        if (!unit.name.empty()) words.append(" ");
        words.append(unit.name.view());
        return words;
    }

    /// A profile is a line: its attribute to the right, over what range, and the height upwards.
    void add_diagram(const ElementReport& report) {
        const scene::Attribute* const attribute = draw::profile_attribute(*report.element, *report.layer);
        if (attribute == nullptr || !draw::has_profiles(*report.layer)) return add_words("BARS MIN-MAX");
        Words title("LINE: ");
        title.append(attribute_title(*attribute->entry).view());
        add_words(title.view());
        const ShownUnit unit = shown_unit(*attribute->entry, units_);
        char least[24];
        std::snprintf(least, sizeof least, "%.3g..", static_cast<double>(attribute->entry->minimum) * unit.factor + unit.offset);
        Words range(least);
        add_words(append_value(*attribute->entry, static_cast<double>(attribute->entry->maximum), range).view());
        add_words("VERTICAL: HEIGHT");
    }

    /// Of arrows in one colour; a scale of colours has no room for more, and says what is missing itself.
    void add_wind_signs(const ElementReport& report) {
        if (report.element->by_color.is_used() || report.layer->entry->role != LayerRole::wind) return;
        add_words("RING: CALM");
        add_words("STAR IN RING: VARIABLE");
        add_words("CROSS: MISSING");
    }

    void add_isosurface(const ElementReport& report) {
        if (!draw::has_isosurface_lines(*report.element)) return;
        Words words("LINES ");
        add_words(append_length(draw::kIsosurfaceLines_m, words).view());
    }

    void add_billboard(const ElementReport& report) {
        const design::DataElement& element = *report.element;
        const LayerRole role = report.layer->entry->role;
        if (role == LayerRole::traffic) add_traffic(element);
        if (role == LayerRole::ghost) add_icon("GHOST FLIGHT", SampleLook::icon, draw::Icon::ghost, element.color);
        add_rim(report);
        add_margin(report, "POS", element.color);
        if (role == LayerRole::obstacle) add_obstacles(report);
    }

    /// A layer that states no uncertainty has no feature that is more uncertain than the others.
    void add_rim(const ElementReport& report) {
        const design::DataElement& element = *report.element;
        if (element.uncertainty == ElementUncertainty::none || element.uncertainty == ElementUncertainty::ellipsoid) return;
        if (element.uncertainty == ElementUncertainty::dashed_rim && report.layer->states_uncertainty()) {
            begin("UNCERTAIN", SampleLook::dashed_rim, element.color).under = kUnderSigns;
            made_.share = 1 - (1 - draw::kMinDashes) * element.uncertainty_strength;
            add_sample(made_);
        }
        add_words("? UNKNOWN");
    }

    void add_traffic(const design::DataElement& element) {
        add_icon("TRAFFIC", SampleLook::icon, draw::Icon::traffic, element.color);
        add_icon(units_ == base::DisplayUnits::metric ? "TFC 11 KM 366 M" : "TFC 6 NM 1200 FT", SampleLook::icon,
                 draw::Icon::near_traffic, element.color);
        add_icon("STALE TFC", SampleLook::crossed_icon, draw::Icon::traffic, draw::kStaleTraffic);
    }

    /// Of the kinds that there are.
    void add_obstacles(const ElementReport& report) {
        const scene::Layer& layer = *report.layer;
        const scene::Attribute* const kind = layer.find("kind");
        for (std::uint32_t n = 0; kind != nullptr && n < kind->entry->class_count; ++n)
            for (std::uint32_t feature = 0; feature < layer.entry->feature_count; ++feature) {
                if (scene::value_or_nan(layer, "kind", feature) != n) continue;
                base::FixedString<15> name;
                for (const char letter : kind->class_name(n)) {
                    const char upper = letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
                    name.append(std::string_view(&upper, 1));
                }
                add_icon(name.view(), SampleLook::icon, draw::icon_of(layer, feature), report.element->color);
                break;
            }
    }

    Color ground_;
    base::DisplayUnits units_;
    const design::GridSettings& grid_;
    LegendSample made_;
    draw::DataLegend legend_;
};

}  // namespace

void add_sign_legend(const ElementReports& reports, const design::DesignSettings& design, draw::DataLegends& legends) noexcept {
    Signs signs(design);
    if (design.labels.show_suppressed) signs.add_suppressed(reports);
    for (const bool obstacles : {false, true})
        for (const ElementReport& report : reports) {
            if (report.state != ElementState::shown || report.layer == nullptr || shows_nothing(report)) continue;
            if ((report.layer->entry->role == LayerRole::obstacle) == obstacles) signs.add(report);
        }
    if (!signs.legend().signs.empty()) static_cast<void>(legends.try_push_back(signs.legend()));
}

}  // namespace tedavis::display
