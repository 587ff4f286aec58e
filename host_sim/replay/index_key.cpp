#include "host_sim/replay/index_key.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <memory>
#include <vector>

#include "host_sim/user_error.hpp"
#include "render_core/base/hash.hpp"

namespace tedavis::host_sim {
namespace {

constexpr std::uint64_t kSampleBytes = 64u << 10;

struct FileTimes {
    std::int64_t size = 0, modified_ns = 0, changed_ns = 0;
};

std::int64_t nanoseconds(const timespec& time) { return std::int64_t{time.tv_sec} * 1'000'000'000 + time.tv_nsec; }

FileTimes file_times(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0)
        throw UserError(path + ": cannot be looked at (" + std::strerror(errno) + "); check that it is still there");
    return {status.st_size, nanoseconds(status.st_mtim), nanoseconds(status.st_ctim)};
}

void add_sample(base::Fnv1a64& hash, base::ByteSource& content, std::uint64_t offset) {
    std::vector<char> bytes(std::min(kSampleBytes, content.size() - offset));
    if (content.read(offset, bytes.data(), bytes.size())) hash.add(bytes.data(), bytes.size());
}

}  // namespace

const char* first_difference(const IndexKey& a, const IndexKey& b) {
    static constexpr const char* kNames[] = {"the program",         "the log",           "the bus settings",
                                             "the switch log",      "the switch config", "the aircraft or the phase",
                                             "the terrain database"};
    static_assert(std::size(kNames) == IndexKey::count_);
    for (std::size_t n = 0; n < a.parts.size(); ++n)
        if (a.parts[n] != b.parts[n]) return kNames[n];
    return nullptr;
}

FileIdentity file_identity(const std::string& path, base::ByteSource& content) {
    const FileTimes times = file_times(path);
    base::Fnv1a64 hash;
    hash.add(&times, sizeof times);
    add_sample(hash, content, 0);
    add_sample(hash, content, content.size() - std::min(kSampleBytes, content.size()));
    return {hash.value(), times.changed_ns};
}

std::uint64_t times_identity(const std::string& path) {
    const FileTimes times = file_times(path);
    base::Fnv1a64 hash;
    hash.add(&times, sizeof times);
    return hash.value();
}

std::uint64_t program_identity() { return times_identity("/proc/self/exe"); }

std::uint64_t text_identity(std::string_view text) {
    if (text.empty()) return 0;
    base::Fnv1a64 hash;
    hash.add(text.data(), text.size());
    return hash.value();
}

std::uint64_t terrain_identity(const terrain::TerrainDatabase* database) {
    if (database == nullptr) return 0;
    base::Fnv1a64 hash;
    hash.add(&database->header(), sizeof(terrain::FileHeader));
    // The header does not know the heights. A page's checksum covers the checksums of its chunks.
    const auto page = std::make_unique<terrain::DirectoryPage>();
    for (std::uint32_t n = 0; n < database->lattice().page_count(); ++n) {
        if (!database->has_page(n)) continue;
        const terrain::TdbFailure failure = database->read_page(n, *page);
        hash.add(&failure.error, sizeof failure.error);
        if (failure.error == terrain::TdbError::none) hash.add(&page->crc, sizeof page->crc);
    }
    return hash.value();
}

}  // namespace tedavis::host_sim
