/// Names of files in a scene file.
#pragma once

#include <filesystem>
#include <string>

namespace tedavis::host_sim {

/// Resolves a name; relative names are relative to `folder`, that of the scene file.
[[nodiscard]] inline std::string source_path(const std::string& folder, const std::string& name) {
    const std::filesystem::path path(name);
    return path.is_absolute() ? name : (std::filesystem::path(folder) / path).lexically_normal().string();
}

}  // namespace tedavis::host_sim
