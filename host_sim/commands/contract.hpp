/// `tedavis contract RUN CONTRACT [-o DIR]`: tests whether the pictures of a run meet a perceptual contract.
#pragma once

#include <cstdint>
#include <string>

#include "host_sim/console.hpp"

namespace tedavis::host_sim {

struct ContractOptions {
    std::string run;            ///< folder that replay wrote, with its pictures
    std::string contract;       ///< shipped name of configs/contracts, or a path
    std::string output;         ///< folder; empty: nothing is written
    std::uint32_t threads = 0;  ///< 0: as many as there are processors
};

/// Writes to the folder contract.json, and for each broken condition the views of its worst moment. Returns 0 where the
/// contract holds, kCheckFailedExitCode where it does not, kInterruptedExitCode with the results so far; throws UserError and
/// Interrupted.
[[nodiscard]] int run_contract(const ContractOptions& options, Console& console);

}  // namespace tedavis::host_sim
