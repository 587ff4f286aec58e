/// The stages of a terrain build in the order in which StagedRun runs them.
#pragma once

#include <vector>

#include "host_sim/terrain_builder/build_parts.hpp"
#include "host_sim/terrain_builder/staged_run.hpp"

namespace tedavis::host_sim {

/// `parts` must outlive the stages. Stages depend only on the plan of `parts`, so that a continued build has the same ones.
[[nodiscard]] std::vector<BuildStage> build_stages(BuildParts& parts);

/// A stage whose tasks have no result to be processed in order. `cost` is the processor time of all tasks, microseconds.
template <class Task>
BuildStage plain_stage(std::string_view name, double cost, std::uint32_t count, Task task) {
    return {name, cost, [count] { return count; },
            [task](std::uint32_t index) {
                task(index);
                return std::function<void()>([] {});
            }};
}

}  // namespace tedavis::host_sim
