/// A fixed number of threads that share the indices of a parallel_for.
///
/// Threads are created at start and sleep between calls. Memory  none after start. Only one parallel_for() may run at a time.
#pragma once

#include <cstdint>
#include <memory>

#include "render_core/base/error.hpp"
#include "render_core/base/ports/workers.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::platform {

inline constexpr std::uint32_t kMaxWorkers = 64;

struct ThreadWorkersSettings {
    std::uint32_t concurrency = 1;        ///< 1..kMaxWorkers, the caller included; 1 creates no thread
    void (*on_thread_start)() = nullptr;  ///< called once in every new thread (the tests' heap trap needs it)
};

/// The number of processors that this process may use, 1..kMaxWorkers.
[[nodiscard]] std::uint32_t usable_processors() noexcept;

[[nodiscard]] base::Result<std::unique_ptr<base::Workers>, base::Error> make_thread_workers(
    const ThreadWorkersSettings& settings);

}  // namespace tedavis::platform
