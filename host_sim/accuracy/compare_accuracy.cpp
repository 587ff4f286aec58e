#include "host_sim/accuracy/compare_accuracy.hpp"

#include <algorithm>
#include <cstdio>

#include "host_sim/evaluation/html_parts.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

template <class Item>
const Item* item_called(const std::vector<Item>& items, const std::string& name) {
    const auto found = std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.name == name; });
    return found == items.end() ? nullptr : &*found;
}

bool grew(double earlier, double now, double share) { return now > earlier * (1 + share); }

ComparedLevel compared_level(const MeasuredKnob& knob, const MeasuredKnob& earlier_knob, const MeasuredLevel& now,
                             const MeasuredLevel& earlier, double slower_share, double error_share) {
    ComparedLevel level;
    level.knob = knob.name;
    level.level = now.name;
    level.ms = now.ms.median;
    level.earlier_ms = earlier.ms.median;
    level.error = now.error.max;
    level.earlier_error = earlier.error.max;
    level.is_slower = grew(earlier.ms.median, now.ms.median, std::max(slower_share, knob.noise + earlier_knob.noise));
    // Below the reference's own bound an error says nothing.
    const double trusted = std::max(knob.reference_bound, earlier_knob.reference_bound);
    level.is_less_accurate = (now.error.max > trusted && grew(earlier.error.max, now.error.max, error_share)) ||
                             (now.error.mean > trusted && grew(earlier.error.mean, now.error.mean, error_share));
    return level;
}

std::string compared_line(const char* format, const ComparedLevel& level, double earlier, double now) {
    char figures[120];
    std::snprintf(figures, sizeof figures, format, now, earlier);
    return "\n  " + level.knob + ", " + level.level + ": " + figures;
}

const ComparedLevel* same_level(const std::vector<ComparedLevel>& levels, const ComparedLevel& row) {
    for (const ComparedLevel& level : levels)
        if (level.knob == row.knob && level.level == row.level) return &level;
    return nullptr;
}

std::string remark_on(const ComparedLevel& level) {
    if (level.is_slower && level.is_less_accurate) return "slower, less accurate";
    return level.is_slower ? "slower" : level.is_less_accurate ? "less accurate" : "";
}

std::string three_digits(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

std::string comparison_row(const std::vector<ComparedReport>& comparisons, const ComparedLevel& row) {
    std::string cells = "<th>" + escaped_html(row.knob) + "</th>" + html_cell(row.level) + html_number(decimal(row.ms, 3)) +
                        html_number(three_digits(row.error));
    for (const ComparedReport& compared : comparisons) {
        const ComparedLevel* const level = same_level(compared.levels, row);
        cells += html_number(level == nullptr ? "-" : decimal(level->earlier_ms, 3)) +
                 html_number(level == nullptr ? "-" : three_digits(level->earlier_error)) +
                 html_cell(level == nullptr ? "not measured there" : remark_on(*level));
    }
    return "<tr>" + cells + "</tr>";
}

}  // namespace

ComparedReport compare_accuracy(const AccuracyReport& report, const AccuracyReport& earlier, const std::string& file,
                                const ComparisonLimits& limits) {
    const MeasuringConditions &now = report.conditions, &then = earlier.conditions;
    if (!have_same_inputs(now, then))
        throw UserError("--compare " + file +
                        ": was measured over other heights, another flight, displays or extent (--quick or not), so its errors "
                        "are not of the same inputs; measure over " +
                        then.terrain + " and " + then.flight + ", " + then.size + " pixels, device " + then.device + ", design " +
                        then.design + (then.is_quick ? ", with --quick" : ", without --quick"));
    ComparedReport compared;
    compared.file = file;
    compared.processor = then.processor;
    compared.date = then.date;
    compared.version = then.version;
    compared.is_same_machine = now.processor == then.processor && now.processors == then.processors;
    const double infinite = 1e300;
    for (const MeasuredKnob& knob : report.knobs) {
        const MeasuredKnob* const old_knob = item_called(earlier.knobs, knob.name);
        if (old_knob == nullptr) continue;
        compared.ranks.add(knob, *old_knob);
        for (const MeasuredLevel& level : knob.levels)
            if (const MeasuredLevel* const old_level = item_called(old_knob->levels, level.name))
                compared.levels.push_back(compared_level(knob, *old_knob, level, *old_level,
                                                         compared.is_same_machine ? limits.slower : infinite,
                                                         limits.less_accurate));
        for (const MeasuredLevel& level : old_knob->levels)
            if (item_called(knob.levels, level.name) == nullptr) compared.gone.push_back(knob.name + ": " + level.name);
    }
    return compared;
}

bool is_worse(const ComparedReport& compared) {
    return !compared.gone.empty() || std::any_of(compared.levels.begin(), compared.levels.end(), [](const ComparedLevel& level) {
        return level.is_slower || level.is_less_accurate;
    });
}

std::string comparison_text(const ComparedReport& compared) {
    std::string text = "\n\nbeside " + compared.file + " (" + compared.processor + ", " + compared.date + ")";
    if (!compared.is_same_machine) text += "\n  It is of another machine, so times are not judged.";
    text += "\n  " + rank_text(compared.ranks);
    for (const ComparedLevel& level : compared.levels) {
        if (level.is_slower) text += compared_line("takes %.3f ms, and took %.3f ms", level, level.earlier_ms, level.ms);
        if (level.is_less_accurate)
            text += compared_line("is wrong by up to %.3g, and was by %.3g", level, level.earlier_error, level.error);
    }
    for (const std::string& name : compared.gone) text += "\n  " + name + ": is no longer measured";
    return text + (is_worse(compared) ? "" : "\n  No level is worse than it was.");
}

std::string comparison_table(const std::vector<ComparedReport>& comparisons) {
    if (comparisons.empty()) return "";
    std::string head = "<tr><th>setting</th><th>level</th><th class='n'>ms</th><th class='n'>greatest error</th>", rows;
    for (const ComparedReport& compared : comparisons)
        head += "<th class='n'>ms: " + escaped_html(compared.processor + ", " + compared.date) +
                "</th><th class='n'>greatest error</th><th>" + (compared.is_same_machine ? "" : "another machine") + "</th>";
    std::vector<ComparedLevel> all;
    for (const ComparedReport& compared : comparisons)
        for (const ComparedLevel& level : compared.levels)
            if (same_level(all, level) == nullptr) all.push_back(level);
    for (const ComparedLevel& row : all) rows += comparison_row(comparisons, row);
    std::string ranks;
    for (const ComparedReport& compared : comparisons)
        ranks += "<p>Beside " + escaped_html(compared.file) + ": " + escaped_html(rank_text(compared.ranks)) + "</p>";
    return ranks + html_table(head + "</tr>", rows);
}

}  // namespace tedavis::host_sim
