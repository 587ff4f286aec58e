#include "host_sim/commands/command_groups.hpp"
#include "host_sim/flight_test/read_steps.hpp"

namespace tedavis::host_sim {
namespace {

void add_verify(CLI::App& app, CommandLine& line) {
    VerifyOptions& o = line.verify;
    CLI::App* command =
        add_long_command(app, line, "verify", "flight tests: frames and switches in, phase, source, flags and alerts out",
                         [&o](Console& console) { return run_verify(o, console); });
    command->add_option("SCRIPT", o.scripts,
                        "files, shipped names, or folders of them (configs/flight_tests/README.md); default: the shipped tests");
    command->add_option("--set", o.parameters, "name=value: a parameter of the scripts; may be repeated")
        ->allow_extra_args(false);
    command->add_option("--junit", o.junit, "file to write the results to as JUnit XML");
    command->add_option("-o", o.output,
                        "folder to write to: of each script that fails the picture of its first failing instant, "
                        "and the frame's record; of one on a board the record");
    command->add_option("--target", o.target, "flies against a running tedavis-display: its record socket; needs --board");
    command->add_option("--board", o.board, "board file of that display, whose bus and panel the scripts then have");
    command->add_option("--interface", o.interface_name, "CAN interface to send on; default: the board file's");
    command->add_option(
        "--panel-lines", o.panel_lines,
        "folder with sim_gpioN/pull of the lines of the board's panel (gpio-sim), for scripts that throw switches");
    command->add_flag("--strict", o.strict, "on a board: what cannot be judged, and a script that is left out, has not passed");
}

/// The log, and what a script can say of its display; defaults are those of scripts.
void add_recorded_flight(CLI::App* command, RecordOptions& o) {
    command->add_option("LOG", o.input,
                        "candump log, folder of a replay or of a generated flight, or shipped scenario, such as default; "
                        "leave it out where --target is given");
    command->add_option("--switches", o.switches, "switch log; default: none, or that of the folder");
    command->add_option("--switch-config", o.switch_config, "panel, file or shipped name; default: one_hot");
    command->add_option("--bus", o.bus, "bus file or shipped name: how the frames are read; default: canaerospace");
    command->add_option("--design", o.design, "design file or shipped name; default: that of the replay, else default");
    command->add_option("--device", o.device, "device file or shipped name; default: that of the replay, else es2-small");
    command->add_option("--aircraft", o.aircraft, "aircraft file or shipped name; default: that of the replay, else none");
    command->add_option("--terrain", o.terrain, "terrain database (.tdb), or jacksboro, which is built; default likewise");
    command->add_option("--scene", o.scene, "scene database (.sdb); default: that of the replay or generated flight, else none");
}

void add_record(CLI::App& app, CommandLine& line) {
    RecordOptions& o = line.record;
    CLI::App* command = add_long_command(app, line, "record", "a flight as a flight test, which expects what it shows today",
                                         [&o](Console& console) { return run_record(o, console); });
    add_recorded_flight(command, o);
    command->add_option("-o", o.output, "script to write (.toml), to be edited and flown by verify")->required();
    CLI::Option* from = add_optional(command, "--from", o.from_s,
                                     "earliest frame, in seconds since the log's first; default: 0, or the replay's");
    CLI::Option* to = add_optional(command, "--to", o.to_s, "latest frame; default: the log's end, or the replay's last frame");
    from->check(CLI::Range(0.0, kLatestTestTime_s));
    to->check(CLI::Range(0.0, kLatestTestTime_s));
    command->add_option("--at", o.at_s, "what is shown at this time alone, s; may be repeated")
        ->allow_extra_args(false)
        ->check(CLI::Range(0.0, kLatestTestTime_s))
        ->excludes(from)
        ->excludes(to);
    command->add_option("--margin", o.margin_s, "seconds by which a change may come earlier or later (README.md of flight_tests)")
        ->check(CLI::Range(0.0, 60.0))
        ->capture_default_str();
    command->add_flag("--yes", o.yes, "replaces a script that is there already, and with --target its log");
    command->add_option(
        "--target", o.target,
        "a running tedavis-display by its record socket, instead of LOG; its bus is written as a log beside the script");
    command->add_option("--board", o.board, "board file of that display");
    command->add_option("--interface", o.interface_name, "CAN interface to listen to; default: the board file's");
    command->add_option("--for", o.for_s, "seconds to listen to it")
        ->check(CLI::Range(10.0, kLatestTestTime_s))
        ->capture_default_str();
}

void add_bus(CLI::App& app, CommandLine& line) {
    CLI::App* const bus = app.add_subcommand("bus", "frames of the aircraft's bus");
    bus->require_subcommand(1);
    BusEncodeOptions& o = line.bus_encode;
    CLI::App* command = add_command(*bus, line, "encode", "prints frames as candump does",
                                    [&o](Console& console) { return run_bus_encode(o, console); });
    command
        ->add_option("VALUE", o.values,
                     "signal=value with the unit in the name (indicated_airspeed_kt=90), phase=approach.final, phase_origin=fms")
        ->required();
    command->add_option("--at", o.at_s, "stamp of the first frame, s")->check(CLI::Range(0.0, 4e9))->capture_default_str();
    command
        ->add_option(
            "--code", o.code,
            "message code of the first frame of each identifier: a receiver drops a message that repeats the code before "
            "it, so count on by one for each you send")
        ->check(CLI::Range(0u, 255u))
        ->capture_default_str();
    command->add_option("--interface", o.interface_name, "name of the interface")->capture_default_str();
    command->add_option("--bus", o.bus, "bus file or shipped name: how values are written")->capture_default_str();
}

}  // namespace

void add_tests(CLI::App& app, CommandLine& line) {
    add_verify(app, line);
    add_record(app, line);
    add_bus(app, line);
}

}  // namespace tedavis::host_sim
