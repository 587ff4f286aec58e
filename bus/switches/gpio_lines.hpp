/// What the live switch source needs from a GPIO library: lines by chip and name, their levels, and edges with kernel
/// stamps. One implementation for each generation of libgpiod, and one in the tests.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include "bus/switches/switch_config.hpp"
#include "bus/switches/switch_edge.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::bus {

/// "switch line 'chip.name': " and then `what`.
[[nodiscard]] base::Error switch_line_error(const SwitchLine& line, std::string_view what);

class GpioLines {
public:
    virtual ~GpioLines() = default;
    /// Takes all lines of the config as inputs that report both edges; false with `error` filled, and then none is taken.
    /// Start-up only (allocates).
    [[nodiscard]] virtual bool request(const SwitchConfig& config, base::Error& error) = 0;
    virtual void release() = 0;

    /// The logical level now; false when the hardware does not answer.
    [[nodiscard]] virtual bool read_level(std::size_t line, bool& level) = 0;

    struct Burst {
        std::size_t count = 0;
        bool lost = false;    ///< the kernel says that edges were dropped
        bool failed = false;  ///< the hardware does not answer
    };
    /// Fills `out` with edges that wait for this line, oldest first, stamped on the kernel's monotonic clock. Never
    /// blocks, never allocates; a full `out` means that more may wait.
    [[nodiscard]] virtual Burst read_edges(std::size_t line, base::Span<SwitchEdge> out) = 0;
};

/// libgpiod as found when this was built; null when built without it.
[[nodiscard]] std::unique_ptr<GpioLines> make_gpiod_lines();

}  // namespace tedavis::bus
