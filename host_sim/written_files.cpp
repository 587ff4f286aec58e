#include "host_sim/written_files.hpp"

#include <algorithm>
#include <filesystem>

namespace tedavis::host_sim {

namespace {

constexpr const char* kSetAside = ".earlier";

}  // namespace

WrittenFiles::~WrittenFiles() {
    std::error_code ignored;
    for (const std::string& path : paths_) std::filesystem::remove(path, ignored);
    for (const std::string& path : set_aside_) std::filesystem::rename(path + kSetAside, path, ignored);
}

void WrittenFiles::add_new(const std::string& path) {
    if (std::find(paths_.begin(), paths_.end(), path) != paths_.end()) return;
    std::error_code fault;
    if (std::filesystem::is_regular_file(path, fault)) {
        std::filesystem::rename(path, path + kSetAside, fault);
        if (fault) return;  // it cannot be replaced either, and stays
        set_aside_.push_back(path);
    }
    add(path);
}

void WrittenFiles::keep() {
    std::error_code ignored;
    for (const std::string& path : set_aside_) std::filesystem::remove(path + kSetAside, ignored);
    paths_.clear();
    set_aside_.clear();
}

}  // namespace tedavis::host_sim
