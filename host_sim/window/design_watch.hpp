/// Notices that the design file, or a palette that it names, was changed while the window is open.
#pragma once

#include <string>
#include <vector>

#include "host_sim/commands/replay.hpp"
#include "host_sim/replay/load_design.hpp"
#include "render_core/design/design_settings.hpp"

namespace tedavis::host_sim {

enum class DesignNews {
    none,
    changed,  ///< `design()` is another one
    broken,   ///< `sentence()` says why; `design()` is still the last sound one
};

class DesignWatch {
public:
    /// Reads the design; throws UserError where it is not sound. The options are copied.
    explicit DesignWatch(const PictureOptions& options);

    /// Looks at the files. A new content counts once it has been met twice, so that a half written file is left alone.
    [[nodiscard]] DesignNews look();

    [[nodiscard]] const design::DesignSettings& design() const { return design_; }
    [[nodiscard]] const std::string& sentence() const { return sentence_; }

private:
    PictureOptions options_;
    std::vector<ReadFile> taken_;        ///< what the last design was read from
    std::vector<std::string> last_met_;  ///< their contents at the last look
    design::DesignSettings design_;
    std::string sentence_;
};

}  // namespace tedavis::host_sim
