#include "host_sim/sweep/written_files.hpp"

#include <filesystem>

namespace tedavis::host_sim {

WrittenFiles::~WrittenFiles() {
    std::error_code ignored;
    for (const std::string& path : paths_) std::filesystem::remove(path, ignored);
}

}  // namespace tedavis::host_sim
