/// Workers that stay together over many short passes: waking them for each pass costs more than a pass of a small stream takes.
///
/// One of them leads; the others look for work that it shares, in turns of bounded length, and leave where there is none for
/// long. Whoever comes late or leaves is not waited for: the leader does all that nobody takes. Thread-safe by its atomics; no
/// heap, no locks.
#pragma once

#include <atomic>

#include "render_core/base/ports/workers.hpp"

namespace tedavis::raytrace {

class ThreadTeam {
public:
    using Lead = void (*)(void* context, ThreadTeam& crew);
    /// `lane` below that of run(), another for each thread that works at the same time.
    using Work = void (*)(void* context, std::uint32_t index, std::uint32_t lane);

    /// Calls lead(context, crew) once, on any thread, and returns when it is over. 1 to 64 lanes.
    static void run(base::Workers& workers, std::uint32_t lanes, Lead lead, void* context);

    /// For the leader: calls work(context, i, lane) once for each i below `count`, and returns when all are done.
    void share(std::uint32_t count, Work work, void* context);
    /// Some have left. To have them back, end the lead and run again.
    [[nodiscard]] bool has_lost() const { return lost_.load(std::memory_order_relaxed) > 0; }

private:
    ThreadTeam(Lead lead, void* context, std::uint32_t lanes) : lead_(lead), lead_context_(context), lanes_(lanes) {}

    static void enter(void* crew, std::uint32_t) { static_cast<ThreadTeam*>(crew)->serve(); }
    void serve();
    [[nodiscard]] bool take_one(std::uint32_t lane);

    Lead lead_;
    void* lead_context_;
    std::uint32_t lanes_;
    Work work_ = nullptr;
    void* work_context_ = nullptr;
    /// Below: the next index; above: how many there are. Setting it hands the work over, taking one receives it.
    alignas(64) std::atomic<std::uint64_t> ticket_{0};
    alignas(64) std::atomic<std::uint32_t> done_{0};
    alignas(64) std::atomic<std::uint32_t> arrived_{0};
    std::atomic<std::uint32_t> lost_{0};
    std::atomic<bool> is_over_{false};
};

}  // namespace tedavis::raytrace
