#include "render_core/raytrace/stream/range_task.hpp"

#include <algorithm>

#include "render_core/raytrace/stream/token_writer.hpp"

namespace tedavis::raytrace {
namespace {

void expand_range(void* context, const Batch& batch, TokenWriter& out) {
    const RangeSteps& steps = *static_cast<const RangeSteps*>(context);
    for (std::uint32_t n = 0; n < batch.count; ++n) {
        std::uint32_t first = batch.record(n)[0];
        const std::uint32_t end = batch.record(n)[1];
        for (std::uint32_t piece = 0; piece < steps.pieces && first < end; ++piece) {
            const std::uint32_t to = first + std::min(steps.grain, end - first);
            out.literal(first);
            out.literal(to);
            out.call(batch.next);
            first = to;
        }
        if (first < end) {
            out.literal(first);
            out.literal(end);
            out.call(batch.self);
        }
        out.done();
    }
}

}  // namespace

Task make_range_task(base::FixedString<31> name, RangeSteps& steps, TaskId next) {
    TEDAVIS_CHECK(steps.grain > 0 && steps.pieces > 0 && steps.pieces <= 4096);
    Task task;
    task.name = name;
    task.arguments = kRangeArguments;
    task.most_outputs = (steps.pieces + 1) * (kRangeArguments + 1);
    task.run = expand_range;
    task.context = &steps;
    task.next = next;
    task.lanes = 1;
    return task;
}

}  // namespace tedavis::raytrace
