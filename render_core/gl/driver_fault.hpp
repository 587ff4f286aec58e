/// Known faults of drivers: each has a name, a description, and a test for the drivers that have it. Facts are in
/// capability_probe.hpp; a workaround is at the place of use, which calls Gl::suffers() with the fault's name. A device file
/// whose driver does not have a fault disables it: `ignore_faults = ["adreno-program-binaries"]` in its table [gl].
///
/// Pure. Any thread.
#pragma once

#include <cstdint>
#include <string_view>

#include "render_core/base/span.hpp"
#include "render_core/gl/capability_probe.hpp"

namespace tedavis::gl {

enum class DriverFault : std::uint8_t { adreno_program_binaries, powervr_program_binaries, count };

struct KnownFault {
    DriverFault fault;
    std::string_view name;
    const char* story;  ///< what goes wrong, the workaround, and who reported it
    bool (*shows_on)(const DriverFacts&);
};

/// In the order of DriverFault.
[[nodiscard]] base::Span<const KnownFault> known_faults() noexcept;
/// Returns the fault of a name, or DriverFault::count.
[[nodiscard]] DriverFault find_fault(std::string_view name) noexcept;

}  // namespace tedavis::gl
