/// The scene file and the sheet of tests/real/davos, as if the real data lay where this build was told that they are.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/support/files/paths.hpp"
#include "tests/support/files/temporary_folder.hpp"

namespace tedavis::test_support {

class DavosFiles {
public:
    DavosFiles() {
        namespace fs = std::filesystem;
        const fs::path from = test_support::source_dir() + "/tests/real/davos";
        for (const auto& entry : fs::recursive_directory_iterator(from)) {
            const std::string name = fs::relative(entry.path(), from).string();
            if (entry.is_directory()) {
                fs::create_directory(folder.file(name));
                continue;
            }
            std::ostringstream text;
            text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
            folder.write(name, with_real_data(text.str(), "../../../../../shared/data"));
        }
    }
    [[nodiscard]] static std::string with_real_data(std::string text, const std::string& as_stated) {
        for (std::size_t at = 0; (at = text.find(as_stated)) != std::string::npos;)
            text.replace(at, as_stated.size(), test_support::real_data_dir());
        return text;
    }

    TemporaryFolder folder;
};

}  // namespace tedavis::test_support
