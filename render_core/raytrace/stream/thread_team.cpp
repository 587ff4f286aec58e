#include "render_core/raytrace/stream/thread_team.hpp"

namespace tedavis::raytrace {
namespace {

/// Some tenth of a millisecond: longer than the leader takes between two passes, shorter than a time slice.
constexpr std::uint32_t kMaxLooks = 1u << 14;

void rest_shortly() {
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#elif defined(__aarch64__) || defined(__arm__)
    __asm__ volatile("yield");
#endif
}

}  // namespace

void ThreadTeam::run(base::Workers& workers, std::uint32_t lanes, Lead lead, void* context) {
    ThreadTeam team(lead, context, lanes);
    if (lanes < 2) return lead(context, team);
    workers.parallel_for(lanes, &ThreadTeam::enter, &team);
}

void ThreadTeam::serve() {
    const std::uint32_t lane = arrived_.fetch_add(1, std::memory_order_relaxed);
    if (lane == 0) {
        lead_(lead_context_, *this);
        return is_over_.store(true, std::memory_order_relaxed);
    }
    for (std::uint32_t looks = 0; looks < kMaxLooks; ++looks) {
        if (is_over_.load(std::memory_order_relaxed)) return;
        if (take_one(lane))
            looks = 0;
        else
            rest_shortly();
    }
    lost_.fetch_add(1, std::memory_order_relaxed);
}

bool ThreadTeam::take_one(std::uint32_t lane) {
    std::uint64_t ticket = ticket_.load(std::memory_order_relaxed);
    if (static_cast<std::uint32_t>(ticket) >= ticket >> 32) return false;
    ticket = ticket_.fetch_add(1, std::memory_order_acquire);
    const std::uint32_t index = static_cast<std::uint32_t>(ticket);
    if (index >= ticket >> 32) return false;
    work_(work_context_, index, lane);
    done_.fetch_add(1, std::memory_order_release);
    return true;
}

void ThreadTeam::share(std::uint32_t count, Work work, void* context) {
    if (lanes_ < 2 || count < 2) {
        for (std::uint32_t n = 0; n < count; ++n) work(context, n, 0);
        return;
    }
    work_ = work;
    work_context_ = context;
    done_.store(0, std::memory_order_relaxed);
    ticket_.store(std::uint64_t{count} << 32, std::memory_order_release);
    while (take_one(0)) {
    }
    while (done_.load(std::memory_order_acquire) != count) rest_shortly();
}

}  // namespace tedavis::raytrace
