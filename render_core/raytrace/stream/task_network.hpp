/// The functional model: tasks by number, each with what follows it. Calls name the number, so that a task can be inserted,
/// replaced or removed between two rewritings of a stream that calls it (thesis 6.2.2.3); what is still to be called is done the
/// new way.
///
/// Errors are one sentence; then nothing has changed. Not to be changed while a stream is being rewritten. No heap.
#pragma once

#include "render_core/base/fault_text.hpp"
#include "render_core/base/fixed_vector.hpp"
#include "render_core/base/result.hpp"
#include "render_core/raytrace/stream/task.hpp"

namespace tedavis::raytrace {

/// What a call takes and by how much it may lengthen the stream.
struct CallShape {
    bool is_known = false;  ///< such a task is there, and a token may stand for so many calls
    std::uint32_t arguments = 0;
    std::uint32_t most_outputs = 0;
    std::uint32_t growth = 0;
    std::uint32_t left_words = 0;
};

class TaskNetwork {
public:
    using Answer = base::Result<TaskId, base::FaultText>;

    [[nodiscard]] Answer add(const Task& task);
    /// Another task for the calls of `id`, with as many arguments. Without a `next` it keeps the present one.
    [[nodiscard]] Answer replace(TaskId id, const Task& task);
    /// Calls of `at` go to `task`, which takes as many arguments and has what was there as its next. Gives its new number.
    [[nodiscard]] Answer insert(TaskId at, const Task& task);
    /// Calls of `id` become calls of its next where that takes as many arguments; else they vanish with their arguments.
    [[nodiscard]] Answer remove(TaskId id);
    [[nodiscard]] Answer set_next(TaskId id, TaskId next);

    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(tasks_.size()); }
    [[nodiscard]] const Task& task(TaskId id) const { return tasks_[id]; }
    /// Calls that one token may stand for; does not change once the task is added.
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
