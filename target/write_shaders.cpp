#include "target/write_shaders.hpp"

#include <memory>

#include "platform/programs/new_program_folder.hpp"
#include "platform/runtime/display_host.hpp"
#include "render_core/gl/program.hpp"
#include "target/board_display.hpp"
#include "target/json_line.hpp"

namespace tedavis::target {

base::Error write_shaders(const BoardSettings& settings, const char* path, const StopSignal& stop, bool json, std::FILE* out) {
    const std::string_view device = settings.device.name.view();
    if (gl::has_compiler(settings.device.capability))
        return base::make_error("--write-shaders: device '", device,
                                "' has a compiler and needs no programs; leave [programs] out of the board file");
    platform::NewProgramFolder programs;
    if (base::Error error = programs.open(path)) return error;
    platform::DisplayHostSettings of_host = off_screen_host_settings(settings);
    of_host.display.device.capability = gl::with_compiler(settings.device.capability);
    of_host.display.programs = &programs;
    of_host.programs = {};
    const auto host = std::make_unique<platform::DisplayHost>();
    if (const platform::HostFault fault = start_board_host(settings, of_host, *host)) return fault.error;
    if (stop.requested()) return base::make_error("interrupted; nothing was written");
    if (base::Error error = programs.commit()) return error;
    if (json)
        std::fputs(JsonLine()
                       .open_object()
                       .text("programs", path)
                       .number("count", std::uint64_t{programs.programs()})
                       .text("device", device)
                       .close_object()
                       .line()
                       .data(),
                   out);
    else
        std::fprintf(out, "%s: %zu programs for %s, readable by this machine's driver alone\n", path, programs.programs(),
                     settings.device.name.c_str());
    return {};
}

}  // namespace tedavis::target
