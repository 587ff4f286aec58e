/// A file that goes into a pack.
#pragma once

#include <string>
#include <vector>

namespace tedavis::host_sim {

struct PackedFile {
    std::string from;                     ///< path of the original
    std::string path;                     ///< path in the pack
    std::string sources;                  ///< sources that a database states
    std::string valid_from, valid_until;  ///< UTC days as "2026-12-28"; empty: it states none
};
using PackedFiles = std::vector<PackedFile>;

/// Adds a file unless it is in the list. Throws UserError where another file has its path in the pack.
void add_packed(PackedFile file, PackedFiles& files);

}  // namespace tedavis::host_sim
