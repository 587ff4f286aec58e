#include "host_sim/commands/accuracy.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "host_sim/accuracy/accuracy_json.hpp"
#include "host_sim/accuracy/accuracy_page.hpp"
#include "host_sim/accuracy/accuracy_text.hpp"
#include "host_sim/accuracy/compare_accuracy.hpp"
#include "host_sim/accuracy/knobs/flown_knob.hpp"
#include "host_sim/accuracy/knobs/knob_flight.hpp"
#include "host_sim/accuracy/knobs/knob_registry.hpp"
#include "host_sim/accuracy/knobs/ray_search_knobs.hpp"
#include "host_sim/accuracy/measure_knob.hpp"
#include "host_sim/atomic_file.hpp"
#include "host_sim/commands/accuracy_flights.hpp"
#include "host_sim/input_file.hpp"
#include "host_sim/interrupt.hpp"
#include "host_sim/json_text.hpp"
#include "host_sim/new_folder.hpp"
#include "host_sim/options/replay_options.hpp"
#include "host_sim/replay/display_session.hpp"
#include "host_sim/replay/index_key.hpp"
#include "host_sim/user_error.hpp"
#include "platform/clock/monotonic_clock.hpp"

namespace tedavis::host_sim {
namespace {

constexpr const char* kJsonName = "/accuracy.json";
constexpr const char* kCsvName = "/accuracy.csv";
constexpr const char* kPageName = "/report.html";
constexpr const char* kPictureFolder = "/pictures/";
constexpr std::size_t kRounds = 31, kQuickRounds = 11;
constexpr std::size_t kMoments = 120, kLinePoses = 60, kQuickEffectPoses = 3;
constexpr std::uint32_t kPlacesAcross = 192;  ///< of a frame of a full run
constexpr const char* kOwnCommand = "tedavis accuracy ";
constexpr std::uint32_t kSmallestSide_px = 64;
constexpr double kGovernorRate_hz = 10, kQuickGovernorRate_hz = 2;  ///< frames of the flight
constexpr double kKnob_s = 120, kQuickKnob_s = 8;                   ///< for the rounds of a knob

double clock_ms() { return static_cast<double>(platform::monotonic_now().ns) * 1e-6; }

/// What is measured, and by which displays.
std::string input_options(const AccuracyOptions& options) {
    std::string text;
    for (const std::string& terrain : options.terrains) text += " --terrain " + terrain;
    for (const std::string& flight : options.flights) text += " --flight " + flight;
    for (const std::string& switches : options.switches) text += " --switches " + switches;
    const FlownDisplay usual, &display = options.display;
    if (size_word(display.size) != size_word(usual.size)) text += " --size " + size_word(display.size);
    if (display.device != usual.device) text += " --device " + display.device;
    if (display.design != usual.design) text += " --design " + display.design;
    return text;
}

/// That makes such a report again.
std::string command_of(const AccuracyOptions& options) {
    std::string command = "tedavis accuracy -o " + options.output;
    if (options.is_quick) command += " --quick";
    command += input_options(options);
    for (const std::string& knob : options.knobs) command += " --knob " + knob;
    if (!options.costs.empty()) command += " --costs " + options.costs;
    if (options.is_control_only) command += " --negative-control";
    for (const std::string& file : options.compare) command += " --compare " + file;
    return command;
}

/// Calls `use(picture)` for each picture of the report.
template <class Report, class Use>
void for_each_picture(Report& report, const Use& use) {
    for (auto& knob : report.knobs)
        if (knob.pictures)
            for (const auto& [what, picture] : named_pictures(*knob.pictures)) use(*picture);
}

/// What an earlier run has left in the folder, with its conditions; without one a report of nothing.
AccuracyReport begun_report(const std::string& folder, const MeasuringConditions& now) {
    const std::string path = folder + kJsonName;
    AccuracyReport earlier;
    if (std::filesystem::exists(path)) earlier = read_accuracy(read_file(path), path);
    for_each_picture(earlier, [&](ReportPicture& picture) { picture.png = read_file(folder + kPictureFolder + picture.file); });
    earlier.interrupted = false;
    if (earlier.knobs.empty()) earlier.conditions = now;
    if (!are_of_one_kind(earlier.conditions, now))
        throw UserError(
            path +
            ": was measured with another program, machine, terrain, flight, display or extent, which cannot stand in one "
            "report; name another folder with -o");
    return earlier;
}

const MeasuredKnob* knob_of(const AccuracyReport& report, const std::string& name) {
    const auto found =
        std::find_if(report.knobs.begin(), report.knobs.end(), [&](const auto& knob) { return knob.name == name; });
    return found == report.knobs.end() ? nullptr : &*found;
}

void write_report(const AccuracyReport& report, const std::string& folder) {
    std::filesystem::create_directories(folder + kPictureFolder);
    for_each_picture(report, [&](const ReportPicture& picture) {
        write_file_atomically(folder + kPictureFolder + picture.file, {picture.png.data(), picture.png.size()});
    });
    AtomicFile json(folder + kJsonName), csv(folder + kCsvName), page(folder + kPageName);
    json.stream() << json_text(accuracy_json(report), 1) << "\n";
    csv.stream() << accuracy_csv(report);
    page.stream() << accuracy_page(report);
    for (AtomicFile* const file : {&json, &csv, &page}) file->seal();
    for (AtomicFile* const file : {&json, &csv, &page}) file->commit();
}

/// Takes the place of the knob's earlier figures, in the registry's order.
void put(const MeasuredKnob& measured, AccuracyReport& report) {
    std::vector<MeasuredKnob> ordered;
    for (const RegisteredKnob& known : knob_registry())
        if (known.name == measured.name)
            ordered.push_back(measured);
        else if (const MeasuredKnob* const kept = knob_of(report, known.name))
            ordered.push_back(*kept);
    report.knobs = std::move(ordered);
}

class AccuracyRun {
public:
    AccuracyRun(const AccuracyOptions& options, Console& console) : options_(options), console_(console) {}

