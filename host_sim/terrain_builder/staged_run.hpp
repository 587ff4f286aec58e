/// The stages of a build, one after the other: tasks in parallel, results in order, the journal kept, progress told.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "host_sim/terrain_builder/build_journal.hpp"
#include "render_core/base/ports/workers.hpp"

namespace tedavis::host_sim {

/// Does a task on any thread and returns what is to be done with its result, which happens in the order of the tasks. Both
/// must be such that doing them again changes nothing.
using StageTask = std::function<std::function<void()>(std::uint32_t)>;

struct BuildStage {
    std::string_view name;
    double cost = 0;                       ///< of all its tasks, in any unit that all stages share
    std::function<std::uint32_t()> count;  ///< of its tasks; asked when the stages before are done
    StageTask task;
};

class StagedRun {
public:
    /// `record` is what the journal keeps, and is kept up to date; `sync` brings all work files to the disk.
    /// `interval` is the time between records.
    StagedRun(BuildJournal& journal, BuildRecord& record, base::Workers& workers, BuildProgress progress,
              std::function<void()> sync, std::chrono::milliseconds interval);

    /// From where the record stands. What a task or the progress throws ends the run after a last record.
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
