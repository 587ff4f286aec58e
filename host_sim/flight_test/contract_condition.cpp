#include "host_sim/flight_test/contract_condition.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>

#include "host_sim/contract/contract_meter.hpp"
#include "host_sim/contract/contract_report.hpp"
#include "host_sim/flight_test/read_conditions.hpp"
#include "host_sim/shipped_files.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

/// The designs and the palette that `tedavis contract` reads from the summary of a run.
FlightRun run_of_picture(const PictureOptions& picture) {
    FlightRun run;
    run.folder = "flight test";
    run.design = picture.design;
    run.palette = picture.palette;
    return run;
}

/// A contract, and what measures pictures for it. It reads designs and palette when it first measures.
class TestedContract {
public:
    TestedContract(Contract contract, const PictureOptions& picture)
        : contract_(std::move(contract)), run_(run_of_picture(picture)), meter_(settings_of(contract_)) {}
    TestedContract(const TestedContract&) = delete;
    TestedContract& operator=(const TestedContract&) = delete;

    [[nodiscard]] const std::vector<ContractCondition>& conditions() const { return contract_.conditions; }

    [[nodiscard]] std::vector<ContractReading> readings(ShownPicture& picture) {
        if (!contract_meter_) contract_meter_.emplace(contract_, run_);
        const FlightFrame& frame = picture.frame();
        const bool has_layers = std::any_of(conditions().begin(), conditions().end(), [&](const ContractCondition& condition) {
            return applies_in(condition, frame.phase) && needs_layers(condition);
        });
        return contract_meter_->readings(meter_, frame, picture.pixels(), has_layers ? &picture.layers() : nullptr);
    }

private:
    Contract contract_;
    FlightRun run_;
    std::optional<ContractMeter> contract_meter_;
    PictureMeter meter_;
};

/// What is known of a condition over the frames of a window.
struct ConditionOverFrames {
    explicit ConditionOverFrames(const perception::ConditionLimit& limit) : watch(limit) {}

    perception::ConditionWatch watch;
    std::vector<ContractReading> readings;  ///< of its frames
};

std::string words_of_moment(const ContractCondition& condition, const ContractReading& reading) {
    const std::string name = '"' + condition.name + '"';
    if (reading.state == ReadingState::missing) return name + " was not measured: " + reading.words;
    if (reading.state == ReadingState::absent) return name + " has nothing to measure";
    return name + " has " + reading_text(condition, reading) + ", and " + bound_text(condition);
}

class ContractObserver {
public:
    ContractObserver(std::shared_ptr<TestedContract> contract, WindowKind kind) : contract_(std::move(contract)) {
        for (const ContractCondition& condition : contract_->conditions()) {
            perception::ConditionLimit limit = condition.limit;
            if (kind != WindowKind::during) limit.for_s = 0;
            states_.emplace_back(limit);
        }
        keeps_frames_ = kind == WindowKind::during;
    }

    Observation observe(const ObservedFrame& frame) {
        if (frame.picture == nullptr) return {false, "no picture", "the frame has none"};
        const std::vector<ContractReading> readings = contract_->readings(*frame.picture);
        Observation observation;
        bool has_measured = false;
        for (std::size_t n = 0; n < readings.size(); ++n) {
            has_measured = has_measured || readings[n].state == ReadingState::measured;
            const std::string broken = observe_condition(n, readings[n], frame);
            if (!broken.empty()) observation.found += (observation.found.empty() ? "" : "; ") + broken;
        }
        if (observation.found.empty() && !has_measured) observation.found = "no condition of the contract applies";
        observation.holds = observation.found.empty();
        observation.reason = words_of_phase(frame.record.phase) + ", design " + std::string(frame.record.design.view());
        return observation;
    }

private:
    /// What is broken with this frame, in words; empty where nothing is.
    std::string observe_condition(std::size_t n, const ContractReading& reading, const ObservedFrame& frame) {
        const ContractCondition& condition = contract_->conditions()[n];
        ConditionOverFrames& state = states_[n];
        if (!keeps_frames_) state = ConditionOverFrames({condition.limit.is_most, condition.limit.limit, 0});
        const bool counts = applies_in(condition, frame.picture->frame().phase) &&
                            !(reading.state == ReadingState::absent && condition.is_optional);
        if (!counts) {
            state.watch.skip(frame.time_s);
        } else {
            const double value =
                reading.state == ReadingState::measured ? reading.value : std::numeric_limits<double>::quiet_NaN();
            state.watch.add({frame.time_s, value, static_cast<std::uint32_t>(state.readings.size())});
            state.readings.push_back(reading);
        }
        perception::ConditionWatch until_now = state.watch;
        until_now.end(frame.time_s);
        const perception::ConditionVerdict& verdict = until_now.verdict();
        if (!verdict.is_broken) return {};
        std::string words = words_of_moment(condition, state.readings[verdict.worst.place]);
        if (!keeps_frames_ || condition.limit.for_s <= 0) return words;
        char times[96];
        std::snprintf(times, sizeof times, " at %.2f s, beyond it for %.2f s, %g s are allowed", verdict.worst.time_s,
                      verdict.broken_s, condition.limit.for_s);
        return words + times;
    }

