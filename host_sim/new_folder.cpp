#include "host_sim/new_folder.hpp"

#include <filesystem>

#include "host_sim/atomic_file.hpp"

namespace tedavis::host_sim {

NewFolder::NewFolder(const std::string& path) {
    namespace fs = std::filesystem;
    std::error_code ignored;
    fs::path missing = fs::absolute(path, ignored).lexically_normal();
    if (!missing.has_filename()) missing = missing.parent_path();
    for (; !missing.empty() && !fs::exists(missing, ignored); missing = missing.parent_path())
        made_.insert(made_.begin(), missing.string());
    make_folder(path);
}

NewFolder::~NewFolder() {
    std::error_code not_empty;
    for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) std::filesystem::remove(*folder, not_empty);
}

}  // namespace tedavis::host_sim
