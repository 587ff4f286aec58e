/// Detects changes of the design file, and of the palettes and phases' designs that it names, while the window is open.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host_sim/options/picture_options.hpp"
#include "host_sim/replay/load_design.hpp"

namespace tedavis::host_sim {

enum class DesignNews {
    none,
    changed,  ///< `designs()` have changed
    broken,   ///< `message()` has the fault; `designs()` are still the last valid ones
};

class DesignWatch {
public:
    /// Reads the design. Throws UserError where it is not valid. The options are copied.
    explicit DesignWatch(const PictureOptions& options);

    /// Reads the files. A new content is taken once it was read twice, so that a half-written file is ignored.
    [[nodiscard]] DesignNews look();

    [[nodiscard]] const LoadedDesigns& designs() const { return *designs_; }
    [[nodiscard]] const std::string& message() const { return message_; }

private:
    PictureOptions options_;
    std::vector<ReadFile> taken_;        ///< the files of the last design
    std::vector<std::string> last_met_;  ///< contents of the files at the last call of look()
    std::unique_ptr<LoadedDesigns> designs_;
    std::string message_;
};

}  // namespace tedavis::host_sim
