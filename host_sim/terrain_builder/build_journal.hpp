/// The progress of a build, on disk: appended records, each with a checksum, of which the last complete one is valid.
#pragma once

#include <cstdint>
#include <string>

#include "host_sim/terrain_builder/import_posts.hpp"
#include "host_sim/terrain_builder/work_file.hpp"

namespace tedavis::host_sim {

/// Everything of stages before `stage` is done, and tasks 0..next-1 of it.
struct BuildRecord {
    std::uint32_t stage = 0, next = 0;
    std::uint64_t end = 0;  ///< offset of the end of the appended parts in the database
    PostStatistics statistics;
};

class BuildJournal {
public:
    /// Opens the journal of a work folder. `key` identifies inputs and options: a folder with another key, or with a journal that
    /// cannot be read, is emptied. Throws UserError.
    BuildJournal(const std::string& folder, std::uint64_t key);

    [[nodiscard]] const BuildRecord& last() const { return last_; }
    [[nodiscard]] bool resumes() const { return records_ > 1; }
    /// Appends a record, which is on disk when this returns; the results that it states as done must be on disk before.
    void append(const BuildRecord& record);

private:
    bool read_records(std::uint64_t key);

    WorkFile file_;
    std::uint64_t records_ = 0;
    BuildRecord last_;
};

}  // namespace tedavis::host_sim
