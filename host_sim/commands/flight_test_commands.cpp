#include "host_sim/commands/command_groups.hpp"

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
                        "and the frame's record");
}

void add_bus(CLI::App& app, CommandLine& line) {
    CLI::App* const bus = app.add_subcommand("bus", "frames of the aircraft's bus");
    bus->require_subcommand(1);
    BusEncodeOptions& o = line.bus_encode;
    CLI::App* command = add_command(*bus, line, "encode", "prints frames as candump does",
                                    [&o](Console& console) { return run_bus_encode(o, console); });
    command
        ->add_option("VALUE", o.values,
                     "signal=value with the unit in the name (indicated_airspeed_kt=90), phase=approach.final, phase_source=fms")
        ->required();
    command->add_option("--at", o.at_s, "stamp of the first frame, s")->check(CLI::Range(0.0, 4e9))->capture_default_str();
    command->add_option("--interface", o.interface_name, "name of the interface")->capture_default_str();
    command->add_option("--bus", o.bus, "bus file or shipped name: how values are written")->capture_default_str();
}

}  // namespace

void add_tests(CLI::App& app, CommandLine& line) {
    add_verify(app, line);
    add_bus(app, line);
}

}  // namespace tedavis::host_sim
