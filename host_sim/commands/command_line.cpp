#include "host_sim/commands/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <new>
#include <ostream>
#include <string>

#include "host_sim/commands/command_groups.hpp"
#include "host_sim/commands/option_texts.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/user_errors.hpp"
#include "host_sim/version.hpp"

namespace tedavis::host_sim {

CLI::App* add_command(CLI::App& parent, CommandLine& line, const std::string& name, const std::string& purpose,
                      std::function<int(Console&)> run) {
    CLI::App* command = parent.add_subcommand(name, purpose);
    command->add_flag("--json", line.json, "machine-readable result on stdout");
    command->callback([&line, run = std::move(run)] { line.run = run; });
    return command;
}

CLI::App* add_long_command(CLI::App& parent, CommandLine& line, const std::string& name, const std::string& purpose,
                           std::function<int(Console&)> run) {
    return add_command(parent, line, name, purpose, [run = std::move(run)](Console& console) {
        const InterruptGuard interrupt;
        return run(console);
    });
}

void add_class(CLI::App* command, std::optional<flight::AircraftClass>& aircraft, const std::string& otherwise) {
    static const std::map<std::string, flight::AircraftClass> kClasses{{"light", flight::AircraftClass::light},
                                                                       {"jet", flight::AircraftClass::jet},
                                                                       {"helicopter", flight::AircraftClass::helicopter},
                                                                       {"glider", flight::AircraftClass::glider}};
    command->add_option_function<std::string>(
        "--class", [&aircraft](const std::string& word) { aircraft = choice_from("--class", word, kClasses); },
        "light, jet, helicopter or glider: by it the motion tells the flight phase; default: " + otherwise);
}

void add_strict(CLI::App* command, bool& strict) {
    command->add_flag("--strict", strict, "exit code 1 where there is a warning");
}

namespace {

constexpr int kDone = 0, kWrongUsage = 2;

void add_compare(CLI::App& app, CommandLine& line) {
    static const std::map<std::string, Alignment> kAlignments{
        {"time", Alignment::time}, {"place", Alignment::place}, {"takeoff", Alignment::takeoff}};
    CompareOptions& o = line.compare;
    CLI::App* command = add_command(app, line, "compare", "two runs, of two designs or two flights, on one page",
                                    [&o](Console& console) { return run_compare(o, console); });
    command->add_option("RUN_A", o.run_a, "folder that replay or fly wrote")->required();
    command->add_option("RUN_B", o.run_b, "another one")->required();
    command->add_option("-o", o.output, "page to write (HTML); compare.json, the aligned instants, is written beside it")
        ->required();
    command->add_option_function<std::string>(
        "--align", [&o](const std::string& word) { o.align.by = choice_from("--align", word, kAlignments); },
        "time (of one log, else UTC), place (the nearest on the other track), or takeoff (time since it); default: the first of "
        "them that the runs share");
    add_optional(
        command, "--within", o.align.within_m,
        "metres that counterparts are apart at most where places are aligned; default: 3000; not with --align time or takeoff")
        ->check(CLI::Range(1.0, 1e6));
}

void add_comparisons(CLI::App& app, CommandLine& line) {
    DiffOptions& d = line.diff;
    CLI::App* diff = add_command(app, line, "diff", "the first frame in which two runs differ",
                                 [&d](Console& console) { return run_diff(d, console); });
    diff->add_option("RUN_A", d.run_a, "folder that replay or fly wrote")->required();
    diff->add_option("RUN_B", d.run_b, "another one")->required();
    add_compare(app, line);
    CheckOptions& c = line.check;
    CLI::App* check = add_command(app, line, "check", "validates configuration files, databases and logs",
                                  [&c](Console& console) { return run_check(c, console); });
    check->add_option("FILE", c.files, "any file that the programs read")->required();
    check->add_option("--bus", c.bus, "bus file or shipped name: how the frames of logs are read")->capture_default_str();
    check->add_option("--switch-config", c.switch_config,
                      "panel of switch logs, file or shipped name; default: the shipped one that fits best");
    check->add_flag("--resolved", c.resolved,
                    "prints one design, a file or a shipped name, with all that it inherits by based_on, as a file of its own");
    add_strict(check, c.strict);
    EvaluateOptions& e = line.evaluate;
    CLI::App* evaluate =
        add_long_command(app, line, "evaluate", "clutter and saliency of pictures, of a flight, or of two designs",
                         [&e](Console& console) { return run_evaluate(e, console); });
    evaluate
        ->add_option("INPUT", e.inputs,
                     "pictures (PNG, JPEG) of any software, folders that sheet wrote; or a folder that replay wrote, with its "
                     "pictures; or two of them over the same flight, which are compared")
        ->required();
    evaluate->add_option("-o", e.output, "folder to write to: evaluation.json, views of pictures or peaks, report.html of runs")
        ->required();
    evaluate->add_option("--orderings", e.orderings,
                         "what is reported of pictures, to hold theirs against: file or shipped name, such as thesis");
    evaluate->add_option_function<std::string>(
        "--canny", [&e](const std::string& text) { e.canny = canny_from(text); },
        "sigma,low,high: blur in px and thresholds on the gradient of 8-bit channels by which edges are clutter; default: "
        "1,70,170, or what the orderings state");
    evaluate->add_option("--fixations", e.fixations,
                         "recorded gaze (CSV with columns x,y in pixels or 0..1; file with several pictures; time_s with a run): "
                         "scores the saliency maps by AUC and NSS");
    ContractOptions& k = line.contract;
    CLI::App* contract = add_long_command(app, line, "contract", "whether the pictures of a run keep a perceptual contract",
                                          [&k](Console& console) { return run_contract(k, console); });
    contract->add_option("RUN", k.run, "folder that replay wrote, with its pictures; best with --layers")->required();
    contract->add_option("CONTRACT", k.contract, "file or shipped name, such as default")->required();
    contract->add_option("-o", k.output, "folder to write to: contract.json, views of the worst moment of what does not hold");
    contract->add_option("--threads", k.threads, "that measure; default: as many as there are processors")
        ->check(CLI::Range(1, 256));
}

/// Messages may span lines and quote what a broken file holds; the contract is one line that a terminal can show.
std::string one_sentence(std::string text) {
    constexpr std::size_t kLongest = 1000;
    for (char& c : text) {
        if (c == '\n' || c == '\r' || c == '\t') c = ' ';
        if (static_cast<unsigned char>(c) < 32 || c == 127) c = '?';
    }
    if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

bool has_command(const CLI::App& app, const std::string& name) {
    const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
    return std::any_of(commands.begin(), commands.end(), [&](const CLI::App* command) { return command->check_name(name); });
}

int parse_and_run(int argc, const char* const* argv, std::ostream& results, std::ostream& notes, bool live,
                  std::istream* answers) {
    CommandLine line;
    CLI::App app("tedavis: recorded flights through a synthetic-vision display. Not certified for use in flight.", "tedavis");
    app.set_version_flag("--version", std::string("tedavis ") + version());
    app.require_subcommand(1);
    add_fly(app, line);
    add_builders(app, line);
    add_displays(app, line);
    add_comparisons(app, line);
    add_tests(app, line);
    if (argc > 1 && argv[1][0] != '-' && !has_command(app, argv[1])) {
        throw UserError(std::string(argv[1]) + ": no such command; tedavis --help lists them");
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& request) {
        app.exit(request, results, notes);  // --help, --version
        return kDone;
    } catch (const CLI::ParseError& error) {
        notes << "tedavis: " << one_sentence(error.what()) << "; see tedavis --help\n";
        return kWrongUsage;
    }
    Console console(results, notes, line.json, live);
    console.set_answers(answers);
    return line.run(console);
}

}  // namespace

int run_command_line(int argc, const char* const* argv, std::ostream& results, std::ostream& notes, bool live,
                     std::istream* answers) {
    try {
        return parse_and_run(argc, argv, results, notes, live, answers);
    } catch (const UserErrors& errors) {
        for (const std::string& message : errors.sentences()) notes << "tedavis: " << one_sentence(message) << '\n';
    } catch (const UserError& error) {
        notes << "tedavis: " << one_sentence(error.what()) << '\n';
    } catch (const Interrupted& interrupted) {
        notes << "tedavis: " << interrupted.what() << '\n';
        return kInterruptedExitCode;
    } catch (const std::bad_alloc&) {
        notes << "tedavis: not enough memory for this input; split it\n";
    } catch (const std::exception& error) {
        notes << "tedavis: " << error.what() << "; please report this\n";
    }
    return kWrongUsage;
}

}  // namespace tedavis::host_sim
