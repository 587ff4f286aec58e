#include "host_sim/reports/run_folder.hpp"

#include <cstdio>
#include <filesystem>

#include "host_sim/user_error.hpp"

namespace tedavis::host_sim {

std::string frame_picture_path(const std::string& folder, std::uint64_t frame) {
    char name[32];
    std::snprintf(name, sizeof name, "%06llu.png", static_cast<unsigned long long>(frame));
    return folder + "/" + kFramesFolder + "/" + name;
}

void require_no_run(const std::string& output) {
    if (std::filesystem::exists(output + "/" + kFrameRecordsName))
        throw UserError("-o " + output + ": this folder holds a run; name another one");
}

}  // namespace tedavis::host_sim
