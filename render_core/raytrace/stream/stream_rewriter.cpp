#include "render_core/raytrace/stream/stream_rewriter.hpp"

#include <charconv>

#include "render_core/raytrace/stream/call_scan.hpp"
#include "render_core/raytrace/stream/decode_group.hpp"
#include "render_core/raytrace/stream/execute_group.hpp"
#include "render_core/raytrace/stream/thread_team.hpp"

namespace tedavis::raytrace {
namespace {

/// Groups are as large as gives each worker so many of them: small ones share the work well, large ones fill kernels.
constexpr std::uint32_t kGroupsOfWorker = 8;
constexpr std::uint32_t kMinGroupCalls = 8, kMaxGroupCalls = 4096;
constexpr std::uint32_t kMinFullGroupWords = 512, kMaxGroupWords = 16384;
/// Fewer words than that are decoded sooner than shared.
constexpr std::uint32_t kWordsToShare = 4096;
constexpr std::uint32_t kMaxRoundsAlone = 64;

void append_number(base::FaultText& text, std::uint64_t number) {
    char digits[20];
    const std::to_chars_result end = std::to_chars(digits, digits + sizeof digits, number);
    text.append({digits, static_cast<std::size_t>(end.ptr - digits)});
}

}  // namespace

struct StreamRewriter::Pass {
    const TaskNetwork& network;
    BlockPool& pool;
    base::Span<BlockGroup> groups;
    base::Span<Segment> segments;
    RoundRoom room;

    static void decode(void* context, std::uint32_t index, std::uint32_t) {
        const Pass& pass = *static_cast<const Pass*>(context);
        decode_group(pass.pool, pass.network, pass.groups[index]);
    }
    static void execute(void* context, std::uint32_t index, std::uint32_t lane) {
        const Pass& pass = *static_cast<const Pass*>(context);
        BlockGroup& group = pass.groups[index];
        if (group.is_rewritten) execute_group(pass.groups, group, pass.network, pass.room, pass.pool, pass.segments[lane]);
    }
};

struct StreamRewriter::Run {
    StreamRewriter& rewriter;
    const TaskNetwork& network;
    std::uint32_t most_rounds;
    std::uint32_t lanes;
    RewriteReport report;
    base::FaultText fault;
    bool is_over = false;
    std::uint32_t alone = 0, most_alone = 1;  ///< rounds since a worker was lost, and how many until it is called back

