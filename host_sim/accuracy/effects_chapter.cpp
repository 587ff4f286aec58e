#include "host_sim/accuracy/effects_chapter.hpp"

#include <algorithm>
#include <cstdio>

#include "host_sim/evaluation/html_parts.hpp"
#include "host_sim/reports/line_chart.hpp"

namespace tedavis::host_sim {
namespace {

std::uint64_t without(const EffectUse& use) { return use.skipped + use.replaced; }

std::string reasons_of(const EffectUse& use) {
    std::string text;
    for (const EffectReason& reason : use.reasons)
        text += (text.empty() ? "" : "; ") + reason.text + " (" + std::to_string(reason.frames) + ")";
    return text;
}

std::string saved_text(const EffectUse& use) {
    if (without(use) == 0) return "";
    char text[64];
    std::snprintf(text, sizeof text, "%.2f +- %.2f", use.saved.ms, use.saved.spread_ms);
    return text;
}

/// The bound in its own unit; the measured difference counts for colours alone, since positions may move by half a pixel.
std::string difference_text(const EffectUse& use) {
    if (use.skipped == 0) return "";
    char text[80];
    if (use.contribution == "geometry")
        std::snprintf(text, sizeof text, "at most %.2g px", use.bound);
    else
        std::snprintf(text, sizeof text, "%u of 255", use.largest_difference);
    return text;
}

std::string use_row(const EffectUse& use) {
    return std::string(use.keeps_promise() ? "<tr>" : "<tr class='dominated'>") + "<th>" + escaped_html(use.name) + "</th>" +
           html_number(std::to_string(use.asked)) + html_number(std::to_string(use.run)) +
           html_number(std::to_string(use.replaced)) + html_number(std::to_string(use.skipped)) + html_number(saved_text(use)) +
           html_number(difference_text(use)) + html_number(without(use) > 0 ? std::to_string(use.skipped_work) : "") +
           html_cell(reasons_of(use)) + "</tr>";
}

std::string summary_of(const UncalledEffects& measured) {
    const auto count = [&](auto holds) {
        return std::to_string(std::count_if(measured.uses.begin(), measured.uses.end(), holds));
    };
    const std::string broken = count([](const EffectUse& use) { return !use.keeps_promise(); });
    return "Each effect was asked for over " + std::to_string(measured.frames) + " poses of the flight, in the design " +
           measured.design + " on " + measured.device + ". Of " + std::to_string(measured.uses.size()) + " effects " +
           count([](const EffectUse& use) { return use.run > 0; }) + " were drawn at least once, and " +
           count([](const EffectUse& use) { return without(use) > 0; }) + " were left out or replaced at least once. " + broken +
           " of them can be seen to be missing, or did work nevertheless.";
}

}  // namespace

std::string effects_chapter(const UncalledEffects& measured) {
    std::string rows;
    for (const EffectUse& use : measured.uses) rows += use_row(use);
    return "<p>" + escaped_html(summary_of(measured)) +
           "</p>\n<p class='soft'>Time saved: a frame with the effect forced less the frame as it is drawn, median of the pairs "
           "and half of "
           "the distance between their quartiles. Difference: of the picture without the effect from the picture with it, for "
           "effects that "
           "change colours the largest of a channel, for those that change positions the bound. Work: draws, passes and bytes of "
           "GL for the "
           "effect in frames without it.</p>\n" +
           html_table(
               "<tr><th>effect</th><th class='n'>asked</th><th class='n'>run</th><th class='n'>replaced</th><th class='n'>left "
               "out</th><th class='n'>ms saved</th><th class='n'>difference</th><th class='n'>work</th><th>why</th></tr>",
               rows);
}

std::string uncalled_text(const UncalledEffects& measured) {
    std::string text = "\n\nwhat the scene did not call for, of " + std::to_string(measured.frames) + " pictures";
    for (const EffectUse& use : measured.uses) {
        if (without(use) == 0) continue;
        text += "\n  " + use.name + ": " + std::to_string(without(use)) + " without it, " + saved_text(use) + " ms saved" +
                (use.skipped > 0 ? ", " + difference_text(use) : "") + "; " + reasons_of(use);
    }
    return text;
}

}  // namespace tedavis::host_sim
