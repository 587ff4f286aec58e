/// A file that goes into a pack.
#pragma once

#include <string>
#include <vector>

namespace tedavis::host_sim {

struct PackedFile {
    std::string from;                     ///< where it is copied from
    std::string path;                     ///< within the pack
    std::string sources;                  ///< what a database says of its sources
    std::string valid_from, valid_until;  ///< UTC days as "2026-12-28"; empty: it states none
};
using PackedFiles = std::vector<PackedFile>;

/// Adds a file, once. Throws UserError where another one would lie at its place.
void add_packed(PackedFile file, PackedFiles& files);

}  // namespace tedavis::host_sim
