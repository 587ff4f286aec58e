#include "render_core/effects/calibration_text.hpp"

#include <cstdio>

namespace tedavis::effects {
namespace {

void append(CalibrationText& text, std::initializer_list<std::string_view> parts) {
    for (const std::string_view part : parts) text.append(part);
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// A TOML basic string of what a driver or a file calls itself.
void append_quoted(CalibrationText& text, std::string_view value) {
    text.append("\"");
    for (const char& c : value) {
        if (is_control(c)) continue;
        if (c == '"' || c == '\\') text.append("\\");
        text.append({&c, 1});
    }
    text.append("\"");
}

/// Of one line, so that it can stand behind a '#'.
void append_comment(CalibrationText& text, std::initializer_list<std::string_view> parts) {
    text.append("# ");
    for (const std::string_view part : parts)
        for (const char& c : part) text.append(is_control(c) ? std::string_view(" ") : std::string_view(&c, 1));
    text.append("\n");
}

void append_number(CalibrationText& text, const char* key, double value) {
    char line[80];
    std::snprintf(line, sizeof line, "%s = %.6f\n", key, value);
    text.append(line);
}

void append_cost(CalibrationText& text, const MeasuredCost& cost) {
    text.append("\n");
    if (!cost.note.empty()) append_comment(text, {"not measured: ", cost.note.view()});
    append(text, {"[cost.", cost.name.view(), "]\n"});
    append_number(text, "fixed_ms", cost.line.fixed_ms);
    append_number(text, "ms_per_megapixel", cost.line.ms_per_megapixel);
    append_number(text, "ms_per_thousand", cost.line.ms_per_thousand);
}

void append_names(CalibrationText& text, const EffectSet& effects) {
    bool is_first = true;
    for (std::size_t n = 0; n < kEffectCount; ++n) {
        if (!effects.has(static_cast<Effect>(n))) continue;
        if (!is_first) text.append(", ");
        append_quoted(text, row_of(static_cast<Effect>(n)).name);
        is_first = false;
    }
}

void append_level(CalibrationText& text, const QualityLevel& level) {
    text.append("\n[[quality]]\n");
    append_number(text, "tau_factor", level.tau_factor);
    append_number(text, "detail_factor", level.detail_factor);
    text.append("given_up = [");
    append_names(text, level.given_up);
    text.append("]\n");
    append_number(text, "ms", level.ms);
    append_number(text, "error_px", level.error_px);
    append_number(text, "error_color", level.error_color);
}

void append_subject(CalibrationText& text, const MeasuredCosts& measured) {
    const CalibrationSubject& of = measured.subject;
    text.append("device = ");
    append_quoted(text, of.device.view());
    text.append("\nrenderer = ");
    append_quoted(text, of.renderer.view());
    append(text, {"\nwidth_px = ", base::digits(of.width_px).view(), "\nheight_px = ", base::digits(of.height_px).view()});
    text.append("\ndate = ");
    append_quoted(text, measured.date.view());
    text.append("\n");
}

}  // namespace

void write_calibration(const MeasuredCosts& measured, CalibrationText& text) {
    text.clear();
    append_comment(text, {"What everything costs on one display, by ", measured.program.view(), ", over ",
                          measured.terrain.view(), " with the design ", measured.design.view(), "."});
    append_subject(text, measured);
    for (const MeasuredCost& cost : measured.costs) append_cost(text, cost);
    text.append("\n");
    append_comment(text, {"The quality levels that the governor may choose, from the design's own picture to the cheapest one. "
                          "error_px is the proven bound of the drawn terrain's error."});
    const QualityLevels levels = choose_levels(measured.candidates);
    for (std::size_t n = 0; n < levels.count; ++n) append_level(text, levels.at[n]);
}

}  // namespace tedavis::effects
