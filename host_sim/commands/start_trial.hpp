/// Starts displays as replays and boards do, so that a check finds everything that a start would refuse.
///
/// Thread  one; draws without a screen, over a small generated terrain in a temporary folder.
#pragma once

#include <string>

#include "host_sim/temporary_folder.hpp"

namespace tedavis::host_sim {

class StartTrial {
public:
    /// A device file with a design (a shipped one may have its short name), each sound by itself. Throws UserError: the sentence
    /// of the start, behind the device's file and the design.
    void require(const std::string& device, const std::string& design);

private:
    [[nodiscard]] const std::string& terrain();

    TemporaryFolder folder_;
    std::string terrain_;
};

}  // namespace tedavis::host_sim
