/// Notices that the design file, or a palette or a phase's design that it names, was changed while the window is open.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host_sim/options/picture_options.hpp"
#include "host_sim/replay/load_design.hpp"

namespace tedavis::host_sim {

enum class DesignNews {
    none,
    changed,  ///< `designs()` are others
    broken,   ///< `message()` says why; `designs()` are still the last sound ones
};

class DesignWatch {
public:
    /// Reads the design; throws UserError where it is not sound. The options are copied.
    explicit DesignWatch(const PictureOptions& options);

    /// Looks at the files. A new content counts once it has been met twice, so that a half written file is left alone.
    [[nodiscard]] DesignNews look();

    [[nodiscard]] const LoadedDesigns& designs() const { return *designs_; }
    [[nodiscard]] const std::string& message() const { return message_; }

private:
    PictureOptions options_;
    std::vector<ReadFile> taken_;        ///< what the last design was read from
    std::vector<std::string> last_met_;  ///< their contents at the last look
    std::unique_ptr<LoadedDesigns> designs_;
    std::string message_;
};

}  // namespace tedavis::host_sim
