#include "host_sim/commands/evaluate.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "host_sim/atomic_file.hpp"
#include "host_sim/evaluation/evaluate_flight.hpp"
#include "host_sim/evaluation/evaluation_json.hpp"
#include "host_sim/evaluation/evaluation_workers.hpp"
#include "host_sim/evaluation/html_parts.hpp"
#include "host_sim/evaluation/moment_card.hpp"
#include "host_sim/evaluation/picture_orderings.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/new_folder.hpp"
#include "host_sim/reports/drawn_sheet.hpp"
#include "host_sim/reports/line_chart.hpp"
#include "host_sim/reports/run_findings.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr char kEvaluationName[] = "evaluation.json";
constexpr std::size_t kPhasesInText = 24;

std::string padded(std::string text, std::size_t width) {
    if (text.size() < width) text.append(width - text.size(), ' ');
    return text;
}

std::string gaze_text(const std::vector<const PictureMeasures*>& pictures) {
    const auto summary = gaze_summary_json(pictures);
    if (summary.is_null()) return {};
    const auto count = summary["pictures"].get<std::size_t>();
    return "\n  recorded gaze on " + std::to_string(count) + (count == 1 ? " picture: AUC " : " pictures: AUC ") +
           decimal(summary["auc"].get<double>(), 3) +
           (summary["nss"].is_null() ? std::string() : ", NSS " + decimal(summary["nss"].get<double>(), 2));
}

std::string pictures_text(const std::string& output, const std::vector<EvaluatedPicture>& pictures,
                          const perception::RegionGrid& grid) {
    std::size_t width = 8;
    for (const EvaluatedPicture& one : pictures) width = std::max(width, one.file.size());
    std::string text = output + ": " + std::to_string(pictures.size()) + (pictures.size() == 1 ? " picture" : " pictures");
    text += "\n  " + padded("picture", width) + "  clutter  congestion  entropy  busiest region";
    std::vector<const PictureMeasures*> measures;
    for (const EvaluatedPicture& one : pictures) {
        const std::size_t busiest = busiest_region(one.measures.clutter_grid);
        const int column = static_cast<int>(busiest) % grid.columns, row = static_cast<int>(busiest) / grid.columns;
        text += "\n  " + padded(one.file, width) + "  " + padded(clutter_text(one.measures.clutter), 7) + "  " +
                padded(one.measures.opinions ? decimal(one.measures.opinions->feature_congestion, 2) : "", 10) + "  " +
                padded(one.measures.opinions ? decimal(one.measures.opinions->subband_entropy, 2) : "", 7) + "  " +
                clutter_text(one.measures.clutter_grid[busiest]) + " " + region_name(grid, column, row);
        measures.push_back(&one.measures);
    }
    const std::string agreement = agreement_words(agreement_over_pictures(pictures), "pictures");
    return text + (agreement.empty() ? agreement : "\n  " + agreement) + gaze_text(measures);
}

std::string phases_text(const EvaluatedFlight& flight) {
    std::string text = "\n  phase                    from s     to s    mean  highest";
    const std::vector<SpanSummary> spans = summaries_by_phase(flight);
    for (std::size_t n = 0; n < spans.size() && n < kPhasesInText; ++n) {
        const SpanSummary& span = spans[n];
        char line[120];
        std::snprintf(line, sizeof line, "\n  %-22s %8.1f %8.1f   %.3f    %.3f", span.phase.c_str(),
                      flight.run.frames[span.first].time_s, flight.run.frames[span.end - 1].time_s, span.mean, span.highest);
        text += line;
    }
    if (spans.size() > kPhasesInText)
        text += "\n  and " + std::to_string(spans.size() - kPhasesInText) + " more phases in report.html";
    return text;
}

