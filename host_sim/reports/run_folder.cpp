#include "host_sim/reports/run_folder.hpp"

#include <cstdio>

namespace tedavis::host_sim {

std::string frame_picture_path(const std::string& folder, std::uint64_t frame) {
    char name[32];
    std::snprintf(name, sizeof name, "%06llu.png", static_cast<unsigned long long>(frame));
    return folder + "/" + kFramesFolder + "/" + name;
}

}  // namespace tedavis::host_sim
