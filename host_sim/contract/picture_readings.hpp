/// The readings of a contract that are measured in a picture. Those that need the layers of the pixels must only be called if the
/// picture has them.
#pragma once

#include "host_sim/contract/contract.hpp"
#include "host_sim/contract/contract_reading.hpp"
#include "host_sim/contract/measured_frame.hpp"
#include "render_core/design/symbology_palette.hpp"

namespace tedavis::host_sim {

[[nodiscard]] ContractReading clutter_reading(const ContractCondition& condition, const MeasuredFrame& frame);
/// Reading of saliency_share and saliency_over_area. Absent where no aspect is prioritized, or where data or their uncertainty
/// are requested in a run without a scene; a design that shows nothing of a scene has 0.
[[nodiscard]] ContractReading saliency_reading(const ContractCondition& condition, const MeasuredFrame& frame);
/// Reading of the faintest sign. Absent where the layer has no sign.
[[nodiscard]] ContractReading contrast_reading(const ContractCondition& condition, const MeasuredFrame& frame);
/// Reading of the faintest sign of any role of the palette with which the symbology was drawn. Absent where it has no sign.
[[nodiscard]] ContractReading role_contrast_reading(const ContractCondition& condition, const MeasuredFrame& frame,
                                                    const design::SymbologyPalette& palette);
/// Reading of the obstacles near the track that are in the picture. An obstacle has the rank of the first salient place whose
/// focus disc reaches the middle of its box (places in omitted layers do not count); one that the design leaves out has no
/// rank. Absent where there is no such obstacle.
[[nodiscard]] ContractReading obstacle_reading(const ContractCondition& condition, const MeasuredFrame& frame);

}  // namespace tedavis::host_sim
