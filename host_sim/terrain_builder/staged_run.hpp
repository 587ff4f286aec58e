/// Runs the stages of a build one after the other: tasks in parallel, results in order; writes the journal and reports progress.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "host_sim/terrain_builder/build_journal.hpp"
#include "render_core/base/ports/workers.hpp"

namespace tedavis::host_sim {

/// Runs a task on any thread and returns a function that processes its result; these functions are called in the order of the
/// tasks. Both must be idempotent.
using StageTask = std::function<std::function<void()>(std::uint32_t)>;

struct BuildStage {
    std::string_view name;
    double cost = 0;                       ///< of all its tasks, in a unit that is common to all stages
    std::function<std::uint32_t()> count;  ///< number of its tasks; called when the stages before are done
    StageTask task;
};

class StagedRun {
public:
    /// `record` is the record for the journal, which the run updates; `sync` writes all work files to the disk; `interval` is the
    /// time between records. The references must outlive this object.
    StagedRun(BuildJournal& journal, BuildRecord& record, base::Workers& workers, BuildProgress progress,
              std::function<void()> sync, std::chrono::milliseconds interval);

    /// Continues from the record. An exception of a task or of the progress function ends the run after a last record.
    void run(const std::vector<BuildStage>& stages);

private:
    void run_stage(const std::vector<BuildStage>& stages, std::uint32_t stage);
    void checkpoint();

    BuildJournal& journal_;
    BuildRecord& record_;
    base::Workers& workers_;
    const BuildProgress progress_;
    const std::function<void()> sync_;
    const std::chrono::milliseconds interval_;
    std::chrono::steady_clock::time_point last_checkpoint_;
};

}  // namespace tedavis::host_sim
