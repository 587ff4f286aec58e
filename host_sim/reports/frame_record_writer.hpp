/// Writes `frames.jsonl`, one record per line. The file appears when the run is finished or ended by Ctrl-C; after commit()
/// every line in it is complete.
#pragma once

#include <cstdint>
#include <string>

#include "host_sim/atomic_file.hpp"
#include "host_sim/reports/frame_record_json.hpp"

namespace tedavis::host_sim {

class FrameRecordWriter {
public:
    /// `origin`: the source's time that `time_s` counts from. Throws UserError where the folder cannot be written.
    FrameRecordWriter(const std::string& folder, base::Time origin);
    void write(const FrameResult& result);
    void commit();
    [[nodiscard]] std::uint64_t written() const { return written_; }

private:
    AtomicFile file_;
    base::Time origin_;
    std::uint64_t written_ = 0;
};

}  // namespace tedavis::host_sim
