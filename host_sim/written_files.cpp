#include "host_sim/written_files.hpp"

#include <filesystem>

namespace tedavis::host_sim {

WrittenFiles::~WrittenFiles() {
    std::error_code ignored;
    for (const std::string& path : paths_) std::filesystem::remove(path, ignored);
}

void WrittenFiles::add_new(const std::string& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) add(path);
}

}  // namespace tedavis::host_sim
