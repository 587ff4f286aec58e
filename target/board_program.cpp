#include "target/board_program.hpp"

#include <memory>

#include "bus/socketcan/raw_can_socket.hpp"
#include "target/calibrate_board.hpp"
#include "target/command_line.hpp"
#include "target/display_application.hpp"
#include "target/run_report.hpp"
#include "target/self_test.hpp"
#include "target/self_test/board_checks.hpp"

namespace tedavis::target {
namespace {

constexpr int kDone = 0, kFailed = 1, kWrongInput = 2, kStopped = 130;

int refuse(const base::Error& error) {
    EventLog().write({error.message.view()});
    return kWrongInput;
}

int run_display(const CommandLine& line, std::FILE* out) {
    const auto settings = load_board_settings(line.config);
    if (!settings.ok()) return refuse(settings.error());
    bus::RawCanSocket can;
    BoardPorts ports;
    ports.can = &can;
    ports.gpio = bus::make_gpiod_lines();
    ports.clocks = machine_clocks();
    const EventLog log;
    Snapshot snapshot(log);
    ports.snapshot = &snapshot;
    const StopSignal stop;
    const auto application = std::make_unique<DisplayApplication>(settings.value(), std::move(ports));
    if (const base::Error error = application->start()) return refuse(error);
    const base::Surface& surface = application->surface();
    if (line.shot != nullptr)
        if (const base::Error error = snapshot.start(line.shot, surface.width(), surface.height())) return refuse(error);
    print_start(*application, line.json, out);
    const RunReport report = application->run(line.frames, stop);
    print_end(report, line.json, out);
    return report.end == RunEnd::stopped ? kDone : kFailed;
}

/// With a board file its own set-up is tested first.
int test_machine(const CommandLine& line, std::FILE* out) {
    SelfTestReport report;
    if (line.config != nullptr) {
        const auto settings = load_board_settings(line.config);
        if (!settings.ok()) return refuse(settings.error());
        report.add("board_file", true, settings.value().title.view());
        check_board(settings.value(), report);
    }
    run_self_test(embedded_inputs(), report);
    print_self_test(report, line.json, out);
    return report.holds() ? kDone : kFailed;
}

int calibrate(const CommandLine& line, std::FILE* out) {
    const auto settings = load_board_settings(line.config);
    if (!settings.ok()) return refuse(settings.error());
    const StopSignal stop;
    const CalibrateRequest request{line.output, line.rounds, line.json};
    const base::Error error = calibrate_board(settings.value(), request, {machine_clocks(), EventLog()}, stop, out);
    if (!error) return kDone;
    const int code = refuse(error);
    return stop.requested() ? kStopped : code;
}

}  // namespace

int run_board_program(int count, const char* const* arguments, std::FILE* out) {
    const auto line = parse_command_line(count, arguments);
    if (!line.ok()) return refuse(line.error());
    switch (line.value().request) {
        case Request::help: std::fputs(command_line_help(), out); return kDone;
        case Request::version: print_version(line.value().json, out); return kDone;
        case Request::self_test: return test_machine(line.value(), out);
        case Request::calibrate: return calibrate(line.value(), out);
        case Request::run: break;
    }
    return run_display(line.value(), out);
}

}  // namespace tedavis::target
