#include "host_sim/heap_trap/heap_trap.hpp"

#include <execinfo.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>

#include "render_core/base/driver_scope.hpp"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TEDAVIS_TRAP_BY_HOOK 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define TEDAVIS_TRAP_BY_HOOK 1
#endif
#endif

namespace tedavis::host_sim {
namespace {

constexpr int kMaxFrames = 24;
std::atomic<bool> armed{false};
std::atomic<std::uint64_t> ours{0};
std::atomic<std::uint64_t> drivers{0};
void* first_frames[kMaxFrames];
std::atomic<int> first_frame_count{0};
thread_local bool watched = false;

void record_allocation() {
    if (!watched || !armed.load(std::memory_order_relaxed)) return;
    if (base::driver_depth > 0) {
        drivers.fetch_add(1, std::memory_order_relaxed);
        return;
    }
    if (ours.fetch_add(1, std::memory_order_relaxed) > 0) return;
    watched = false;  // what backtrace itself allocates is not ours
    first_frame_count.store(backtrace(first_frames, kMaxFrames));
    watched = true;
}

#if defined(TEDAVIS_TRAP_BY_HOOK)
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void*, std::size_t),
                                                         void (*on_free)(const volatile void*));
void on_malloc(const volatile void*, std::size_t) { record_allocation(); }
void on_free(const volatile void*) {}
[[maybe_unused]] const int kHooked = __sanitizer_install_malloc_and_free_hooks(&on_malloc, &on_free);
#endif

}  // namespace

HeapTrap::HeapTrap() {
    void* warm_up[2];
    static_cast<void>(backtrace(warm_up, 2));  // its first call loads a library
    ours = drivers = 0;
    first_frame_count = 0;
    watched = true;
    armed = true;
}

HeapTrap::~HeapTrap() { close(); }

void HeapTrap::close() { armed = false; }

HeapCounts HeapTrap::counts() const { return {ours.load(), drivers.load()}; }

std::string HeapTrap::first_of_ours() const {
    std::string text;
    const int count = first_frame_count.load();
    char** names = count > 0 ? backtrace_symbols(first_frames, count) : nullptr;
    for (int i = 0; names != nullptr && i < count; ++i) text += std::string(names[i]) + "\n";
    std::free(names);
    return text;
}

void HeapTrap::watch_this_thread() { watched = true; }

}  // namespace tedavis::host_sim

#if !defined(TEDAVIS_TRAP_BY_HOOK)
// The whole family, so that no allocation and no release mixes two allocators.
// The C library's own names. NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);
// NOLINTEND(bugprone-reserved-identifier)

void* malloc(std::size_t size) noexcept {
    tedavis::host_sim::record_allocation();
    return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
    tedavis::host_sim::record_allocation();
    return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) noexcept {
    tedavis::host_sim::record_allocation();
    return __libc_realloc(old, size);
}
void* memalign(std::size_t alignment, std::size_t size) noexcept {
    tedavis::host_sim::record_allocation();
    return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept { return memalign(alignment, size); }
int posix_memalign(void** out, std::size_t alignment, std::size_t size) noexcept {
    if (alignment % sizeof(void*) != 0 || (alignment & (alignment - 1)) != 0 || alignment == 0) return EINVAL;
    void* memory = memalign(alignment, size);
    if (memory == nullptr) return ENOMEM;
    *out = memory;
    return 0;
}
void* valloc(std::size_t size) noexcept { return memalign(4096, size); }
void* pvalloc(std::size_t size) noexcept { return memalign(4096, (size + 4095) / 4096 * 4096); }
void free(void* memory) noexcept { __libc_free(memory); }
}
#endif
