#include "host_sim/commands/record_input.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "host_sim/reports/run_folder.hpp"
#include "host_sim/reports/run_frames.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

namespace fs = std::filesystem;

bool is_file(const std::string& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

/// A file of a folder; empty where there is none.
std::string file_of_folder(const std::string& folder, const char* name) {
    const std::string path = (fs::path(folder) / name).string();
    return is_file(path) ? path : "";
}

void fill(std::string& target, const std::string& otherwise) {
    if (target.empty()) target = otherwise;
}

/// What a replay wrote names what it was made of.
class RecordedRun {
public:
    explicit RecordedRun(const std::string& folder) : folder_(folder), summary_(summary_of_run(folder)) {}

    void fill_in(FlightTest& test) const {
        test.log = file("log");
        fill(test.switch_log, file("switches"));
        PictureOptions& picture = test.picture;
        fill(picture.terrain, file("terrain"));
        fill(picture.scene, file("scene"));
        fill(picture.design, config("design"));
        fill(picture.device, config("device"));
        fill(picture.aircraft, config("aircraft"));
    }

private:
    [[nodiscard]] std::string text(const char* key) const {
        return summary_.is_object() && summary_.contains(key) && summary_[key].is_string() ? summary_[key].get<std::string>()
                                                                                           : std::string();
    }
    [[nodiscard]] std::string file(const char* key) const {
        std::string name = text(key);
        if (name.empty()) return name;
        if (auto found = file_of_run(folder_, name)) return *found;
        throw UserError(folder_ + "/" + kSummaryName + ": its " + key + " " + name +
                        " is not there; put it back, or name the log itself");
    }
    /// A name without slash and dot is that of a shipped file.
    [[nodiscard]] std::string config(const char* key) const {
        const std::string name = text(key);
        return name.find('.') == std::string::npos ? name : file(key);
    }

    std::string folder_;
    nlohmann::ordered_json summary_;
};

void fill_from_folder(const std::string& folder, FlightTest& test) {
    if (!file_of_folder(folder, kSummaryName).empty()) {
        RecordedRun(folder).fill_in(test);
        if (test.log.empty()) throw UserError(folder + "/" + kSummaryName + ": names no log; name the log itself");
        return;
    }
    test.log = file_of_folder(folder, "flight.log");
    if (test.log.empty())
        throw UserError(folder + ": is neither the folder of a replay (" + kSummaryName +
                        ") nor that of a generated flight (flight.log); name a log");
    fill(test.switch_log, file_of_folder(folder, "flight.switches"));
    fill(test.picture.scene, file_of_folder(folder, "scene.sdb"));
}

}  // namespace

FlightTest recorded_input(const RecordOptions& options) {
    if (options.input.empty())
        throw UserError(
            "what to record is missing; name a log, a folder or a scenario, or --target with a display's record socket");
    FlightTest test;
    PictureOptions& picture = test.picture;
    picture.design = options.design;
    picture.device = options.device;
    picture.aircraft = options.aircraft;
    picture.terrain = options.terrain;
    picture.scene = options.scene;
    test.switch_log = options.switches;
    test.switch_config = options.switch_config;
    const bool is_name = options.input.find_first_of("./") == std::string::npos;
    std::error_code error;
    if (fs::is_directory(options.input, error))
        fill_from_folder(options.input, test);
    else if (is_name && !fs::exists(options.input, error))
        test.scenario = options.input;
    else
        test.log = options.input;
    if (!test.scenario.empty() && !options.switches.empty())
        throw UserError("--switches: the scenario " + test.scenario + " has its own; leave it out, or name a log");
    fill(picture.design, PictureOptions().design);
    fill(picture.device, "es2-small");
    fill(test.switch_config, "one_hot");
    picture.bus = options.bus.empty() ? PictureOptions().bus : options.bus;
    return test;
}

RecordedSpan recorded_span(const RecordOptions& options) {
    const bool is_of_run = !options.from_s && !options.to_s && !file_of_folder(options.input, kFrameRecordsName).empty();
    if (!is_of_run) return {options.from_s, options.to_s};
    const std::vector<RunFrame> frames = frames_of_run<RunFrame>(options.input, [](const RunRecords::Json&, RunFrame&) {});
    return {frames.front().time_s, frames.back().time_s};
}

}  // namespace tedavis::host_sim
