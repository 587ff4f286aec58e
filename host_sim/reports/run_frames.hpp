/// Reads the frames of a run, ascending in time, with the entries that every reader of its records needs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/reports/run_records.hpp"

namespace tedavis::host_sim {

struct RunFrame {
    std::uint64_t frame = 0;
    double time_s = 0;    ///< since the log's first frame
    std::string phase;    ///< "approach.final"; empty where the record has none
    std::string picture;  ///< path of the picture; read_run_frame() does not check that the file exists
};

/// "approach.final" of a record; empty where it has none.
[[nodiscard]] std::string phase_of_record(const RunRecords::Json& record);

/// Converts the record that `records` has read last. Throws UserError where it has no time.
[[nodiscard]] RunFrame read_run_frame(const RunRecords::Json& record, const RunRecords& records, const std::string& folder);

/// Reads all frames. `Frame` is derived from RunFrame; `read(record, frame)` fills in its further members from the record. Throws
/// UserError where the folder holds no run, and what `read` throws.
template <class Frame, class Read>
[[nodiscard]] std::vector<Frame> frames_of_run(const std::string& folder, Read read) {
    std::vector<Frame> frames;
    RunRecords records(folder);
    while (const std::optional<RunRecords::Json> record = records.next()) {
        Frame& frame = frames.emplace_back();
        static_cast<RunFrame&>(frame) = read_run_frame(*record, records, folder);
        read(*record, frame);
    }
    std::stable_sort(frames.begin(), frames.end(), [](const Frame& a, const Frame& b) { return a.time_s < b.time_s; });
    return frames;
}

/// `summary.json`, null where there is none, as in a run that was interrupted. Throws UserError where it is no object.
[[nodiscard]] RunRecords::Json summary_of_run(const std::string& folder);

/// Finds a file that the summary names, such as the terrain. Files that `fly` wrote lie in the folder of the run, which may have
/// been moved since. A relative name is relative to the working folder of that time, so it is searched in the folder of the run,
/// in those above it, and in the working folder; an absolute one in the folder of the run and at its path. Nothing where there is
/// no such file.
[[nodiscard]] std::optional<std::string> file_of_run(const std::string& folder, const std::string& name);

}  // namespace tedavis::host_sim
