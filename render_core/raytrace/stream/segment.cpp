#include "render_core/raytrace/stream/segment.hpp"

#include <utility>

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
    constexpr std::uint64_t kItem = 2 * sizeof(Item) + 2 * sizeof(std::uint16_t) + sizeof(std::uint32_t) + sizeof(WrittenRun);
    return kMaxItems * kMaxParts * kItem + (kMaxArguments + kMaxOutputs) * sizeof(std::uint32_t) +
           kMaxSteps * kMaxOutputs * (sizeof(std::uint32_t) + sizeof(std::uint16_t)) + 10 * alignof(std::max_align_t);
}

bool Segment::start(base::Arena& arena) {
    items_ = arena.allocate_array<Item>(kMaxItems * kMaxParts);
    next_items_ = arena.allocate_array<Item>(kMaxItems * kMaxParts);
    order_ = arena.allocate_array<std::uint16_t>(kMaxItems * kMaxParts);
    gathered_ = arena.allocate_array<std::uint16_t>(kMaxItems * kMaxParts);
    borders_ = arena.allocate_array<std::uint32_t>(kMaxItems * kMaxParts);
    runs_ = arena.allocate_array<WrittenRun>(kMaxItems * kMaxParts);
    copies_ = arena.allocate_array<std::uint32_t>(kMaxArguments);
    records_ = arena.allocate_array<std::uint32_t>(kMaxOutputs);
    output_ = arena.allocate_array<std::uint32_t>(kMaxSteps * kMaxOutputs);
    call_places_ = arena.allocate_array<std::uint16_t>(kMaxSteps * kMaxOutputs);
    return !items_.empty() && !next_items_.empty() && !order_.empty() && !gathered_.empty() && !borders_.empty() &&
           !runs_.empty() && !copies_.empty() && !records_.empty() && !output_.empty() && !call_places_.empty();
}

void Segment::add(std::uint32_t call, const CallShape& shape, std::uint32_t kept, std::uint32_t skipped, BlockCursor from) {
    Item& item = items_[count_++];
    item = {kept, skipped, call, kMaxParts, from.together() == 0 ? nullptr : from.words(), {}};
    if (shape.arguments > from.together()) {
        std::uint32_t* copy = copies_.data() + copied_;
        from.read(copy, shape.arguments);
        item.arguments = copy;
        copied_ += shape.arguments;
    }
    words_ += shape.arguments;
    outputs_ += shape.most_outputs + shape.left_words;
}

void Segment::run(const TaskNetwork& network, BlockGroup& group) {
    TokenWriter out(network, output_, call_places_);
    run_open_items(network, out, group);
    for (std::uint32_t step = 1; step < kMaxSteps && go_on(network); ++step) run_open_items(network, out, group);
}

/// Whether what an item gave is nothing but calls that can be executed at once. They need no more room than it took.
bool Segment::goes_on(const TaskNetwork& network, const Item& item) const {
    const WrittenRun& given = item.given;
    if (given.calls == 0 || given.calls > item.parts) return false;  // has left over, or is done
    std::uint32_t behind = given.first_word;
    for (std::uint32_t n = 0; n < given.calls; ++n) {
        const std::uint32_t place = call_places_[given.first_call + n];
        const CallShape shape = network.shape(output_[place]);
        if (!shape.is_known || shape.growth > 0 || place - behind != shape.arguments) return false;
        behind = place + 1;
    }
    return behind == given.first_word + given.words;
}

/// Puts the calls that items gave in their place. False where there are none to go on with.
bool Segment::go_on(const TaskNetwork& network) {
    std::uint32_t count = 0, open = 0;
    for (std::uint32_t n = 0; n < count_; ++n) {
        const Item& item = items_[n];
        if (!goes_on(network, item)) {
            next_items_[count] = item;
            next_items_[count++].parts = 0;
            continue;
        }
        const WrittenRun& given = item.given;
        for (std::uint32_t part = 0, behind = given.first_word; part < given.calls; ++part) {
            const std::uint32_t place = call_places_[given.first_call + part];
            const bool is_first = part == 0;
            next_items_[count++] = {is_first ? item.kept : 0, is_first ? item.skipped : 0, output_[place],
                                    item.parts / given.calls, output_.data() + behind,     {}};
            behind = place + 1;
        }
        open += given.calls;
    }
    if (open == 0) return false;
    std::swap(items_, next_items_);
    count_ = count;
    return true;
}

void Segment::sort_by_task(std::uint32_t tasks, std::uint32_t* ends) {
    for (std::uint32_t n = 0; n < count_; ++n)
        if (items_.data()[n].parts > 0) ++ends[called_task(items_.data()[n].call)];
    for (std::uint32_t task = 0, before = 0; task < tasks; ++task) {
        const std::uint32_t of_task = ends[task];
        ends[task] = before;
        before += of_task;
    }
    for (std::uint32_t n = 0; n < count_; ++n)
        if (items_.data()[n].parts > 0) order_[ends[called_task(items_.data()[n].call)]++] = static_cast<std::uint16_t>(n);
}

void Segment::run_open_items(const TaskNetwork& network, TokenWriter& out, BlockGroup& group) {
    std::uint32_t ends[kMaxTasks] = {};
    sort_by_task(network.size(), ends);
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

void Segment::run_gathered(const Task& task, TaskId id, Order gathered, TokenWriter& out, RewriteCounts& counts) {
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
