/// The environment of measuring many pictures: threads, the stop flag, and progress.
#pragma once

#include <functional>
#include <string>

#include "host_sim/console.hpp"
#include "host_sim/evaluation/picture_meter.hpp"
#include "host_sim/terrain_builder/idle_pool.hpp"
#include "host_sim/terrain_builder/ordered_tasks.hpp"

namespace tedavis::host_sim {

struct EvaluationWork {
    base::Workers& workers;
    Console& console;
    std::function<bool()> is_stopped;  ///< called from any thread
    EvaluationSettings settings;
};

/// Calls `measure(meter, index)` on any thread, and `take(index, Result&&)` one after the other, ascending. If the work is
/// stopped, it ends early, after the last index taken; returns the number of indices taken. Exceptions of `measure` are passed
/// on.
template <class Measure, class Take>
std::size_t for_each_picture(const EvaluationWork& work, const std::string& what, std::size_t count, Measure measure, Take take) {
    using Result = std::invoke_result_t<Measure&, PictureMeter&, std::size_t>;
    IdlePool<PictureMeter> meters;
    std::size_t taken = 0;
    bool is_whole = true;
    const auto run = [&](std::uint32_t index) -> std::optional<Result> {
        if (work.is_stopped()) return std::nullopt;
        auto meter = meters.take([&] { return std::make_unique<PictureMeter>(work.settings); });
        std::optional<Result> result = measure(*meter, std::size_t{index});
        meters.give_back(std::move(meter));
        return result;
    };
    const auto commit = [&](std::uint32_t index, std::optional<Result>&& result) {
        is_whole = is_whole && result.has_value();
        if (!is_whole) return;
        take(std::size_t{index}, std::move(*result));
        ++taken;
        work.console.progress(what, taken, count);
    };
    run_in_order(work.workers, 0, static_cast<std::uint32_t>(count), run, commit);
    work.console.progress_done();
    return taken;
}

}  // namespace tedavis::host_sim
