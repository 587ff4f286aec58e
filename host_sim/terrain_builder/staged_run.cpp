#include "host_sim/terrain_builder/staged_run.hpp"

#include <utility>

#include "host_sim/terrain_builder/ordered_tasks.hpp"

namespace tedavis::host_sim {
namespace {

constexpr double kProgressUnits = 1e6;

}  // namespace

StagedRun::StagedRun(BuildJournal& journal, BuildRecord& record, base::Workers& workers, BuildProgress progress,
                     std::function<void()> sync, std::chrono::milliseconds interval)
    : journal_(journal),
      record_(record),
      workers_(workers),
      progress_(std::move(progress)),
      sync_(std::move(sync)),
      interval_(interval),
      last_checkpoint_(std::chrono::steady_clock::now()) {}

void StagedRun::run(const std::vector<BuildStage>& stages) {
    try {
        for (std::uint32_t stage = record_.stage; stage < stages.size(); ++stage) run_stage(stages, stage);
    } catch (...) {
        checkpoint();
        throw;
    }
    checkpoint();
}

void StagedRun::run_stage(const std::vector<BuildStage>& stages, std::uint32_t stage) {
    const BuildStage& now = stages[stage];
    double before = 0, total = 0;
    for (std::uint32_t n = 0; n < stages.size(); ++n) {
        if (n < stage) before += stages[n].cost;
        total += stages[n].cost;
    }
    const std::uint32_t count = now.count();
    run_in_order(
        workers_, record_.next, count, [&now](std::uint32_t index) { return now.task(index); },
        [&](std::uint32_t index, const std::function<void()>& finish) {
            const BuildRecord last = record_;
            try {
                finish();
            } catch (...) {
                record_ = last;  // half of what the task leaves is nothing: it is done again
                throw;
            }
            record_.next = index + 1;
            if (std::chrono::steady_clock::now() - last_checkpoint_ >= interval_) checkpoint();
            const double done = before + now.cost * record_.next / count;
            if (progress_)
                progress_(now.name, static_cast<std::uint64_t>(kProgressUnits * done / total),
                          static_cast<std::uint64_t>(kProgressUnits));
        });
    record_.stage = stage + 1;
    record_.next = 0;
}

void StagedRun::checkpoint() {
    sync_();
    journal_.append(record_);
    last_checkpoint_ = std::chrono::steady_clock::now();
}

}  // namespace tedavis::host_sim
