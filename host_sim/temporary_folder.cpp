#include "host_sim/temporary_folder.hpp"

#include <cstdlib>
#include <filesystem>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

TemporaryFolder::TemporaryFolder() {
    std::error_code none;
    const std::filesystem::path parent = std::filesystem::temp_directory_path(none);
    path_ = (parent / "tedavis_XXXXXX").string();
    if (none || mkdtemp(path_.data()) == nullptr)
        throw UserError((none ? std::string("TMPDIR") : parent.string()) +
                        ": no folder for temporary files can be made there; name another one in TMPDIR");
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

}  // namespace tedavis::host_sim
