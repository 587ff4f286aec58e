#include "host_sim/terrain_builder/coarse_proof.hpp"

#include <cstdio>
#include <filesystem>
#include <utility>

#include "host_sim/terrain_builder/part_store.hpp"
#include "host_sim/terrain_builder/work_file.hpp"
#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

struct StoredErrors {
    std::uint32_t level, i, j, reserved;
    double values[5];
};

}  // namespace

CoarseProof::CoarseProof(std::string path) : path_(std::move(path)) {
    if (std::filesystem::exists(path_)) load();
}

void CoarseProof::include(const std::vector<CoarseErrors>& errors) {
    for (const CoarseErrors& one : errors) all_[one.chunk].include(one.errors);
}

void CoarseProof::save() const {
    std::vector<StoredErrors> records;
    for (const auto& [chunk, e] : all_)
        records.push_back(
            {chunk.level, chunk.i, chunk.j, 0, {e.own.above_m, e.own.below_m, e.strips.above_m, e.strips.below_m, e.shift_m}});
    const std::string fresh = path_ + ".new";
    WorkFile file(fresh);
    const std::size_t bytes = records.size() * sizeof(StoredErrors);
    const std::uint32_t crc = checksum(records.data(), bytes);
    file.resize(0);
    file.write(0, &crc, sizeof crc);
    file.write(sizeof crc, records.data(), bytes);
    file.sync();
    if (std::rename(fresh.c_str(), path_.c_str()) != 0) throw UserError(path_ + ": cannot be written; check the folder");
}

void CoarseProof::load() {
    const WorkFile file = WorkFile::existing(path_);
    std::uint32_t crc = 0;
    if (file.size() < sizeof crc) return;
    std::vector<StoredErrors> records((file.size() - sizeof crc) / sizeof(StoredErrors));
    const std::size_t bytes = records.size() * sizeof(StoredErrors);
    file.read(0, &crc, sizeof crc);
    file.read(sizeof crc, records.data(), bytes);
    if (crc != checksum(records.data(), bytes)) return;
    for (const StoredErrors& r : records) {
        const auto& v = r.values;
        all_[{r.level, r.i, r.j}] = {{v[0], v[1]}, {v[2], v[3]}, v[4]};
    }
}

}  // namespace tedavis::host_sim
