/// A folder for files that one command needs only while it runs: removed with all its content, whatever ends the command.
#pragma once

#include <string>

namespace tedavis::host_sim {

class TemporaryFolder {
public:
    /// Throws UserError where the folder cannot be made in the system's folder for temporary files.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }

private:
    std::string path_;
};

}  // namespace tedavis::host_sim
