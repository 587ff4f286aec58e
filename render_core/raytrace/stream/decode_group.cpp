#include "render_core/raytrace/stream/decode_group.hpp"

#include "render_core/raytrace/stream/call_scan.hpp"

namespace tedavis::raytrace {

void decode_group(const BlockPool& pool, const TaskNetwork& network, BlockGroup& group) {
    CallScan scan(pool, group);
    FoundCall found;
    group.behind_last = group.words;
    while (scan.next(found)) {
        group.behind_last = group.words - found.place - 1;
        if (found.is_first) {
            group.before_first = found.before;
            group.first_call = found.call;
            continue;
        }
        const CallShape shape = network.shape(found.call);
        if (!shape.is_known || found.before < shape.arguments) continue;
        if (shape.growth == 0) group.runs_steady = true;
        if (shape.growth > 0 && group.growth == 0) group.first_growth = shape.growth;
        group.growth += shape.growth;
    }
}

}  // namespace tedavis::raytrace
