#include "host_sim/pack/packed_file.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

void add_packed(PackedFile file, PackedFiles& files) {
    const auto there = std::find_if(files.begin(), files.end(), [&](const PackedFile& other) { return other.path == file.path; });
    if (there == files.end()) return files.push_back(std::move(file));
    std::error_code ignored;
    if (std::filesystem::equivalent(there->from, file.from, ignored)) return;
    throw UserError(file.from + ": would lie in the pack where " + there->from + " does (" + file.path + "); rename one of them");
}

}  // namespace tedavis::host_sim