    std::shared_ptr<TestedContract> contract_;
    std::vector<ConditionOverFrames> states_;
    bool keeps_frames_ = false;
};

FrameObserver observer_of(const std::shared_ptr<TestedContract>& contract, WindowKind kind) {
    return [observer = std::make_shared<ContractObserver>(contract, kind)](const ObservedFrame& frame) {
        return observer->observe(frame);
    };
}

bool may_apply_in(const ContractCondition& condition, const std::string& phase) {
    const auto is_inside = [&](const std::string& named) { return named.compare(0, phase.size() + 1, phase + ".") == 0; };
    return applies_in(condition, phase) || std::any_of(condition.phases.begin(), condition.phases.end(), is_inside);
}

/// Traffic and the own trail are drawn as data without a scene, and contrast is measured of them; saliency is not.
bool needs_scene(const ContractCondition& condition) {
    const bool is_saliency =
        condition.measure == ContractMeasure::saliency_share || condition.measure == ContractMeasure::saliency_over_area;
    return condition.measure == ContractMeasure::obstacle_rank ||
           (is_saliency && (condition.layer == "data" || condition.layer == "uncertainty"));
}

/// True where the table asks for no phase, or for one in which the condition may count.
bool may_apply(const ContractCondition& condition, const std::vector<FrameCondition>& conditions) {
    return std::all_of(conditions.begin(), conditions.end(), [&](const FrameCondition& other) {
        return other.key != "phase" || may_apply_in(condition, other.expected);
    });
}

/// What cannot be judged, or never counts, in frames as the table asks for them; empty where nothing is wrong.
std::string fault_of_contract(const Contract& contract, const PictureOptions& picture,
                              const std::vector<FrameCondition>& conditions) {
    for (const ContractCondition& condition : contract.conditions)
        if (picture.scene.empty() && needs_scene(condition) && !condition.is_optional && may_apply(condition, conditions))
            return "\"" + condition.name + "\" of " + contract.path +
                   " cannot be judged in a script without a scene; say scene, or optional = true there";
    const bool has_any = std::any_of(contract.conditions.begin(), contract.conditions.end(),
                                     [&](const ContractCondition& condition) { return may_apply(condition, conditions); });
    for (const FrameCondition& other : conditions)
        if (other.key == "phase" && !has_any)
            return contract.path + " has no condition for the phase " + other.expected + "; name another contract";
    return {};
}

}  // namespace

void read_contract_condition(ScriptTable& table, const PictureOptions& picture, std::vector<FrameCondition>& conditions) {
    const auto name = table.text("contract");
    if (!name) return;
    const std::string path = stated_config(*name, "contracts", table.file());
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        return table.fault("contract", "'contract': there is no file " + path +
                                           "; name a shipped one of configs/contracts, or a path from this file's folder");
    try {
        Contract contract = read_contract(path);
        if (const std::string message = fault_of_contract(contract, picture, conditions); !message.empty())
            return table.fault("contract", "'contract': " + message);
        const auto tested = std::make_shared<TestedContract>(std::move(contract), picture);
        conditions.push_back({"contract", *name, observer_of(tested, WindowKind::at), std::nullopt,
                              [tested](WindowKind kind) { return observer_of(tested, kind); }});
    } catch (const UserError& fault) {
        table.fault("contract", std::string("'contract': ") + fault.what());
    }
}

}  // namespace tedavis::host_sim
