/// Names of files in a scene file.
#pragma once

#include <filesystem>
#include <string>

namespace tedavis::host_sim {

/// Relative names start from the scene file's folder.
[[nodiscard]] inline std::string source_path(const std::string& folder, const std::string& name) {
    const std::filesystem::path path(name);
    return path.is_absolute() ? name : (std::filesystem::path(folder) / path).lexically_normal().string();
}

}  // namespace tedavis::host_sim
