#include "host_sim/commands/contract.hpp"

#include <cctype>
#include <cstdio>
#include <optional>

#include "host_sim/atomic_file.hpp"
#include "host_sim/contract/contract_meter.hpp"
#include "host_sim/contract/contract_report.hpp"
#include "host_sim/evaluation/evaluate_flight.hpp"
#include "host_sim/evaluation/evaluation_workers.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/new_folder.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

constexpr char kContractName[] = "contract.json";
using FrameReadings = std::vector<std::vector<ContractReading>>;

FrameReadings measured_readings(const Contract& contract, const FlightRun& run, const EvaluationWork& work) {
    const ContractMeter contract_meter(contract, run);
    FrameReadings readings;
    (void)for_each_picture(
        work, run.folder, run.frames.size(),
        [&](PictureMeter& meter, std::size_t n) { return contract_meter.readings(meter, run.frames[n]); },
        [&](std::size_t, std::vector<ContractReading>&& one) { readings.push_back(std::move(one)); });
    if (readings.empty()) throw Interrupted("interrupted; nothing was judged");
    return readings;
}

/// "2-clutter-in-cruise": begins the names of a condition's files.
std::string file_stem(std::size_t number, const std::string& name) {
    std::string stem = std::to_string(number) + "-";
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            stem += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (stem.back() != '-')
            stem += '-';
    while (stem.back() == '-') stem.pop_back();
    return stem;
}

std::string moment_title(const JudgedCondition& one) {
    char time[32];
    std::snprintf(time, sizeof time, "%.1f s", one.verdict.worst.time_s);
    return one.condition.name + ", worst at " + time + (one.worst.region.empty() ? "" : ": " + one.worst.region);
}

/// Of every broken condition, the worst moment.
void draw_worst(const JudgedContract& judged, const FlightRun& run, const std::string& folder, const EvaluationWork& work,
                nlohmann::ordered_json& json) {
    EvaluatedFlight flight;
    flight.run = run;
    std::vector<MomentToDraw> moments;
    PlanLines plan;
    MomentViews views;
    std::vector<ClutterOpinions> opinions(judged.conditions.size());
    std::size_t failure = 0;
    for (std::size_t n = 0; n < judged.conditions.size(); ++n) {
        const JudgedCondition& one = judged.conditions[n];
        if (one.is_kept()) continue;
        nlohmann::ordered_json& told = json["failures"][failure++];
        told["sheet"] = nullptr;
        if (one.state != ConditionState::broken) continue;
        const std::string stem = file_stem(n + 1, one.condition.name);
        told["sheet"] = stem + ".sheet.png";
        moments.push_back({&flight, one.verdict.worst.place, stem, moment_title(one), &plan, &views, &opinions[n]});
    }
    draw_moments(moments, folder, work);
}

int exit_code_of(const JudgedContract& judged) {
    if (judged.interrupted) return kInterruptedExitCode;
    return judged.holds() ? 0 : kCheckFailedExitCode;
}

}  // namespace

int run_contract(const ContractOptions& options, Console& console) {
    const Contract contract = read_contract(resolve_config(options.contract, "contracts"));
    const FlightRun run = read_flight_run(options.run);
    if (!options.output.empty()) require_no_run(options.output);
    const auto workers = evaluation_workers(options.threads);
    const InterruptGuard interrupt;
    EvaluationWork work{*workers, console, [&] { return interrupt.requested(); }, settings_of(contract)};
    std::optional<NewFolder> folder;
    if (!options.output.empty()) folder.emplace(options.output);
    const JudgedContract judged = judge_contract(contract, run, measured_readings(contract, run, work));
    nlohmann::ordered_json json = contract_json(judged);
    if (folder) {
        draw_worst(judged, run, options.output, work, json);
        write_file_atomically(options.output + "/" + kContractName, json_text(json) + "\n");
        folder->keep();
    }
    console.result(contract_text(judged), json_text(json));
    return exit_code_of(judged);
}

}  // namespace tedavis::host_sim
