#include "target/run_report.hpp"

#include <cinttypes>
#include <cmath>

#include "target/json_line.hpp"

namespace tedavis::target {
namespace {

const char* to_string(base::MemoryKind kind) { return kind == base::MemoryKind::cpu ? "cpu" : "gpu"; }
const char* to_string(RunEnd end) { return end == RunEnd::stopped ? "stopped" : "surface_lost"; }

const char* to_string(platform::FlipPacing pacing) { return pacing == platform::FlipPacing::vblank ? "vblank" : "timer"; }

void add_screen(const platform::ScreenReport& screen, JsonLine& line) {
    line.open_object("screen").text("driver", screen.driver.view()).text("connector", screen.connector.view());
    line.text("mode", screen.mode.view()).number("flips", screen.flips).number("missed_flips", screen.missed_flips);
    line.number("late_flips", screen.late_flips).number("hidden_frames", screen.hidden_frames);
    line.number("unplugged", screen.unplugged).number("taken_away", screen.taken_away);
    line.text("paced_by", to_string(screen.paced_by)).boolean("atomic", screen.is_atomic).close_object();
}

void print_screen(const platform::ScreenReport& screen, std::FILE* out) {
    std::fprintf(out,
                 "screen %s of %s, %s: %" PRIu64 " flips, %" PRIu64 " missed, %" PRIu64 " late, paced by %s; %" PRIu64
                 " frames hidden, unplugged %" PRIu64 " times, taken away %" PRIu64 " times; %s mode setting\n",
                 screen.connector.c_str(), screen.driver.c_str(), screen.mode.c_str(), screen.flips, screen.missed_flips,
                 screen.late_flips, to_string(screen.paced_by), screen.hidden_frames, screen.unplugged, screen.taken_away,
                 screen.is_atomic ? "atomic" : "legacy");
}

double milliseconds(base::Duration duration) { return static_cast<double>(duration.ns) / 1e6; }

void add_latency(const LatencyReport& latency, JsonLine& line) {
    line.open_object("can_to_screen").number("pictures", latency.pictures);
    line.number("median_ms", milliseconds(latency.median)).number("p99_ms", milliseconds(latency.p99));
    line.number("longest_ms", milliseconds(latency.longest)).number("p99_pictures", latency.p99_pictures);
    line.number("most_pictures", latency.most_pictures).close_object();
}

void print_latency(const LatencyReport& latency, std::FILE* out) {
    std::fprintf(
        out,
        "from a CAN frame to the screen: median %.0f ms, 99 of 100 pictures within %.0f ms and %.2f frame times, longest "
        "%.1f ms and %.2f frame times\n",
        milliseconds(latency.median), milliseconds(latency.p99), latency.p99_pictures, milliseconds(latency.longest),
        latency.most_pictures);
}

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

void add_pack(const platform::CheckedPack& pack, JsonLine& json) {
    if (!pack.is_pack()) return;
    json.open_object("pack").text("folder", pack.folder.view()).text("title", pack.title.view()).number("files", pack.files);
    json.boolean("signed", pack.is_signed).text("valid_from", pack.valid_from.view());
    json.text("valid_until", pack.valid_until.view()).close_object();
}

void print_start_json(DisplayApplication& application, const StartTest& test, std::FILE* out) {
    const BoardSettings& settings = application.settings();
    JsonLine json;
    json.open_object().text("version", TEDAVIS_VERSION).text("board", settings.title.view());
    json.text("device", settings.device.name.view()).text("size", size_text(application.surface()).view());
    json.number("frame_rate_hz", settings.device.frame_rate_hz).text("gl", gl_description(application).view());
    if (const platform::ScreenReport& screen = application.screen(); !screen.connector.empty())
        json.open_object("screen")
            .text("driver", screen.driver.view())
            .text("connector", screen.connector.view())
            .text("mode", screen.mode.view())
            .close_object();
    json.text("can", settings.can.interface_name.view()).text("terrain", settings.terrain.view());
    json.text("terrain_fault", application.terrain_fault().message.view());
    json.text("scene", settings.scene.view());
    json.text("switches", settings.has_switches ? settings.switches.title.view() : "");
    add_pack(settings.pack, json);
    if (test.checks > 0)
        json.open_object("self_test")
            .boolean("holds", true)
            .number("checks", std::uint64_t{test.checks})
            .number("ms", test.took.to_seconds() * 1000)
            .close_object();
    json.open_list("budget");
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

void print_start(DisplayApplication& application, bool json, std::FILE* out, const StartTest& test) {
    if (json) {
        print_start_json(application, test, out);
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
        if (settings.pack.is_pack())
            std::fprintf(out, "pack %s: %" PRIu64 " files, each as packed%s\n", settings.pack.title.c_str(), settings.pack.files,
                         settings.pack.is_signed ? ", signed" : "");
        if (test.checks > 0)
            std::fprintf(out, "self-test of the start: passed, %zu checks in %.1f ms\n", test.checks,
                         test.took.to_seconds() * 1000);
        if (const platform::ScreenReport& screen = application.screen(); !screen.connector.empty())
            std::fprintf(out, "screen %s of %s, %s\n", screen.connector.c_str(), screen.driver.c_str(), screen.mode.c_str());
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
        line.number("gl_calls_outside_device", report.gl_calls_outside_device);
        line.number("first_picture_s", report.has_first_picture ? report.first_picture.to_seconds() : std::nan(""));
        line.number("warm_s", report.is_warm ? report.warm.to_seconds() : std::nan(""));
        line.open_object("can");
        line.number("frames", report.bus.frames).number("decoded", report.bus.decoded).number("alien", report.bus.alien);
        line.number("errors", report.bus.errors).number("dropped", report.bus.dropped);
        line.close_object();
        add_latency(report.latency, line);
        if (!report.screen.connector.empty()) add_screen(report.screen, line);
        std::fputs(line.close_object().line().data(), out);
    } else {
        std::fprintf(out,
                     "%s after %" PRIu64 " frames, %" PRIu64 " turns missed; CAN %" PRIu64 " frames, %" PRIu64
                     " decoded, %" PRIu64 " foreign, %" PRIu64 " errors, %" PRIu64 " dropped; %" PRIu64
                     " GL calls outside the device\n",
                     to_string(report.end), report.frames, report.missed, report.bus.frames, report.bus.decoded, report.bus.alien,
                     report.bus.errors, report.bus.dropped, report.gl_calls_outside_device);
        if (report.has_first_picture)
            std::fprintf(out, "first correct picture %.2f s after the start of the process\n", report.first_picture.to_seconds());
        if (report.is_warm)
            std::fprintf(out, "all designs drawn once %.2f s after the start of the process\n", report.warm.to_seconds());
        if (report.latency.pictures > 0) print_latency(report.latency, out);
        if (!report.screen.connector.empty()) print_screen(report.screen, out);
    }
    std::fflush(out);
}

}  // namespace tedavis::target
