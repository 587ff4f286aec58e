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
    /// The same, but a file that is there already, of an earlier command, is not removed.
    void add_new(const std::string& path);
    void keep() { paths_.clear(); }

private:
    std::vector<std::string> paths_;
};

}  // namespace tedavis::host_sim
