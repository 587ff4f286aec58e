/// Files that a command has written, and that go again where it fails before they are a result.
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

    /// Before it is written.
    void add(const std::string& path) { paths_.push_back(path); }
    /// The same; a file that is there already, of an earlier command, is set aside (`X.earlier`) until keep(), and comes back
    /// without it.
    void add_new(const std::string& path);
    void keep();

private:
    std::vector<std::string> paths_, set_aside_;
};

}  // namespace tedavis::host_sim
