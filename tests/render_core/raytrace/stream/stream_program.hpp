/// A network of small tasks on whole numbers, and random programs for it.
#pragma once

#include <random>
#include <vector>

#include "render_core/raytrace/stream/token_writer.hpp"

namespace tedavis::test_support {

class NumberTasks {
public:
    using Writer = raytrace::TokenWriter;
    using Batch = raytrace::Batch;

    raytrace::TaskNetwork network;
    raytrace::TaskId add, twice, turn, drop, fibonacci, spread, bush, mark;
    std::vector<std::uint32_t> marks = std::vector<std::uint32_t>(1 << 16);  ///< where `mark` writes

    NumberTasks() {
        add = made("add", 2, 1, &NumberTasks::run_add);
        twice = made("twice", 1, 2, &NumberTasks::run_twice);
        turn = made("turn", 2, 2, &NumberTasks::run_turn);
        drop = made("drop", 1, 0, &NumberTasks::run_drop);
        fibonacci = made("fibonacci", 1, 5, &NumberTasks::run_fibonacci);
        spread = made("spread", 2, 3 * 40, &NumberTasks::run_spread);
        bush = made("bush", 2, 3 * 4 + 3, &NumberTasks::run_bush);
        mark = made("mark", 2, 0, &NumberTasks::run_mark);
    }
    NumberTasks(const NumberTasks&) = delete;

    /// Another "add": the difference.
    raytrace::Task difference() {
        raytrace::Task task = network.task(add);
        task.name = "difference";
        task.run = &NumberTasks::run_difference;
        return task;
    }

private:
    raytrace::TaskId made(const char* name, std::uint32_t arguments, std::uint32_t outputs, raytrace::BatchFunction run) {
        raytrace::Task task;
        task.name = name;
        task.arguments = arguments;
        task.most_outputs = outputs;
        task.run = run;
        task.context = this;
        return network.add(task).value();
    }

    template <class Work>
    static void each(const Batch& batch, Writer& out, Work work) {
        for (std::uint32_t n = 0; n < batch.count; ++n) {
            work(batch.record(n));
            out.done();
        }
    }
    static void run_add(void*, const Batch& batch, Writer& out) {
        each(batch, out, [&](const std::uint32_t* a) { out.literal(a[0] + a[1]); });
    }
    static void run_difference(void*, const Batch& batch, Writer& out) {
        each(batch, out, [&](const std::uint32_t* a) { out.literal(a[0] - a[1]); });
    }
    static void run_twice(void*, const Batch& batch, Writer& out) {
        each(batch, out, [&](const std::uint32_t* a) {
            const std::uint32_t both[] = {a[0], a[0]};
            out.literals(both, 2);
        });
    }
    static void run_turn(void*, const Batch& batch, Writer& out) {
        each(batch, out, [&](const std::uint32_t* a) {
            out.literal(a[1]);
            out.literal(a[0]);
        });
    }
    static void run_drop(void*, const Batch&, Writer&) {}
    static void run_fibonacci(void* self, const Batch& batch, Writer& out) {
        each(batch, out, [&](const std::uint32_t* a) {
            const std::uint32_t n = a[0] % 20;
            out.literal(n < 2 ? n : n - 1);
            if (n < 2) return;
            out.call(batch.self);
            out.literal(n - 2);
            out.call(batch.self);
            out.call(static_cast<NumberTasks*>(self)->add);
        });
    }
    /// A parallel task: up to 40 sums.
    static void run_spread(void* self, const Batch& batch, Writer& out) {
        each(batch, out, [&](const std::uint32_t* a) {
            std::vector<std::uint32_t> records;
            for (std::uint32_t n = 0; n < a[0] % 41; ++n) records.insert(records.end(), {n, a[1]});
            out.calls(static_cast<NumberTasks*>(self)->add, records.data(), a[0] % 41);
        });
    }
    /// A recursive task that comes to anything: depth and seed give smaller ones, sums, numbers.
    static void run_bush(void* self, const Batch& batch, Writer& out) {
        const NumberTasks& tasks = *static_cast<NumberTasks*>(self);
        each(batch, out, [&](const std::uint32_t* a) {
            const std::uint32_t depth = a[0] % 5;
            std::uint32_t seed = a[1];
            for (std::uint32_t branch = 0; branch < 4; ++branch) {
                seed = seed * 1664525 + 1013904223;
                const std::uint32_t kind = seed >> 29;
                out.literal(depth == 0 ? seed : depth - 1);
                if (kind < 2) continue;
                out.literal(seed ^ branch);
                if (kind < 5) out.call(depth == 0 ? tasks.turn : batch.self);
                if (kind == 5) out.call(tasks.add);
                if (kind == 6) out.call(tasks.mark_free_spread(depth));
            }
            out.call(tasks.twice);
        });
    }
    raytrace::TaskId mark_free_spread(std::uint32_t depth) const { return depth == 0 ? add : spread; }
    static void run_mark(void* self, const Batch& batch, Writer& out) {
        each(batch, out, [&](const std::uint32_t* a) { static_cast<NumberTasks*>(self)->marks[a[0] & 0xffff] = a[1]; });
    }
};

/// About 2 `length` tokens: runs of numbers of all lengths, calls, calls for several, behind so many numbers that no call lacks
/// any. Places that are marked differ.
inline std::vector<raytrace::Token> random_program(const NumberTasks& tasks, std::uint32_t seed, std::size_t length) {
    std::mt19937 random(seed);
    const auto below = [&](std::uint32_t end) { return static_cast<std::uint32_t>(random() % end); };
    const raytrace::TaskId pure[] = {tasks.add, tasks.twice, tasks.turn, tasks.drop, tasks.fibonacci, tasks.spread, tasks.bush};
    std::vector<raytrace::Token> program(length, raytrace::literal(3));
    std::uint32_t marked = 0;
    while (program.size() < 2 * length) {
        for (std::uint32_t n = below(10) == 0 ? below(300) : below(6); n > 0; --n)
            program.push_back(raytrace::literal(random() % 10));
        const raytrace::TaskId task = pure[below(7)];
        const std::uint32_t count = below(4) == 0 ? 1 + below(60) : 1;
        if (count > 1)
            for (std::uint32_t n = below(8) == 0 ? 1 : 0; n < count * tasks.network.task(task).arguments; ++n)
                program.push_back(raytrace::literal(random() % 200));
        program.push_back(raytrace::call(task, count));
        if (below(3) != 0) continue;
        program.push_back(raytrace::literal(marked++));
        program.push_back(raytrace::literal(random()));
        program.push_back(raytrace::call(tasks.mark));
    }
    return program;
}

}  // namespace tedavis::test_support
