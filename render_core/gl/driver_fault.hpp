/// Faults of drivers that are known: each has a name, a story, and says on which drivers it shows. Facts are in
/// capability_probe.hpp; what is done about a fault stands where it is done, and asks Gl::suffers() by the fault's name. A device
/// file whose driver is proved good switches one off: `ignore_faults = ["adreno-program-binaries"]` in its table [gl].
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
    const char* story;  ///< what goes wrong, what is done about it, who reported it
    bool (*shows_on)(const DriverFacts&);
};

/// In the order of DriverFault.
[[nodiscard]] base::Span<const KnownFault> known_faults() noexcept;
/// DriverFault::count where there is none of that name.
[[nodiscard]] DriverFault find_fault(std::string_view name) noexcept;

}  // namespace tedavis::gl
