/// Keeps workers running over many short passes, because waking them for each pass would cost more than a pass of a small
/// stream.
///
/// One thread leads; the others poll for shared work in bounded intervals and leave when there is none for long. The leader
/// does not wait for late or missing threads and executes all work that is not taken. Thread-safe by atomics; no heap, no
/// locks.
#pragma once

#include <atomic>

#include "render_core/base/ports/workers.hpp"

namespace tedavis::raytrace {

class ThreadTeam {
public:
    using Lead = void (*)(void* context, ThreadTeam& team);
    /// `lane` is below `lanes` of run() and differs between threads that work at the same time.
    using Work = void (*)(void* context, std::uint32_t index, std::uint32_t lane);

    /// Calls lead(context, team) once, on any thread, and returns when it has ended. `lanes` is 1 to 64.
    static void run(base::Workers& workers, std::uint32_t lanes, Lead lead, void* context);

    /// To be called by the leader: calls work(context, i, lane) once for each i below `count`, and returns when all are done.
    void share(std::uint32_t count, Work work, void* context);
    /// True where threads have left; end the lead function and call run() again to use them.
    [[nodiscard]] bool has_lost() const { return lost_.load(std::memory_order_relaxed) > 0; }

private:
    ThreadTeam(Lead lead, void* context, std::uint32_t lanes) : lead_(lead), lead_context_(context), lanes_(lanes) {}

    static void enter(void* team, std::uint32_t) { static_cast<ThreadTeam*>(team)->serve(); }
    void serve();
    [[nodiscard]] bool take_one(std::uint32_t lane);

    Lead lead_;
    void* lead_context_;
    std::uint32_t lanes_;
    Work work_ = nullptr;
    void* work_context_ = nullptr;
    /// Low half: the next index; high half: the count. Storing it publishes the work; taking an index acquires it.
    alignas(64) std::atomic<std::uint64_t> ticket_{0};
    alignas(64) std::atomic<std::uint32_t> done_{0};
    alignas(64) std::atomic<std::uint32_t> arrived_{0};
    std::atomic<std::uint32_t> lost_{0};
    std::atomic<bool> is_over_{false};
};

}  // namespace tedavis::raytrace
