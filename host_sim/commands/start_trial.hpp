/// Starts displays as replays and boards do, so that a check finds everything that a start would refuse.
///
/// Thread  one; draws without a screen, over a small generated terrain in a temporary folder.
#pragma once

#include <optional>
#include <string>

#include "host_sim/options/picture_options.hpp"
#include "host_sim/temporary_folder.hpp"
#include "render_core/base/budget_shortage.hpp"

namespace tedavis::host_sim {

class StartTrial {
public:
    /// Starts a display with a device file and a design (a file or a short name), each valid by itself. Throws UserError with the
    /// device's file, the design and the message of the start.
    void require(const std::string& device, const std::string& design);

    struct Outcome {
        std::optional<base::BudgetShortage> shortage;  ///< the budget line that was too small; nothing: the display was started
        base::BudgetTable used;                        ///< after a start, the used part of each line
    };
    /// Starts a display with the options, over their terrain or else the generated one. Throws UserError with the message of a
    /// start that fails for another reason than a budget line.
    [[nodiscard]] Outcome start(PictureOptions options);

private:
    [[nodiscard]] const std::string& terrain();

    TemporaryFolder folder_;
    std::string terrain_;
};

}  // namespace tedavis::host_sim
