/// How far a build has come, on disk: records that are only appended, each with a checksum; the last whole one counts.
#pragma once

#include <cstdint>
#include <string>

#include "host_sim/terrain_builder/import_posts.hpp"
#include "host_sim/terrain_builder/work_file.hpp"

namespace tedavis::host_sim {

/// Everything of stages before `stage` is done, and tasks 0..next-1 of it.
struct BuildRecord {
    std::uint32_t stage = 0, next = 0;
    std::uint64_t end = 0;  ///< of what was appended to the database
    PostStatistics statistics;
};

class BuildJournal {
public:
    /// Opens the journal of a work folder. `key` names inputs and options: a folder of another key, or one whose journal
    /// cannot be read, is emptied. Throws UserError.
    BuildJournal(const std::string& folder, std::uint64_t key);

    [[nodiscard]] const BuildRecord& last() const { return last_; }
    [[nodiscard]] bool resumes() const { return records_ > 1; }
    /// On disk when this returns; what it speaks of must be there already.
    void append(const BuildRecord& record);

private:
    bool read_records(std::uint64_t key);

    WorkFile file_;
    std::uint64_t records_ = 0;
    BuildRecord last_;
};

}  // namespace tedavis::host_sim