    /// False where the user has stopped it.
    bool measure(const std::vector<RegisteredKnob>& knobs, const KnobGround& ground, AccuracyReport& report) {
        for (std::size_t n = 0; n < knobs.size(); ++n) {
            if (knob_of(report, knobs[n].name) != nullptr) continue;
            try {
                put(measured(knobs[n], ground, n, knobs.size()), report);
            } catch (const Interrupted&) {
                report.interrupted = true;
                break;
            }
            write_report(report, options_.output);
        }
        console_.progress_done();
        return !report.interrupted;
    }

    /// The chapters beside the knobs, each once. False where the user has stopped it.
    bool measure_chapters(const std::vector<MeasuredFlight>& flights, AccuracyReport& report) {
        const KnobGround ground = flights.front().knob_ground(options_);
        try {
            std::vector<KnobGround> asked;
            if (ground.recorded != nullptr) asked.push_back({ground.ground, ground.is_quick, nullptr, ground.display});
            for (const MeasuredFlight& flight : flights) asked.push_back(flight.knob_ground(options_));
            report.flights = errors_over(asked, report.flights);
            for (const KnobGround& flown : asked) add_flight_errors(flown, report);
            if (!report.uncalled) report.uncalled = uncalled(ground);
            if (!report.control) report.control = measure_control(*make_ray_control(ground));
        } catch (const Interrupted&) {
            report.interrupted = true;
        }
        console_.progress_done();
        return !report.interrupted;
    }

    /// Alone. False where the user has stopped it; since it is short, it is whole then, too, and the report lacks nothing.
    bool measure_control_alone(const KnobGround& ground, AccuracyReport& report) {
        report.control = measure_control(*make_ray_control(ground));
        return !interrupt_.requested();
    }

