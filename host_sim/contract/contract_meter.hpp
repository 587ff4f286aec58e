/// Measures a run's pictures for the conditions of a contract.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/contract/color_groups.hpp"
#include "host_sim/contract/contract.hpp"
#include "host_sim/contract/contract_reading.hpp"
#include "host_sim/evaluation/flight_run.hpp"
#include "host_sim/evaluation/picture_meter.hpp"

namespace tedavis::host_sim {

/// What each design says of each condition on colours, measured once: by the design's name, then by the condition's place.
using DesignGaps = std::map<std::string, std::vector<std::optional<ColorGap>>>;

class ContractMeter {
public:
    /// Reads the run's designs, the current files, where a condition needs their colours. Throws UserError where they cannot be
    /// read.
    ContractMeter(const Contract& contract, const FlightRun& run);

    /// Returns the readings of one frame, one per condition. Threads  any number at once, each with its own meter.
    [[nodiscard]] std::vector<ContractReading> readings(PictureMeter& meter, const FlightFrame& frame) const;

private:
    [[nodiscard]] ContractReading color_reading(std::size_t condition, const FlightFrame& frame) const;

    const Contract& contract_;
    DesignGaps gaps_;
};

}  // namespace tedavis::host_sim
