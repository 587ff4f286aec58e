#include "render_core/raytrace/stream/task_network.hpp"

#include <algorithm>
#include <initializer_list>

#include "render_core/raytrace/stream/token_writer.hpp"

namespace tedavis::raytrace {
namespace {

constexpr std::uint32_t kMaxCallsOfNothing = 4096;  ///< of a task that takes and gives nothing

base::FaultText task_fault(std::string_view name, std::string_view what) {
    base::FaultText message("task '");
    message.append(name);
    message.append("' ");
    message.append(what);
    return message;
}

std::uint32_t most_calls(const Task& task) {
    std::uint32_t most = task.most_count == 0 ? kMaxCallsOfNothing : task.most_count;
    if (task.arguments > 0) most = std::min(most, (kMaxPatternWords - 1) / task.arguments);
    if (task.most_outputs > 0) most = std::min(most, kMaxOutputWords / task.most_outputs);
    return most;
}

/// Empty where nothing is wrong.
base::FaultText fault_of(const Task& task) {
    if (task.run == nullptr) return task_fault(task.name.view(), "has no function; give it one");
    if (task.lanes == 0) return task_fault(task.name.view(), "has 0 lanes; give it 1 or more");
    if (task.arguments >= kMaxPatternWords || task.most_outputs > kMaxOutputWords)
        return task_fault(task.name.view(), "takes more than 4095 words or gives more than 16384; divide it");
    return {};
}

void pass_on(void*, const Batch& batch, TokenWriter& out) { out.each_calls(batch.next, batch.arguments, batch.count); }

void take_away(void*, const Batch&, TokenWriter&) {}

}  // namespace

TaskNetwork::Answer TaskNetwork::add(const Task& task) {
    const base::FaultText fault = fault_of(task);
    if (!fault.empty()) return base::fail(fault);
    if (tasks_.full()) return base::fail(task_fault(task.name.view(), "is one too many; a network holds 64"));
    Task added = task;
    added.most_count = most_calls(task);
    (void)tasks_.try_push_back(added);
    return static_cast<TaskId>(tasks_.size() - 1);
}

TaskNetwork::Answer TaskNetwork::replace(TaskId id, const Task& task) {
    const base::FaultText fault = fault_of(task);
    if (!fault.empty()) return base::fail(fault);
    if (id >= tasks_.size()) return base::fail(task_fault(task.name.view(), "has none to replace; add it first"));
    Task& present = tasks_[id];
    if (task.arguments != present.arguments)
        return base::fail(task_fault(task.name.view(), "takes another number of words than what it replaces; add it instead"));
    if (std::uint64_t{task.most_outputs} * present.most_count > kMaxOutputWords)
        return base::fail(
            task_fault(task.name.view(), "gives more than calls of what it replaces allow; add that with a most_count"));
    const TaskId next = task.next == kNoTask ? present.next : task.next;
    const std::uint32_t most_count = present.most_count;
    present = task;
    present.next = next;
    present.most_count = most_count;
    return id;
}

TaskNetwork::Answer TaskNetwork::insert(TaskId at, const Task& task) {
    if (at >= tasks_.size()) return base::fail(task_fault(task.name.view(), "has no place there; add it instead"));
    if (tasks_.full()) return base::fail(task_fault(task.name.view(), "is one too many; a network holds 64"));
    const Task moved = tasks_[at];
    Task inserted = task;
    inserted.next = static_cast<TaskId>(tasks_.size());
    const Answer replaced = replace(at, inserted);
    if (!replaced) return replaced;
    (void)tasks_.try_push_back(moved);
    return inserted.next;
}

TaskNetwork::Answer TaskNetwork::remove(TaskId id) {
    if (id >= tasks_.size()) return base::fail(base::FaultText("a task that is not there cannot be removed"));
    Task& task = tasks_[id];
    const bool has_next = task.next < tasks_.size() && task.next != id && tasks_[task.next].arguments == task.arguments;
    task.run = has_next ? pass_on : take_away;
    task.context = nullptr;
    task.most_outputs = has_next ? task.arguments + 1 : 0;
    return id;
}

TaskNetwork::Answer TaskNetwork::set_next(TaskId id, TaskId next) {
    if (id >= tasks_.size() || next >= tasks_.size())
        return base::fail(base::FaultText("only tasks that are there can follow each other; add both first"));
    tasks_[id].next = next;
    return id;
}

}  // namespace tedavis::raytrace
