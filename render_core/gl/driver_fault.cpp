#include "render_core/gl/driver_fault.hpp"

namespace tedavis::gl {
namespace {

bool has(const base::FixedString<127>& text, std::string_view part) { return text.view().find(part) != std::string_view::npos; }

/// "Adreno (TM) 530": the series is the number's first digit.
bool is_adreno_3_to_5(const DriverFacts& driver) {
    constexpr std::string_view kFamily = "Adreno (TM) ";
    const std::string_view renderer = driver.renderer.view();
    const std::size_t at = renderer.find(kFamily);
    if (at == std::string_view::npos || at + kFamily.size() >= renderer.size()) return false;
    const char series = renderer[at + kFamily.size()];
    return series >= '3' && series <= '5';
}

bool is_powervr_rogue(const DriverFacts& driver) { return has(driver.renderer, "PowerVR Rogue"); }

constexpr KnownFault kFaults[] = {
    {DriverFault::adreno_program_binaries, "adreno-program-binaries",
     "Programs loaded from binaries draw wrongly or fail now and then on Adreno 3xx, 4xx and 5xx, so none are made or taken "
     "there "
     "(Chromium issue 510637; Mapbox GL Native, pull request 9574).",
     is_adreno_3_to_5},
    {DriverFault::powervr_program_binaries, "powervr-program-binaries",
     "PowerVR Rogue's drivers hand out binaries that they do not take back rightly, so none are made or taken there (ANGLE issue "
     "42263580).",
     is_powervr_rogue},
};
static_assert(sizeof kFaults / sizeof kFaults[0] == static_cast<std::size_t>(DriverFault::count));

}  // namespace

base::Span<const KnownFault> known_faults() noexcept { return kFaults; }

DriverFault find_fault(std::string_view name) noexcept {
    for (const KnownFault& known : kFaults)
        if (known.name == name) return known.fault;
    return DriverFault::count;
}

}  // namespace tedavis::gl
