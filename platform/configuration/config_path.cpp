#include "platform/configuration/config_path.hpp"

namespace tedavis::platform {

Path path_beside(std::string_view file, std::string_view name) {
    Path path;
    const std::size_t slash = file.rfind('/');
    if (name.substr(0, 1) != "/" && slash != std::string_view::npos) path.append(file.substr(0, slash + 1));
    path.append(name);
    return path;
}

}  // namespace tedavis::platform
