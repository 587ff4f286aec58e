/// The errors of chunks above the units while they are gathered, unit by unit; on disk between the records of a build.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "host_sim/terrain_builder/coarse_chunks.hpp"

namespace tedavis::host_sim {

class CoarseProof {
public:
    /// Goes on from the file at `path`, where there is a whole one.
    explicit CoarseProof(std::string path);

    /// The same errors again change nothing.
    void include(const std::vector<CoarseErrors>& errors);
    [[nodiscard]] const std::map<terrain::ChunkKey, ChunkErrors>& all() const { return all_; }
    /// The file is the old one or the new one, never a part. Throws UserError.
    void save() const;

private:
    void load();

    std::string path_;
    std::map<terrain::ChunkKey, ChunkErrors> all_;
};

}  // namespace tedavis::host_sim