    /// By the costs that the user gave, with the frames of the flight. False where the user has stopped it.
    bool measure_governor(const KnobGround& ground, AccuracyReport& report) {
        KnobFlight flight(ground);
        PictureOptions picture;
        picture.terrain = ground.ground.path();
        picture.design = ground.display.design;
        picture.scene = flight.scene();
        GovernorChoicePlan plan{options_.budget_ms, options_.is_quick ? kQuickGovernorRate_hz : kGovernorRate_hz, {}};
        plan.progress = progress_of("frames of the governor");
        try {
            report.governor = governor_choice(options_.costs, picture, flight, plan);
        } catch (const Interrupted&) {
            report.interrupted = true;
        }
        console_.progress_done();
        return !report.interrupted;
    }

private:
    std::function<void(std::size_t, std::size_t)> progress_of(const char* what) {
        return [this, what](std::size_t done, std::size_t total) {
            console_.progress(what, done, total);
            if (interrupt_.requested()) throw Interrupted("interrupted");
        };
    }

    /// Of a flight that the report does not have yet.
    void add_flight_errors(const KnobGround& ground, AccuracyReport& report) {
        if (errors_over(ground, report.flights) != nullptr) return;
        FlightErrorsPlan plan;
        if (!options_.is_quick) plan = {kMoments, kLinePoses, kPlacesAcross, {}};
        plan.progress = progress_of("error along the flight");
        report.flights.push_back(measure_flight_errors(ground, plan));
        write_report(report, options_.output);
    }

    UncalledEffects uncalled(const KnobGround& ground) {
        KnobFlight flight(ground);
        PictureOptions picture = flown_level(ground.ground.path(), ground.display).picture;
        picture.scene = flight.scene();
        UncalledPlan plan;
        if (options_.is_quick) plan.poses = kQuickEffectPoses;
        plan.progress = progress_of("effects");
        return measure_uncalled(flight, picture, plan);
    }

    MeasuredKnob measured(const RegisteredKnob& registered, const KnobGround& ground, std::size_t number, std::size_t count) {
        const std::unique_ptr<Knob> knob = registered.make(ground);
        MeasuringPlan plan;
        plan.rounds = options_.is_quick ? kQuickRounds : kRounds;
        plan.most_s = options_.is_quick ? kQuickKnob_s : kKnob_s;
        plan.clock_ms = clock_ms;
        plan.progress = [&](std::size_t done, std::size_t total) {
            console_.progress("knobs", number * total + done, count * total);
            if (interrupt_.requested()) throw Interrupted("interrupted");
        };
        MeasuredKnob found = measure_knob(*knob, plan);
        for (MeasuredLevel& level : found.levels) complete_command(level.worst_command);
        if (found.pictures) complete_command(found.pictures->place.command);
        return found;
    }

    /// A command of this program's own also needs what was measured.
    void complete_command(std::string& command) const {
        if (command.rfind(kOwnCommand, 0) == 0) command += (options_.is_quick ? " --quick" : "") + input_options(options_);
    }

