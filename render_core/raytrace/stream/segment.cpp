#include "render_core/raytrace/stream/segment.hpp"

namespace tedavis::raytrace {
namespace {

/// With so many calls the rest of the last lanes weighs little, and gathering costs more.
constexpr std::uint32_t kKernelsInPlace = 4;

bool runs_in_place(std::uint32_t calls, std::uint32_t lanes) { return calls >= kKernelsInPlace * lanes || calls % lanes == 0; }

void run_batch(const Task& task, const Batch& batch, base::Span<const std::uint32_t> borders, WrittenRun* runs, TokenWriter& out,
               RewriteCounts& counts) {
    out.begin(borders, runs, task.most_outputs);
    task.run(task.context, batch, out);
    out.finish();
    counts.calls += batch.count;
    ++counts.batches;
    counts.lanes += (batch.count + task.lanes - 1) / task.lanes * task.lanes;
}

}  // namespace

std::uint64_t Segment::bytes_needed() {
    constexpr std::uint64_t kItem = sizeof(Item) + 2 * sizeof(std::uint16_t) + sizeof(std::uint32_t) + sizeof(WrittenRun);
    return kMostItems * kItem + 2 * kMostArguments * sizeof(std::uint32_t) +
           kMostOutputs * (sizeof(std::uint32_t) + sizeof(std::uint16_t)) + 9 * alignof(std::max_align_t);
}

bool Segment::start(base::Arena& arena) {
    items_ = arena.allocate_array<Item>(kMostItems);
    order_ = arena.allocate_array<std::uint16_t>(kMostItems);
    gathered_ = arena.allocate_array<std::uint16_t>(kMostItems);
    borders_ = arena.allocate_array<std::uint32_t>(kMostItems);
    runs_ = arena.allocate_array<WrittenRun>(kMostItems);
    copies_ = arena.allocate_array<std::uint32_t>(kMostArguments);
    records_ = arena.allocate_array<std::uint32_t>(kMostArguments);
    output_ = arena.allocate_array<std::uint32_t>(kMostOutputs);
    call_places_ = arena.allocate_array<std::uint16_t>(kMostOutputs);
    return !items_.empty() && !order_.empty() && !gathered_.empty() && !borders_.empty() && !runs_.empty() && !copies_.empty() &&
           !records_.empty() && !output_.empty() && !call_places_.empty();
}

void Segment::add(std::uint32_t call, const CallShape& shape, std::uint32_t kept, std::uint32_t skipped, BlockCursor from) {
    Item& item = items_[count_++];
    item = {call, kept, skipped, from.together() == 0 ? nullptr : from.words(), {}};
    if (shape.arguments > from.together()) {
        std::uint32_t* copy = copies_.data() + copied_;
        from.read(copy, shape.arguments);
        item.arguments = copy;
        copied_ += shape.arguments;
    }
    words_ += shape.arguments;
    outputs_ += shape.most_outputs;
}

void Segment::sort_by_task(std::uint32_t (&ends)[kMostTasks]) {
    for (std::uint32_t n = 0; n < count_; ++n) ++ends[called_task(items_[n].call)];
    std::uint32_t before = 0;
    for (std::uint32_t& end : ends) {
        const std::uint32_t of_task = end;
        end = before;
        before += of_task;
    }
    for (std::uint32_t n = 0; n < count_; ++n) order_[ends[called_task(items_[n].call)]++] = static_cast<std::uint16_t>(n);
}

void Segment::run(const TaskNetwork& network, BlockGroup& group) {
    TokenWriter out(network, output_, call_places_);
    std::uint32_t ends[kMostTasks] = {};
    sort_by_task(ends);
    for (std::uint32_t task = 0, first = 0; task < network.size(); first = ends[task++]) {
        if (ends[task] == first) continue;
        run_task(network, {order_.data() + first, ends[task] - first}, out, group.counts);
        if (out.fault() == WriterFault::none || group.fault != WriterFault::none) continue;
        group.fault = out.fault();
        group.fault_task = static_cast<TaskId>(task);
    }
}

void Segment::run_task(const TaskNetwork& network, base::Span<const std::uint16_t> of_task, TokenWriter& out,
                       RewriteCounts& counts) {
    const TaskId id = called_task(items_[of_task[0]].call);
    const Task& task = network.task(id);
    std::size_t gathered = 0;
    for (const std::uint16_t n : of_task) {
        Item& item = items_[n];
        const std::uint32_t calls = call_count(item.call);
        if (of_task.size() > 1 && !runs_in_place(calls, task.lanes)) {
            gathered_[gathered++] = n;
            continue;
        }
        run_batch(task, {item.arguments, calls, task.arguments, id, task.next}, {&calls, 1}, &item.given, out, counts);
    }
    if (gathered > 0) run_gathered(task, id, {gathered_.data(), gathered}, out, counts);
}

void Segment::run_gathered(const Task& task, TaskId id, base::Span<const std::uint16_t> gathered, TokenWriter& out,
                           RewriteCounts& counts) {
    std::uint32_t calls = 0;
    std::uint32_t* record = records_.data();
    for (std::size_t n = 0; n < gathered.size(); ++n) {
        const Item& item = items_[gathered[n]];
        const std::uint32_t words = call_count(item.call) * task.arguments;
        for (std::uint32_t w = 0; w < words; ++w) record[w] = item.arguments[w];
        record += words;
        borders_[n] = calls += call_count(item.call);
    }
    run_batch(task, {records_.data(), calls, task.arguments, id, task.next}, {borders_.data(), gathered.size()}, runs_.data(),
              out, counts);
    for (std::size_t n = 0; n < gathered.size(); ++n) items_[gathered[n]].given = runs_[n];
}

void Segment::write(BlockCursor& from, BlockWriter& to) {
    for (std::uint32_t n = 0; n < count_; ++n) {
        const Item& item = items_[n];
        if (item.kept > 0) to.copy(from, item.kept);
        from.skip(item.skipped);
        const WrittenRun& given = item.given;
        to.write(output_.data() + given.first_word, given.words, call_places_.data() + given.first_call, given.calls,
                 given.first_word);
    }
    count_ = words_ = outputs_ = copied_ = 0;
}

}  // namespace tedavis::raytrace
