/// The functional model: numbered tasks, each with its next task. Calls refer to the number, so a task can be inserted,
/// replaced or removed between two rounds (thesis 6.2.2.3); pending calls then use the new task.
///
/// On an error, one sentence is returned and nothing is changed. The network must not be changed during a round. No heap.
#pragma once

#include "render_core/base/fault_text.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/result.hpp"
#include "render_core/raytrace/stream/task.hpp"

namespace tedavis::raytrace {

/// The arguments of a call, and the number of words by which it may lengthen the stream.
struct CallShape {
    bool is_known = false;  ///< the task exists, and a token may stand for this many calls
    std::uint32_t arguments = 0;
    std::uint32_t most_outputs = 0;
    std::uint32_t growth = 0;
    std::uint32_t left_words = 0;
};

class TaskNetwork {
public:
    using Answer = base::Result<TaskId, base::FaultText>;

    [[nodiscard]] Answer add(const Task& task);
    /// Replaces the task for the calls of `id` by one with as many arguments. Without a `next` the current one is kept.
    [[nodiscard]] Answer replace(TaskId id, const Task& task);
    /// Inserts `task`, which has as many arguments, before task `at`: calls of `at` go to it, and its next is the previous
    /// task. Returns the new number of the previous task.
    [[nodiscard]] Answer insert(TaskId at, const Task& task);
    /// Removes a task: its calls become calls of its next task where that has as many arguments; else they are dropped with
    /// their arguments.
    [[nodiscard]] Answer remove(TaskId id);
    [[nodiscard]] Answer set_next(TaskId id, TaskId next);

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(tasks_.size()); }
    [[nodiscard]] const Task& task(TaskId id) const { return tasks_[id]; }
    /// Largest number of calls that one token may stand for; constant after the task is added.
    [[nodiscard]] std::uint32_t most_count(TaskId id) const { return tasks_[id].most_count; }
    [[nodiscard]] CallShape shape(std::uint32_t call) const {
        const TaskId id = called_task(call);
        const std::uint32_t count = call_count(call);
        if (id >= tasks_.size()) return {};
        const Task& called = tasks_.data()[id];
        if (count == 0 || count > called.most_count) return {};
        const std::uint32_t arguments = called.arguments * count, outputs = called.most_outputs * count;
        return {true, arguments, outputs, outputs > arguments + 1 ? outputs - arguments - 1 : 0, called.left_words * count};
    }

private:
    base::FixedVector<Task, kMaxTasks> tasks_;
};

}  // namespace tedavis::raytrace
