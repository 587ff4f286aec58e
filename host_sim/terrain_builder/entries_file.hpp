/// The entries of all chunks while a database is built, on disk.
#pragma once

#include <string>

#include "host_sim/terrain_builder/tdb_layout.hpp"
#include "host_sim/terrain_builder/work_file.hpp"

namespace tedavis::host_sim {

class EntriesFile {
public:
    EntriesFile(const std::string& path, const terrain::Lattice& lattice) : order_(lattice), file_(path) {
        file_.resize(order_.count() * sizeof(terrain::ChunkEntry));
    }

    [[nodiscard]] std::uint64_t count() const { return order_.count(); }
    [[nodiscard]] terrain::ChunkEntry read(const terrain::ChunkKey& key) const {
        terrain::ChunkEntry entry;
        file_.read(order_.index(key) * sizeof entry, &entry, sizeof entry);
        return entry;
    }
    void write(const terrain::ChunkEntry& entry) {
        file_.write(order_.index(terrain::key_of(entry)) * sizeof entry, &entry, sizeof entry);
    }
    void sync() { file_.sync(); }

private:
    ChunkOrder order_;
    WorkFile file_;
};

}  // namespace tedavis::host_sim
