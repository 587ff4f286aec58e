#include "render_core/raytrace/stream/execute_group.hpp"

#include "render_core/raytrace/stream/call_scan.hpp"

namespace tedavis::raytrace {
namespace {

/// Which calls of a group are executed, asked in order.
class GroupAdmission {
public:
    GroupAdmission(const BlockGroup& group, const RoundRoom& room)
        : group_(group), room_(room), growth_(group.growth_before), leads_(group.leads) {}

    [[nodiscard]] bool admits(const FoundCall& found, const CallShape& shape) {
        if (found.is_first) return group_.first_runs;
        if (!shape.is_known || found.before < shape.arguments) return false;
        if (shape.growth == 0) return true;
        const bool admitted = room_.admits(growth_, shape.growth, leads_);
        growth_ += shape.growth;
        leads_ = false;
        return admitted;
    }

private:
    const BlockGroup& group_;
    const RoundRoom& room_;
    std::uint64_t growth_;
    bool leads_;
};

}  // namespace

void execute_group(base::Span<const BlockGroup> groups, BlockGroup& group, const TaskNetwork& network, const RoundRoom& room,
                   BlockPool& pool, Segment& segment) {
    BlockWriter writer(pool, group.given);
    BlockCursor reading(pool, group.first_block), writing = reading;
    GroupAdmission admission(group, room);
    CallScan scan(pool, group);
    FoundCall found;
    std::uint32_t behind = 0;  // words of the group that have been dealt with
    while (scan.next(found)) {
        const CallShape shape = network.shape(found.call);
        if (!admission.admits(found, shape)) continue;
        if (!segment.fits(shape)) {
            segment.run(network, group);
            segment.write(writing, writer);
        }
        const std::uint32_t borrowed = found.is_first ? group.borrowed : 0;
        const std::uint32_t own = shape.arguments - borrowed, kept = found.place - behind - own;
        reading.skip(kept);
        BlockCursor arguments = reading;
        if (borrowed > 0) {
            arguments = BlockCursor(pool, groups[group.lender].first_block);
            arguments.skip(group.lender_offset);
        }
        segment.add(found.call, shape, kept, own + 1, arguments);
        reading.skip(own + 1);
        behind = found.place + 1;
    }
    segment.run(network, group);
    segment.write(writing, writer);
    writer.copy(writing, group.words - behind - group.lent);
    writer.finish();
    group.new_words = writer.words();
    group.new_blocks = writer.blocks();
    if (group.new_blocks == 0) return;
    group.new_first = group.given.ids[0];
    group.new_last = group.given.ids[group.new_blocks - 1];
}

}  // namespace tedavis::raytrace
