#include "host_sim/shipped_files.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {
namespace {

std::string shipped_names(const std::string& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
        if (entry.path().extension() == ".toml")
            names.push_back(std::filesystem::relative(entry.path(), folder, error).replace_extension().string());
    }
    std::sort(names.begin(), names.end());
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    return list.empty() ? "none in " + folder : list;
}

}  // namespace

std::string shipped_root() {
    const char* named = std::getenv("TEDAVIS_ROOT");
    return named != nullptr && *named != '\0' ? named : TEDAVIS_DEFAULT_ROOT;
}

std::string resolve_config(const std::string& name_or_path, const std::string& folder) {
    const bool bare = name_or_path.find_first_of("./") == std::string::npos;
    const bool short_name = name_or_path.find('.') == std::string::npos && name_or_path.rfind('/', 0) != 0;
    const std::string shipped_folder = shipped_root() + "/configs/" + folder;
    std::string shipped = shipped_folder + "/" + name_or_path + ".toml";
    if (bare && std::filesystem::is_regular_file(shipped)) return shipped;
    if (std::filesystem::is_regular_file(name_or_path)) return name_or_path;
    if (short_name && std::filesystem::is_regular_file(shipped)) return shipped;
    throw UserError(name_or_path + ": no such file and no shipped one of " + folder +
                    "; name a file, or one of these: " + shipped_names(shipped_folder));
}

std::string path_from(const std::string& stated_in, const std::string& path) {
    return (std::filesystem::path(stated_in).parent_path() / path).lexically_normal().string();
}

std::string stated_config(const std::string& name_or_path, const std::string& folder, const std::string& stated_in) {
    const bool is_bare = name_or_path.find_first_of("./") == std::string::npos;
    return is_bare ? shipped_root() + "/configs/" + folder + "/" + name_or_path + ".toml" : path_from(stated_in, name_or_path);
}

}  // namespace tedavis::host_sim
