/// Measures a run's pictures for the conditions of a contract.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host_sim/contract/color_groups.hpp"
#include "host_sim/contract/contract.hpp"
#include "host_sim/contract/contract_reading.hpp"
#include "host_sim/contract/measured_frame.hpp"
#include "host_sim/evaluation/flight_run.hpp"
#include "host_sim/evaluation/picture_meter.hpp"
#include "render_core/design/symbology_palette.hpp"

namespace tedavis::host_sim {

/// The colour gaps of each design for each condition on colours, measured once; by the design's name, then by the condition's
/// index.
using DesignGaps = std::map<std::string, std::vector<std::optional<ColorGap>>>;

/// The palette of a run's symbology, read from the current file.
struct RunPalette {
    design::SymbologyPalettes palettes;
    std::string name;
};

/// Returns the settings with which the pictures of a contract are measured.
[[nodiscard]] EvaluationSettings settings_of(const Contract& contract);

class ContractMeter {
public:
    /// Reads the run's designs and palette, the current files, where a condition needs their colours. Throws UserError where they
    /// cannot be read.
    ContractMeter(const Contract& contract, const FlightRun& run);

    /// Returns the readings of one frame, one per condition. Threads  any number at once, each with its own meter.
    [[nodiscard]] std::vector<ContractReading> readings(PictureMeter& meter, const FlightFrame& frame) const;
    /// The same for a picture in memory; `mask` may be null.
    [[nodiscard]] std::vector<ContractReading> readings(PictureMeter& meter, const FlightFrame& frame, const RgbaPicture& picture,
                                                        const LayerMask* mask) const;

private:
    [[nodiscard]] ContractReading color_reading(std::size_t condition, const FlightFrame& frame) const;

    [[nodiscard]] ContractReading symbology_reading(const ContractCondition& condition, const MeasuredFrame& frame) const;

    const Contract& contract_;
    DesignGaps gaps_;
    std::optional<RunPalette> palette_;  ///< nothing where no condition needs it
};

}  // namespace tedavis::host_sim
