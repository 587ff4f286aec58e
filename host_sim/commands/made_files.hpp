/// Files that a command makes on its way: removed again where it does not come to its end.
#pragma once

#include <string>
#include <vector>

namespace tedavis::host_sim {

class MadeFiles {
public:
    MadeFiles() = default;
    /// Unless kept, removes the files.
    ~MadeFiles();
    MadeFiles(const MadeFiles&) = delete;
    MadeFiles& operator=(const MadeFiles&) = delete;

    /// A file that will be made; one that is there already, of an earlier command, is never removed.
    void add(const std::string& path);
    void keep() { paths_.clear(); }

private:
    std::vector<std::string> paths_;
};

}  // namespace tedavis::host_sim