    const InterruptGuard interrupt_;
    const AccuracyOptions& options_;
    Console& console_;
};

std::string answers(const AccuracyOptions& options, const AccuracyReport& report) {
    std::string text;
    if (options.budget_ms) text += budget_text(report, *options.budget_ms);
    if (options.target_error.empty()) return text;
    const TargetError target = target_from(options.target_error);
    return text + target_text(report, target.value, target.unit, "--target-error " + options.target_error);
}

void list_unmeasured(const std::vector<RegisteredKnob>& knobs, AccuracyReport& report) {
    report.not_measured.clear();
    for (const RegisteredKnob& knob : knobs)
        if (knob_of(report, knob.name) == nullptr) report.not_measured.push_back(knob.name);
}

/// Of the GL that draws the knobs' pictures. Throws UserError where the device or the design cannot be drawn with.
std::string renderer(const FlownDisplay& display) {
    PictureOptions picture = flown_level("", display).picture;
    picture.gl = offered_gl();
    return DisplaySession(picture, true).gl_description();
}

void require_room_for_levels(const FlownDisplay& display) {
    if (std::min(display.size.width, display.size.height) < kSmallestSide_px)
        throw UserError("--size " + size_word(display.size) + ": a quarter of it is too small a picture; give 64x64 or more");
    static_cast<void>(seen_grid(display));
}

MeasuredInputs inputs_of(const AccuracyOptions& options, const MeasuredFlight& flight) {
    MeasuredInputs inputs;
    inputs.terrain = flight.terrain;
    inputs.terrain_identity = terrain_identity(&flight.ground->database());
    if (flight.recorded) {
        inputs.flight = flight.recorded->log;
        inputs.flight_identity = flight.recorded->identity;
    }
    inputs.size = size_text(options.display.size);
    inputs.device = options.display.device;
    inputs.design = options.display.design;
    inputs.display_identity = identity_of(options.display);
    inputs.is_quick = options.is_quick;
    return inputs;
}

/// Before anything is measured, so that a wrong name costs no time.
std::vector<std::pair<std::string, AccuracyReport>> earlier_reports(const std::vector<std::string>& files) {
    std::vector<std::pair<std::string, AccuracyReport>> reports;
    for (const std::string& file : files) reports.emplace_back(file, read_accuracy(read_file(file), file));
    return reports;
}

/// Returns 1 if an error lies above its proven bound, a skipped effect can be seen or did work, the negative control was not
/// caught, or a comparison is worse; 0 otherwise.
int verdict_on(const AccuracyReport& report) {
    const auto holds = [](const FlightErrors& flight) { return flight.holds(); };
    if (!std::all_of(report.flights.begin(), report.flights.end(), holds)) return 1;
    if (report.uncalled && !report.uncalled->keep_promise()) return 1;
    const bool is_worse_now = std::any_of(report.comparisons.begin(), report.comparisons.end(), is_worse);
    return (report.control && !report.control->is_caught) || is_worse_now ? 1 : 0;
}

}  // namespace

TargetError target_from(const std::string& text) {
    char* end = nullptr;
    TargetError target;
    target.value = std::strtod(text.c_str(), &end);
    const std::string rest = end;
    const std::size_t unit = rest.find_first_not_of(' ');
    if (!(target.value > 0) || unit == std::string::npos)
        throw UserError("--target-error " + text + ": is no error above 0 with its unit; write it as \"0.5 px\"");
    target.unit = rest.substr(unit);
    return target;
}

int run_accuracy(const AccuracyOptions& options, Console& console) {
    const std::vector<RegisteredKnob> knobs =
        options.is_control_only ? std::vector<RegisteredKnob>() : chosen_knobs(options.knobs);
    if (!options.target_error.empty()) static_cast<void>(target_from(options.target_error));
    const auto earlier = earlier_reports(options.compare);
    if (!options.costs.empty()) static_cast<void>(read_costs(options.costs));
    require_pairs(options);
    require_room_for_levels(options.display);
    const std::string drawn_by = renderer(options.display);
    NewFolder folder(options.output);
    const std::unique_ptr<base::Workers> workers = trace_workers(0);
    const std::vector<MeasuredFlight> flights = read_flights(options, *workers, console);
    const KnobGround ground = flights.front().knob_ground(options);
    const MeasuringConditions now = conditions_now(command_of(options), drawn_by, inputs_of(options, flights.front()));
    AccuracyReport report = begun_report(options.output, now);
    const ComparisonLimits limits = {options.slower_percent / 100, options.less_accurate_percent / 100};
    for (const auto& [file, old] : earlier) static_cast<void>(compare_accuracy(report, old, file, limits));  // of one kind?
    report.budget_ms = options.budget_ms;
    AccuracyRun run(options, console);
    require_uninterrupted(options.output);  // also where nothing is left to be measured
    bool is_whole = run.measure(knobs, ground, report);
    list_unmeasured(knobs, report);
    if (options.is_control_only)
        is_whole = run.measure_control_alone(ground, report);
    else if (is_whole && options.knobs.empty())
        is_whole = run.measure_chapters(flights, report);
    if (is_whole && !options.costs.empty()) is_whole = run.measure_governor(ground, report);
    report.comparisons.clear();
    for (const auto& [file, old] : earlier) report.comparisons.push_back(compare_accuracy(report, old, file, limits));
    write_report(report, options.output);
    folder.keep();
    console.result(accuracy_text(report) + answers(options, report) + "\n\n" + options.output + kPageName,
                   json_text(accuracy_json(report)));
    return is_whole ? verdict_on(report) : kInterruptedExitCode;
}

}  // namespace tedavis::host_sim
