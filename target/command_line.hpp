/// The parsed command line of `tedavis-display`.
#pragma once

#include <cstdint>

#include "platform/configuration/pack_check.hpp"
#include "render_core/base/error.hpp"
#include "render_core/base/result.hpp"

namespace tedavis::target {

enum class Request : std::uint8_t { run, self_test, probe, calibrate, write_shaders, help, version };

struct CommandLine {
    Request request = Request::run;
    const char* config = nullptr;                        ///< board file, or a pack; null only for requests that need none
    const char* pack_key = platform::kInstalledPackKey;  ///< key that a pack must be signed with
    bool names_pack_key = false;                         ///< --pack-key was given, so there must be a pack
    std::uint64_t frames = 0;                            ///< 0: run until a signal
    bool json = false;
    const char* shot = nullptr;     ///< of a run: the file of a picture; null: none
    const char* output = nullptr;   ///< of a calibration; not null there
    const char* shaders = nullptr;  ///< of write_shaders: the folder; not null there
    std::uint32_t rounds = 15;      ///< of a calibration, kMinRounds to kMaxRounds of platform::BenchFrames
};

/// Parses the arguments after the program's name. `--help` and `--version` take precedence over everything before the first
/// fault.
[[nodiscard]] base::Result<CommandLine, base::Error> parse_command_line(int count, const char* const* arguments);

/// The text of `--help`.
[[nodiscard]] const char* command_line_help() noexcept;

}  // namespace tedavis::target
