#include "host_sim/reports/run_frames.hpp"

#include <filesystem>

#include "host_sim/input_file.hpp"
#include "host_sim/reports/run_folder.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

std::string record_text(const RunRecords::Json& record, const char* key) {
    return record.contains(key) && record[key].is_string() ? record[key].get<std::string>() : std::string();
}

}  // namespace

std::string phase_of_record(const RunRecords::Json& record) {
    const std::string sub = record_text(record, "sub_phase");
    return record_text(record, "phase") + (sub.empty() ? "" : "." + sub);
}

RunFrame read_run_frame(const RunRecords::Json& record, const RunRecords& records, const std::string& folder) {
    if (!record.contains("time_s") || !record["time_s"].is_number())
        throw UserError(records.path() + ":" + std::to_string(records.line()) +
                        ": a record without time_s; replay the run again");
    RunFrame frame;
    frame.frame = record["frame"].get<std::uint64_t>();
    frame.time_s = record["time_s"].get<double>();
    frame.phase = phase_of_record(record);
    frame.picture = frame_picture_path(folder, frame.frame);
    return frame;
}

RunRecords::Json summary_of_run(const std::string& folder) {
    const std::string path = folder + "/" + kSummaryName;
    if (!std::filesystem::exists(path)) return {};
    RunRecords::Json summary = RunRecords::Json::parse(read_file(path), nullptr, false);
    if (!summary.is_object()) throw UserError(path + ": no summary of a run; replay the run again");
    return summary;
}

std::optional<std::string> file_of_run(const std::string& folder, const std::string& name) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    if (name.empty()) return std::nullopt;
    std::vector<fs::path> places = {fs::path(folder) / fs::path(name).filename()};
    if (fs::path(name).is_relative())
        for (fs::path above = fs::weakly_canonical(folder, ignored); above.has_relative_path(); above = above.parent_path())
            places.push_back(above / name);
    places.emplace_back(name);
    for (const fs::path& place : places)
        if (fs::is_regular_file(place, ignored)) return place.string();
    return std::nullopt;
}

}  // namespace tedavis::host_sim
