/// What the core needs to use more than one processor core: fork and join over indices. Implemented in platform/threads.
#pragma once

#include <cstdint>

namespace tedavis::base {

class Workers {
public:
    /// Must not call back into the same Workers. Results must go to places that depend on `index` alone: then they are the
    /// same for every number of workers.
    using Task = void (*)(void* context, std::uint32_t index);

    virtual ~Workers() = default;
    /// How many tasks may run at once, the caller included; 1 or more.
    [[nodiscard]] virtual std::uint32_t concurrency() const = 0;
    /// Calls task(context, i) once for every i in [0, count) and returns when all are done. Never allocates.
    virtual void parallel_for(std::uint32_t count, Task task, void* context) = 0;
};

/// Everything on the caller, in order.
class SerialWorkers final : public Workers {
public:
    [[nodiscard]] std::uint32_t concurrency() const override { return 1; }
    void parallel_for(std::uint32_t count, Task task, void* context) override {
        for (std::uint32_t i = 0; i < count; ++i) task(context, i);
    }
};

}  // namespace tedavis::base
