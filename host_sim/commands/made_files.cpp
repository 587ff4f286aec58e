#include "host_sim/commands/made_files.hpp"

#include <filesystem>

namespace tedavis::host_sim {

MadeFiles::~MadeFiles() {
    std::error_code ignored;
    for (const std::string& path : paths_) std::filesystem::remove(path, ignored);
}

void MadeFiles::add(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) paths_.push_back(path);
}

}  // namespace tedavis::host_sim
