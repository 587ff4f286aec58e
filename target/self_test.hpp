/// `tedavis-display --self-test`: checks that this build works on this machine, without any file.
///
/// Decodes a known bus log with the standard bus settings, compares the state with known values, draws one 640 x 480
/// picture of it over a known terrain database through headless EGL, and compares its content. Everything it needs is
/// embedded in the program.
///
/// Thread  one; makes and releases a surface. Memory  its own reservation. Failure  a failed check in the report.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string_view>

#include "render_core/base/span.hpp"
#include "target/self_test/self_test_report.hpp"

namespace tedavis::target {

/// The text of a file of configs/palettes with its name.
struct NamedPalette {
    std::string_view name, text;
};
inline constexpr std::size_t kSelfTestPalettes = 2;

struct SelfTestInputs {
    base::Span<const char> log;
    base::Span<const unsigned char> terrain;
    std::string_view bus, device, design;      ///< texts of configuration files
    NamedPalette palettes[kSelfTestPalettes];  ///< all palettes that the design names
};

/// Returns the inputs that are embedded in the program; they live as long as it.
[[nodiscard]] SelfTestInputs embedded_inputs() noexcept;

/// Adds its checks to `report`; stops at a failure that makes the remaining checks impossible.
void run_self_test(const SelfTestInputs& inputs, SelfTestReport& report);

/// The part of the self-test that is run at every start: decodes the known bus log, compares the state with the known values,
/// and the program's geodesy with GeographicLib's. Draws nothing and needs no surface.
void run_start_test(const SelfTestInputs& inputs, SelfTestReport& report);

/// Adds a check that numbers are computed as base/float_environment.hpp says, at this moment and in this thread.
void check_arithmetic(const char* name, SelfTestReport& report);

/// Prints one line per check and a summary line, or one line of JSON {"self_test", "version", "checks": [{"name", "holds",
/// "finding"}]}.
void print_self_test(const SelfTestReport& report, bool json, std::FILE* out);

/// The same for other checks: `title` "probe" is the first key of the JSON line as well.
void print_checks(const SelfTestReport& report, const char* title, bool json, std::FILE* out);

}  // namespace tedavis::target
