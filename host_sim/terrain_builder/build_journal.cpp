#include "host_sim/terrain_builder/build_journal.hpp"

#include <cstddef>
#include <cstring>
#include <filesystem>

#include "host_sim/atomic_file.hpp"
#include "host_sim/terrain_builder/part_store.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

/// As it lies in the file; the first one holds the key.
struct StoredRecord {
    std::uint32_t stage, next;
    std::uint64_t end;
    float min_height_m, max_height_m;
    std::uint64_t valid_posts, void_posts;
    std::uint32_t reserved, crc;
};
static_assert(sizeof(StoredRecord) == 48);

std::uint32_t crc_of(const StoredRecord& record) { return checksum(&record, offsetof(StoredRecord, crc)); }

StoredRecord stored(const BuildRecord& record) {
    const PostStatistics& s = record.statistics;
    StoredRecord out{record.stage, record.next, record.end, s.min_height_m, s.max_height_m, s.valid_posts, s.void_posts, 0, 0};
    out.crc = crc_of(out);
    return out;
}

BuildRecord loaded(const StoredRecord& in) {
    BuildRecord record;
    record.stage = in.stage;
    record.next = in.next;
    record.end = in.end;
    record.statistics = {in.min_height_m, in.max_height_m, in.valid_posts, in.void_posts};
    return record;
}

void empty_folder(const std::string& folder) {
    std::error_code error;
    std::filesystem::remove_all(folder, error);
    if (error) throw UserError(folder + ": cannot be removed (" + error.message() + "); remove it or name another output");
    make_folder(folder);
}

}  // namespace

BuildJournal::BuildJournal(const std::string& folder, std::uint64_t key) {
    make_folder(folder);
    const std::string path = folder + "/journal";
    file_ = WorkFile(path);
    if (read_records(key)) return;
    file_ = WorkFile();
    empty_folder(folder);
    file_ = WorkFile(path);
    BuildRecord first;
    first.end = key;
    append(first);
    last_ = BuildRecord();
}

bool BuildJournal::read_records(std::uint64_t key) {
    const std::uint64_t count = file_.size() / sizeof(StoredRecord);
    for (records_ = 0; records_ < count; ++records_) {
        StoredRecord record;
        file_.read(records_ * sizeof record, &record, sizeof record);
        if (record.crc != crc_of(record) || (records_ == 0 && record.end != key)) break;
        if (records_ > 0) last_ = loaded(record);
    }
    return records_ > 0;
}

void BuildJournal::append(const BuildRecord& record) {
    const StoredRecord bytes = stored(record);
    file_.write(records_ * sizeof bytes, &bytes, sizeof bytes);
    file_.sync();
    ++records_;
    last_ = record;
}

}  // namespace tedavis::host_sim
