#include "host_sim/reports/frame_record_writer.hpp"

#include "host_sim/reports/run_folder.hpp"

namespace tedavis::host_sim {

FrameRecordWriter::FrameRecordWriter(const std::string& folder, base::Time origin)
    : file_(folder + "/" + kFrameRecordsName), origin_(origin) {}

void FrameRecordWriter::write(const FrameResult& result) {
    file_.stream() << frame_record_json(result, origin_) << '\n';
    ++written_;
}

void FrameRecordWriter::commit() { file_.commit(); }

}  // namespace tedavis::host_sim
