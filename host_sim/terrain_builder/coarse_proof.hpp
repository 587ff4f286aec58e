/// Collects the errors of chunks above the units, unit by unit; saved to disk with each record of the build.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/coarse_chunks.hpp"

namespace tedavis::host_sim {

class CoarseProof {
public:
    /// Loads the file at `path` if it exists and is complete.
    explicit CoarseProof(std::string path);

    /// Includes errors; to include the same ones twice changes nothing.
    void include(const std::vector<CoarseErrors>& errors);
    [[nodiscard]] const std::map<terrain::ChunkKey, ChunkErrors>& all() const { return all_; }
    /// Replaces the file as a whole. Throws UserError.
    void save() const;

private:
    void load();

    std::string path_;
    std::map<terrain::ChunkKey, ChunkErrors> all_;
};

}  // namespace tedavis::host_sim