std::string flight_text(const EvaluatedFlight& flight) {
    const SpanSummary all = summary_of(flight, 0, flight.run.frames.size());
    std::string text = flight.run.folder + ": " + std::to_string(flight.run.frames.size()) + " frames" +
                       (flight.interrupted ? " (interrupted)" : "") + ", mean clutter " + clutter_text(all.mean) + ", highest " +
                       clutter_text(all.highest) + " at " + seconds_text(flight.run.frames[all.highest_at].time_s) + " (" +
                       flight.run.frames[all.highest_at].phase + ")";
    for (const FlightMoment& moment : flight.moments)
        text += "\n  " + moment_words(flight, moment) + "; " + opinions_words(moment.opinions);
    const std::string agreement = agreement_words(agreement_over_moments(flight), "peaks");
    if (!agreement.empty()) text += "\n  " + agreement;
    std::vector<const PictureMeasures*> measures;
    for (const PictureMeasures& one : flight.measures) measures.push_back(&one);
    return text + phases_text(flight) + gaze_text(measures);
}

/// Pictures of a moment, and those of the other flight at the same time.
void add_moment(FlightReport& report, std::size_t n, FlightMoment& moment, std::vector<MomentToDraw>& to_draw) {
    const EvaluatedFlight& own = report.flights[n];
    const std::string title = moment_words(own, moment);
    moment.file = moment.label;
    to_draw.push_back({&own, moment.index, moment.file, title, &moment.plan, &moment.views, &moment.opinions});
    if (!report.comparison) return;
    const EvaluatedFlight& other = report.flights[1 - n];
    moment.other = frame_nearest(other, own.run.frames[moment.index].time_s);
    to_draw.push_back({&other, moment.other, moment.file + ".other", title + ": the other design", &moment.other_plan,
                       &moment.other_views, &moment.other_opinions});
}

FlightReport evaluated_flights(const EvaluateOptions& options, const FixationFile* gaze, const EvaluationWork& work) {
    std::vector<FlightRun> runs;
    for (const std::string& folder : options.inputs) runs.push_back(read_flight_run(folder));
    FlightReport report;
    report.settings = work.settings;
    for (FlightRun& run : runs) {
        try {
            report.flights.push_back(measure_flight(std::move(run), gaze, work));
        } catch (const Interrupted&) {
            if (report.flights.empty()) throw;
            report.flights.front().interrupted = true;  // it is whole, but what it was to be compared with is missing
        }
    }
    if (report.flights.size() == 2) report.comparison = compared(report.flights[0], report.flights[1]);
    std::vector<MomentToDraw> to_draw;
    for (std::size_t n = 0; n < report.flights.size(); ++n) {
        EvaluatedFlight& flight = report.flights[n];
        flight.moments = moments_of(flight, !report.comparison ? "" : n == 0 ? "A" : "B");
        for (FlightMoment& moment : flight.moments) add_moment(report, n, moment, to_draw);
    }
    draw_moments(to_draw, options.output, work);
    return report;
}

/// What is drawn over a picture counts as clutter and draws the eye.
void warn_of_overlay(const FlightRun& run, Console& console) {
    const auto drawn_over = [](const FlightFrame& frame) { return frame.has_accuracy_overlay; };
    const auto count = static_cast<std::uint64_t>(std::count_if(run.frames.begin(), run.frames.end(), drawn_over));
    if (count == 0) return;
    console.note("warning: " + run.folder + ": " + part_of(count, run.frames.size()) +
                 " pictures have the accuracy drawn over them, which is measured too; replay the run without --show-accuracy and"
                 " --error-map");
}

