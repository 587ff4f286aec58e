/// The stages of a terrain build in their order, as StagedRun does them.
#pragma once

#include <vector>

#include "host_sim/terrain_builder/build_parts.hpp"
#include "host_sim/terrain_builder/staged_run.hpp"

namespace tedavis::host_sim {

/// `parts` must live as long. Stages depend on nothing but the parts' plan, so that a build that goes on has the same ones.
[[nodiscard]] std::vector<BuildStage> build_stages(BuildParts& parts);

/// A stage whose tasks leave nothing to be done in order. `cost` in microseconds of a processor, of all tasks.
template <class Task>
BuildStage plain_stage(std::string_view name, double cost, std::uint32_t count, Task task) {
    return {name, cost, [count] { return count; },
            [task](std::uint32_t index) {
                task(index);
                return std::function<void()>([] {});
            }};
}

}  // namespace tedavis::host_sim
