/// Port: parallel execution over indices (fork and join). Implemented in platform/threads.
#pragma once

#include <cstdint>

namespace tedavis::base {

class Workers {
public:
    /// A task must not call the same Workers. It must write results only to places that depend on `index` alone, so that they
    /// are the same for every number of workers.
    using Task = void (*)(void* context, std::uint32_t index);

    virtual ~Workers() = default;
    /// Number of tasks that may run at once, the caller included; 1 or more.
    [[nodiscard]] virtual std::uint32_t concurrency() const = 0;
    /// Calls task(context, i) once for every i in [0, count) and returns when all are done. Never allocates.
    virtual void parallel_for(std::uint32_t count, Task task, void* context) = 0;
};

/// Runs all tasks on the caller's thread, in order.
class SerialWorkers final : public Workers {
public:
    [[nodiscard]] std::uint32_t concurrency() const override { return 1; }
    void parallel_for(std::uint32_t count, Task task, void* context) override {
        for (std::uint32_t i = 0; i < count; ++i) task(context, i);
    }
};

}  // namespace tedavis::base