int evaluate_runs(const EvaluateOptions& options, const FixationFile* gaze, const EvaluationWork& work) {
    if (options.inputs.size() > 2)
        throw UserError(options.inputs[2] + ": a third run; name one, or two over the same flight that are to be compared");
    const FlightReport report = evaluated_flights(options, gaze, work);
    const nlohmann::ordered_json json = flights_json(report);
    write_file_atomically(options.output + "/" + kEvaluationName, json_text(json) + "\n");
    write_file_atomically(options.output + "/" + kReportName, flight_report_page(report));
    std::string text;
    bool is_interrupted = false;
    for (const EvaluatedFlight& flight : report.flights) {
        warn_of_overlay(flight.run, work.console);
        text += flight_text(flight) + "\n";
        is_interrupted = is_interrupted || flight.interrupted;
    }
    work.console.result(text + options.output + "/" + kReportName, json_text(json));
    return is_interrupted ? kInterruptedExitCode : 0;
}

std::optional<PictureOrderings> asked_orderings(const EvaluateOptions& options) {
    if (options.orderings.empty()) return std::nullopt;
    return read_orderings(resolve_config(options.orderings, "orderings"));
}

std::vector<OrderedPicture> ordered_pictures(const std::vector<EvaluatedPicture>& pictures) {
    std::vector<OrderedPicture> all;
    for (const EvaluatedPicture& picture : pictures) {
        OrderedPicture one{std::filesystem::weakly_canonical(picture.file).string(), picture.measures.clutter, {}};
        for (const LayerShare& layer : picture.measures.layers) one.shares.emplace_back(layer.layer, layer.share);
        all.push_back(std::move(one));
    }
    return all;
}

int evaluate_images(const EvaluateOptions& options, const std::optional<PictureOrderings>& orderings, const FixationFile* gaze,
                    const EvaluationWork& work) {
    const std::vector<std::string> files = pictures_of_sheets(options.inputs);
    if (files.empty()) throw UserError(options.inputs[0] + ": which layer each pixel of a picture is of; name the picture");
    const std::vector<EvaluatedPicture> pictures = evaluate_pictures(files, options.output, gaze, work);
    const bool is_interrupted = pictures.size() < files.size();
    if (pictures.empty()) throw Interrupted("interrupted; nothing was written");
    nlohmann::ordered_json json = pictures_json(pictures, work.settings, is_interrupted);
    std::string text = pictures_text(options.output, pictures, work.settings.grid);
    if (orderings) {
        const std::vector<JudgedOrdering> all = judged(*orderings, ordered_pictures(pictures));
        json["orderings"] = orderings_json(all);
        text += "\n" + orderings_text(all);
    }
    write_file_atomically(options.output + "/" + kEvaluationName, json_text(json) + "\n");
    work.console.result(text, json_text(json));
    return is_interrupted ? kInterruptedExitCode : 0;
}

}  // namespace

int run_evaluate(const EvaluateOptions& options, Console& console) {
    const auto is_run = [](const std::string& input) {
        return is_folder(input) && !std::filesystem::is_regular_file(input + "/" + kSheetJsonName);
    };
    const bool has_run = std::any_of(options.inputs.begin(), options.inputs.end(), is_run);
    if (has_run && !std::all_of(options.inputs.begin(), options.inputs.end(), is_run))
        throw UserError("pictures and runs together; evaluate them one after the other");
    if (has_run && !options.orderings.empty())
        throw UserError("--orderings: compares pictures, and these are runs; name pictures, or leave it out");
    require_no_run(options.output);
    const std::optional<PictureOrderings> orderings = asked_orderings(options);
    std::optional<FixationFile> gaze;
    if (!options.fixations.empty()) gaze = read_fixations(options.fixations);
    const auto workers = evaluation_workers(options.threads);
    const InterruptGuard interrupt;
    NewFolder folder(options.output);
    EvaluationWork work{*workers, console, [&] { return interrupt.requested(); }, {}};
    if (orderings && orderings->canny) work.settings.canny = *orderings->canny;
    if (options.canny) work.settings.canny = *options.canny;
    const int code = has_run ? evaluate_runs(options, gaze ? &*gaze : nullptr, work)
                             : evaluate_images(options, orderings, gaze ? &*gaze : nullptr, work);
    folder.keep();
    return code;
}

}  // namespace tedavis::host_sim
