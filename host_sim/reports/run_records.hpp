/// Reads `frames.jsonl` of a run, one record at a time.
#pragma once

#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace tedavis::host_sim {

class RunRecords {
public:
    using Json = nlohmann::ordered_json;

    /// Throws UserError where the folder has no records, or none in them.
    explicit RunRecords(const std::string& folder);

    /// Returns the next record, which has `frame` and `hash`; nothing at the end. Throws UserError where a line is no record.
    [[nodiscard]] std::optional<Json> next();
    /// Line number of the last record, from 1.
    [[nodiscard]] std::uint64_t line() const { return line_; }
    [[nodiscard]] const std::string& path() const { return path_; }

private:
    std::string path_;
    std::ifstream stream_;
    std::uint64_t line_ = 0;
};

}  // namespace tedavis::host_sim
