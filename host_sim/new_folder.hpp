/// A folder for results: created with its parents, and removed again where nothing is kept in it.
#pragma once

#include <string>
#include <vector>

namespace tedavis::host_sim {

class NewFolder {
public:
    /// Makes the folder unless it exists. Throws UserError where it cannot be made.
    explicit NewFolder(const std::string& path);
    /// Unless kept, removes the folders that it made, as far as they are empty.
    ~NewFolder();
    NewFolder(const NewFolder&) = delete;
    NewFolder& operator=(const NewFolder&) = delete;

    void keep() { made_.clear(); }

private:
    std::vector<std::string> made_;  // outermost first
};

}  // namespace tedavis::host_sim
