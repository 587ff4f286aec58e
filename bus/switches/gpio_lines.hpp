/// Port: the GPIO functions that the live switch source needs: lines by chip and name, their levels, and edges with kernel
/// stamps. There is one implementation for each major version of libgpiod, and one in the tests.
#pragma once

#include <cstddef>
#include <memory>
#include <string_view>

#include "bus/switches/switch_config.hpp"
#include "bus/switches/switch_edge.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/span.hpp"

namespace tedavis::bus {

/// Returns the error "switch line 'chip.name': " followed by `what`.
[[nodiscard]] base::Error switch_line_error(const SwitchLine& line, std::string_view what);

/// What to say of a line that its chip does not have.
[[nodiscard]] std::string_view what_is_missing(const SwitchLine& line);

class GpioLines {
public:
    virtual ~GpioLines() = default;
    /// Requests all lines of the config as inputs that report both edges. On failure it returns false, fills `error` and holds
    /// no line. Start-up only (allocates).
    [[nodiscard]] virtual bool request(const SwitchConfig& config, base::Error& error) = 0;
    virtual void release() = 0;

    /// Reads the current logical level. Returns false when the hardware does not answer.
    [[nodiscard]] virtual bool read_level(std::size_t line, bool& level) = 0;

    struct Burst {
        std::size_t count = 0;
        bool lost = false;    ///< the kernel reports that edges were dropped
        bool failed = false;  ///< the hardware does not answer
    };
    /// Fills `out` with pending edges of this line, oldest first, stamped on the kernel's monotonic clock. Never blocks, never
    /// allocates; a full `out` means that more may be pending.
    [[nodiscard]] virtual Burst read_edges(std::size_t line, base::Span<SwitchEdge> out) = 0;
};

/// Makes the implementation for the libgpiod version found at build time; null when built without libgpiod.
[[nodiscard]] std::unique_ptr<GpioLines> make_gpiod_lines();

}  // namespace tedavis::bus
