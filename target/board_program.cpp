#include "target/board_program.hpp"

#include <memory>

#include "bus/socketcan/raw_can_socket.hpp"
#include "target/calibrate_board.hpp"
#include "target/command_line.hpp"
#include "target/display_application.hpp"
#include "target/probe/machine_offer.hpp"
#include "target/probe/probe_board.hpp"
#include "target/process_age.hpp"
#include "target/run_report.hpp"
#include "target/self_test.hpp"
#include "target/self_test/board_checks.hpp"
#include "target/write_shaders.hpp"

namespace tedavis::target {
namespace {

constexpr int kDone = 0, kFailed = 1, kWrongInput = 2, kStopped = 130;

int refuse(const base::Error& error) {
    EventLog().write({error.message.view()});
    return kWrongInput;
}

/// A service manager tries again after kFailed only.
int refuse(const platform::ConfigError& error) {
    const int code = refuse(static_cast<const base::Error&>(error));
    return error.may_pass ? kFailed : code;
}

base::Result<BoardSettings, platform::ConfigError> settings_of(const CommandLine& line) {
    auto settings = load_board_settings(line.config, line.pack_key);
    if (!line.names_pack_key || !settings.ok() || settings.value().pack.is_pack()) return settings;
    return base::fail(platform::ConfigError{
        base::make_error("--pack-key ", line.pack_key, ": ", line.config,
                         " is of no pack, so that no signature would be asked for; name a pack, or leave the key out")});
}

/// Of a program that decodes wrongly no picture may be shown. False where a check does not hold.
bool test_start(const BoardClocks& clocks, StartTest& test) {
    const base::Time begun = clocks.live.monotonic();
    SelfTestReport report;
    run_start_test(embedded_inputs(), report);
    test = {report.checks().size(), clocks.live.monotonic() - begun};
    if (report.holds()) return true;
    for (const SelfCheck& check : report.checks())
        if (!check.holds) {
            EventLog().write({"the self-test of the start fails (", check.name.view(), ": ", check.finding.view(),
                              "); install the program again, and test this machine with --self-test"});
            break;
        }
    return false;
}

void say_age(const platform::CheckedPack& pack, const BoardClocks& clocks) {
    const auto words = platform::words_of_age(pack, clocks.live.wall());
    if (!words.empty()) EventLog().write({words.view()});
}

int run_display(const CommandLine& line, std::FILE* out) {
    const auto settings = settings_of(line);
    if (!settings.ok()) return refuse(settings.error());
    StartTest test;
    if (!test_start(machine_clocks(), test)) return kFailed;
    bus::RawCanSocket can;
    BoardPorts ports;
    ports.can = &can;
    ports.gpio = bus::make_gpiod_lines();
    ports.clocks = machine_clocks();
    ports.process_age = &process_age;
    const EventLog log;
    Snapshot snapshot(log);
    ports.snapshot = &snapshot;
    ports.explain_panel = &explain_panel;
    const StopSignal stop;
    const auto application = std::make_unique<DisplayApplication>(settings.value(), std::move(ports));
    if (const base::Error error = application->start()) {
        const int code = refuse(platform::fault_of_start(settings.value().pack, error));
        return application->screen().may_come ? kFailed : code;
    }
    if (const base::Error changed = platform::confirm_pack(settings.value().pack))
        return refuse(platform::ConfigError{changed, true});
    const base::Surface& surface = application->surface();
    if (line.shot != nullptr)
        if (const base::Error error = snapshot.start(line.shot, surface.width(), surface.height())) return refuse(error);
    print_start(*application, line.json, out, test);
    say_age(settings.value().pack, machine_clocks());
    const RunReport report = application->run(line.frames, stop);
    print_end(report, line.json, out);
    return report.end == RunEnd::stopped ? kDone : kFailed;
}

/// With a board file its own set-up is tested first.
int test_machine(const CommandLine& line, std::FILE* out) {
    SelfTestReport report;
    if (line.config != nullptr) {
        const auto settings = settings_of(line);
        if (!settings.ok()) return refuse(settings.error());
        report.add("board_file", true, settings.value().title.view());
        check_board(settings.value(), report);
    }
    run_self_test(embedded_inputs(), report);
    print_self_test(report, line.json, out);
    return report.holds() ? kDone : kFailed;
}

int probe(const CommandLine& line, std::FILE* out) {
    SelfTestReport report;
    const ProbePorts ports = machine_probe_ports();
    if (line.config == nullptr) {
        list_offer(ports, report);
        print_offer(report, line.json, out);
        return kDone;
    }
    const auto settings = settings_of(line);
    if (!settings.ok()) return refuse(settings.error());
    report.add("board_file", true, settings.value().title.view());
    probe_board(settings.value(), ports, report);
    print_checks(report, "probe", line.json, out);
    return report.holds() ? kDone : kFailed;
}

int calibrate(const CommandLine& line, std::FILE* out) {
    const auto settings = settings_of(line);
    if (!settings.ok()) return refuse(settings.error());
    const StopSignal stop;
    const CalibrateRequest request{line.output, line.rounds, line.json};
    const base::Error error = calibrate_board(settings.value(), request, {machine_clocks(), EventLog()}, stop, out);
    if (!error) return kDone;
    const int code = refuse(error);
    return stop.requested() ? kStopped : code;
}

int write_board_shaders(const CommandLine& line, std::FILE* out) {
    const auto settings = settings_of(line);
    if (!settings.ok()) return refuse(settings.error());
    const StopSignal stop;
    const base::Error error = write_shaders(settings.value(), line.shaders, stop, line.json, out);
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
        case Request::probe: return probe(line.value(), out);
        case Request::calibrate: return calibrate(line.value(), out);
        case Request::write_shaders: return write_board_shaders(line.value(), out);
        case Request::run: break;
    }
    return run_display(line.value(), out);
}

}  // namespace tedavis::target
