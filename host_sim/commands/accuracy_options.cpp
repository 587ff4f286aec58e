#include "host_sim/commands/command_groups.hpp"
#include "host_sim/commands/option_checks.hpp"
#include "host_sim/commands/option_texts.hpp"

namespace tedavis::host_sim {
namespace {

/// What is measured, and the displays that it is drawn with.
void add_accuracy_inputs(CLI::App& command, AccuracyOptions& o) {
    command
        .add_option("--terrain", o.terrains,
                    "terrain database (.tdb); may be given once for each --flight; default: built from the shipped raster")
        ->allow_extra_args(false);
    command
        .add_option("--flight", o.flights,
                    "candump log, whose poses are measured instead of those of the shipped flight; may be repeated: settings are "
                    "measured over the first one, and the terrain's error over all of them and the shipped flight")
        ->allow_extra_args(false);
    command.add_option("--switches", o.switches, "switch log of the first --flight; may be repeated for the next ones")
        ->allow_extra_args(false);
    command
        .add_option_function<std::string>(
            "--size", [&o](const std::string& text) { o.display.size = size_from(text); },
            "WIDTHxHEIGHT of the largest picture that the settings of a frame, the terrain's error, quality, size and rate are "
            "measured with")
        ->default_str("640x360");
    command.add_option("--device", o.display.device, "device file or shipped name that these pictures are drawn with")
        ->capture_default_str();
    command.add_option("--design", o.display.design, "design file or shipped name that these pictures are drawn with")
        ->capture_default_str();
}

/// What makes the exit code 1.
void add_accuracy_verdicts(CLI::App& command, AccuracyOptions& o) {
    command.add_flag("--negative-control", o.is_control_only,
                     "only a search that is wrong on purpose; ends with 1 if its figures do not show that it is wrong");
    command
        .add_option("--compare", o.compare,
                    "accuracy.json of an earlier run over the same terrain; may be repeated; ends with 1 if a level became worse")
        ->allow_extra_args(false);
    command.add_option("--max-slower", o.slower_percent, "percent by which a median time may grow beside --compare")
        ->check(CLI::Range(0.0, 10'000.0))
        ->capture_default_str();
    command.add_option("--max-less-accurate", o.less_accurate_percent, "percent by which an error may grow beside --compare")
        ->check(CLI::Range(0.0, 10'000.0))
        ->capture_default_str();
}

}  // namespace

void add_accuracy(CLI::App& app, CommandLine& line) {
    AccuracyOptions& o = line.accuracy;
    CLI::App* command =
        add_long_command(app, line, "accuracy", "what accuracy costs in time: errors and times of every setting's levels",
                         [&o](Console& console) { return run_accuracy(o, console); });
    command
        ->add_option("-o", o.output,
                     "folder for report.html, accuracy.json and accuracy.csv; a run that was stopped goes on there")
        ->required();
    command->add_flag("--quick", o.is_quick, "fewer samples and rounds");
    command->add_option("--knob", o.knobs, "only this setting; may be repeated; default: all")->allow_extra_args(false);
    add_accuracy_inputs(*command, o);
    command->add_option("--costs", o.costs,
                        "also says what the governor may choose by this file, which calibrate or tedavis-display --calibrate "
                        "wrote, and what it chooses along "
                        "the flight; its deadline is --budget-ms, or else the time of a frame at the device's rate");
    add_accuracy_verdicts(*command, o);
    add_optional(command, "--budget-ms", o.budget_ms,
                 "also says the most accurate level of each setting within so many milliseconds")
        ->check(above_zero());
    command->add_option(
        "--target-error", o.target_error,
        "also says the quickest level that keeps to an error, such as \"0.5 px\", of each setting with this unit");
}

}  // namespace tedavis::host_sim
