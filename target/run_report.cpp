#include "target/run_report.hpp"

#include <cinttypes>

#include "target/json_line.hpp"

namespace tedavis::target {
namespace {

const char* to_string(base::MemoryKind kind) { return kind == base::MemoryKind::cpu ? "cpu" : "gpu"; }
const char* to_string(RunEnd end) { return end == RunEnd::stopped ? "stopped" : "surface_lost"; }

base::FixedString<447> gl_description(DisplayApplication& application) {
    base::FixedString<447> text(application.surface().backend_name());
    text.append(": ");
    text.append(application.display().gl().driver_text().view());
    return text;
}

base::FixedString<31> size_text(const base::Surface& surface) {
    char text[32];
    std::snprintf(text, sizeof text, "%ux%u", surface.width(), surface.height());
    return text;
}

void print_start_json(DisplayApplication& application, std::FILE* out) {
    const BoardSettings& settings = application.settings();
    JsonLine json;
    json.open_object().text("version", TEDAVIS_VERSION).text("board", settings.title.view());
    json.text("device", settings.device.name.view()).text("size", size_text(application.surface()).view());
    json.number("frame_rate_hz", settings.device.frame_rate_hz).text("gl", gl_description(application).view());
    json.text("can", settings.can.interface_name.view()).text("terrain", settings.terrain.view());
    json.text("terrain_fault", application.terrain_fault().message.view());
    json.text("scene", settings.scene.view());
    json.text("switches", settings.has_switches ? settings.switches.title.view() : "").open_list("budget");
    for (const base::BudgetLine& line : application.display().planner().budget().lines())
        json.open_object()
            .text("name", line.name.view())
            .text("kind", to_string(line.kind))
            .number("bytes", line.bytes)
            .number("in_use", line.use.in_use)
            .text("owner", line.owner.view())
            .text("reason", line.reason.view())
            .close_object();
    std::fputs(json.close_list().close_object().line().data(), out);
}

}  // namespace

void print_version(bool json, std::FILE* out) {
    if (json)
        std::fputs(JsonLine().open_object().text("version", TEDAVIS_VERSION).close_object().line().data(), out);
    else
        std::fputs("tedavis-display " TEDAVIS_VERSION "\n", out);
}

void print_start(DisplayApplication& application, bool json, std::FILE* out) {
    if (json) {
        print_start_json(application, out);
    } else {
        const BoardSettings& settings = application.settings();
        std::fprintf(out, "tedavis-display %s: %s; device %s, %s, %g frames/s\n%s\nCAN %s; terrain %s; scene %s; switches %s\n",
                     TEDAVIS_VERSION, settings.title.c_str(), settings.device.name.c_str(),
                     size_text(application.surface()).c_str(), settings.device.frame_rate_hz, gl_description(application).c_str(),
                     settings.can.interface_name.c_str(),
                     settings.terrain.empty()                      ? "none"
                     : application.terrain_fault().message.empty() ? settings.terrain.c_str()
                                                                   : "FAILED",
                     settings.scene.empty() ? "none" : settings.scene.c_str(),
                     settings.has_switches ? settings.switches.title.c_str() : "none");
        for (const base::BudgetLine& line : application.display().planner().budget().lines())
            std::fprintf(out, "  %-3s %-20s %10" PRIu64 " bytes  %-24s %s\n", to_string(line.kind), line.name.c_str(), line.bytes,
                         line.owner.c_str(), line.reason.c_str());
    }
    std::fflush(out);
}

void print_end(const RunReport& report, bool json, std::FILE* out) {
    if (json) {
        JsonLine line;
        line.open_object().text("end", to_string(report.end)).number("frames", report.frames).number("missed", report.missed);
        line.number("gl_calls_outside_device", report.gl_calls_outside_device).open_object("can");
        line.number("frames", report.bus.frames).number("decoded", report.bus.decoded).number("alien", report.bus.alien);
        line.number("errors", report.bus.errors).number("dropped", report.bus.dropped);
        std::fputs(line.close_object().close_object().line().data(), out);
    } else {
        std::fprintf(out,
                     "%s after %" PRIu64 " frames, %" PRIu64 " turns missed; CAN %" PRIu64 " frames, %" PRIu64
                     " decoded, %" PRIu64 " foreign, %" PRIu64 " errors, %" PRIu64 " dropped; %" PRIu64
                     " GL calls outside the device\n",
                     to_string(report.end), report.frames, report.missed, report.bus.frames, report.bus.decoded, report.bus.alien,
                     report.bus.errors, report.bus.dropped, report.gl_calls_outside_device);
    }
    std::fflush(out);
}

}  // namespace tedavis::target