    static void lead(void* context, ThreadTeam& team) {
        Run& run = *static_cast<Run*>(context);
        do run.rewriter.run_round(run, team);
        while (!run.is_over && !run.calls_back(team));
    }
    /// Not at once, and more seldom each time: where there are fewer processors than workers they are lost again and again.
    bool calls_back(const ThreadTeam& team) {
        if (!team.has_lost() || rewriter.group_count_ < 2 || ++alone < most_alone) return false;
        alone = 0;
        most_alone = std::min(2 * most_alone, kMaxRoundsAlone);
        return true;
    }
};

std::uint64_t StreamRewriter::bytes_needed(const StreamSettings& settings) {
    return (most_groups(settings) + 1) * sizeof(BlockGroup) +
           settings.most_workers * (sizeof(Segment) + Segment::bytes_needed()) + 2 * alignof(std::max_align_t);
}

base::Result<std::uint64_t, base::FaultText> StreamRewriter::start(TokenStream& stream, base::Arena& arena) {
    const std::uint64_t before = arena.use().in_use;
    stream_ = &stream;
    groups_ = arena.allocate_array<BlockGroup>(most_groups(stream.settings()) + 1);
    segments_ = arena.allocate_array<Segment>(stream.settings().most_workers);
    bool fits = !groups_.empty() && !segments_.empty();
    for (Segment& segment : segments_) fits = fits && segment.start(arena);
    if (!fits)
        return base::fail(base::FaultText("what workers need to rewrite a token stream does not fit its memory; give more"));
    return arena.use().in_use - before;
}

void StreamRewriter::form_groups(std::uint32_t lanes) {
    const BlockPool& pool = stream_->pool();
    call_count_ = 0;
    for (std::uint32_t id = stream_->first_block(); id != kNoBlock; id = pool.block(id).next) call_count_ += pool.block(id).calls;
    const std::uint32_t share = kGroupsOfWorker * lanes, least = least_group_words(stream_->settings());
    most_group_calls_ = std::clamp(call_count_ / share, kMinGroupCalls, kMaxGroupCalls);
    const std::uint32_t most_words = std::clamp(stream_->words() / share, kMinFullGroupWords, kMaxGroupWords);
    std::uint32_t early_ends = lanes > 1 ? kEarlyEndsOfWorker * lanes : 0;
    group_count_ = 0;
    bool is_open = false;
    for (std::uint32_t id = stream_->first_block(); id != kNoBlock; id = pool.block(id).next) {
        if (!is_open) {
            groups_[group_count_] = {};
            groups_[group_count_++].first_block = id;
        }
        BlockGroup& group = groups_[group_count_ - 1];
        group.last_block = id;
        ++group.blocks;
        group.words += pool.block(id).words;
        group.calls += pool.block(id).calls;
        is_open = group.calls < most_group_calls_ && group.words < most_words;
        if (is_open || group.words >= least) continue;
        is_open = early_ends == 0;
        early_ends -= is_open ? 0 : 1;
    }
}

void StreamRewriter::link_groups() {
    BlockPool& pool = stream_->pool();
    std::uint32_t first = kNoBlock, last = kNoBlock, words = 0;
    // Blocks that were given and not used lie in the order of the groups, before what is given back behind them.
    for (const BlockGroup& group : groups())
        for (std::uint32_t n = group.is_rewritten ? group.new_blocks : 0; n < group.given.count; ++n)
            pool.give_back(group.given.ids[n]);
    for (const BlockGroup& group : groups()) {
        const std::uint32_t from = group.is_rewritten ? group.new_first : group.first_block;
        const std::uint32_t to = group.is_rewritten ? group.new_last : group.last_block;
        for (std::uint32_t n = 0, id = group.first_block; group.is_rewritten && n < group.blocks; ++n) {
            const std::uint32_t next = pool.block(id).next;
            pool.give_back(id);
            id = next;
        }
        words += group.is_rewritten ? group.new_words : group.words;
        if (from == kNoBlock) continue;
        (last == kNoBlock ? first : pool.block(last).next) = from;
        last = to;
    }
    if (last != kNoBlock) pool.block(last).next = kNoBlock;
    stream_->set_list(first, last, words);
}

void StreamRewriter::rewrite_once(Run& run, ThreadTeam& team) {
    const StreamSettings& settings = stream_->settings();
    const std::uint64_t left = settings.capacity_words - stream_->words();
    const RoundRoom room = {left > settings.reserve_words ? left - settings.reserve_words : 0, left};
    Pass pass{run.network, stream_->pool(), groups(), segments_, room};
    if (stream_->words() < kWordsToShare)
        for (std::uint32_t n = 0; n < group_count_; ++n) Pass::decode(&pass, n, 0);
    else
        team.share(group_count_, &Pass::decode, &pass);
    if (!allocate_round(groups(), run.network, room)) {
        ++run.report.waits;
        stream_->count_refusal();
    }
    give_blocks(groups(), room, {run.lanes > 1 ? kEarlyEndsOfWorker * run.lanes : 0, most_group_calls_}, stream_->pool());
    team.share(group_count_, &Pass::execute, &pass);
    link_groups();
    for (const BlockGroup& group : groups()) {
        run.report.counts.calls += group.counts.calls;
        run.report.counts.batches += group.counts.batches;
        run.report.counts.lanes += group.counts.lanes;
    }
}

void StreamRewriter::run_round(Run& run, ThreadTeam& team) {
    form_groups(run.lanes);
    run.report.is_finished = call_count_ == 0;
    run.is_over = run.report.is_finished || run.report.rounds == run.most_rounds;
    if (run.is_over) return;
    const std::uint64_t batches = run.report.counts.batches;
    rewrite_once(run, team);
    ++run.report.rounds;
    run.report.most_groups = std::max(run.report.most_groups, group_count_);
    run.fault = task_fault();
    if (run.fault.empty() && run.report.counts.batches == batches) {
        form_groups(1);
        run.fault = stuck_text(run.network);
    }
    run.is_over = !run.fault.empty();
}

StreamRewriter::Answer StreamRewriter::rewrite(const TaskNetwork& network, base::Workers& workers, std::uint32_t most_rounds) {
    TEDAVIS_CHECK(stream_ != nullptr);
    const std::uint32_t lanes = std::min(workers.concurrency(), static_cast<std::uint32_t>(segments_.size()));
    Run run{*this, network, most_rounds, lanes, {}, {}};
    while (!run.is_over) ThreadTeam::run(workers, lanes, &Run::lead, &run);
    if (!run.fault.empty()) return base::fail(run.fault);
    return run.report;
}

base::FaultText StreamRewriter::task_fault() const {
    for (const BlockGroup& group : groups()) {
        if (group.fault == WriterFault::none) continue;
        base::FaultText text("task ");
        append_number(text, group.fault_task);
        if (group.fault == WriterFault::too_much) text.append(" of a token stream gave more than its most_outputs; state more");
        if (group.fault == WriterFault::unknown_task)
            text.append(" of a token stream called a task that is not there; add that first");
        if (group.fault == WriterFault::nobody)
            text.append(" of a token stream did not say which calls gave what; it must say done()");
        return text;
    }
    return {};
}

base::FaultText StreamRewriter::stuck_text(const TaskNetwork& network) const {
    std::uint32_t literals = 0;
    for (const BlockGroup& group : groups()) {
        CallScan scan(stream_->pool(), group);
        FoundCall found;
        if (scan.next(found)) return stuck_at(network, found.call, literals + found.before);
        literals += group.words;
    }
    return {};
}

/// The first call is complete or will never be, and if it is, it has not been executed for want of room.
base::FaultText StreamRewriter::stuck_at(const TaskNetwork& network, std::uint32_t call, std::uint32_t literals) const {
    const CallShape shape = network.shape(call);
    base::FaultText text;
    if (!shape.is_known) {
        text.append("the token stream calls task ");
        append_number(text, called_task(call));
        text.append(", which is not there, or too often at once; add it, or call it less often at once");
        return text;
    }
    const bool lacks_arguments = literals < shape.arguments;
    text.append("the token stream cannot go on: '");
    text.append(network.task(called_task(call)).name.view());
    text.append(lacks_arguments ? "' lacks arguments: " : "' has no room: ");
    append_number(text, lacks_arguments ? literals : stream_->words());
    text.append(" of ");
    append_number(text, lacks_arguments ? shape.arguments : stream_->settings().capacity_words);
    text.append(lacks_arguments ? " are there; put before it what gives them" : " words are taken; give capacity_words more");
    return text;
}

}  // namespace tedavis::raytrace
