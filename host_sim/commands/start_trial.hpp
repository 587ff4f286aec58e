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
    /// A device file with a design (a shipped one may have its short name), each sound by itself. Throws UserError: the sentence
    /// of the start, behind the device's file and the design.
    void require(const std::string& device, const std::string& design);

    struct Outcome {
        std::optional<base::BudgetShortage> shortage;  ///< the budget line that was too small; nothing: it has started
        base::BudgetTable used;                        ///< after a start what was taken of each line
    };
    /// A display as the options say, over their terrain or else the generated one. Throws UserError with the sentence of a start
    /// that fails for another reason.
    [[nodiscard]] Outcome start(PictureOptions options);

private:
    [[nodiscard]] const std::string& terrain();

    TemporaryFolder folder_;
    std::string terrain_;
};

}  // namespace tedavis::host_sim
