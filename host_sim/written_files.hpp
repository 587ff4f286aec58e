/// Files that a command has written, which are removed again if it fails before they are complete.
#pragma once

#include <string>
#include <vector>

namespace tedavis::host_sim {

class WrittenFiles {
public:
    WrittenFiles() = default;
    /// Removes them, unless kept.
    ~WrittenFiles();
    WrittenFiles(const WrittenFiles&) = delete;
    WrittenFiles& operator=(const WrittenFiles&) = delete;

    /// To be called before the file is written.
    void add(const std::string& path) { paths_.push_back(path); }
    /// The same; an existing file of an earlier command is renamed (`X.earlier`) until keep() removes it, and restored without
    /// keep().
    void add_new(const std::string& path);
    void keep();

private:
    std::vector<std::string> paths_, set_aside_;
};

}  // namespace tedavis::host_sim
