#include "host_sim/reports/run_records.hpp"

#include "host_sim/reports/run_folder.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

RunRecords::RunRecords(const std::string& folder) : path_(folder + "/" + kFrameRecordsName), stream_(path_) {
    if (!stream_) throw UserError(path_ + ": cannot be read; name a folder that replay or fly wrote");
    if (stream_.peek() == std::ifstream::traits_type::eof()) throw UserError(path_ + ": holds no frame; replay the run again");
}

std::optional<RunRecords::Json> RunRecords::next() {
    std::string text;
    if (!std::getline(stream_, text)) return std::nullopt;
    ++line_;
    Json record = Json::parse(text, nullptr, false);
    if (!record.is_object() || !record.contains("frame") || !record["frame"].is_number_unsigned() || !record.contains("hash"))
        throw UserError(path_ + ":" + std::to_string(line_) + ": no frame record; replay the run again");
    return record;
}

}  // namespace tedavis::host_sim
